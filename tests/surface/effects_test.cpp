#include "surface/effects.h"

#include <gtest/gtest.h>

namespace seaway {
namespace {

EffectSettings with(Effect effect, EffectSetting setting) {
  EffectSettings settings{};
  settings[static_cast<std::size_t>(effect)] = setting;
  return settings;
}

const EffectReport& reportOf(const std::vector<EffectReport>& reports, Effect effect) {
  return reports[static_cast<std::size_t>(effect)];
}

TEST(Effects, EveryEffectIsDescribedInItsPlace) {
  ASSERT_EQ(effectDescriptions().size(), static_cast<std::size_t>(Effect::count));
  for (std::size_t i = 0; i < effectDescriptions().size(); ++i) {
    const EffectDescription& description = effectDescriptions()[i];
    EXPECT_EQ(static_cast<std::size_t>(description.effect), i);
    EXPECT_EQ(effectFromName(description.name), description.effect);
    EXPECT_EQ(effectName(description.effect), description.name);
  }
  EXPECT_FALSE(effectFromName("tsunami"));
}

TEST(Effects, AutomaticRunsOnlyWhenCalledFor) {
  EffectLedger ledger;
  EXPECT_FALSE(ledger.decide(Effect::sun, false, "below the horizon"));
  EXPECT_EQ(reportOf(ledger.report(), Effect::sun).state, EffectState::idle);
  EXPECT_EQ(reportOf(ledger.report(), Effect::sun).reason, "below the horizon");
  EXPECT_TRUE(ledger.decide(Effect::sun, true, "25° up"));
  EXPECT_EQ(reportOf(ledger.report(), Effect::sun).state, EffectState::on);
}

TEST(Effects, OffNeverRunsAndOnAlwaysDoes) {
  EffectLedger off(with(Effect::sky, EffectSetting::off));
  EXPECT_FALSE(off.decide(Effect::sky, true, "sky in view"));
  EXPECT_EQ(reportOf(off.report(), Effect::sky).state, EffectState::off);
  EffectLedger on(with(Effect::sky, EffectSetting::on));
  EXPECT_TRUE(on.decide(Effect::sky, false, "no sky in view"));
  EXPECT_EQ(reportOf(on.report(), Effect::sky).reason, "forced on; no sky in view");
}

TEST(Effects, OneRunOutweighsLaterIdleDecisions) {
  EffectLedger ledger;
  ledger.decide(Effect::water, true, "seen by bow");
  ledger.decide(Effect::water, false, "camera looks up");
  EXPECT_EQ(reportOf(ledger.report(), Effect::water).state, EffectState::on);
  EXPECT_EQ(reportOf(ledger.report(), Effect::water).reason, "seen by bow");
}

TEST(Effects, TimersChargeTheirEffectAndCostsAddUp) {
  EffectLedger ledger;
  ledger.charge(Effect::waves, 3.0);
  ledger.charge(Effect::waves, 4.0);
  ledger.holdMemory(Effect::waves, 512);
  { EffectTimer timer(&ledger, Effect::sky); }
  { EffectTimer nobodyCounts(nullptr, Effect::sky); }
  EXPECT_DOUBLE_EQ(reportOf(ledger.report(), Effect::waves).costMicroseconds, 7.0);
  EXPECT_EQ(reportOf(ledger.report(), Effect::waves).memoryBytes, 512u);
  EXPECT_GT(reportOf(ledger.report(), Effect::sky).costMicroseconds, 0.0);
}

TEST(Effects, WorkInsideAnotherEffectsPassesSaysWhose) {
  EffectLedger ledger;
  EXPECT_FALSE(reportOf(ledger.report(), Effect::sun).costInside);
  ledger.chargeInside(Effect::sun, Effect::water);
  EXPECT_EQ(reportOf(ledger.report(), Effect::sun).costInside, Effect::water);
}

}  // namespace
}  // namespace seaway
