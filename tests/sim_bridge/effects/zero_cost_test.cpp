#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>

#include "tests/render/gl_calls.h"
#include "tests/render/seas.h"
#include "tests/sim_bridge/effects/effect_trial.h"
#include "tests/sim_bridge/test_support.h"
#include "tests/support/allocation_counter.h"

// What is not called for, or switched off, does nothing: no call of OpenGL, no allocation, no
// memory, and pictures, samples and motions are the same.
namespace seaway::bridge {
namespace {

using test::EffectTrial;

/// What one step, one batch of samples and the second picture of a scene did.
struct Account {
  std::size_t stepAllocations = 0, sampleAllocations = 0, frameAllocations = 0;
  long glCalls = 0;
  EffectReport report;  // of the effect in question
  std::vector<std::uint8_t> colours;
  std::vector<float> depths;
  std::vector<SurfaceSample> samples;
  std::vector<VesselPose> poses;
};

template <class Action>
std::size_t allocationsOf(Action action) {
  const std::size_t before = test_support::allocationCount();
  action();
  return test_support::allocationCount() - before;
}

/// Techniques' memory is theirs from the first picture on.
Account accountOf(Effect effect, const test::Json& scene) {
  EffectTrial trial(scene);
  const auto software = render::makeSoftwareGrid({.grid = {16, 16}});
  static const auto throughGl = render::makeProjectedGrid(
      render::test::sharedContext(), {.grid = {16, 16}, .variant = render::GridVariant::gpu});
  Account account;
  EffectLedger ledger(trial.scene().effects), others(trial.scene().effects);
  account.stepAllocations = allocationsOf([&] { trial.step(ledger); });
  account.sampleAllocations = allocationsOf([&] { trial.sample(); });
  for (const auto& technique : {throughGl.get(), software.get()}) trial.draw(*technique, others);
  {
    const render::test::GlCalls counted;
    trial.draw(*throughGl, others);
    account.glCalls = render::test::GlCalls::count();
  }
  trial.draw(*software, others);
  account.frameAllocations = allocationsOf([&] { trial.draw(*software, ledger); });
  account.report = ledger.report()[static_cast<std::size_t>(effect)];
  account.colours = trial.frame().colour.rgb;
  account.depths = trial.frame().depth.metres;
  account.samples = trial.samples();
  account.poses = trial.poses();
  return account;
}

bool sameBits(const std::vector<SurfaceSample>& a, const std::vector<SurfaceSample>& b) {
  if (a.size() != b.size()) return false;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double numbers[2][4] = {{a[i].height, a[i].slope.x, a[i].slope.y, a[i].verticalVelocity},
                                  {b[i].height, b[i].slope.x, b[i].slope.y, b[i].verticalVelocity}};
    if (std::memcmp(numbers[0], numbers[1], sizeof(numbers[0])) != 0) return false;
    if (a[i].status != b[i].status) return false;
  }
  return true;
}

void expectTheSame(const Account& a, const Account& b) {
  int most = 0, count = 0;
  for (std::size_t i = 0; i < a.colours.size(); ++i) {
    const int apart = std::abs(a.colours[i] - b.colours[i]);
    most = std::max(most, apart);
    count += apart > 0;
  }
  EXPECT_EQ(most, 0) << count << " values of the picture differ";
  EXPECT_TRUE(a.depths == b.depths);
  EXPECT_TRUE(sameBits(a.samples, b.samples));
  ASSERT_EQ(a.poses.size(), b.poses.size());
  for (std::size_t i = 0; i < a.poses.size(); ++i) {
    EXPECT_EQ(a.poses[i].height, b.poses[i].height);
    EXPECT_EQ(a.poses[i].roll, b.poses[i].roll);
    EXPECT_EQ(a.poses[i].pitch, b.poses[i].pitch);
  }
}

void expectNoMore(const Account& a, const Account& than) {
  EXPECT_LE(a.stepAllocations, than.stepAllocations);
  EXPECT_LE(a.sampleAllocations, than.sampleAllocations);
  EXPECT_LE(a.frameAllocations, than.frameAllocations);
  EXPECT_LE(a.glCalls, than.glCalls);
  EXPECT_EQ(a.report.memoryBytes, 0u);
  EXPECT_EQ(a.report.costMicroseconds, 0.0);
}

class ZeroCost : public ::testing::TestWithParam<EffectDescription> {
 protected:
  void SetUp() override {
    if (!test::proofOf(effect())) {
      FAIL() << "no scenes in effect_proofs.cpp show that " << GetParam().name
             << " costs nothing where it is not called for";
    }
  }
  static Effect effect() { return GetParam().effect; }
  Account with(const char* difference, const char* setting) {
    return accountOf(effect(), test::sceneOf(effect(), difference, setting, folder_.path()));
  }

