#include "surface/spectra/ndbc.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iomanip>
#include <limits>
#include <sstream>
#include <string_view>

#include "surface/input_error.h"

namespace seaway {
namespace {

/// Where a parser stands: for messages.
struct Place {
  std::string file;
  int line;
  [[noreturn]] void fail(const std::string& what) const { throw InputError(file, line, what); }
};

std::vector<std::string_view> splitWords(std::string_view text) {
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  for (std::size_t at = text.find_first_not_of(blanks); at != std::string_view::npos;
       at = text.find_first_not_of(blanks, at)) {
    const std::size_t end = std::min(text.find_first_of(blanks, at), text.size());
    words.push_back(text.substr(at, end - at));
    at = end;
  }
  return words;
}

double number(std::string_view word, const Place& place) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(value)) {
    place.fail("'" + std::string(word) + "' is not a number");
  }
  return value;
}

std::chrono::sys_time<std::chrono::minutes> minuteOf(int year, int month, int day, int hour,
                                                     int minute, const Place& place) {
  using namespace std::chrono;
  const year_month_day date{std::chrono::year(year), std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  const bool valid = date.ok() && hour >= 0 && hour < 24 && minute >= 0 && minute < 60;
  if (!valid) place.fail("not a date and time");
  return sys_days(date) + hours(hour) + minutes(minute);
}

std::chrono::sys_time<std::chrono::minutes> parseIso(const std::string& time, const Place& place) {
  std::tm tm{};
  std::istringstream stream(time);
  stream >> std::get_time(&tm, "%Y-%m-%dT%H:%M");
  if (stream.fail()) {
    place.fail("time '" + time + "' is not of the form 2020-06-08T03:50");
  }
  return minuteOf(tm.tm_year + 1900, tm.tm_mon + 1, tm.tm_mday, tm.tm_hour, tm.tm_min, place);
}

std::string isoTime(const std::vector<std::string_view>& words, const Place& place) {
  int field[5];
  for (int i = 0; i < 5; ++i) field[i] = static_cast<int>(number(words[static_cast<std::size_t>(i)], place));
  if (field[0] < 100) field[0] += field[0] < 70 ? 2000 : 1900;  // NDBC's old two-digit years
  minuteOf(field[0], field[1], field[2], field[3], field[4], place);
  char text[32];
  std::snprintf(text, sizeof text, "%04d-%02d-%02dT%02d:%02dZ", field[0], field[1], field[2],
                field[3], field[4]);
  return text;
}

SpectrumRecord parseRecord(std::string_view line, const Place& place) {
  const std::vector<std::string_view> words = splitWords(line);
  if (words.size() < 10 || words.size() % 2 != 0) {
    place.fail("expected date, time, separation frequency, then pairs of density and (frequency)");
  }
  SpectrumRecord record;
  record.line = place.line;
  record.time = isoTime(words, place);
  const double separation = number(words[5], place);
  if (separation < 9.0) record.separationFrequency = separation;
  for (std::size_t i = 6; i < words.size(); i += 2) {
    const std::string_view bracketed = words[i + 1];
    if (bracketed.size() < 3 || bracketed.front() != '(' || bracketed.back() != ')') {
      place.fail("'" + std::string(bracketed) + "' is not a frequency in parentheses");
    }
    const double density = number(words[i], place);
    if (density >= 999.0) {
      ++record.missingBins;
      continue;
    }
    record.spectrum.density.push_back(density);
    record.spectrum.frequency.push_back(number(bracketed.substr(1, bracketed.size() - 2), place));
  }
  const bool allMissing = record.missingBins > 0 && record.spectrum.frequency.size() < 2;
  if (allMissing) return record;
  if (const auto problem = record.spectrum.validate()) place.fail(*problem);
  return record;
}

}  // namespace

std::vector<SpectrumRecord> readNdbcSpectralDensity(const std::filesystem::path& path) {
  Place place{path.string(), 0};
  std::ifstream file(path);
  if (!file || std::filesystem::is_directory(path)) place.fail("cannot be read");
  std::vector<SpectrumRecord> records;
  std::string line;
  while (std::getline(file, line)) {
    ++place.line;
    const std::size_t start = line.find_first_not_of(" \t\r");
    if (start == std::string::npos || line[start] == '#') continue;
    records.push_back(parseRecord(line, place));
    const auto bins = [](const SpectrumRecord& r) { return r.spectrum.frequency.size() + r.missingBins; };
    if (bins(records.back()) != bins(records.front())) {
      place.fail("has " + std::to_string(bins(records.back())) + " frequencies where the first record has " +
                 std::to_string(bins(records.front())));
    }
  }
  place.line = 0;
  if (records.empty()) place.fail("holds no spectrum");
  return records;
}

const SpectrumRecord& recordAt(const std::vector<SpectrumRecord>& records, const std::string& time,
                               double tolerance) {
  const auto wanted = parseIso(time, Place{"--time", 0});
  const SpectrumRecord* nearest = nullptr;
  double distance = std::numeric_limits<double>::infinity();
  for (const SpectrumRecord& record : records) {
    const auto stamp = parseIso(record.time, Place{"record", record.line});
    const double seconds = std::abs(std::chrono::duration<double>(stamp - wanted).count());
    if (seconds < distance) {
      distance = seconds;
      nearest = &record;
    }
  }
  if (!nearest || distance > tolerance) {
    throw InputError("no record within " + std::to_string(static_cast<int>(tolerance / 60)) +
                     " minutes of " + time);
  }
  return *nearest;
}

}  // namespace seaway
