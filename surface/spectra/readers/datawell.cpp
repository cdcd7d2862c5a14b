#include <cmath>
#include <filesystem>

#include "surface/angles.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/text_cursor.h"
#include "surface/spectra/readers/time_stamp.h"

// Datawell Waverider reference manual, "Spectrum file": 12 lines of one number (transmission index,
// H_m0 in cm, T_z in s, S_max in m²/Hz, temperatures, battery, accelerometer offsets, compass,
// field inclination), then 64 lines: frequency (Hz), S/S_max, direction (deg, from), spread (deg),
// skewness, kurtosis, with commas. The time stands in the file's name: NAME}2015-01-31T23h30.spt.
namespace seaway::formats {
namespace {

constexpr int headerLines = 12;
constexpr std::size_t bins = 64;

/// The first YYYY-MM-DDThhhmm in the file's name; empty where there is none.
std::string timeOf(const std::string& fileName) {
  constexpr std::size_t length = 16;
  const std::string name = std::filesystem::path(fileName).filename().string();
  for (std::size_t at = 0; at + length <= name.size(); ++at) {
    std::string candidate = name.substr(at, length);
    if (candidate[13] != 'h') continue;
    candidate[13] = ':';
    if (const auto moment = parseIsoTime(candidate)) return isoTime(*moment);
  }
  return "";
}

/// Circular skewness and kurtosis back to the centred second moments m₂ and n₂ (Kuik et al. 1988):
/// skewness = −n₂/((1 − m₂)/2)^(3/2), kurtosis = (6 − 8 m₁ + 2 m₂)/(2 (1 − m₁))².
struct CentredSecond {
  double m2 = 0.0;
  double n2 = 0.0;
};

CentredSecond centredSecond(double m1, double skewness, double kurtosis) {
  const double m2 = 2.0 * kurtosis * (1.0 - m1) * (1.0 - m1) - 3.0 + 4.0 * m1;
  const double half = std::fmax(0.0, 0.5 * (1.0 - m2));
  return {m2, -skewness * half * std::sqrt(half)};
}

struct Row {
  double frequency, share, from_deg, spread_deg, skewness, kurtosis;
};

Row readRow(TextCursor& cursor) {
  constexpr const char* names[] = {"frequency", "S/Smax",   "direction",
                                   "spread",    "skewness", "kurtosis"};
  const auto words = splitWords(cursor.requireLine("64 lines of frequencies"), ",");
  if (words.size() != 6) {
    cursor.fail("must hold frequency, S/Smax, direction, spread, skewness and kurtosis");
  }
  double value[6];
  for (std::size_t i = 0; i < 6; ++i) value[i] = cursor.number(words[i], names[i]);
  const Row row{value[0], value[1], value[2], value[3], value[4], value[5]};
  if (row.share < 0.0 || row.share > 1.01) {
    cursor.fail("S/Smax " + std::string(words[1]) + " is not allowed; must be in [0, 1]");
  }
  if (std::abs(row.from_deg) > 360.0) {
    cursor.fail("direction " + std::string(words[2]) +
                " is not allowed; must be in [-360, 360] deg");
  }
  // √2 rad is the spread of waves from everywhere.
  if (row.spread_deg < 0.0 || row.spread_deg > 81.1) {
    cursor.fail("spread " + std::string(words[3]) + " is not allowed; must be in [0, 81] deg");
  }
  return row;
}

/// The moments; `lost` counts second ones beyond what a distribution can have.
DirectionalMoments momentsOf(const Row& row, std::size_t& lost) {
  const double m1 = std::fmax(0.0, r1OfSpread(row.spread_deg));
  const CentredSecond second = centredSecond(m1, row.skewness, row.kurtosis);
  if (std::hypot(second.m2, second.n2) > 1.0) {
    ++lost;
    return momentsOfMeanDirection(row.from_deg, m1);
  }
  const double mean = radiansFromDegrees(row.from_deg);
  const double c2 = std::cos(2.0 * mean);
  const double s2 = std::sin(2.0 * mean);
  return momentsFromCompassFrom(m1 * std::cos(mean), m1 * std::sin(mean),
                                second.m2 * c2 - second.n2 * s2, second.m2 * s2 + second.n2 * c2);
}

/// S_max, from the header; `hm0` gets the file's own H_m0 in m.
double readHeader(TextCursor& cursor, double& hm0) {
  double highest = 0.0;
  for (int i = 1; i <= headerLines; ++i) {
    const auto words = splitWords(cursor.requireLine("12 lines of single numbers"), ",");
    if (words.size() != 1) cursor.fail("line " + std::to_string(i) + " of 12 must hold one number");
    if (i == 2) hm0 = 0.01 * cursor.number(words[0], "Hm0");
    if (i == 4) highest = cursor.number(words[0], "Smax");
  }
  if (highest < 0.0) cursor.fail("Smax below 0 is not allowed");
  return highest;
}

void noteOddities(SpectrumRecord& record, double hm0, std::size_t lost) {
  if (record.time.empty()) record.notes.push_back("the file's name gives no time");
  record.notes.push_back(
      "directions are relative to the buoy's compass: magnetic north unless corrected there");
  if (lost > 0) {
    record.notes.push_back(std::to_string(lost) +
                           " frequencies: skewness and kurtosis fit no distribution, not used");
  }
  // Its own integral is a sum over its bands; the trapezoid differs by a few percent.
  const double ours = record.spectrum.energy.significantWaveHeight();
  if (std::abs(ours - hm0) > 0.1 * hm0) {
    record.notes.push_back("H_m0 is " + std::to_string(hm0) + " m by its header, " +
                           std::to_string(ours) + " m by its spectrum");
  }
}

}  // namespace

bool looksLikeDatawell(const TextFile& file) {
  TextCursor cursor(file);
  for (int i = 0; i < headerLines; ++i) {
    if (!cursor.nextLine() || splitWords(cursor.line(), ",").size() != 1) return false;
  }
  return cursor.nextLine() && splitWords(cursor.line(), ",").size() == 6;
}

std::vector<SpectrumRecord> readDatawell(const TextFile& file) {
  TextCursor cursor(file);
  double hm0 = 0.0;
  const double highest = readHeader(cursor, hm0);
  SpectrumRecord record;
  record.file = file.name;
  record.line = 1;
  record.time = timeOf(file.name);
  std::size_t lost = 0;
  for (std::size_t bin = 0; bin < bins; ++bin) {
    const Row row = readRow(cursor);
    record.spectrum.energy.frequency.push_back(row.frequency);
    record.spectrum.energy.density.push_back(row.share * highest);
    record.spectrum.moments.push_back(momentsOf(row, lost));
  }
  cursor.skipRestOfLine();
  requireRisingFrequencies(record.spectrum.energy.frequency, cursor);
  if (!cursor.atEnd()) cursor.fail("more than 64 frequencies are not allowed");
  noteOddities(record, hm0, lost);
  return {record};
}

}  // namespace seaway::formats
