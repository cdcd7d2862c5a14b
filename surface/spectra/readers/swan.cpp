#include <cmath>
#include <limits>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/text_cursor.h"
#include "surface/spectra/readers/time_stamp.h"

// SWAN user manual, appendix "Spectrum files, input and output".
namespace seaway::formats {
namespace {

constexpr int mostLocations = 100000;
constexpr int mostBins = 100000;

struct Quantity {
  std::string name;
  double toOurUnit = 1.0;
  double exception = 0.0;
};

struct Location {
  double x = 0.0;
  double y = 0.0;
};

struct Header {
  bool timeDependent = false;
  bool geographic = false;
  bool relativeFrequency = false;
  std::vector<Location> locations;
  std::vector<double> frequencies;
  bool twoDimensional = false;
  bool nautical = false;
  DirectionGrid grid;
  std::vector<Quantity> quantities;
};

/// The first word of the next line that is neither blank nor a comment.
std::string_view headerWord(TextCursor& cursor, const std::string& wanted) {
  while (true) {
    cursor.requireLine(wanted);
    if (!cursor.line().starts_with('$')) return cursor.takeWord(wanted);
  }
}

double headerNumber(TextCursor& cursor, const std::string& wanted) {
  return cursor.number(headerWord(cursor, wanted), wanted);
}

int headerCount(TextCursor& cursor, const std::string& wanted, int most) {
  return cursor.wholeNumber(headerWord(cursor, wanted), wanted, 1, most);
}

std::vector<double> headerList(TextCursor& cursor, const std::string& what) {
  const int count = headerCount(cursor, "the number of " + what, mostBins);
  std::vector<double> list;
  for (int i = 0; i < count; ++i) list.push_back(headerNumber(cursor, what));
  return list;
}

void readLocations(TextCursor& cursor, Header& header) {
  const int count = headerCount(cursor, "the number of locations", mostLocations);
  for (int i = 0; i < count; ++i) {
    const double x = headerNumber(cursor, "a location");
    header.locations.push_back({x, cursor.takeNumber("a location")});
  }
}

void readDirections(TextCursor& cursor, Header& header) {
  std::vector<double> toward;
  for (const double degrees : headerList(cursor, "directions")) {
    toward.push_back(header.nautical ? towardFromCompassFrom(degrees)
                                     : radiansFromDegrees(degrees));
  }
  header.twoDimensional = true;
  header.grid = DirectionGrid(toward, cursor);
}

double densityUnit(std::string_view unit, const TextCursor& cursor) {
  // SWAN's own defaults turn J back into m².
  constexpr double swanWeight = 1025.0 * 9.81;
  if (unit == "m2/Hz") return 1.0;
  if (unit == "m2/Hz/degr") return 180.0 / pi;
  if (unit == "J/m2/Hz") return 1.0 / swanWeight;
  if (unit == "J/m2/Hz/degr") return 180.0 / pi / swanWeight;
  cursor.fail("unit '" + std::string(unit.substr(0, 40)) +
              "' is not allowed; must be one of: m2/Hz/degr, J/m2/Hz/degr, m2/Hz, J/m2/Hz");
}

void readQuantities(TextCursor& cursor, Header& header) {
  const int count = headerCount(cursor, "the number of quantities", 20);
  for (int i = 0; i < count; ++i) {
    Quantity quantity;
    quantity.name = headerWord(cursor, "a quantity's name");
    const std::string_view unit = headerWord(cursor, "a quantity's unit");
    if (i == 0) quantity.toOurUnit = densityUnit(unit, cursor);
    quantity.exception = headerNumber(cursor, "a quantity's exception value");
    header.quantities.push_back(quantity);
  }
  const std::string& first = header.quantities.front().name;
  if (first != "VaDens" && first != "EnDens") {
    cursor.fail("quantity '" + first.substr(0, 40) + "' is not allowed; must be VaDens or EnDens");
  }
  if (header.twoDimensional && count != 1) cursor.fail("a 2-D file must hold one quantity");
}

/// Everything up to the quantities, in the file's own order of keywords.
Header readHeader(TextCursor& cursor) {
  Header header;
  const std::string_view version = headerWord(cursor, "SWAN and a version");
  if (version != "SWAN") cursor.fail("must start with SWAN");
  while (header.quantities.empty()) {
    const std::string keyword(headerWord(cursor, "QUANT"));
    if (keyword == "TIME") {
      cursor.wholeNumber(headerWord(cursor, "the time coding"), "the time coding", 1, 1);
      header.timeDependent = true;
    } else if (keyword == "LOCATIONS" || keyword == "LONLAT") {
      header.geographic = keyword == "LONLAT";
      readLocations(cursor, header);
    } else if (keyword == "AFREQ" || keyword == "RFREQ") {
      header.relativeFrequency = keyword == "RFREQ";
      header.frequencies = headerList(cursor, "frequencies");
      requireRisingFrequencies(header.frequencies, cursor);
    } else if (keyword == "NDIR" || keyword == "CDIR") {
      header.nautical = keyword == "NDIR";
      readDirections(cursor, header);
    } else if (keyword == "QUANT") {
      readQuantities(cursor, header);
    } else {
      cursor.fail("keyword '" + keyword.substr(0, 40) +
                  "' is not allowed; must be one of: TIME, LOCATIONS, LONLAT, AFREQ, RFREQ, NDIR, "
                  "CDIR, QUANT");
    }
  }
  if (header.locations.empty()) cursor.fail("LOCATIONS or LONLAT must come before QUANT");
  if (header.frequencies.size() < 2)
    cursor.fail("AFREQ or RFREQ with 2 frequencies must come before QUANT");
  return header;
}

/// 20161011.000000
std::string timeOf(std::string_view word, const TextCursor& cursor) {
  const auto digits = [&](std::size_t at, std::size_t count) {
    return cursor.wholeNumber(word.substr(at, count), "time", 0, 9999);
  };
  if (word.size() == 15 && word[8] == '.') {
    const auto time = isoTime(digits(0, 4), digits(4, 2), digits(6, 2), digits(9, 2), digits(11, 2),
                              digits(13, 2));
    if (time) return *time;
  }
  cursor.fail("time '" + std::string(word.substr(0, 40)) + "' is not of the form 20161011.000000");
}

/// A 2-D block: one row of directions a frequency, whole numbers times a factor.
void readGrid(TextCursor& cursor, const Header& header, double factor, SpectrumRecord& record) {
  const double scale = factor * header.quantities.front().toOurUnit;
  const double exception = header.quantities.front().exception;
  std::vector<double> row(header.grid.fileColumns());
  record.spectrum.direction = header.grid.directions();
  for (const double frequency : header.frequencies) {
    std::size_t missing = 0;
    for (double& density : row) {
      const double value = cursor.takeNumber("a density");
      const bool isMissing = value == exception;
      missing += isMissing ? 1 : 0;
      if (value < 0.0 && !isMissing) cursor.fail("a density below 0 is not allowed");
      density = value * scale;
    }
    cursor.requireLineEnd("the densities of a frequency");
    record.missingBins += missing;
    if (missing == 0) header.grid.addRow(frequency, row, record.spectrum);
  }
  record.spectrum.integrateGrid();
}

/// A 1-D block: a frequency a line, its quantities in columns.
void readColumns(TextCursor& cursor, const Header& header, SpectrumRecord& record) {
  constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
  DirectionalSpectrum& spectrum = record.spectrum;
  for (const double frequency : header.frequencies) {
    double density = unknown;
    double toward = unknown;
    double spread_deg = unknown;
    for (const Quantity& quantity : header.quantities) {
      const double value = cursor.takeNumber(quantity.name);
      if (value == quantity.exception) continue;
      if (&quantity == &header.quantities.front()) density = value * quantity.toOurUnit;
      if (quantity.name == "NDIR") toward = towardFromCompassFrom(value);
      if (quantity.name == "CDIR") toward = radiansFromDegrees(value);
      if (quantity.name == "DSPRDEGR") spread_deg = value;
    }
    cursor.requireLineEnd("the quantities of a frequency");
    if (std::isnan(density)) {
      ++record.missingBins;
      continue;
    }
    const double r1 = r1OfSpread(spread_deg);
    if (r1 < 0.0 || spread_deg < 0.0) {
      cursor.fail("a directional spread outside [0, 81] deg is not allowed");
    }
    spectrum.energy.frequency.push_back(frequency);
    spectrum.energy.density.push_back(density);
    DirectionalMoments moments;
    moments.a1 = r1 * std::cos(toward);
    moments.b1 = r1 * std::sin(toward);
    spectrum.moments.push_back(moments);
  }
}

void place(const Header& header, std::size_t index, SpectrumRecord& record,
           const TextCursor& cursor) {
  const Location& at = header.locations[index];
  record.location = std::to_string(index + 1);
  if (!header.geographic) {
    record.notes.push_back("at x " + std::to_string(at.x) + " m, y " + std::to_string(at.y) +
                           " m of the model's own plane");
    return;
  }
  if (std::abs(at.y) > 90.0 || std::abs(at.x) > 360.0) {
    cursor.fail("location " + record.location + " is no longitude and latitude");
  }
  record.position = RecordPosition{at.y, at.x};
}

SpectrumRecord readBlock(TextCursor& cursor, const Header& header, std::size_t location) {
  SpectrumRecord record;
  const std::string keyword(headerWord(cursor, "FACTOR, LOCATION, ZERO or NODATA"));
  record.file = cursor.fileName();
  record.line = cursor.lineNumber();
  place(header, location, record, cursor);
  if (header.relativeFrequency) {
    record.notes.push_back("frequencies are those in the frame of the current (RFREQ)");
  }
  if (header.twoDimensional && header.grid.wasSector()) {
    record.notes.push_back("the file gives a sector of directions; no energy outside it");
  }
  if (keyword == "FACTOR" && header.twoDimensional) {
    const double factor = headerNumber(cursor, "the factor");
    if (factor < 0.0) cursor.fail("a factor below 0 is not allowed");
    cursor.nextLine();
    readGrid(cursor, header, factor, record);
  } else if (keyword == "LOCATION" && !header.twoDimensional) {
    cursor.nextLine();
    readColumns(cursor, header, record);
  } else if (keyword == "ZERO") {
    const std::vector<double> calm(header.grid.fileColumns(), 0.0);
    for (const double frequency : header.frequencies) {
      if (header.twoDimensional) {
        header.grid.addRow(frequency, calm, record.spectrum);
      } else {
        record.spectrum.energy.frequency.push_back(frequency);
        record.spectrum.energy.density.push_back(0.0);
      }
    }
    if (header.twoDimensional) record.spectrum.integrateGrid();
    cursor.skipRestOfLine();
  } else if (keyword == "NODATA") {
    record.missingBins = header.frequencies.size();
    record.notes.push_back("NODATA: the model has no spectrum here");
    cursor.skipRestOfLine();
  } else {
    cursor.fail("'" + keyword.substr(0, 40) + "' is not allowed; must be one of: " +
                (header.twoDimensional ? "FACTOR" : "LOCATION") + ", ZERO, NODATA");
  }
  return record;
}

}  // namespace

bool looksLikeSwan(const TextFile& file) {
  TextCursor cursor(file);
  if (!cursor.nextLine()) return false;
  const auto words = splitWords(cursor.line());
  return !words.empty() && words.front() == "SWAN";
}

std::vector<SpectrumRecord> readSwan(const TextFile& file) {
  TextCursor cursor(file);
  const Header header = readHeader(cursor);
  std::vector<SpectrumRecord> records;
  bool first = true;
  while (first || !cursor.atEnd()) {
    first = false;
    std::string time;
    if (header.timeDependent) time = timeOf(headerWord(cursor, "a time"), cursor);
    for (std::size_t i = 0; i < header.locations.size(); ++i) {
      records.push_back(readBlock(cursor, header, i));
      records.back().time = time;
    }
    if (!header.timeDependent) {
      if (!cursor.atEnd()) cursor.fail("more follows than its locations; TIME is not given");
      break;
    }
  }
  return records;
}

}  // namespace seaway::formats
