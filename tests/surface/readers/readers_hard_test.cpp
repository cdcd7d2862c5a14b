#include <gtest/gtest.h>

#include <cmath>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/readers/read_spectra.h"
#include "surface/spectra/readers/time_stamp.h"
#include "tests/surface/readers/spectrum_writers.h"

/// Hostile files: each outcome is a set of valid records or an error that names a file.
namespace seaway {
namespace {

using test::WrittenFiles;

std::string nameOf(const testing::TestParamInfo<std::size_t>& info) {
  constexpr const char* names[] = {"ndbc",    "ndbcYearly", "swan",    "swanLines",
                                   "ww3",     "datawell",   "triaxys", "triaxysLine",
                                   "spotter", "spotterBulk"};
  return names[info.param];
}

bool namesAFile(const std::string& message, const std::vector<TextFile>& files) {
  for (const TextFile& file : files) {
    if (message.rfind(file.name, 0) == 0) return true;
  }
  return false;
}

/// What is wrong with a record that a reader gave, or nothing.
std::string faultOf(const SpectrumRecord& record) {
  if (!record.time.empty() && !parseIsoTime(record.time)) return "time " + record.time;
  if (!record.hasSpectrum()) return record.missingBins > 0 ? "" : "no bins, none missing";
  if (const auto wrong = record.spectrum.validate()) return *wrong;
  const double height = record.spectrum.energy.significantWaveHeight();
  return std::isfinite(height) ? "" : "no finite wave height";
}

class EveryFormatHard : public testing::TestWithParam<std::size_t> {
 protected:
  WrittenFiles written(std::size_t bins, std::size_t directions) const {
    return test::everyFormat(bins, directions)[GetParam()];
  }

