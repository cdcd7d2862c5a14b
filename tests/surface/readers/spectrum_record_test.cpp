#include "surface/spectra/readers/spectrum_record.h"

#include <gtest/gtest.h>

#include <cmath>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"
#include "surface/spectra/readers/time_stamp.h"

namespace seaway {
namespace {

TEST(TimeStamp, IsReadAndWrittenAsIso8601) {
  EXPECT_EQ(isoTime(2020, 6, 8, 3, 50), "2020-06-08T03:50Z");
  EXPECT_EQ(isoTime(2020, 2, 29, 0, 0, 7), "2020-02-29T00:00:07Z");
  for (const char* text : {"2020-06-08T03:50", "2020-06-08T03:50Z", "2020-06-08T03:50:00.25Z"}) {
    const auto moment = parseIsoTime(text);
    ASSERT_TRUE(moment) << text;
    EXPECT_EQ(isoTime(*moment), "2020-06-08T03:50Z");
  }
}

TEST(TimeStamp, IsNothingForWhatIsNoDate) {
  EXPECT_FALSE(isoTime(2021, 2, 29, 0, 0));
  EXPECT_FALSE(isoTime(2021, 1, 1, 24, 0));
  for (const char* text :
       {"", "yesterday", "2020-06-08", "2020-13-08T03:50", "2020-06-08T03:50+02:00",
        "2020-06-08T03:5", "-020-06-08T03:50", "2020-06-08T03:50Zulu"}) {
    EXPECT_FALSE(parseIsoTime(text)) << text;
  }
}

std::vector<SpectrumRecord> threeRecords() {
  std::vector<SpectrumRecord> records(3);
  records[0].time = "2020-06-08T03:50Z";
  records[1].time = "2020-06-08T02:50Z";
  records[2].file = "a.txt";
  return records;
}

TEST(SpectrumRecords, AreFoundByTimeAndNumber) {
  const auto records = threeRecords();
  EXPECT_EQ(recordAt(records, "2020-06-08T02:40").time, "2020-06-08T02:50Z");
  EXPECT_EQ(&recordNumber(records, 2), &records[2]);
  EXPECT_THROW(recordAt(records, "2020-06-09T02:40"), InputError);
  EXPECT_THROW(recordAt(records, "yesterday"), InputError);
  EXPECT_THROW(recordAt({}, "2020-06-08T02:40"), InputError);
  EXPECT_THROW(recordNumber(records, 3), InputError);
  EXPECT_THROW(recordNumber(records, -1), InputError);
}

TEST(SpectrumRecords, CompassMomentsTurnIntoOurs) {
  // Waves from the west (A = 270 deg) go east: θ = 0.
  const auto at = [](double from_deg) {
    const double a = radiansFromDegrees(from_deg);
    return momentsFromCompassFrom(0.8 * std::cos(a), 0.8 * std::sin(a), 0.5 * std::cos(2.0 * a),
                                  0.5 * std::sin(2.0 * a));
  };
  for (const double from_deg : {270.0, 180.0, 196.0, 355.0}) {
    const double toward = towardFromCompassFrom(from_deg);
    const DirectionalMoments m = at(from_deg);
    EXPECT_NEAR(m.a1, 0.8 * std::cos(toward), 1e-12);
    EXPECT_NEAR(m.b1, 0.8 * std::sin(toward), 1e-12);
    EXPECT_NEAR(m.a2, 0.5 * std::cos(2.0 * toward), 1e-12);
    EXPECT_NEAR(m.b2, 0.5 * std::sin(2.0 * toward), 1e-12);
    EXPECT_NEAR(compassFromFromToward(momentsOfMeanDirection(from_deg, 0.8).meanDirection()),
                from_deg, 1e-9);
  }
  EXPECT_NEAR(at(270.0).a1, 0.8, 1e-12);
  EXPECT_FALSE(momentsOfMeanDirection(270.0, 0.8).hasSecond());
}

TEST(SpectrumRecords, SpreadIsTheInverseOfItsR1) {
  DirectionalMoments m;
  m.a1 = r1OfSpread(30.0);
  m.b1 = 0.0;
  EXPECT_NEAR(degreesFromRadians(m.spread()), 30.0, 1e-9);
}

TEST(SpectrumRecords, ThatNoSeaCanHaveAreRefused) {
  SpectrumRecord record;
  record.file = "f";
  record.line = 3;
  record.spectrum.energy = jonswap({20.0, 15.0, 3.3});
  EXPECT_NO_THROW(finishRecord(record));
  for (double& density : record.spectrum.energy.density) density *= 100.0;
  try {
    finishRecord(record);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_EQ(std::string(error.what()).rfind("f:3: H_m0 of its spectrum is 200", 0), 0u)
        << error.what();
  }
}

TEST(SpectrumRecords, WithOneBinLeftHaveNoSpectrum) {
  SpectrumRecord record;
  record.spectrum.energy = {{0.1}, {1.0}};
  record.missingBins = 5;
  finishRecord(record);
  EXPECT_FALSE(record.hasSpectrum());
}

}  // namespace
}  // namespace seaway
