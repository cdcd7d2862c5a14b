#include "tests/surface/readers/spectrum_writers.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>

#include "surface/angles.h"
#include "surface/spectra/families.h"
#include "surface/spectra/spreading.h"

namespace seaway::test {
namespace {

template <class... Values>
std::string print(const char* format, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, format, values...);
  return text;
}

FrequencySpectrum onBins(const FrequencySpectrum& shape, const std::vector<double>& frequencies) {
  FrequencySpectrum spectrum{frequencies, {}};
  for (const double f : frequencies) spectrum.density.push_back(shape.at(f));
  return spectrum;
}

/// Moments as compass files give them: mean directions in degrees from, [0, 360).
struct CompassMoments {
  double alpha1_deg, r1, alpha2_deg, r2;
};

CompassMoments compassOf(const DirectionalMoments& m) {
  // The principal direction is one of two half a turn apart.
  return {compassFromFromToward(m.meanDirection()), m.r1(),
          compassFromFromToward(0.5 * std::atan2(m.b2, m.a2)), std::hypot(m.a2, m.b2)};
}

std::string ndbcDate(const KnownRecord& record) {
  std::string date = record.time.substr(0, 16);
  for (char& c : date) {
    if (c < '0' || c > '9') c = ' ';
  }
  return date;
}

/// What NDBC writes where there is no energy to have a direction.
double or999(double value) { return std::isnan(value) ? 999.0 : value; }

using Column = std::function<double(const DirectionalSpectrum&, std::size_t)>;

std::vector<Column> ndbcColumns() {
  return {[](const DirectionalSpectrum& s, std::size_t i) { return s.energy.density[i]; },
          [](const DirectionalSpectrum& s, std::size_t i) {
            return compassOf(s.moments[i]).alpha1_deg;
          },
          [](const DirectionalSpectrum& s, std::size_t i) {
            return compassOf(s.moments[i]).alpha2_deg;
          },
          [](const DirectionalSpectrum& s, std::size_t i) { return compassOf(s.moments[i]).r1; },
          [](const DirectionalSpectrum& s, std::size_t i) { return compassOf(s.moments[i]).r2; }};
}

std::string swanTime(const KnownRecord& record) {
  const std::string& t = record.time;
  return t.substr(0, 4) + t.substr(5, 2) + t.substr(8, 2) + "." + t.substr(11, 2) +
         t.substr(14, 2) + "00";
}

std::string swanHeader(const KnownRecord& first) {
  const auto& frequencies = first.spectrum.energy.frequency;
  std::string text =
      "SWAN   1       Swan standard spectral file, version\n$ known spectra\n"
      "TIME           time-dependent data\n     1         time coding option\n"
      "LONLAT         locations in spherical coordinates\n     1\n";
  text += print("%12.6f %12.6f\n", first.longitude_deg, first.latitude_deg);
  text += "AFREQ          absolute frequencies in Hz\n";
  text += print("%6zu         number of frequencies\n", frequencies.size());
  for (const double f : frequencies) text += print("%12.5f\n", f);
  return text;
}

std::string triaxysHeader(const KnownRecord& record, const char* type) {
  constexpr const char* months[] = {"JAN", "FEB", "MAR", "APR", "MAY", "JUN",
                                    "JUL", "AUG", "SEP", "OCT", "NOV", "DEC"};
  const std::string& t = record.time;
  const auto& frequencies = record.spectrum.energy.frequency;
  std::string text = "TRIAXYS BUOY DATA REPORT - TAS00000\nVERSION = 5b.02.08\n";
  text += "TYPE    = " + std::string(type) + "\n";
  text += "DATE    = " + t.substr(0, 4) + " " + months[std::stoi(t.substr(5, 2)) - 1] + " " +
          t.substr(8, 2) + " " + t.substr(11, 5) + "(UTC)\n";
  text += print("NUMBER OF FREQUENCIES              = %7zu\n", frequencies.size() + 1);
  text += "INITIAL FREQUENCY (Hz)             =   0.000\n";
  text += print("FREQUENCY SPACING (Hz)             = %7.5f\n", frequencies[0]);
  return text;
}

/// Density at compass direction `from_deg`, by the even grid.
double towards(const DirectionalSpectrum& spectrum, std::size_t f, double from_deg) {
  const double turn = 2.0 * pi;
  const double angle = towardFromCompassFrom(from_deg);
  const auto count = static_cast<double>(spectrum.direction.size());
  const double position = std::round((angle - spectrum.direction[0]) / turn * count);
  const auto wrapped = static_cast<std::size_t>(std::fmod(position + 4.0 * count, count));
  return spectrum.at(f, wrapped);
}

std::string list(const char* key, std::size_t count,
                 const std::function<double(std::size_t)>& value) {
  std::string text = "\"" + std::string(key) + "\":[";
  for (std::size_t i = 0; i < count; ++i)
    text += (i ? "," : "") + print("%.9g", std::isnan(value(i)) ? 0.0 : value(i));
  return text + "]";
}

std::string spotterPlace(const KnownRecord& record) {
  return "\"timestamp\":\"" + record.time.substr(0, 16) + ":00.000Z\"," +
         print("\"latitude\":%.5f,\"longitude\":%.5f", record.latitude_deg, record.longitude_deg);
}

std::string joined(const std::vector<std::string>& parts, const char* key) {
  std::string text = "{\"data\":{\"spotterId\":\"SPOT-0000\",\"" + std::string(key) + "\":[";
  for (std::size_t i = 0; i < parts.size(); ++i) text += (i ? "," : "") + ("{" + parts[i] + "}");
  return text + "]}}\n";
}

}  // namespace

