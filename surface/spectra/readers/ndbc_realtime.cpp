#include <cctype>
#include <filesystem>

#include "surface/input_error.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/ndbc_columns.h"

// Layout: comment lines with '#'; a record a line: YY MM DD hh mm, in density files the separation
// frequency (9.999: missing), then value and (frequency) in turn, newest first.
// https://www.ndbc.noaa.gov/measdes.shtml
namespace seaway::formats {
namespace {

bool isComment(std::string_view line) {
  const std::size_t start = line.find_first_not_of(" \t\r");
  return start == std::string_view::npos || line[start] == '#';
}

bool isFrequency(std::string_view word) {
  return word.size() >= 3 && word.front() == '(' && word.back() == ')';
}

/// By the header's column names, else the file's name, else the count of words: only a density line
/// has a sixth number before the pairs.
NdbcQuantity quantityOf(const TextFile& file) {
  struct Sign {
    const char* header;
    const char* extension;
    NdbcQuantity quantity;
  };
  constexpr Sign signs[] = {{"spec_1", ".data_spec", NdbcQuantity::density},
                            {"alpha1_1", ".swdir", NdbcQuantity::alpha1},
                            {"alpha2_1", ".swdir2", NdbcQuantity::alpha2},
                            {"r1_1", ".swr1", NdbcQuantity::r1},
                            {"r2_1", ".swr2", NdbcQuantity::r2}};
  TextCursor cursor(file);
  while (cursor.nextLine() && isComment(cursor.line())) {
    for (const std::string_view word : splitWords(cursor.line())) {
      for (const Sign& sign : signs) {
        if (word == sign.header) return sign.quantity;
      }
    }
  }
  const std::string extension = std::filesystem::path(file.name).extension().string();
  for (const Sign& sign : signs) {
    if (extension == sign.extension) return sign.quantity;
  }
  if (splitWords(cursor.line()).size() % 2 == 0) return NdbcQuantity::density;
  throw InputError(file.name, 0,
                   "neither its header nor its name says which quantity it holds; name it .swdir, "
                   ".swdir2, .swr1 or .swr2");
}

NdbcRow readRow(const TextCursor& cursor, NdbcQuantity quantity) {
  const std::vector<std::string_view> words = splitWords(cursor.line());
  const bool isDensity = quantity == NdbcQuantity::density;
  const std::size_t first = isDensity ? 6 : 5;
  if (words.size() < first + 4 || (words.size() - first) % 2 != 0) {
    cursor.fail(isDensity ? "expected date, time, separation frequency, then pairs of density and "
                            "(frequency)"
                          : "expected date, time, then pairs of " +
                                std::string(quantityName(quantity)) + " and (frequency)");
  }
  NdbcRow row;
  row.line = cursor.lineNumber();
  row.time = ndbcTime(words, true, cursor);
  if (isDensity) {
    const double separation = cursor.number(words[5], "separation frequency");
    if (separation < 9.0) row.separationFrequency = separation;
  }
  for (std::size_t i = first; i < words.size(); i += 2) {
    const std::string_view bracketed = words[i + 1];
    if (!isFrequency(bracketed)) {
      cursor.fail("'" + std::string(bracketed) + "' is not a frequency in parentheses");
    }
    row.frequency.push_back(cursor.number(bracketed.substr(1, bracketed.size() - 2), "frequency"));
    row.value.push_back(ndbcValue(words[i], quantity, row.frequency.back(), 1.0, cursor));
  }
  requireRisingFrequencies(row.frequency, cursor);
  return row;
}

NdbcFile readFile(const TextFile& file) {
  NdbcFile result{file.name, quantityOf(file), {}, {}};
  TextCursor cursor(file);
  while (cursor.nextLine()) {
    if (isComment(cursor.line())) continue;
    result.rows.push_back(readRow(cursor, result.quantity));
    // Nothing else says how many pairs the first line should have.
    const bool mayBeCut = result.rows.size() == 1 && cursor.isUnended();
    if (mayBeCut) cursor.fail("its first record's line has no end: the file is cut short");
    const std::size_t bins = result.rows.back().frequency.size();
    const std::size_t wanted = result.rows.front().frequency.size();
    if (bins != wanted) {
      cursor.fail("has " + std::to_string(bins) + " frequencies where the first record has " +
                  std::to_string(wanted));
    }
  }
  return result;
}

}  // namespace

bool looksLikeNdbcRealtime(const TextFile& file) {
  TextCursor cursor(file);
  while (cursor.nextLine()) {
    const std::vector<std::string_view> words = splitWords(cursor.line());
    if (isComment(cursor.line())) {
      for (const std::string_view word : words) {
        if (word == "(freq_1)") return true;
      }
      continue;
    }
    return words.size() > 6 &&
           (isFrequency(words[6]) || (words.size() > 7 && isFrequency(words[7])));
  }
  return false;
}

std::vector<SpectrumRecord> readNdbcRealtime(std::span<const TextFile> files) {
  std::vector<NdbcFile> read;
  for (const TextFile& file : files) read.push_back(readFile(file));
  return joinNdbc(read);
}

}  // namespace seaway::formats
