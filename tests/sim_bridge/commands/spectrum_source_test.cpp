#include "sim_bridge/commands/spectrum_source.h"

#include <gtest/gtest.h>

#include "tests/sim_bridge/test_support.h"

namespace seaway::bridge {
namespace {

using test::inputErrorOf;
using test::TempFolder;

double heightOf(const std::string& argument) {
  return spectrumFrom(argument, {}, "").spectrum.energy.significantWaveHeight();
}

std::string faultOf(const std::string& argument) {
  return inputErrorOf([&] { spectrumFrom(argument, {}, ""); });
}

TEST(SpectrumSource, EveryFamilyHasACommandLineForm) {
  EXPECT_NEAR(heightOf("pm:2.5,8"), 2.5, 1e-9);
  EXPECT_NEAR(heightOf("pm_wind:10"), 2.13, 0.01);  // 0.209 U²/g
  EXPECT_NEAR(heightOf("jonswap:2.5,8"), 2.5, 1e-9);
  EXPECT_NEAR(heightOf("jonswap:2.5,8,7"), 2.5, 1e-9);
  EXPECT_NEAR(heightOf("tma:2.5,8,3.3,12"), 2.5, 1e-9);
  EXPECT_NEAR(heightOf("ochi_hubble:4"), 4.0, 1e-9);
  EXPECT_NEAR(heightOf("ochi_hubble:3,14,3,4,7,1.5"), 5.0, 1e-9);
  EXPECT_NEAR(heightOf("torsethaugen:5,9"), 5.0, 1e-9);
  EXPECT_NEAR(heightOf("swell:1.5,14,0.006"), 1.5, 1e-9);
  EXPECT_NEAR(heightOf("wmo:5"), 3.25, 1e-9);
  const SpectrumSource source = spectrumFrom("wmo:5", {}, "");
  EXPECT_EQ(source.source, "wmo:5");
  EXPECT_TRUE(source.spectrum.moments.empty());
}

TEST(SpectrumSource, HelpNamesEveryFamilyAndFormat) {
  const auto outcome = test::seaway({"fit", "--help"});
  EXPECT_EQ(outcome.status, 0);
  for (const char* form : {"pm:Hs,Tp", "pm_wind:U", "jonswap:Hs,Tp[,gamma]",
                           "tma:Hs,Tp,gamma,depth", "ochi_hubble:Hs1,Tp1,lambda1,Hs2,Tp2,lambda2",
                           "torsethaugen:Hs,Tp", "swell:Hs,Tp,width", "wmo:CODE", "swan: ", "ww3: ",
                           "triaxys: ", "spotter: ", "ndbc: ", "ndbc-yearly: ", "datawell: "}) {
    EXPECT_NE(outcome.out.find(form), std::string::npos) << form;
  }
}

TEST(SpectrumSource, ABadFamilyIsRefusedWithItsFormOrItsRange) {
  EXPECT_EQ(faultOf("tma:1,2"), "'tma:1,2' is not tma:Hs,Tp,gamma,depth in numbers");
  EXPECT_EQ(faultOf("jonswap:1,two"), "'jonswap:1,two' is not jonswap:Hs,Tp[,gamma] in numbers");
  EXPECT_EQ(faultOf("jonswap:1,8,"), "'jonswap:1,8,' is not jonswap:Hs,Tp[,gamma] in numbers");
  EXPECT_EQ(faultOf("jonswap:1,8,0.5"),
            "'jonswap:1,8,0.5': peak enhancement gamma 0.5 is not allowed; must be in [1, 20]");
  EXPECT_EQ(faultOf("wmo:10"),
            "'wmo:10': sea state 10 is not allowed; must be in [0, 9] (WMO code table 3700)");
  EXPECT_EQ(faultOf("wmo:2.5"), "'wmo:2.5': sea state must be a whole number in [0, 9]");
  EXPECT_EQ(faultOf("wmo:0"), "'wmo:0': sea state 0 is calm: it has no spectrum");
  EXPECT_EQ(
      faultOf("fourier:1,2").rfind("'fourier:1,2' is neither a file nor one of: pm:Hs,Tp,", 0), 0u);
  EXPECT_EQ(inputErrorOf([] { spectrumFrom("pm:1,8", {}, "", "swan"); }),
            "--record, --time and --format are for a file; 'pm:1,8' is none");
}

const std::string density =
    "2020 06 08 03 50 9.999 0.0 (0.10) 0.0 (0.11) 0.0 (0.12)\n"
    "2020 06 08 02 50 9.999 1.0 (0.10) 2.0 (0.11) 1.0 (0.12)\n";

TEST(SpectrumSource, ARecordIsChosenByNumberOrTimeWithItsDirections) {
  const TempFolder folder;
  const std::string file = folder.write("b.data_spec", density).string();
  folder.write("b.swdir", "2020 06 08 02 50 180 (0.10) 180 (0.11) 180 (0.12)\n");
  folder.write("b.swr1", "2020 06 08 02 50 0.8 (0.10) 0.8 (0.11) 0.8 (0.12)\n");
  for (const SpectrumSource& source :
       {spectrumFrom(file, 1, ""), spectrumFrom(file, {}, "2020-06-08T02:50", "ndbc")}) {
    EXPECT_EQ(source.source, file + ":2");
    EXPECT_EQ(source.recordTime, "2020-06-08T02:50Z");
    EXPECT_NEAR(source.spectrum.moments.at(1).b1, 0.8, 1e-12);
  }
  EXPECT_EQ(inputErrorOf([&] { spectrumFrom(file, {}, ""); }),
            file + ":1: the spectrum of 2020-06-08T03:50Z has no energy");
  EXPECT_EQ(inputErrorOf([&] { spectrumFrom(file, 2, ""); }),
            file + ": --record: 2 is not allowed; the file has 2 records, from 0");
  EXPECT_EQ(inputErrorOf([&] { spectrumFrom(file, 1, "2020-06-08T02:50"); }),
            "give --record or --time, not both");
  EXPECT_NE(inputErrorOf([&] { spectrumFrom(file, 1, "", "swan"); }), "");
}

TEST(SpectrumSource, ARecordWithoutBinsIsRefused) {
  const TempFolder folder;
  const std::string file =
      folder.write("b.data_spec", "2020 06 08 03 50 9.999 999.0 (0.10) 999.0 (0.11)\n").string();
  EXPECT_EQ(inputErrorOf([&] { spectrumFrom(file, {}, ""); }),
            file + ":1: the spectrum of 2020-06-08T03:50Z has fewer than 2 bins");
}

}  // namespace
}  // namespace seaway::bridge