std::vector<KnownRecord> knownRecords(std::size_t bins, std::size_t directions) {
  std::vector<double> frequencies;
  // The tail of a few bins reaches as far as that of many.
  for (std::size_t i = 1; i <= bins; ++i) {
    frequencies.push_back(0.5 * static_cast<double>(i) / static_cast<double>(bins));
  }
  const FrequencySpectrum first = onBins(jonswap({2.0, 6.0, 2.0}), frequencies);
  const FrequencySpectrum second = onBins(piersonMoskowitz(1.2, 5.0), frequencies);
  std::vector<KnownRecord> records(2);
  records[0].spectrum = spreadByCosinePower(first, towardFromCompassFrom(350.0), 6.0, directions);
  records[1].spectrum = spreadByCosinePower(second, towardFromCompassFrom(10.0), 15.0, directions);
  records[1].time = "2020-06-08T02:50Z";
  return records;
}

WrittenFiles ndbcRealtimeFiles(const std::vector<KnownRecord>& records) {
  constexpr const char* names[] = {"b.data_spec", "b.swdir", "b.swdir2", "b.swr1", "b.swr2"};
  constexpr const char* headers[] = {"spec", "alpha1", "alpha2", "r1", "r2"};
  WrittenFiles written{"ndbc", {}};
  const auto columns = ndbcColumns();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    const std::string header = headers[c];
    std::string text = "#YY  MM DD hh mm " + std::string(c == 0 ? "Sep_Freq  < " : "") + header +
                       "_1 (freq_1) " + header + "_2 (freq_2) ... >\n";
    for (const KnownRecord& record : records) {
      text += ndbcDate(record) + (c == 0 ? " 9.999" : "");
      const auto& frequencies = record.spectrum.energy.frequency;
      for (std::size_t i = 0; i < frequencies.size(); ++i) {
        text += print(" %.5f (%.6f)", or999(columns[c](record.spectrum, i)), frequencies[i]);
      }
      text += '\n';
    }
    written.files.push_back({names[c], text});
  }
  return written;
}

