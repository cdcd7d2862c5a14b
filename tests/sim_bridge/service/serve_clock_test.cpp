#include "sim_bridge/service/serve_clock.h"

#include <gtest/gtest.h>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

TEST(ServeClock, StandsStillWhereTimeIsTheHosts) {
  const ServeClock clock = ServeClock::parse("--clock", "host");
  EXPECT_TRUE(clock.isHosts());
  EXPECT_EQ(clock.now(), 0.0);
}

TEST(ServeClock, RunsFromZeroOnAndNeverBack) {
  for (const char* text : {"real", "x2.5", "x0.01"}) {
    const ServeClock clock = ServeClock::parse("--clock", text);
    EXPECT_FALSE(clock.isHosts());
    double last = 0.0;
    for (int i = 0; i < 1000; ++i) {
      const double now = clock.now();
      EXPECT_GE(now, last);
      last = now;
    }
    EXPECT_GT(last, 0.0);
  }
}

TEST(ServeClock, OtherWordsAreRefused) {
  for (const char* text : {"", "x", "x0", "x-1", "xnan", "xinf", "2", "x2 ", "fast", "x1e7"}) {
    EXPECT_NE(test::inputErrorOf([&] { ServeClock::parse("--clock", text); }), "") << text;
  }
}

}  // namespace
}  // namespace seaway::bridge
