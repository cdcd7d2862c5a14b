#include "surface/surface_sample.h"

#include <array>
#include <utility>

namespace seaway {

std::string statusText(SampleStatus status) {
  static constexpr std::array<std::pair<SampleStatus, const char*>, 9> names{{
      {SampleStatus::truncated, "truncated"},
      {SampleStatus::notFinite, "not_finite"},
      {SampleStatus::outOfRange, "out_of_range"},
      {SampleStatus::noKinematics, "no_kinematics"},
      {SampleStatus::aboveSurface, "above_surface"},
      {SampleStatus::belowBed, "below_bed"},
      {SampleStatus::wakeOutOfTime, "wake_out_of_time"},
      {SampleStatus::wakePartial, "wake_partial"},
      {SampleStatus::dry, "dry"},
  }};
  std::string text;
  for (const auto& [bit, name] : names) {
    if (!has(status, bit)) continue;
    if (!text.empty()) text += '|';
    text += name;
  }
  return text.empty() ? "ok" : text;
}

}  // namespace seaway