WrittenFiles ndbcYearlyFiles(const std::vector<KnownRecord>& records) {
  constexpr const char* letters = "wdijk";
  WrittenFiles written{"ndbc-yearly", {}};
  const auto columns = ndbcColumns();
  for (std::size_t c = 0; c < columns.size(); ++c) {
    std::string text = "#YY  MM DD hh mm";
    for (const double f : records[0].spectrum.energy.frequency) text += print("  %.6f", f);
    text += '\n';
    for (const KnownRecord& record : records) {
      text += ndbcDate(record);
      for (std::size_t i = 0; i < record.spectrum.energy.frequency.size(); ++i) {
        const double value = columns[c](record.spectrum, i);
        text += print(" %8.5f", or999(c >= 3 ? 100.0 * value : value));
      }
      text += '\n';
    }
    written.files.push_back({"41010" + std::string(1, letters[c]) + "2020.txt", text});
  }
  return written;
}

WrittenFiles swanFile(const std::vector<KnownRecord>& records) {
  const std::size_t directions = records[0].spectrum.direction.size();
  const double step_deg = 360.0 / static_cast<double>(directions);
  std::string text = swanHeader(records[0]);
  text += print("NDIR           spectral nautical directions in degr\n%6zu\n", directions);
  // As SWAN does, from wherever the model's own x axis puts the first.
  const auto from_deg = [&](std::size_t d) { return 270.0 - step_deg * static_cast<double>(d); };
  for (std::size_t d = 0; d < directions; ++d) text += print("%10.4f\n", from_deg(d));
  text +=
      "QUANT\n     1         number of quantities in table\nVaDens\nm2/Hz/degr     unit\n"
      "   -0.9900E+02 exception value\n";
  for (const KnownRecord& record : records) {
    const DirectionalSpectrum& s = record.spectrum;
    const double highest = *std::max_element(s.density.begin(), s.density.end());
    const double factor = (highest > 0.0 ? highest : 1.0) / 9999.0 * (pi / 180.0);
    text += swanTime(record) + "                         date and time\nFACTOR\n";
    text += print("%18.8E\n", factor);
    for (std::size_t f = 0; f < s.energy.frequency.size(); ++f) {
      for (std::size_t d = 0; d < directions; ++d) {
        const double density = towards(s, f, from_deg(d)) * (pi / 180.0);
        text += print(" %6ld", std::lround(density / factor));
      }
      text += '\n';
    }
  }
  return {"swan", {{"known.spec", text}}};
}

WrittenFiles swanLineFile(const std::vector<KnownRecord>& records) {
  std::string text = swanHeader(records[0]);
  text +=
      "QUANT\n     3\nVaDens\nm2/Hz\n   -0.9900E+02\nNDIR\ndegr\n   -0.9990E+03\n"
      "DSPRDEGR\ndegr\n   -0.9000E+01\n";
  for (const KnownRecord& record : records) {
    text += swanTime(record) + "\nLOCATION     1\n";
    for (std::size_t f = 0; f < record.spectrum.energy.frequency.size(); ++f) {
      const DirectionalMoments& m = record.spectrum.moments[f];
      text += print("%12.5E", record.spectrum.energy.density[f]);
      text += m.hasFirst() ? print(" %9.4f %9.4f\n", compassFromFromToward(m.meanDirection()),
                                   degreesFromRadians(m.spread()))
                           : std::string("  -0.9990E+03  -0.9000E+01\n");
    }
  }
  return {"swan", {{"known.spc", text}}};
}

