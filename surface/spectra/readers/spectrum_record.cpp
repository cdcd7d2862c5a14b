#include "surface/spectra/readers/spectrum_record.h"

#include <cmath>
#include <limits>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/time_stamp.h"

namespace seaway {

const SpectrumRecord& recordAt(const std::vector<SpectrumRecord>& records, const std::string& time,
                               double tolerance) {
  const auto wanted = parseIsoTime(time);
  if (!wanted) {
    throw InputError("--time: '" + time + "' is not allowed; must be of the form 2020-06-08T03:50");
  }
  const SpectrumRecord* nearest = nullptr;
  double distance = std::numeric_limits<double>::infinity();
  for (const SpectrumRecord& record : records) {
    const auto stamp = parseIsoTime(record.time);
    if (!stamp) continue;
    const double seconds = std::abs(std::chrono::duration<double>(*stamp - *wanted).count());
    if (seconds < distance) {
      distance = seconds;
      nearest = &record;
    }
  }
  if (!nearest || distance > tolerance) {
    throw InputError(records.empty() ? "--time" : records.front().file, 0,
                     "--time " + time + ": no record within " +
                         std::to_string(static_cast<int>(tolerance / 60)) + " minutes");
  }
  return *nearest;
}

const SpectrumRecord& recordNumber(const std::vector<SpectrumRecord>& records, int number) {
  if (number < 0 || static_cast<std::size_t>(number) >= records.size()) {
    throw InputError(records.empty() ? "" : records.front().file, 0,
                     "--record: " + std::to_string(number) + " is not allowed; the file has " +
                         std::to_string(records.size()) + " records, from 0");
  }
  return records[static_cast<std::size_t>(number)];
}

void finishRecord(SpectrumRecord& record) {
  DirectionalSpectrum& spectrum = record.spectrum;
  if (spectrum.energy.frequency.size() < 2 && record.missingBins > 0) {
    spectrum = {};
    return;
  }
  if (const auto wrong = spectrum.validate()) throw InputError(record.file, record.line, *wrong);
  if (!(spectrum.energy.significantWaveHeight() < 100.0)) {
    throw InputError(record.file, record.line,
                     "H_m0 of its spectrum is " +
                         std::to_string(spectrum.energy.significantWaveHeight()) +
                         " m; must be < 100 m");
  }
}

DirectionalMoments momentsFromCompassFrom(double firstReal, double firstImaginary,
                                          double secondReal, double secondImaginary) {
  // e^(iθ) = −i e^(−iA), e^(2iθ) = −e^(−2iA).
  return {-firstImaginary, -firstReal, -secondReal, secondImaginary};
}

DirectionalMoments momentsOfMeanDirection(double from_deg, double r1) {
  const double toward = towardFromCompassFrom(from_deg);
  DirectionalMoments moments;
  moments.a1 = r1 * std::cos(toward);
  moments.b1 = r1 * std::sin(toward);
  return moments;
}

double r1OfSpread(double spread_deg) {
  const double spread = radiansFromDegrees(spread_deg);
  return 1.0 - 0.5 * spread * spread;
}

}  // namespace seaway
