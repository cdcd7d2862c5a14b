#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "surface/spectra/readers/spectrum_record.h"
#include "surface/spectra/readers/text_cursor.h"

/// NDBC spreads a record over up to five files, one quantity each; both of its layouts are read
/// into the same rows and joined here. Internal to surface/spectra/readers.
namespace seaway::formats {

enum class NdbcQuantity { density, alpha1, alpha2, r1, r2 };
const char* quantityName(NdbcQuantity quantity);

/// One time of one file.
struct NdbcRow {
  std::string time;  ///< ISO 8601
  int line = 0;
  std::optional<double> separationFrequency;  ///< Hz
  std::vector<double> frequency;              ///< Hz
  std::vector<double> value;                  ///< m²/Hz, degrees (from) or 1; NaN where missing
};

struct NdbcFile {
  std::string name;
  NdbcQuantity quantity = NdbcQuantity::density;
  std::vector<NdbcRow> rows;
  std::vector<std::string> notes;  ///< for every record that uses the file
};

/// The time of `words`: year, month, day, hour and, where `hasMinute`, minute. Two-digit years are
/// 1970–2069. Fails for what is no date and time.
std::string ndbcTime(const std::vector<std::string_view>& words, bool hasMinute,
                     const TextCursor& cursor);

/// A value of the file as a number: NaN for 999 and 9999, NDBC's missing. Fails for what is no
/// number, a negative density, an angle outside [0, 360], and an r outside [0, 1] × `rScale`.
double ndbcValue(std::string_view word, NdbcQuantity quantity, double frequency, double rScale,
                 const TextCursor& cursor);

/// Records of the density file, with what the others say at the same times. Throws InputError for
/// no density file, two files of one quantity, and frequencies that differ between files.
std::vector<SpectrumRecord> joinNdbc(const std::vector<NdbcFile>& files);

}  // namespace seaway::formats