WrittenFiles wavewatchFile(const std::vector<KnownRecord>& records) {
  const DirectionalSpectrum& first = records[0].spectrum;
  const std::size_t bins = first.energy.frequency.size();
  const std::size_t directions = first.direction.size();
  std::string text =
      print("'WAVEWATCH III SPECTRA' %5zu %5zu %5d 'known spectra'\n", bins, directions, 1);
  for (std::size_t f = 0; f < bins; ++f) {
    text += print("%11.4E%s", first.energy.frequency[f], f % 8 == 7 || f + 1 == bins ? "\n" : "");
  }
  for (std::size_t d = 0; d < directions; ++d) {
    const double toward = std::fmod(2.5 * pi - first.direction[d], 2.0 * pi);
    text += print(" %10.3E%s", toward, d % 7 == 6 || d + 1 == directions ? "\n" : "");
  }
  for (const KnownRecord& record : records) {
    const std::string date = swanTime(record);
    text += date.substr(0, 8) + " " + date.substr(9) + "\n";
    text += print("'41010     '%7.2f%7.2f%10.1f%7.2f%6.1f%7.2f%6.1f\n", record.latitude_deg,
                  record.longitude_deg, 873.0, 6.2, 190.0, 0.1, 350.0);
    for (std::size_t i = 0; i < bins * directions; ++i) {
      text += print(" %10.3E%s", record.spectrum.at(i % bins, i / bins),
                    i % 7 == 6 || i + 1 == bins * directions ? "\n" : "");
    }
  }
  return {"ww3", {{"known.ww3", text}}};
}

std::vector<double> datawellFrequencies() {
  std::vector<double> frequencies;
  for (int i = 0; i < 16; ++i) frequencies.push_back(0.025 + 0.005 * i);
  for (int i = 0; i < 48; ++i) frequencies.push_back(0.11 + 0.01 * i);
  return frequencies;
}

WrittenFiles datawellFile(const KnownRecord& record) {
  const DirectionalSpectrum& s = record.spectrum;
  const double highest = *std::max_element(s.energy.density.begin(), s.energy.density.end());
  std::string text = "1\n";
  text += print("%.1f\n%.3f\n%.6E\n", 100.0 * s.energy.significantWaveHeight(),
                s.energy.zeroCrossingPeriod(), highest);
  text += "20.0\n18.0\n7\n0.01\n0.02\n-0.01\n123\n60.0\n";
  for (std::size_t f = 0; f < s.energy.frequency.size(); ++f) {
    DirectionalMoments m = s.moments[f];
    if (!m.hasFirst())
      m = {0.01, 0.0, 0.0, 0.0};  // a Waverider gives noise where there is no energy
    // Centred on the mean direction, compass sense.
    const double m1 = m.r1();
    const double angle = std::atan2(m.b2, m.a2) - 2.0 * m.meanDirection();
    const double m2 = std::hypot(m.a2, m.b2) * std::cos(angle);
    const double n2 = -std::hypot(m.a2, m.b2) * std::sin(angle);
    text += print("%.4f,%.6E,%.3f,%.4f,%.6f,%.6f\n", s.energy.frequency[f],
                  highest > 0.0 ? s.energy.density[f] / highest : 0.0,
                  compassFromFromToward(m.meanDirection()), degreesFromRadians(m.spread()),
                  -n2 / std::pow(0.5 * (1.0 - m2), 1.5),
                  (6.0 - 8.0 * m1 + 2.0 * m2) / std::pow(2.0 * (1.0 - m1), 2.0));
  }
  const std::string& t = record.time;
  return {"datawell", {{"BUOY}" + t.substr(0, 13) + "h" + t.substr(14, 2) + ".spt", text}}};
}

WrittenFiles triaxysFile(const KnownRecord& record) {
  const std::size_t directions = record.spectrum.direction.size();
  const double step_deg = 360.0 / static_cast<double>(directions);
  std::string text = triaxysHeader(record, "DIRECTIONAL SPECTRUM");
  text += "RESOLVABLE FREQUENCY RANGE (Hz)    =   0.030  TO  0.455\n";
  text += print("NUMBER OF DIRECTIONS               = %7zu\n", directions + 1);
  text += print("DIRECTION SPACING (DEG)            = %.6f\n", step_deg);
  text += "COLUMNS = 0.00 TO 360.00 DEG\nROWS    = 0.00 TO   0.64 Hz\n";
  for (std::size_t f = 0; f <= record.spectrum.energy.frequency.size(); ++f) {
    for (std::size_t d = 0; d <= directions; ++d) {
      const double density =
          f == 0 ? 0.0 : towards(record.spectrum, f - 1, step_deg * static_cast<double>(d));
      text += print(" %.7E", density * (pi / 180.0));
    }
    text += '\n';
  }
  return {"triaxys", {{"known.dirspec", text}}};
}

