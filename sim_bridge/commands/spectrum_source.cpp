#include "sim_bridge/commands/spectrum_source.h"

#include <charconv>
#include <vector>

#include "sim_bridge/scene/schema.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"
#include "surface/spectra/ndbc.h"

namespace seaway::bridge {
namespace {

std::vector<double> parameters(const std::string& argument, std::string_view list) {
  std::vector<double> numbers;
  const char* at = list.data();
  const char* const end = at + list.size();
  while (true) {
    double value = 0.0;
    const auto [stop, fault] = std::from_chars(at, end, value);
    if (fault != std::errc{} || (stop != end && *stop != ',')) {
      throw InputError("'" + argument + "' is not jonswap:Hs,Tp,gamma or pm:Hs,Tp in numbers");
    }
    numbers.push_back(value);
    if (stop == end) return numbers;
    at = stop + 1;
  }
}

FrequencySpectrum family(const std::string& argument, const std::string& name,
                         const std::vector<double>& numbers) {
  const std::size_t most = name == "jonswap" ? 3 : 2;
  if (numbers.size() < 2 || numbers.size() > most) {
    throw InputError("'" + argument + "': wanted " +
                     (most == 3 ? "jonswap:Hs,Tp or jonswap:Hs,Tp,gamma" : "pm:Hs,Tp"));
  }
  requireInRange("'" + argument + "': Hs", numbers[0], Range::above(0.0), "m");
  requireInRange("'" + argument + "': Tp", numbers[1], Range::above(0.0), "s");
  JonswapParameters sea{numbers[0], numbers[1], name == "pm" ? 1.0 : 3.3};
  if (numbers.size() == 3) sea.peakEnhancement = numbers[2];
  requireInRange("'" + argument + "': gamma", sea.peakEnhancement, Range::within(1.0, 20.0), "");
  return jonswap(sea);
}

const SpectrumRecord& choose(const std::vector<SpectrumRecord>& records, const std::string& file,
                             std::optional<int> record, const std::string& time) {
  if (!time.empty()) {
    try {
      return recordAt(records, time);
    } catch (const InputError& fault) {
      throw InputError(file, 0, std::string("--time ") + time + ": " + fault.what());
    }
  }
  const int index = record.value_or(0);
  if (index < 0 || index >= static_cast<int>(records.size())) {
    throw InputError(file, 0,
                     "--record: " + std::to_string(index) + " is not allowed; the file has " +
                         std::to_string(records.size()) + " records, from 0");
  }
  return records[static_cast<std::size_t>(index)];
}

}  // namespace

SpectrumSource spectrumFrom(const std::string& argument, std::optional<int> record,
                            const std::string& time) {
  const std::size_t colon = argument.find(':');
  const std::string name = argument.substr(0, colon);
  if (colon != std::string::npos && (name == "jonswap" || name == "pm")) {
    if (record || !time.empty()) {
      throw InputError("--record and --time choose from a file; '" + argument + "' is none");
    }
    const auto numbers = parameters(argument, std::string_view(argument).substr(colon + 1));
    return {family(argument, name, numbers), argument, ""};
  }
  if (record && !time.empty()) throw InputError("give --record or --time, not both");
  const std::vector<SpectrumRecord> records = readNdbcSpectralDensity(argument);
  if (records.empty()) throw InputError(argument, 0, "holds no record");
  const SpectrumRecord& chosen = choose(records, argument, record, time);
  const std::string fault = chosen.spectrum.validate().value_or("");
  if (!fault.empty()) throw InputError(argument, chosen.line, fault);
  if (!(chosen.spectrum.moment(0) > 0.0)) {
    throw InputError(argument, chosen.line, "the spectrum of " + chosen.time + " has no energy");
  }
  return {chosen.spectrum, argument + ":" + std::to_string(chosen.line), chosen.time};
}

}  // namespace seaway::bridge
