#include "sim_bridge/selftest/verdict.h"

#include <gtest/gtest.h>

#include <csignal>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

ChildOutcome ended(int status, std::string out = "", std::string err = "") {
  ChildOutcome outcome;
  outcome.status = status;
  outcome.out = std::move(out);
  outcome.err = std::move(err);
  return outcome;
}

ChildOutcome shell(const std::string& script, const ChildLimits& limits = {}) {
  return runProgram("/bin/sh", {"-c", script}, limits);
}

TEST(ChildRun, TellsStatusAndBothOutputs) {
  const ChildOutcome outcome = shell("echo out; echo err >&2; exit 2");
  EXPECT_EQ(outcome.status, 2);
  EXPECT_EQ(outcome.signal, 0);
  EXPECT_EQ(outcome.out, "out\n");
  EXPECT_EQ(outcome.err, "err\n");
}

TEST(ChildRunHard, TellsTheSignalThatEndedIt) { EXPECT_EQ(shell("kill -SEGV $$").signal, SIGSEGV); }

TEST(ChildRunHard, EndsWhatDoesNotEnd) {
  const ChildOutcome outcome =
      shell("while :; do :; done", {.time = std::chrono::milliseconds(100)});
  EXPECT_TRUE(outcome.timedOut);
  EXPECT_EQ(outcome.signal, SIGKILL);
}

TEST(ChildRunHard, HasNoMoreMemoryThanItMay) {
  // The pause lets the limit be set, which it is once the program runs.
  const char* script = "sleep 0.1; exec dd if=/dev/zero of=/dev/null bs=256M count=1";
  const ChildOutcome free = shell(script);
  EXPECT_EQ(free.status, 0) << free.err;
  const ChildOutcome held = shell(script, {.memoryBytes = std::size_t{128} << 20});
  EXPECT_EQ(held.status, 1);
  EXPECT_NE(faultOf(held, {}, "/nowhere"), "");
}

TEST(ChildRunHard, SaysThatAProgramIsNotThere) {
  EXPECT_ANY_THROW(runProgram("/no/such/program", {}));
}

TEST(Verdict, KnowsWhatMayNotHappen) {
  const test::TempFolder folder;
  const auto fault = [&](const ChildOutcome& outcome, const Expectation& expectation = {}) {
    return faultOf(outcome, expectation, folder.path());
  };
  EXPECT_EQ(fault(ended(0)), "");
  EXPECT_EQ(fault(ended(2, "", "seaway: error: f.yaml:3: no")), "");
  EXPECT_NE(fault(ended(1, "", "seaway: error: no")), "");
  EXPECT_NE(fault(ended(2)), "");
  EXPECT_NE(fault(ended(0), {Expected::refuses}), "");
  EXPECT_NE(fault(ended(2, "", "error"), {Expected::works}), "");
  EXPECT_NE(fault(ended(2, "", "error: bad"), {Expected::refuses, "", true}), "");
  EXPECT_NE(fault(ended(0, "height_m\n-nan\n")), "");
  EXPECT_EQ(fault(ended(0, "name: nanny, info\n")), "");
  EXPECT_NE(fault(ended(0, "all well"), {Expected::works, "unwell"}), "");
  EXPECT_NE(fault(ended(2, "", "error\nterminate called after")), "");
}

TEST(Verdict, LooksIntoTheFilesThatAreLeft) {
  const test::TempFolder folder;
  folder.write("t.csv", "a,b\n1,inf\n");
  EXPECT_NE(faultOf(ended(0), {}, folder.path()), "");
  folder.write("t.csv", "a,b\n1,2\n");
  EXPECT_EQ(faultOf(ended(0), {}, folder.path()), "");
  EXPECT_NE(faultOf(ended(2, "", "error"), {}, folder.path()), "") << "a refusal left a file";
  folder.write("summary.json.unfinished", "{}");
  EXPECT_EQ(faultOf(ended(2, "", "error"), {}, folder.path()), "") << "a run ended under way";
  folder.write("telemetry.csv.part17", "a,b");
  EXPECT_NE(faultOf(ended(2, "", "error"), {}, folder.path()), "") << "half a file";
}

}  // namespace
}  // namespace seaway::bridge