WrittenFiles triaxysLineFile(const KnownRecord& record) {
  const FrequencySpectrum& energy = record.spectrum.energy;
  std::string text = triaxysHeader(record, "NON-DIRECTIONAL SPECTRUM");
  text += "COLUMN 1 = FREQUENCY (Hz)\nCOLUMN 2 = SPECTRAL DENSITY (M^2/Hz)\n0.000  0.0000000E+00\n";
  for (std::size_t f = 0; f < energy.frequency.size(); ++f) {
    text += print("%.6f  %.7E\n", energy.frequency[f], energy.density[f]);
  }
  return {"triaxys", {{"known.nondirspec", text}}};
}

WrittenFiles spotterFile(const std::vector<KnownRecord>& records) {
  std::vector<std::string> parts;
  for (const KnownRecord& record : records) {
    const DirectionalSpectrum& s = record.spectrum;
    const std::size_t n = s.energy.frequency.size();
    parts.push_back(list("frequency", n, [&](std::size_t i) { return s.energy.frequency[i]; }) +
                    "," + list("a1", n, [&](std::size_t i) { return s.moments[i].a1; }) + "," +
                    list("b1", n, [&](std::size_t i) { return s.moments[i].b1; }) + "," +
                    list("a2", n, [&](std::size_t i) { return s.moments[i].a2; }) + "," +
                    list("b2", n, [&](std::size_t i) { return s.moments[i].b2; }) + "," +
                    list("varianceDensity", n, [&](std::size_t i) { return s.energy.density[i]; }) +
                    "," + spotterPlace(record));
  }
  return {"spotter", {{"known.json", joined(parts, "frequencyData")}}};
}

WrittenFiles spotterBulkFile(const std::vector<KnownRecord>& records) {
  std::vector<std::string> parts;
  for (const KnownRecord& record : records) {
    const FrequencySpectrum& energy = record.spectrum.energy;
    const auto peak = std::max_element(energy.density.begin(), energy.density.end());
    const DirectionalMoments& m =
        record.spectrum.moments[static_cast<std::size_t>(peak - energy.density.begin())];
    parts.push_back(print("\"significantWaveHeight\":%.3f,\"peakPeriod\":%.3f,",
                          energy.significantWaveHeight(), energy.peakPeriod()) +
                    print("\"meanDirection\":%.2f,\"meanDirectionalSpread\":%.3f,",
                          compassFromFromToward(m.meanDirection()),
                          degreesFromRadians(m.spread())) +
                    spotterPlace(record));
  }
  return {"spotter", {{"bulk.json", joined(parts, "waves")}}};
}

std::vector<WrittenFiles> everyFormat(std::size_t bins, std::size_t directions) {
  const auto records = knownRecords(bins, directions);
  KnownRecord waverider = records[0];
  waverider.spectrum = spreadByCosinePower(onBins(jonswap({2.0, 6.0, 2.0}), datawellFrequencies()),
                                           towardFromCompassFrom(350.0), 6.0);
  return {ndbcRealtimeFiles(records), ndbcYearlyFiles(records),    swanFile(records),
          swanLineFile(records),      wavewatchFile(records),      datawellFile(waverider),
          triaxysFile(records[0]),    triaxysLineFile(records[0]), spotterFile(records),
          spotterBulkFile(records)};
}

}  // namespace seaway::test
