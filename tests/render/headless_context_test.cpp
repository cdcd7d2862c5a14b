#include "render/headless_context.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "surface/input_error.h"
#include "tests/render/seas.h"

namespace seaway::render {
namespace {

std::string messageOf(const std::function<void()>& action) {
  try {
    action();
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

bool offers(const std::string& backend) {
  const std::vector<std::string> all = headlessBackends();
  return std::find(all.begin(), all.end(), backend) != all.end();
}

/// Resident memory of this process, bytes.
double residentBytes() {
  std::ifstream statistics("/proc/self/statm");
  double total = 0.0, resident = 0.0;
  statistics >> total >> resident;
  return resident * static_cast<double>(sysconf(_SC_PAGESIZE));
}

Frame drawnBy(HeadlessContext& context) {
  const WaterSurface water = test::moderateSea();
  EffectLedger effects;
  View view;
  view.water = &water;
  view.time = 2.0;
  view.camera = test::cameraAt({10.0, 20.0, 4.0}, -8.0, 3.0, 60.0, {96, 64});
  view.effects = &effects;
  return makeProjectedGrid(context, {.grid = {64, 64}})->draw(view);
}

class Backend : public ::testing::TestWithParam<const char*> {
 protected:
  void SetUp() override {
    if (!offers(GetParam())) GTEST_SKIP() << GetParam() << " is not on this machine";
  }
};

TEST_P(Backend, OffersOpenGl45AndSaysWhatItIs) {
  const auto context = makeHeadlessContext(GetParam());
  EXPECT_EQ(context->backend(), GetParam());
  EXPECT_FALSE(context->renderer().empty());
  EXPECT_GE(context->version().substr(0, 3), "4.5");
  EXPECT_GE(context->maximumSize(), 4096);
  EXPECT_EQ(context->isSoftware(), context->renderer().find("llvmpipe") != std::string::npos);
}

TEST_P(Backend, SeveralCanLiveInOneThread) {
  const auto a = makeHeadlessContext(GetParam());
  const auto b = makeHeadlessContext(GetParam());
  const Frame first = drawnBy(*a);
  drawnBy(*b);
  EXPECT_EQ(drawnBy(*a).colour.rgb, first.colour.rgb);
}

TEST_P(Backend, ManyContextsOneAfterTheOtherLeaveNoMemoryBehind) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "freed memory stays resident for a while under the sanitizer";
#endif
  for (int i = 0; i < 10; ++i) makeHeadlessContext(GetParam());
  const double before = residentBytes();
  for (int i = 0; i < 60; ++i) makeHeadlessContext(GetParam());
  // A context of llvmpipe holds about a megabyte. OSMesa itself keeps a kilobyte of each.
  EXPECT_LT(residentBytes() - before, 6e6);
}

INSTANTIATE_TEST_SUITE_P(EveryBackend, Backend, ::testing::Values("osmesa", "egl", "egl:0"),
                         [](const auto& backend) {
                           std::string name = backend.param;
                           name.erase(std::remove(name.begin(), name.end(), ':'), name.end());
                           return name;
                         });

TEST(HeadlessContext, OsmesaAndEglOnLlvmpipeDrawTheSameBits) {
  const auto osmesa = makeHeadlessContext("osmesa");
  if (!offers("egl")) GTEST_SKIP() << "EGL is not on this machine";
  const auto egl = makeHeadlessContext("egl");
  if (egl->renderer() != osmesa->renderer()) {
    GTEST_SKIP() << "EGL draws with " << egl->renderer() << ", OSMesa with " << osmesa->renderer();
  }
  const Frame a = drawnBy(*osmesa), b = drawnBy(*egl);
  EXPECT_EQ(a.colour.rgb, b.colour.rgb);
  EXPECT_EQ(a.depth.metres, b.depth.metres);
  // And back again: each finds its own functions and state after the other has drawn.
  EXPECT_EQ(drawnBy(*osmesa).colour.rgb, a.colour.rgb);
}

TEST(HeadlessContext, UnknownBackendIsRefusedWithTheKnownOnesNamed) {
  for (const char* name : {"vulkan", "", "egl:", "egl:-1", "egl:1x", "EGL", "osmesa:0"}) {
    const std::string message = messageOf([&] { makeHeadlessContext(name); });
    EXPECT_NE(message.find("'" + std::string(name) + "'"), std::string::npos) << message;
    EXPECT_NE(message.find("osmesa, egl or egl:N"), std::string::npos) << message;
    EXPECT_EQ(messageOf([&] { requireBackend(name); }), message);
  }
}

TEST(HeadlessContext, AnEglDeviceThatIsNotThereIsRefusedWithThoseThatAreNamed) {
  const std::string message = messageOf([] { requireBackend("egl:97"); });
  EXPECT_NE(message.find("'egl:97'"), std::string::npos) << message;
  EXPECT_NE(message.find("this machine offers: osmesa"), std::string::npos) << message;
}

}  // namespace
}  // namespace seaway::render
