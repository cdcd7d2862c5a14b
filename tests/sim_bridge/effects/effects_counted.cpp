#include <tbb/global_control.h>

#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

#include "tests/sim_bridge/effects/effect_trial.h"

#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_START_INSTRUMENTATION
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(label) static_cast<void>(label)
#endif

namespace {

using namespace seaway;
using bridge::test::EffectTrial;

struct Counted {
  std::string name;  // effect and variant
  EffectTrial trial;
  EffectLedger ledger;

  Counted(Effect effect, const char* variant, const char* difference, const char* setting,
          const std::filesystem::path& folder)
      : name(std::string(effectName(effect)) + " " + variant),
        trial(bridge::test::sceneOf(effect, difference, setting, folder)),
        ledger(trial.scene().effects) {
    trial.step(ledger);
  }
};

template <class Action>
void count(const Counted& counted, const char* what, Action action) {
  CALLGRIND_ZERO_STATS;
  action();
  const std::string label = counted.name + " " + what;
  CALLGRIND_DUMP_STATS_AT(label.c_str());
}

}  // namespace

/// effects_counted FOLDER, under callgrind with --instr-atstart=no: dumps what a step, a batch of
/// samples and a picture of each proof's scenes take, labelled "EFFECT VARIANT WHAT".
int main(int argumentCount, char** arguments) {
  if (argumentCount != 2) return 2;
  const tbb::global_control alone(tbb::global_control::max_allowed_parallelism, 1);
  const std::filesystem::path folder = arguments[1];
  std::vector<std::unique_ptr<Counted>> all;
  for (const EffectDescription& each : effectDescriptions()) {
    const auto proof = bridge::test::proofOf(each.effect);
    if (!proof) return 1;
    const auto add = [&](const char* variant, const char* difference, const char* setting) {
      all.push_back(std::make_unique<Counted>(each.effect, variant, difference, setting, folder));
    };
    add("idle", proof->quiet, "auto");
    add("off", proof->quiet, "off");
    if (!proof->bare) continue;
    add("busy_off", proof->busy, "off");
    add("bare", proof->bare, "auto");
  }
  // One for all, so that its sky need not be drawn anew where the light is as before.
  const auto technique = render::makeSoftwareGrid({.grid = {16, 16}});
  for (int i = 0; i < 3; ++i) all[0]->trial.draw(*technique, all[0]->ledger);
  CALLGRIND_START_INSTRUMENTATION;
  for (const auto& each : all) {
    EffectLedger ledger(each->trial.scene().effects);
    count(*each, "step", [&] { each->trial.step(ledger); });
    count(*each, "samples", [&] { each->trial.sample(); });
    each->trial.draw(*technique, ledger);  // the first makes what later ones find
    count(*each, "picture", [&] { each->trial.draw(*technique, ledger); });
  }
  return 0;
}
