#include "sim_bridge/commands/spectrum_source.h"

#include <array>
#include <cmath>
#include <filesystem>
#include <span>

#include "surface/input_error.h"
#include "surface/spectra/families.h"
#include "surface/spectra/readers/read_spectra.h"
#include "surface/spectra/readers/text_cursor.h"
#include "surface/spectra/sea_states.h"
#include "surface/spectra/swell.h"
#include "surface/spectra/two_peak_families.h"

namespace seaway::bridge {
namespace {

using Numbers = std::span<const double>;

/// A family as the command line names it.
struct Family {
  const char* name;
  const char* form;
  const char* summary;
  std::array<std::size_t, 2> counts;  ///< of numbers allowed
  FrequencySpectrum (*make)(Numbers);
};

FrequencySpectrum makeOchiHubble(Numbers n) {
  if (n.size() == 1) return ochiHubbleMostProbable(n[0]);
  return ochiHubble({n[0], n[1], n[2]}, {n[3], n[4], n[5]});
}

FrequencySpectrum makeSeaState(Numbers n) {
  if (n[0] != std::floor(n[0]) || std::abs(n[0]) > 99.0) {
    throw InputError("sea state must be a whole number in [0, 9]");
  }
  return seaStateSpectrum(static_cast<int>(n[0]));
}

constexpr std::array<Family, 8> families{{
    {"pm",
     "pm:Hs,Tp",
     "Pierson-Moskowitz",
     {2, 2},
     [](Numbers n) { return piersonMoskowitz(n[0], n[1]); }},
    {"pm_wind",
     "pm_wind:U",
     "the same, fully developed, by the wind at 19.5 m",
     {1, 1},
     [](Numbers n) { return piersonMoskowitzOfWind(n[0]); }},
    {"jonswap",
     "jonswap:Hs,Tp[,gamma]",
     "JONSWAP, gamma 3.3",
     {2, 3},
     [](Numbers n) {
       return jonswap({n[0], n[1], n.size() > 2 ? n[2] : 3.3});
     }},
    {"tma",
     "tma:Hs,Tp,gamma,depth",
     "JONSWAP in finite depth",
     {4, 4},
     [](Numbers n) {
       return tma({n[0], n[1], n[2]}, n[3]);
     }},
    {"ochi_hubble",
     "ochi_hubble:Hs or ochi_hubble:Hs1,Tp1,lambda1,Hs2,Tp2,lambda2",
     "Ochi-Hubble, most probable or by its six parameters",
     {1, 6},
     makeOchiHubble},
    {"torsethaugen",
     "torsethaugen:Hs,Tp",
     "two peaks, simplified Torsethaugen",
     {2, 2},
     [](Numbers n) { return torsethaugen(n[0], n[1]); }},
    {"swell",
     "swell:Hs,Tp,width",
     "Gaussian swell, width in Hz",
     {3, 3},
     [](Numbers n) { return gaussianSwell(n[0], n[1], n[2]); }},
    {"wmo", "wmo:CODE", "sea state 1-9 of WMO table 3700", {1, 1}, makeSeaState},
}};

/// The numbers of "a,b,c"; empty where one is none.
std::vector<double> numbersOf(std::string_view list) {
  std::vector<double> numbers;
  while (true) {
    const std::size_t comma = list.find(',');
    const auto number = numberOf(list.substr(0, comma));
    if (!number) return {};
    numbers.push_back(*number);
    if (comma == std::string_view::npos) return numbers;
    list.remove_prefix(comma + 1);
  }
}

FrequencySpectrum familySpectrum(const Family& family, const std::string& argument) {
  const std::vector<double> numbers =
      numbersOf(std::string_view(argument).substr(argument.find(':') + 1));
  if (numbers.size() != family.counts[0] && numbers.size() != family.counts[1]) {
    throw InputError("'" + argument + "' is not " + family.form + " in numbers");
  }
  try {
    return family.make(numbers);
  } catch (const InputError& fault) {
    throw InputError("'" + argument + "': " + fault.what());
  }
}

const Family* familyNamed(const std::string& argument) {
  const std::size_t colon = argument.find(':');
  if (colon == std::string::npos) return nullptr;
  for (const Family& family : families) {
    if (argument.compare(0, colon, family.name) == 0) return &family;
  }
  if (std::error_code ignored; std::filesystem::exists(argument, ignored)) return nullptr;
  std::string forms;
  for (const Family& family : families)
    forms += (forms.empty() ? "" : ", ") + std::string(family.form);
  throw InputError("'" + argument + "' is neither a file nor one of: " + forms);
}

/// As recordAt, with file and option named where there is none.
const SpectrumRecord& atTime(const std::vector<SpectrumRecord>& records, const std::string& file,
                             const std::string& time) {
  try {
    return recordAt(records, time);
  } catch (const InputError& fault) {
    throw InputError(file, 0, "--time " + time + ": " + fault.what());
  }
}

}  // namespace

SpectrumSource spectrumFrom(const std::string& argument, std::optional<int> record,
                            const std::string& time, const std::string& format) {
  if (const Family* family = familyNamed(argument)) {
    if (record || !time.empty() || !format.empty()) {
      throw InputError("--record, --time and --format are for a file; '" + argument + "' is none");
    }
    DirectionalSpectrum spectrum;
    spectrum.energy = familySpectrum(*family, argument);
    return {std::move(spectrum), argument, "", {}};
  }
  if (record && !time.empty()) throw InputError("give --record or --time, not both");
  const std::vector<SpectrumRecord> records = readSpectra(withCompanions(argument), format);
  const SpectrumRecord& chosen =
      time.empty() ? recordNumber(records, record.value_or(0)) : atTime(records, argument, time);
  const std::string of = chosen.time.empty() ? "" : " of " + chosen.time;
  if (!chosen.hasSpectrum()) {
    throw InputError(argument, chosen.line, "the spectrum" + of + " has fewer than 2 bins");
  }
  if (!(chosen.spectrum.energy.moment(0) > 0.0)) {
    throw InputError(argument, chosen.line, "the spectrum" + of + " has no energy");
  }
  const std::string line = chosen.line > 0 ? ":" + std::to_string(chosen.line) : "";
  return {chosen.spectrum, argument + line, chosen.time, chosen.notes};
}

std::string spectrumFamilies() {
  std::string text;
  for (const Family& family : families) {
    text += "  " + std::string(family.form) + ": " + family.summary + "\n";
  }
  return text;
}

std::string spectrumFileFormats() {
  std::string text;
  for (const SpectrumFormatName& format : spectrumFormats()) {
    text += "  " + format.name + ": " + format.summary + "\n";
  }
  return text;
}

}  // namespace seaway::bridge