 private:
  test::TempFolder folder_;
  // Which thread takes which piece decides what is allocated for it.
  tbb::global_control alone_{tbb::global_control::max_allowed_parallelism, 1};
};

TEST_P(ZeroCost, RunsWhereItIsCalledFor) {
  const Account busy = with(test::proofOf(effect())->busy, "auto");
  EXPECT_EQ(busy.report.state, EffectState::on) << busy.report.reason;
}

TEST_P(ZeroCost, NothingIsPaidWhereItIsNotCalledFor) {
  const auto proof = test::proofOf(effect());
  const Account idle = with(proof->quiet, "auto"), off = with(proof->quiet, "off");
  EXPECT_EQ(idle.report.state, EffectState::idle) << idle.report.reason;
  EXPECT_EQ(off.report.state, EffectState::off);
  expectNoMore(idle, off);
  expectNoMore(off, idle);
  expectTheSame(idle, off);
}

TEST_P(ZeroCost, ForcedOnButIdleItChangesNothing) {
  const auto proof = test::proofOf(effect());
  const char* scene = proof->forced ? proof->forced : proof->quiet;
  expectTheSame(with(scene, "on"), with(scene, "auto"));
}

class EffectOff : public ZeroCost {};

TEST_P(EffectOff, IsAsWithoutItsCause) {
  const auto proof = test::proofOf(effect());
  const Account off = with(proof->busy, "off"), bare = with(proof->bare, "auto");
  EXPECT_EQ(off.report.state, EffectState::off);
  expectNoMore(off, bare);
  EXPECT_TRUE(off.colours == bare.colours);
  EXPECT_TRUE(sameBits(off.samples, bare.samples));
}

std::vector<EffectDescription> everyEffect() {
  return {effectDescriptions().begin(), effectDescriptions().end()};
}

/// Those that have a scene like that of `busy` but without their cause.
std::vector<EffectDescription> effectsWithCause() {
  std::vector<EffectDescription> effects = everyEffect();
  std::erase_if(effects, [](const EffectDescription& each) {
    const auto proof = test::proofOf(each.effect);
    return !proof || !proof->bare;
  });
  return effects;
}

const auto nameOf = [](const auto& one) { return std::string(one.param.name); };
INSTANTIATE_TEST_SUITE_P(EveryEffect, ZeroCost, ::testing::ValuesIn(everyEffect()), nameOf);
INSTANTIATE_TEST_SUITE_P(Effects, EffectOff, ::testing::ValuesIn(effectsWithCause()), nameOf);

TEST(GlCalls, EveryFunctionThatIsCalledIsCounted) {
  const auto names = render::test::GlCalls::counted();
  const std::set<std::string_view> counted(names.begin(), names.end());
  static const std::regex call(R"(\bgl[A-Z]\w+(?=\())");
  for (const auto& entry :
       std::filesystem::recursive_directory_iterator(SEAWAY_SOURCE_DIR "/render")) {
    if (entry.path().extension() != ".cpp" && entry.path().extension() != ".h") continue;
    const std::string text = test::readFile(entry.path());
    for (std::sregex_iterator it(text.begin(), text.end(), call), end; it != end; ++it) {
      EXPECT_TRUE(counted.contains(it->str())) << it->str() << " in " << entry.path();
    }
  }
}

}  // namespace
}  // namespace seaway::bridge
