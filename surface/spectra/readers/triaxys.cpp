#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <map>

#include "surface/angles.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/text_cursor.h"
#include "surface/spectra/readers/time_stamp.h"

// AXYS TRIAXYS processed files: TRIAXYS BUOY [DATA] REPORT, lines KEY = VALUE, then for a
// directional spectrum one row a frequency of densities (m²/Hz/deg) at 0…360 deg (from; both ends),
// for a non-directional one rows of frequency and density (m²/Hz).
namespace seaway::formats {
namespace {

using Keys = std::map<std::string, std::string>;

std::string trimmed(std::string_view text) {
  const std::size_t start = text.find_first_not_of(" \t\r");
  if (start == std::string_view::npos) return "";
  return std::string(text.substr(start, text.find_last_not_of(" \t\r") + 1 - start));
}

/// The header up to its last line, ROWS or COLUMN 2; keys without a unit in parentheses.
Keys readKeys(TextCursor& cursor) {
  Keys keys;
  while (true) {
    const std::string_view line = cursor.requireLine("its header's last line, ROWS or COLUMN 2");
    const std::size_t equals = line.find('=');
    if (equals == std::string_view::npos) {
      if (line.find("TRIAXYS") != std::string_view::npos) continue;
      cursor.fail("must be of the form KEY = VALUE");
    }
    std::string_view key = line.substr(0, equals);
    key = key.substr(0, key.find('('));
    const std::string name = trimmed(key);
    keys[name] = trimmed(line.substr(equals + 1));
    if (name == "ROWS" || name == "COLUMN 2") {
      cursor.skipRestOfLine();
      return keys;
    }
  }
}

const std::string& required(const Keys& keys, const std::string& name, const TextCursor& cursor) {
  const auto found = keys.find(name);
  if (found == keys.end()) cursor.fail("its header lacks '" + name + "'");
  return found->second;
}

/// "2018 Feb 09 04:00(UTC)" or "2018-02-09 04:00:00(UTC)"; notes a time zone that is not named.
std::string timeOf(const std::string& text, const TextCursor& cursor, SpectrumRecord& record) {
  const std::size_t bracket = text.find('(');
  if (bracket == std::string::npos) {
    record.notes.push_back("the date names no time zone: taken as UTC");
  } else if (text.substr(bracket) != "(UTC)" && text.substr(bracket) != "(GMT)") {
    cursor.fail("time zone '" + text.substr(bracket, 20) + "' is not allowed; must be (UTC)");
  }
  const auto words = splitWords(std::string_view(text).substr(0, bracket));
  if (words.size() == 2) {
    const auto moment = parseIsoTime(std::string(words[0]) + "T" + std::string(words[1]));
    if (moment) return isoTime(*moment);
  }
  if (words.size() == 4) {
    constexpr std::array<const char*, 12> months{"JAN", "FEB", "MAR", "APR", "MAY", "JUN",
                                                 "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"};
    std::string month(words[1]);
    for (char& c : month) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    const auto found = std::find(months.begin(), months.end(), month);
    const std::string number = std::to_string(found - months.begin() + 1);
    const std::string day(words[2]);
    const auto moment =
        parseIsoTime(std::string(words[0]) + "-" + (number.size() < 2 ? "0" : "") + number + "-" +
                     (day.size() < 2 ? "0" : "") + day + "T" + std::string(words[3]));
    if (moment) return isoTime(*moment);
  }
  cursor.fail("DATE '" + text.substr(0, 40) + "' is not of the form 2018 Feb 09 04:00(UTC)");
}

struct Frequencies {
  double initial = 0.0;
  double spacing = 0.0;
  int count = 0;
  double at(int row) const { return initial + spacing * row; }
};

Frequencies frequenciesOf(const Keys& keys, const TextCursor& cursor) {
  Frequencies frequencies;
  const auto number = [&](const char* key) {
    return cursor.number(required(keys, key, cursor), key);
  };
  frequencies.count = cursor.wholeNumber(required(keys, "NUMBER OF FREQUENCIES", cursor),
                                         "NUMBER OF FREQUENCIES", 2, 100000);
  frequencies.initial = number("INITIAL FREQUENCY");
  frequencies.spacing = number("FREQUENCY SPACING");
  if (!(frequencies.spacing > 0.0) || frequencies.initial < 0.0 ||
      frequencies.at(frequencies.count) > 100.0) {
    cursor.fail("INITIAL FREQUENCY and FREQUENCY SPACING must be >= 0 and > 0, in (0, 100] Hz");
  }
  return frequencies;
}

DirectionGrid gridOf(const Keys& keys, const TextCursor& cursor) {
  const double spacing =
      cursor.number(required(keys, "DIRECTION SPACING", cursor), "DIRECTION SPACING");
  const int columns = cursor.wholeNumber(required(keys, "NUMBER OF DIRECTIONS", cursor),
                                         "NUMBER OF DIRECTIONS", 4, 3601);
  if (std::abs(spacing * (columns - 1) - 360.0) > 0.01) {
    cursor.fail("NUMBER OF DIRECTIONS and DIRECTION SPACING must make 0 to 360 deg");
  }
  std::vector<double> toward;
  for (int i = 0; i + 1 < columns; ++i) toward.push_back(towardFromCompassFrom(spacing * i));
  return DirectionGrid(toward, cursor);
}

double takeDensity(TextCursor& cursor) {
  const double density = cursor.takeNumber("a density");
  if (density < 0.0) cursor.fail("a density below 0 is not allowed");
  return density;
}

void readDirectional(TextCursor& cursor, const Keys& keys, SpectrumRecord& record) {
  const Frequencies frequencies = frequenciesOf(keys, cursor);
  const DirectionGrid grid = gridOf(keys, cursor);
  std::vector<double> row(grid.fileColumns());
  for (int i = 0; i < frequencies.count; ++i) {
    for (double& density : row) density = takeDensity(cursor) * (180.0 / pi);
    takeDensity(cursor);  // 360 deg is 0 deg again
    cursor.requireLineEnd("the densities of a frequency");
    if (frequencies.at(i) > 0.0) grid.addRow(frequencies.at(i), row, record.spectrum);
  }
  record.spectrum.integrateGrid();
  record.notes.push_back(
      "densities taken as m2/Hz/deg, directions as from true north: the file "
      "states neither");
}

void readNonDirectional(TextCursor& cursor, const Keys& keys, SpectrumRecord& record) {
  const int count = cursor.wholeNumber(required(keys, "NUMBER OF FREQUENCIES", cursor),
                                       "NUMBER OF FREQUENCIES", 2, 100000);
  for (int i = 0; i < count; ++i) {
    const double frequency = cursor.takeNumber("a frequency");
    const double density = takeDensity(cursor);
    cursor.requireLineEnd("frequency and density");
    if (i == 0 && frequency == 0.0) continue;
    record.spectrum.energy.frequency.push_back(frequency);
    record.spectrum.energy.density.push_back(density);
  }
  requireRisingFrequencies(record.spectrum.energy.frequency, cursor);
}

}  // namespace

bool looksLikeTriaxys(const TextFile& file) {
  TextCursor cursor(file);
  return cursor.nextLine() && cursor.line().find("TRIAXYS") != std::string_view::npos &&
         cursor.line().find("REPORT") != std::string_view::npos;
}

std::vector<SpectrumRecord> readTriaxys(const TextFile& file) {
  TextCursor cursor(file);
  if (!looksLikeTriaxys(file)) {
    cursor.nextLine();
    cursor.fail("must start with TRIAXYS BUOY DATA REPORT");
  }
  SpectrumRecord record;
  record.file = file.name;
  record.line = 1;
  const Keys keys = readKeys(cursor);
  record.time = timeOf(required(keys, "DATE", cursor), cursor, record);
  const std::string& type = required(keys, "TYPE", cursor);
  if (type == "DIRECTIONAL SPECTRUM") {
    readDirectional(cursor, keys, record);
  } else if (type == "NON-DIRECTIONAL SPECTRUM") {
    readNonDirectional(cursor, keys, record);
  } else {
    cursor.fail("TYPE '" + type.substr(0, 40) +
                "' is not allowed; must be DIRECTIONAL SPECTRUM or NON-DIRECTIONAL SPECTRUM");
  }
  if (!cursor.atEnd()) cursor.fail("more follows than NUMBER OF FREQUENCIES says");
  return {record};
}

}  // namespace seaway::formats
