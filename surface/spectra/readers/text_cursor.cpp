#include "surface/spectra/readers/text_cursor.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "surface/input_error.h"

namespace seaway {
namespace {

constexpr std::string_view blanks = " \t\r\f\v";

std::optional<double> plainNumber(std::string_view word) {
  double value = 0.0;
  const char* const end = word.data() + word.size();
  const auto [stop, fault] = std::from_chars(word.data(), end, value);
  if (fault != std::errc{} || stop != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// What a message shows of a word: a binary file may be one long word.
std::string shown(std::string_view word) {
  constexpr std::size_t most = 40;
  std::string text(word.substr(0, most));
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return word.size() > most ? text + "..." : text;
}

}  // namespace

std::optional<double> numberOf(std::string_view word) {
  if (word.starts_with('+')) word.remove_prefix(1);
  if (word.starts_with('+')) return std::nullopt;
  if (const auto plain = plainNumber(word)) return plain;
  std::string text(word.substr(0, 64));
  const std::size_t mantissa = text.find_first_not_of("-.0123456789");
  if (mantissa != std::string::npos && (text[mantissa] == 'D' || text[mantissa] == 'd')) {
    text[mantissa] = 'e';
  } else {
    // Fortran drops the letter of an exponent of three digits.
    const std::size_t sign = text.find_last_of("+-");
    if (sign == std::string::npos || sign == 0 || sign + 4 != text.size()) return std::nullopt;
    if (text.find('.') > sign) return std::nullopt;
    text.insert(sign, 1, 'e');
  }
  return plainNumber(text);
}

std::vector<std::string_view> splitWords(std::string_view line, std::string_view separators) {
  const std::string between = std::string(blanks) + std::string(separators);
  std::vector<std::string_view> words;
  for (std::size_t at = line.find_first_not_of(between); at != std::string_view::npos;
       at = line.find_first_not_of(between, at)) {
    const std::size_t end = std::min(line.find_first_of(between, at), line.size());
    words.push_back(line.substr(at, end - at));
    at = end;
  }
  return words;
}

bool TextCursor::nextLine() {
  const std::string_view text = file_.text;
  if (next_ >= text.size()) {
    line_ = {};
    at_ = 0;
    return false;
  }
  const std::size_t end = std::min(text.find('\n', next_), text.size());
  line_ = text.substr(next_, end - next_);
  if (line_.ends_with('\r')) line_.remove_suffix(1);
  next_ = std::min(end + 1, text.size());
  at_ = 0;
  ++number_;
  return true;
}

std::string_view TextCursor::requireLine(const std::string& wanted) {
  while (nextLine()) {
    if (line_.find_first_not_of(blanks) != std::string_view::npos) return line_;
  }
  fail("ends before " + wanted);
}

std::string_view TextCursor::takeWord(const std::string& wanted) {
  std::size_t start = line_.find_first_not_of(blanks, at_);
  while (start == std::string_view::npos) {
    if (!nextLine()) fail("ends before " + wanted);
    start = line_.find_first_not_of(blanks);
  }
  at_ = std::min(line_.find_first_of(blanks, start), line_.size());
  return line_.substr(start, at_ - start);
}

double TextCursor::takeNumber(const std::string& wanted) {
  const std::string_view word = takeWord(wanted);
  return number(word, wanted);
}

void TextCursor::requireLineEnd(const std::string& after) const {
  const std::size_t start = line_.find_first_not_of(blanks, at_);
  if (start != std::string_view::npos) {
    fail("'" + shown(line_.substr(start)) + "' is not allowed after " + after);
  }
}

bool TextCursor::atEnd() const {
  return restOfLine().find_first_not_of(blanks) == std::string_view::npos &&
         std::string_view(file_.text).find_first_not_of(" \t\r\f\v\n", next_) ==
             std::string_view::npos;
}

double TextCursor::number(std::string_view word, const std::string& wanted) const {
  const auto value = numberOf(word);
  if (!value) fail(wanted + ": '" + shown(word) + "' is not a number");
  return *value;
}

int TextCursor::wholeNumber(std::string_view word, const std::string& wanted, int least,
                            int most) const {
  const double value = number(word, wanted);
  if (!(value >= least && value <= most) || value != std::floor(value)) {
    fail(wanted + ": '" + shown(word) + "' is not allowed; must be a whole number in [" +
         std::to_string(least) + ", " + std::to_string(most) + "]");
  }
  return static_cast<int>(value);
}

void TextCursor::fail(const std::string& what) const {
  throw InputError(file_.name, number_, what);
}

}  // namespace seaway
