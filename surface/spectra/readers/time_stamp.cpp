#include "surface/spectra/readers/time_stamp.h"

#include <charconv>
#include <cstdio>

namespace seaway {
namespace {

using std::chrono::sys_seconds;

std::optional<sys_seconds> momentOf(int year, int month, int day, int hour, int minute,
                                    int second) {
  using namespace std::chrono;
  const year_month_day date{std::chrono::year(year),
                            std::chrono::month(static_cast<unsigned>(month)),
                            std::chrono::day(static_cast<unsigned>(day))};
  const bool valid = year >= 1800 && year <= 9999 && month >= 1 && day >= 1 && date.ok() &&
                     hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 &&
                     second < 60;
  if (!valid) return std::nullopt;
  return sys_days(date) + hours(hour) + minutes(minute) + seconds(second);
}

/// Takes `digits` digits off the front of `text`.
std::optional<int> takeDigits(std::string_view& text, std::size_t digits) {
  int value = 0;
  if (text.size() < digits || text.front() == '-') return std::nullopt;
  const auto [stop, fault] = std::from_chars(text.data(), text.data() + digits, value);
  if (fault != std::errc{} || stop != text.data() + digits) return std::nullopt;
  text.remove_prefix(digits);
  return value;
}

bool takeCharacter(std::string_view& text, char wanted) {
  if (!text.starts_with(wanted)) return false;
  text.remove_prefix(1);
  return true;
}

}  // namespace

std::optional<std::string> isoTime(int year, int month, int day, int hour, int minute, int second) {
  const auto moment = momentOf(year, month, day, hour, minute, second);
  if (!moment) return std::nullopt;
  return isoTime(*moment);
}

std::string isoTime(std::chrono::sys_seconds moment) {
  using namespace std::chrono;
  const sys_days day = floor<days>(moment);
  const year_month_day date(day);
  const hh_mm_ss clock(moment - day);
  char text[48];
  const int length = std::snprintf(
      text, sizeof text, "%04d-%02u-%02uT%02d:%02d", static_cast<int>(date.year()),
      static_cast<unsigned>(date.month()), static_cast<unsigned>(date.day()),
      static_cast<int>(clock.hours().count()), static_cast<int>(clock.minutes().count()));
  std::string result(text, static_cast<std::size_t>(length));
  if (clock.seconds().count() != 0) {
    std::snprintf(text, sizeof text, ":%02d", static_cast<int>(clock.seconds().count()));
    result += text;
  }
  return result + 'Z';
}

std::optional<std::chrono::sys_seconds> parseIsoTime(std::string_view text) {
  int field[6] = {};
  constexpr char after[] = {'-', '-', 'T', ':'};
  for (int i = 0; i < 5; ++i) {
    const auto value = takeDigits(text, i == 0 ? 4 : 2);
    if (!value || (i < 4 && !takeCharacter(text, after[i]))) return std::nullopt;
    field[i] = *value;
  }
  if (takeCharacter(text, ':')) {
    const auto seconds = takeDigits(text, 2);
    if (!seconds) return std::nullopt;
    field[5] = *seconds;
    if (takeCharacter(text, '.')) {
      while (!text.empty() && text.front() >= '0' && text.front() <= '9') text.remove_prefix(1);
    }
  }
  takeCharacter(text, 'Z');
  if (!text.empty()) return std::nullopt;
  return momentOf(field[0], field[1], field[2], field[3], field[4], field[5]);
}

}  // namespace seaway