  /// Records, or none after an error; both are checked.
  std::vector<SpectrumRecord> outcome(const std::vector<TextFile>& files) const {
    try {
      std::vector<SpectrumRecord> records = parseSpectra(files);
      for (const SpectrumRecord& record : records) EXPECT_EQ(faultOf(record), "");
      EXPECT_FALSE(records.empty());
      return records;
    } catch (const InputError& error) {
      EXPECT_TRUE(namesAFile(error.what(), files)) << error.what();
      return {};
    }
  }
};

TEST_P(EveryFormatHard, AFileCutAtAnyByteGivesWholeRecordsOrAnError) {
  const WrittenFiles whole = written(4, 4);
  const auto truth = parseSpectra(whole.files);
  for (std::size_t f = 0; f < whole.files.size(); ++f) {
    for (std::size_t length = 0; length < whole.files[f].text.size(); ++length) {
      std::vector<TextFile> files = whole.files;
      files[f].text.resize(length);
      const auto records = outcome(files);
      ASSERT_LE(records.size(), truth.size());
      for (std::size_t i = 0; i < records.size(); ++i) {
        const auto& density = records[i].spectrum.energy.density;
        const auto& wanted = truth[i].spectrum.energy.density;
        ASSERT_EQ(density.size(), wanted.size()) << length << " of " << files[f].name;
        // The last number of a cut file may be shorter, and then the record says that it may be.
        const bool last = f == 0 && i + 1 == records.size() && !files[f].text.ends_with('\n');
        for (std::size_t b = 0; b + (last ? 1 : 0) < density.size(); ++b) {
          ASSERT_EQ(density[b], wanted[b]) << length << " of " << files[f].name;
        }
        if (last && records[i].line > 0) {
          EXPECT_NE(records[i].notes.back().find("cut short"), std::string::npos);
        }
      }
    }
  }
}

TEST_P(EveryFormatHard, AnyByteChangedGivesValidRecordsOrAnError) {
  const WrittenFiles whole = written(3, 4);
  constexpr char changes[] = {'\0', ' ', '\n', '-', '.', ',', '9', 'e', 'x', '\'', '"', '\xff'};
  for (std::size_t f = 0; f < whole.files.size(); ++f) {
    std::vector<TextFile> files = whole.files;
    std::string& text = files[f].text;
    for (std::size_t at = 0; at < text.size(); ++at) {
      const char before = text[at];
      for (const char change : changes) {
        text[at] = change;
        outcome(files);
      }
      text[at] = before;
    }
  }
}

TEST_P(EveryFormatHard, AnyByteLostOrDoubledGivesValidRecordsOrAnError) {
  const WrittenFiles whole = written(3, 4);
  for (std::size_t f = 0; f < whole.files.size(); ++f) {
    for (std::size_t at = 0; at < whole.files[f].text.size(); ++at) {
      std::vector<TextFile> files = whole.files;
      files[f].text.erase(at, 1);
      outcome(files);
      files[f].text = whole.files[f].text;
      files[f].text.insert(at, 1, files[f].text[at]);
      outcome(files);
    }
  }
}

TEST_P(EveryFormatHard, AnyLineLostOrDoubledGivesValidRecordsOrAnError) {
  const WrittenFiles whole = written(6, 8);
  for (std::size_t f = 0; f < whole.files.size(); ++f) {
    const std::string& text = whole.files[f].text;
    for (std::size_t start = 0; start < text.size(); start = text.find('\n', start) + 1) {
      const std::size_t length = text.find('\n', start) + 1 - start;
      std::vector<TextFile> files = whole.files;
      files[f].text.erase(start, length);
      outcome(files);
      files[f].text = text;
      files[f].text.insert(start, text.substr(start, length));
      outcome(files);
    }
  }
}

TEST_P(EveryFormatHard, LinesMayEndAsWindowsEndsThem) {
  WrittenFiles whole = written(4, 8);
  const auto truth = parseSpectra(whole.files);
  for (TextFile& file : whole.files) {
    std::string text;
    for (const char c : file.text) text += c == '\n' ? std::string("\r\n") : std::string(1, c);
    file.text = text;
  }
  const auto records = parseSpectra(whole.files);
  ASSERT_EQ(records.size(), truth.size());
  EXPECT_EQ(records[0].spectrum.energy.density, truth[0].spectrum.energy.density);
}

TEST_P(EveryFormatHard, ThreeBinsAndTwoThousandAreRead) {
  for (const std::size_t bins : {3u, 2000u}) {
    const auto records = parseSpectra(written(bins, 8).files);
    const std::size_t read = records[0].spectrum.energy.frequency.size();
    // Waveriders have 64, bulk parameters none.
    EXPECT_TRUE(read == bins || GetParam() == 5 || GetParam() == 9) << read;
  }
}

INSTANTIATE_TEST_SUITE_P(Readers, EveryFormatHard, testing::Range<std::size_t>(0, 10), nameOf);

/// The same spectrum in every density of which is what `change` makes of it.
std::vector<WrittenFiles> changed(void (*change)(DirectionalSpectrum&)) {
  auto records = test::knownRecords(6, 8);
  for (auto& record : records) change(record.spectrum);
  test::KnownRecord waverider = records[0];
  waverider.spectrum.energy = {test::datawellFrequencies(), std::vector<double>(64, 0.0)};
  waverider.spectrum.energy.density[20] = records[0].spectrum.energy.density[2];
  waverider.spectrum.moments.assign(64, records[0].spectrum.moments[2]);
  return {test::ndbcRealtimeFiles(records), test::ndbcYearlyFiles(records),
          test::swanFile(records),          test::swanLineFile(records),
          test::wavewatchFile(records),     test::datawellFile(waverider),
          test::triaxysFile(records[0]),    test::triaxysLineFile(records[0]),
          test::spotterFile(records)};
}

void scale(DirectionalSpectrum& spectrum, bool keepThird) {
  const std::size_t directions = spectrum.direction.size();
  for (std::size_t f = 0; f < spectrum.energy.frequency.size(); ++f) {
    if (f == 2 && keepThird) continue;
    spectrum.energy.density[f] = 0.0;
    for (std::size_t d = 0; d < directions; ++d) spectrum.density[f * directions + d] = 0.0;
  }
}

TEST(SpectraHard, AllZeroSpectraAreRecordsWithoutEnergy) {
  for (const WrittenFiles& written : changed([](DirectionalSpectrum& s) { scale(s, false); })) {
    SCOPED_TRACE(written.files[0].name);
    for (const SpectrumRecord& record : parseSpectra(written.files)) {
      EXPECT_EQ(faultOf(record), "");
      EXPECT_EQ(record.spectrum.energy.moment(0), 0.0);
      EXPECT_EQ(record.spectrum.energy.peakPeriod(), 0.0);
    }
  }
}

TEST(SpectraHard, OneBinWithEnergyIsRead) {
  for (const WrittenFiles& written : changed([](DirectionalSpectrum& s) { scale(s, true); })) {
    SCOPED_TRACE(written.files[0].name);
    const SpectrumRecord record = parseSpectra(written.files)[0];
    int withEnergy = 0;
    for (const double density : record.spectrum.energy.density) withEnergy += density > 0.0;
    EXPECT_EQ(withEnergy, 1);
    EXPECT_GT(record.spectrum.energy.significantWaveHeight(), 0.0);
  }
}

TEST(SpectraHard, DirectionsAcrossNorthKeepTheirMean) {
  // 350 and 10 deg: read as numbers their mean would be 180.
  for (const WrittenFiles& written : test::everyFormat(12, 36)) {
    const auto records = parseSpectra(written.files);
    for (std::size_t i = 0; i < records.size(); ++i) {
      const DirectionalSpectrum& s = records[i].spectrum;
      if (s.moments.empty()) continue;
      std::size_t peak = 0;
      for (std::size_t b = 0; b < s.moments.size(); ++b) {
        if (s.energy.density[b] > s.energy.density[peak]) peak = b;
      }
      const double from_deg = compassFromFromToward(s.moments[peak].meanDirection());
      EXPECT_NEAR(from_deg, i == 0 ? 350.0 : 10.0, 0.1) << written.files[0].name;
    }
  }
}

}  // namespace
}  // namespace seaway
