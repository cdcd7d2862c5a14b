#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <optional>

#include "surface/input_error.h"
#include "surface/spectra/readers/direction_grid.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/ndbc_columns.h"

// Layout: a header row YY (YYYY, #YY) MM DD hh [mm] and the frequencies, then a row a record with
// one value a frequency. The file's name says which quantity: station, then w (density), d (α₁), i
// (α₂), j (r₁) or k (r₂), then the year. r₁ and r₂ are in hundredths.
// https://www.ndbc.noaa.gov/measdes.shtml
namespace seaway::formats {
namespace {

struct Header {
  bool hasMinute = false;
  std::vector<std::string_view> frequencies;
};

std::optional<Header> headerOf(std::string_view line) {
  std::vector<std::string_view> words = splitWords(line, "#");
  if (words.size() < 5 || (words[0] != "YY" && words[0] != "YYYY") || words[1] != "MM" ||
      words[2] != "DD" || words[3] != "hh") {
    return std::nullopt;
  }
  Header header;
  header.hasMinute = words[4] == "mm";
  words.erase(words.begin(), words.begin() + (header.hasMinute ? 5 : 4));
  if (words.empty() || !numberOf(words.front())) return std::nullopt;
  header.frequencies = std::move(words);
  return header;
}

struct NamedQuantity {
  NdbcQuantity quantity = NdbcQuantity::density;
  bool named = false;
};

NamedQuantity quantityOf(const std::string& fileName) {
  struct Sign {
    char letter;
    const char* folder;
    NdbcQuantity quantity;
  };
  constexpr Sign signs[] = {{'w', "swden", NdbcQuantity::density},
                            {'d', "swdir", NdbcQuantity::alpha1},
                            {'i', "swdir2", NdbcQuantity::alpha2},
                            {'j', "swr1", NdbcQuantity::r1},
                            {'k', "swr2", NdbcQuantity::r2}};
  const std::filesystem::path path(fileName);
  const std::string stem = path.stem().string();
  const std::string extension = path.extension().string();
  const std::string folder = path.parent_path().filename().string();
  for (const Sign& sign : signs) {
    const bool byLetter = stem.size() >= 7 && stem[5] == sign.letter &&
                          std::isdigit(static_cast<unsigned char>(stem[6])) != 0;
    if (byLetter || extension == std::string(".") + sign.folder) return {sign.quantity, true};
  }
  for (const Sign& sign : signs) {
    if (folder == sign.folder) return {sign.quantity, true};
  }
  return {};
}

bool isR(NdbcQuantity quantity) {
  return quantity == NdbcQuantity::r1 || quantity == NdbcQuantity::r2;
}

NdbcRow readRow(const TextCursor& cursor, bool hasMinute, const std::vector<double>& frequencies,
                NdbcQuantity quantity) {
  const std::vector<std::string_view> words = splitWords(cursor.line());
  const std::size_t first = hasMinute ? 5 : 4;
  if (words.size() != first + frequencies.size()) {
    cursor.fail("has " + std::to_string(words.size()) + " columns where its header has " +
                std::to_string(first + frequencies.size()));
  }
  NdbcRow row;
  row.line = cursor.lineNumber();
  row.time = ndbcTime(words, hasMinute, cursor);
  row.frequency = frequencies;
  for (std::size_t bin = 0; bin < frequencies.size(); ++bin) {
    row.value.push_back(ndbcValue(words[first + bin], quantity, frequencies[bin], 100.0, cursor));
  }
  return row;
}

/// Hundredths, unless no value of the file is above 1: then someone has scaled them already.
void scaleR(NdbcFile& file) {
  double highest = 0.0;
  for (const NdbcRow& row : file.rows) {
    for (const double r : row.value) highest = std::fmax(highest, r);
  }
  if (highest <= 1.0) {
    file.notes.push_back(std::string(quantityName(file.quantity)) +
                         " is at most 1 in the whole file: taken as it is, not as hundredths");
    return;
  }
  for (NdbcRow& row : file.rows) {
    for (double& r : row.value) r *= 0.01;
  }
}

NdbcFile readFile(const TextFile& file, bool alone) {
  const NamedQuantity named = quantityOf(file.name);
  if (!named.named && !alone) {
    throw InputError(file.name, 0,
                     "its name does not say which quantity it holds; must be as 41010w2019.txt: "
                     "w density, d alpha1, i alpha2, j r1, k r2");
  }
  NdbcFile result{file.name, named.quantity, {}, {}};
  if (!named.named) result.notes.push_back("the file's name does not say so: taken as density");
  std::vector<double> frequencies;
  bool hasMinute = false;
  TextCursor cursor(file);
  while (cursor.nextLine()) {
    if (const auto header = headerOf(cursor.line())) {
      hasMinute = header->hasMinute;
      frequencies.clear();
      for (const std::string_view word : header->frequencies) {
        frequencies.push_back(cursor.number(word, "frequency"));
      }
      requireRisingFrequencies(frequencies, cursor);
      continue;
    }
    const std::size_t start = cursor.line().find_first_not_of(" \t\r");
    if (start == std::string_view::npos || cursor.line()[start] == '#') continue;
    if (frequencies.empty())
      cursor.fail("a header row YY MM DD hh and frequencies must come first");
    result.rows.push_back(readRow(cursor, hasMinute, frequencies, named.quantity));
  }
  if (isR(named.quantity)) scaleR(result);
  return result;
}

}  // namespace

bool looksLikeNdbcYearly(const TextFile& file) {
  TextCursor cursor(file);
  while (cursor.nextLine()) {
    if (splitWords(cursor.line()).empty()) continue;
    return headerOf(cursor.line()).has_value();
  }
  return false;
}

std::vector<SpectrumRecord> readNdbcYearly(std::span<const TextFile> files) {
  std::vector<NdbcFile> read;
  for (const TextFile& file : files) read.push_back(readFile(file, files.size() == 1));
  return joinNdbc(read);
}

}  // namespace seaway::formats
