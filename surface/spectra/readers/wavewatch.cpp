#include <cmath>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/text_cursor.h"
#include "surface/spectra/readers/time_stamp.h"

// WAVEWATCH III user manual, ww3_outp: transfer file of spectra (ITYPE 1, OTYPE 3). The header
// 'WAVEWATCH III SPECTRA' NK NTH points 'grid'; frequencies in Hz; directions in rad, clockwise
// from north, toward; then a time, and for every point 'name' latitude longitude depth wind-speed
// wind- direction current-speed current-direction and E(f, θ) in m²/Hz/rad, frequencies running
// fastest.
namespace seaway::formats {
namespace {

constexpr std::string_view signature = "'WAVEWATCH III SPECTRA'";

struct Header {
  std::vector<double> frequencies;
  DirectionGrid grid;
  int points = 0;
};

std::vector<double> takeNumbers(TextCursor& cursor, int count, const std::string& wanted) {
  std::vector<double> numbers;
  for (int i = 0; i < count; ++i) numbers.push_back(cursor.takeNumber(wanted));
  cursor.requireLineEnd("the last " + wanted);
  return numbers;
}

Header readHeader(TextCursor& cursor) {
  const std::string_view line = cursor.requireLine(std::string(signature));
  const std::size_t start = line.find(signature);
  if (start == std::string_view::npos) cursor.fail("must start with " + std::string(signature));
  const auto words = splitWords(line.substr(start + signature.size()));
  if (words.size() < 3) {
    cursor.fail("must give the numbers of frequencies, directions and points");
  }
  Header header;
  const int frequencies = cursor.wholeNumber(words[0], "number of frequencies", 2, 100000);
  const int directions = cursor.wholeNumber(words[1], "number of directions", 3, 3600);
  header.points = cursor.wholeNumber(words[2], "number of points", 1, 100000);
  cursor.skipRestOfLine();
  header.frequencies = takeNumbers(cursor, frequencies, "frequency");
  requireRisingFrequencies(header.frequencies, cursor);
  std::vector<double> toward = takeNumbers(cursor, directions, "direction");
  for (double& direction : toward) direction = 0.5 * pi - direction;
  header.grid = DirectionGrid(toward, cursor);
  return header;
}

/// 20141215 000000
std::string timeOf(TextCursor& cursor) {
  const std::string_view date = cursor.takeWord("a date");
  const int day = cursor.wholeNumber(date, "date", 0, 99991231);
  const int clock = cursor.wholeNumber(cursor.takeWord("a time"), "time", 0, 235959);
  cursor.requireLineEnd("the time");
  const auto time = isoTime(day / 10000, day / 100 % 100, day % 100, clock / 10000,
                            clock / 100 % 100, clock % 100);
  if (!time) cursor.fail("not a date and time");
  return *time;
}

/// Words of a point's line, where fixed columns may have run together: "  34.00-117.00".
std::vector<std::string_view> pointWords(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::string_view word : splitWords(text)) {
    for (std::size_t sign = word.find('-', 1); sign != std::string_view::npos;
         sign = word.find('-', 1)) {
      if (word[sign - 1] == 'E' || word[sign - 1] == 'e') break;
      words.push_back(word.substr(0, sign));
      word.remove_prefix(sign);
    }
    words.push_back(word);
  }
  return words;
}

void readPoint(TextCursor& cursor, SpectrumRecord& record) {
  const std::string_view line = cursor.requireLine("a point's name");
  const std::size_t open = line.find('\'');
  const std::size_t close = open == std::string_view::npos ? open : line.find('\'', open + 1);
  if (close == std::string_view::npos) cursor.fail("must be a point's name in quotes and place");
  record.file = cursor.fileName();
  record.line = cursor.lineNumber();
  const std::string_view name = line.substr(open + 1, close - open - 1);
  record.location = name.substr(0, name.find_last_not_of(' ') + 1);
  const auto words = pointWords(line.substr(close + 1));
  if (words.size() < 3) cursor.fail("a point must give latitude, longitude and depth");
  const RecordPosition position{cursor.number(words[0], "latitude"),
                                cursor.number(words[1], "longitude")};
  if (std::abs(position.latitude_deg) > 90.0 || std::abs(position.longitude_deg) > 360.0) {
    cursor.fail("latitude and longitude must be in [-90, 90] and [-360, 360] deg");
  }
  record.position = position;
  const double depth = cursor.number(words[2], "depth");
  if (depth > 0.0) record.depth = depth;
  cursor.skipRestOfLine();
}

SpectrumRecord readRecord(TextCursor& cursor, const Header& header) {
  SpectrumRecord record;
  readPoint(cursor, record);
  const std::size_t bins = header.frequencies.size();
  const std::size_t columns = header.grid.fileColumns();
  std::vector<double> density;
  for (std::size_t i = 0; i < bins * columns; ++i) {
    density.push_back(cursor.takeNumber("a density"));
    if (density.back() < 0.0) cursor.fail("a density below 0 is not allowed");
  }
  cursor.requireLineEnd("the spectrum");
  std::vector<double> row(columns);
  for (std::size_t f = 0; f < bins; ++f) {
    for (std::size_t d = 0; d < columns; ++d) row[d] = density[d * bins + f];
    header.grid.addRow(header.frequencies[f], row, record.spectrum);
  }
  record.spectrum.integrateGrid();
  return record;
}

}  // namespace

bool looksLikeWavewatch(const TextFile& file) {
  TextCursor cursor(file);
  return cursor.nextLine() && cursor.line().find(signature) != std::string_view::npos;
}

std::vector<SpectrumRecord> readWavewatch(const TextFile& file) {
  TextCursor cursor(file);
  const Header header = readHeader(cursor);
  std::vector<SpectrumRecord> records;
  do {
    const std::string time = timeOf(cursor);
    for (int point = 0; point < header.points; ++point) {
      records.push_back(readRecord(cursor, header));
      records.back().time = time;
    }
  } while (!cursor.atEnd());
  return records;
}

}  // namespace seaway::formats
