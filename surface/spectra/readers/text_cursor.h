#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "surface/spectra/readers/text_file.h"

namespace seaway {

/// The number that is the whole of `word`, whatever the locale; nothing for NaN, infinities and
/// anything else. Takes Fortran's forms too: +1.5, 1.5D-3, and 1.5-103 for 1.5e-103.
std::optional<double> numberOf(std::string_view word);

/// The words of a line between blanks and any of `separators`.
std::vector<std::string_view> splitWords(std::string_view line, std::string_view separators = "");

/// Walks a file line by line, and word by word within and across lines. Its failures name file and
/// line. The file must outlive it.
class TextCursor {
 public:
  explicit TextCursor(const TextFile& file) : file_(file) {}

  /// Goes to the next line, with what is left of this one passed over; false at the end.
  bool nextLine();
  /// Goes to the next line that is not blank; at the end of the file fails: "ends before WANTED".
  std::string_view requireLine(const std::string& wanted);

  std::string_view line() const { return line_; }  ///< whole current line, without its end
  int lineNumber() const { return number_; }       ///< of the current line, from 1

  /// The next word, on this line or a later one; fails at the end of the file.
  std::string_view takeWord(const std::string& wanted);
  /// The same, as a number.
  double takeNumber(const std::string& wanted);
  /// The rest of the current line that no word was taken from.
  std::string_view restOfLine() const { return line_.substr(at_); }
  void skipRestOfLine() { at_ = line_.size(); }
  /// Fails unless only blanks are left on the current line.
  void requireLineEnd(const std::string& after) const;
  /// Whether the current line is the last and lacks its end.
  bool isUnended() const { return next_ == file_.text.size() && !file_.text.ends_with('\n'); }
  /// Whether only blanks are left in the file.
  bool atEnd() const;
  /// `word` as a number, as a whole number in [least, most]; fails naming `wanted` and the word.
  double number(std::string_view word, const std::string& wanted) const;
  int wholeNumber(std::string_view word, const std::string& wanted, int least, int most) const;

  /// Throws InputError: file, line, `what`.
  [[noreturn]] void fail(const std::string& what) const;
  const std::string& fileName() const { return file_.name; }

 private:
  const TextFile& file_;
  std::size_t next_ = 0;   ///< where the next line starts
  std::string_view line_;  ///< current line
  std::size_t at_ = 0;     ///< within it
  int number_ = 0;
};

}  // namespace seaway
