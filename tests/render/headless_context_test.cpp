#include "render/headless_context.h"

#include <gtest/gtest.h>

#include "surface/input_error.h"

namespace seaway::render {
namespace {

TEST(HeadlessContext, OsmesaOffersOpenGl45AndSaysWhatItIs) {
  const auto context = makeHeadlessContext("osmesa");
  EXPECT_EQ(context->backend(), "osmesa");
  EXPECT_FALSE(context->renderer().empty());
  EXPECT_GE(context->version().substr(0, 3), "4.5");
  EXPECT_GE(context->maximumSize(), 4096);
}

TEST(HeadlessContext, UnknownBackendIsRefusedWithTheKnownOnesNamed) {
  try {
    makeHeadlessContext("vulkan");
    FAIL() << "made";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("vulkan"), std::string::npos);
    EXPECT_NE(std::string(error.what()).find("osmesa"), std::string::npos);
  }
}

TEST(HeadlessContext, SeveralCanLiveInOneThread) {
  const auto a = makeHeadlessContext("osmesa");
  const auto b = makeHeadlessContext("osmesa");
  a->makeCurrent();
  b->makeCurrent();
  a->makeCurrent();
  EXPECT_EQ(a->renderer(), b->renderer());
}

}  // namespace
}  // namespace seaway::render
