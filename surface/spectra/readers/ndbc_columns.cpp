#include "surface/spectra/readers/ndbc_columns.h"

#include <cmath>
#include <limits>
#include <map>
#include <sstream>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/time_stamp.h"

namespace seaway::formats {
namespace {

constexpr double missing = std::numeric_limits<double>::quiet_NaN();

/// NDBC: D(f, A) = (1/π)(½ + r₁ cos(A − α₁) + r₂ cos 2(A − α₂)), A from which waves come.
DirectionalMoments momentsOf(double alpha1_deg, double r1, double alpha2_deg, double r2) {
  const double alpha1 = radiansFromDegrees(alpha1_deg);
  const double alpha2 = radiansFromDegrees(alpha2_deg);
  return momentsFromCompassFrom(r1 * std::cos(alpha1), r1 * std::sin(alpha1),
                                r2 * std::cos(2.0 * alpha2), r2 * std::sin(2.0 * alpha2));
}

/// The rows of one quantity by time; the first of several.
class RowsByTime {
 public:
  explicit RowsByTime(const NdbcFile* file) : file_(file) {
    if (!file) return;
    for (const NdbcRow& row : file->rows) rows_.emplace(row.time, &row);
  }

  const NdbcFile* file() const { return file_; }

  /// The row that goes with a density row, or null. Notes in `record` where the file has none.
  const NdbcRow* rowFor(const NdbcRow& density, SpectrumRecord& record) const {
    if (!file_) return nullptr;
    const std::string name = quantityName(file_->quantity);
    const auto found = rows_.find(density.time);
    if (found == rows_.end()) {
      record.notes.push_back(name + " is not given at this time");
      return nullptr;
    }
    const NdbcRow& row = *found->second;
    requireSameFrequencies(row, density, record);
    record.notes.insert(record.notes.end(), file_->notes.begin(), file_->notes.end());
    return &row;
  }

 private:
  void requireSameFrequencies(const NdbcRow& row, const NdbcRow& density,
                              const SpectrumRecord& record) const {
    bool same = row.frequency.size() == density.frequency.size();
    for (std::size_t bin = 0; same && bin < row.frequency.size(); ++bin) {
      // Files round to three decimals or more.
      same = std::abs(row.frequency[bin] - density.frequency[bin]) < 6e-4;
    }
    if (same) return;
    throw InputError(file_->name, row.line,
                     "its frequencies are not those of " + record.file + ":" +
                         std::to_string(density.line) + ", the density of the same time");
  }

  const NdbcFile* file_;
  std::map<std::string, const NdbcRow*> rows_;
};

void noteLoneRow(const NdbcRow* angle, const NdbcRow* r, const std::string& index,
                 SpectrumRecord& record) {
  if (!angle == !r) return;
  record.notes.push_back(angle ? "alpha" + index + " without r" + index +
                                     ": not used, a direction needs both"
                               : "r" + index + " without alpha" + index + ": not used");
}

void fill(SpectrumRecord& record, const NdbcRow& density, const NdbcRow* alpha1, const NdbcRow* r1,
          const NdbcRow* alpha2, const NdbcRow* r2) {
  const auto at = [](const NdbcRow* row, std::size_t bin) {
    return row ? row->value[bin] : missing;
  };
  const bool directional = (alpha1 && r1) || (alpha2 && r2);
  for (std::size_t bin = 0; bin < density.frequency.size(); ++bin) {
    if (std::isnan(density.value[bin])) {
      ++record.missingBins;
      continue;
    }
    record.spectrum.energy.frequency.push_back(density.frequency[bin]);
    record.spectrum.energy.density.push_back(density.value[bin]);
    if (directional) {
      record.spectrum.moments.push_back(
          momentsOf(at(alpha1, bin), at(r1, bin), at(alpha2, bin), at(r2, bin)));
    }
  }
  noteLoneRow(alpha1, r1, "1", record);
  noteLoneRow(alpha2, r2, "2", record);
}

const NdbcFile* fileOf(const std::vector<NdbcFile>& files, NdbcQuantity quantity) {
  const NdbcFile* found = nullptr;
  for (const NdbcFile& file : files) {
    if (file.quantity != quantity) continue;
    if (found) {
      throw InputError(file.name, 0,
                       "holds " + std::string(quantityName(quantity)) + " as " + found->name +
                           " does; one file of each is allowed");
    }
    found = &file;
  }
  return found;
}

}  // namespace

const char* quantityName(NdbcQuantity quantity) {
  constexpr const char* names[] = {"density", "alpha1", "alpha2", "r1", "r2"};
  return names[static_cast<int>(quantity)];
}

std::string ndbcTime(const std::vector<std::string_view>& words, bool hasMinute,
                     const TextCursor& cursor) {
  constexpr const char* names[] = {"year", "month", "day", "hour", "minute"};
  int field[5] = {};
  for (std::size_t i = 0; i < (hasMinute ? 5u : 4u); ++i) {
    field[i] = cursor.wholeNumber(words[i], names[i], 0, 9999);
  }
  if (field[0] < 100) field[0] += field[0] < 70 ? 2000 : 1900;
  const auto time = isoTime(field[0], field[1], field[2], field[3], field[4]);
  if (!time) cursor.fail("not a date and time");
  return *time;
}

double ndbcValue(std::string_view word, NdbcQuantity quantity, double frequency, double rScale,
                 const TextCursor& cursor) {
  std::ostringstream name;
  name << quantityName(quantity) << " at " << frequency << " Hz";
  const double value = cursor.number(word, name.str());
  if (value == 999.0 || value == 9999.0) return missing;
  const bool isAngle = quantity == NdbcQuantity::alpha1 || quantity == NdbcQuantity::alpha2;
  const double most = isAngle                             ? 360.0
                      : quantity == NdbcQuantity::density ? std::numeric_limits<double>::infinity()
                                                          : rScale;
  if (value >= 0.0 && value <= most) return value;
  std::ostringstream allowed;
  allowed << name.str() << ": " << word << " is not allowed; must be ";
  if (quantity == NdbcQuantity::density) {
    allowed << ">= 0 m2/Hz";
  } else {
    allowed << "in [0, " << most << "]";
  }
  cursor.fail(allowed.str() + ", or 999 where missing");
}

std::vector<SpectrumRecord> joinNdbc(const std::vector<NdbcFile>& files) {
  const NdbcFile* density = fileOf(files, NdbcQuantity::density);
  if (!density) {
    throw InputError(files.front().name, 0,
                     "holds " + std::string(quantityName(files.front().quantity)) +
                         "; the file of spectral density is needed with it");
  }
  const RowsByTime alpha1(fileOf(files, NdbcQuantity::alpha1));
  const RowsByTime alpha2(fileOf(files, NdbcQuantity::alpha2));
  const RowsByTime r1(fileOf(files, NdbcQuantity::r1));
  const RowsByTime r2(fileOf(files, NdbcQuantity::r2));
  std::vector<SpectrumRecord> records;
  for (const NdbcRow& row : density->rows) {
    SpectrumRecord& record = records.emplace_back();
    record.file = density->name;
    record.line = row.line;
    record.time = row.time;
    record.separationFrequency = row.separationFrequency;
    record.notes = density->notes;
    const NdbcRow* alpha1Row = alpha1.rowFor(row, record);
    const NdbcRow* r1Row = r1.rowFor(row, record);
    const NdbcRow* alpha2Row = alpha2.rowFor(row, record);
    const NdbcRow* r2Row = r2.rowFor(row, record);
    fill(record, row, alpha1Row, r1Row, alpha2Row, r2Row);
  }
  return records;
}

}  // namespace seaway::formats
