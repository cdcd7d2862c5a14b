#include <cmath>
#include <nlohmann/json.hpp>

#include "surface/angles.h"
#include "surface/input_error.h"
#include "surface/spectra/families.h"
#include "surface/spectra/readers/formats.h"
#include "surface/spectra/readers/time_stamp.h"

// Sofar Ocean API, wave-data: an object, perhaps under "data", with "frequencyData" (spectra:
// frequency, varianceDensity in m²/Hz, a1 b1 a2 b2 toward, counter-clockwise from east) and "waves"
// (bulk parameters; directions from, degrees true; spread √(2(1 − r₁)) in degrees).
namespace seaway::formats {
namespace {

using Json = nlohmann::json;

/// A value and the way to it, for messages.
struct Node {
  const Json& json;
  std::string file;
  std::string path;

  [[noreturn]] void fail(const std::string& what) const {
    throw InputError(file, 0, "key '" + path + "': " + what);
  }
  const Json* find(const char* key) const {
    const auto found = json.find(key);
    return found == json.end() || found->is_null() ? nullptr : &*found;
  }
  bool has(const char* key) const { return find(key) != nullptr; }
  Node operator[](const char* key) const {
    const Json* found = find(key);
    if (!found) fail("lacks '" + std::string(key) + "'");
    return {*found, file, path + "." + key};
  }
  Node operator[](std::size_t i) const {
    return {json[i], file, path + "[" + std::to_string(i) + "]"};
  }
  double number() const {
    if (!json.is_number()) fail("must be a number");
    return json.get<double>();
  }
  double number(double least, double most, const char* range) const {
    const double value = number();
    if (!(value >= least && value <= most)) {
      fail(json.dump() + " is not allowed; must be " + range);
    }
    return value;
  }
};

std::vector<double> numbersOf(const Node& node) {
  if (!node.json.is_array()) node.fail("must be a list of numbers");
  std::vector<double> numbers;
  for (std::size_t i = 0; i < node.json.size(); ++i) numbers.push_back(node[i].number());
  return numbers;
}

SpectrumRecord timeAndPlace(const Node& node) {
  SpectrumRecord record;
  record.file = node.file;
  const Node stamp = node["timestamp"];
  if (!stamp.json.is_string()) stamp.fail("must be text");
  const auto moment = parseIsoTime(stamp.json.get_ref<const std::string&>());
  if (!moment) stamp.fail("is not of the form 2018-02-14T00:27:19.000Z");
  record.time = isoTime(*moment);
  if (node.has("latitude") && node.has("longitude")) {
    record.position = RecordPosition{node["latitude"].number(-90.0, 90.0, "in [-90, 90]"),
                                     node["longitude"].number(-360.0, 360.0, "in [-360, 360]")};
  }
  return record;
}

/// A list of the record that has one value for each frequency; empty where it is not there.
std::vector<double> columnOf(const Node& node, const char* key, std::size_t size) {
  if (!node.has(key)) return {};
  std::vector<double> column = numbersOf(node[key]);
  if (column.size() != size) {
    node[key].fail("has " + std::to_string(column.size()) + " values for " + std::to_string(size) +
                   " frequencies");
  }
  return column;
}

void readMoments(const Node& node, SpectrumRecord& record) {
  const std::size_t size = record.spectrum.energy.frequency.size();
  const auto column = [&](const char* key) { return columnOf(node, key, size); };
  const auto a1 = column("a1"), b1 = column("b1"), a2 = column("a2"), b2 = column("b2");
  const auto from_deg = column("direction"), spread_deg = column("directionalSpread");
  const bool first = !a1.empty() && !b1.empty();
  const bool mean = !from_deg.empty() && !spread_deg.empty();
  if (!first && !mean) return;
  for (std::size_t i = 0; i < size; ++i) {
    DirectionalMoments moments;
    if (first) {
      moments.a1 = a1[i];
      moments.b1 = b1[i];
    } else {
      moments = momentsOfMeanDirection(from_deg[i], std::fmax(0.0, r1OfSpread(spread_deg[i])));
    }
    if (!a2.empty() && !b2.empty()) {
      moments.a2 = a2[i];
      moments.b2 = b2[i];
    }
    record.spectrum.moments.push_back(moments);
  }
}

SpectrumRecord spectralRecord(const Node& node) {
  SpectrumRecord record = timeAndPlace(node);
  FrequencySpectrum& energy = record.spectrum.energy;
  energy.frequency = numbersOf(node["frequency"]);
  energy.density = columnOf(node, "varianceDensity", energy.frequency.size());
  if (energy.density.empty()) node.fail("lacks 'varianceDensity'");
  readMoments(node, record);
  if (const auto wrong = record.spectrum.validate()) node.fail(*wrong);
  return record;
}

/// Bulk parameters become the least that agrees with them: a Pierson–Moskowitz spectrum, and first
/// moments that are the same at every frequency.
SpectrumRecord bulkRecord(const Node& node) {
  SpectrumRecord record = timeAndPlace(node);
  const double height = node["significantWaveHeight"].number(0.0, 100.0, "in [0, 100] m");
  const double period = node["peakPeriod"].number(0.1, 100.0, "in [0.1, 100] s");
  record.spectrum.energy = piersonMoskowitz(height > 0.0 ? height : 1.0, period);
  if (height == 0.0) {
    for (double& density : record.spectrum.energy.density) density = 0.0;
  }
  record.notes.push_back(
      "bulk parameters only: a Pierson-Moskowitz spectrum of their wave height and peak period");
  if (node.has("meanDirection") && node.has("meanDirectionalSpread")) {
    const double from_deg = node["meanDirection"].number(-360.0, 360.0, "in [-360, 360]");
    const double spread_deg = node["meanDirectionalSpread"].number(0.0, 81.1, "in [0, 81] deg");
    const DirectionalMoments moments =
        momentsOfMeanDirection(from_deg, std::fmax(0.0, r1OfSpread(spread_deg)));
    record.spectrum.moments.assign(record.spectrum.energy.frequency.size(), moments);
    record.notes.push_back("their mean direction and spread are taken at every frequency");
  }
  return record;
}

std::vector<SpectrumRecord> recordsOf(const Node& list, SpectrumRecord (*readOne)(const Node&)) {
  if (!list.json.is_array()) list.fail("must be a list");
  std::vector<SpectrumRecord> records;
  for (std::size_t i = 0; i < list.json.size(); ++i) {
    const Node node = list[i];
    if (!node.json.is_object()) node.fail("must be a mapping");
    records.push_back(readOne(node));
  }
  return records;
}

Json parsed(const TextFile& file) {
  try {
    return Json::parse(file.text);
  } catch (const Json::exception& fault) {
    throw InputError(file.name, 0, std::string("is not JSON: ") + fault.what());
  }
}

}  // namespace

bool looksLikeSpotter(const TextFile& file) {
  const std::size_t start = file.text.find_first_not_of(" \t\r\n");
  return start != std::string::npos && file.text[start] == '{';
}

std::vector<SpectrumRecord> readSpotter(const TextFile& file) {
  const Json whole = parsed(file);
  const Node root{whole, file.name, "(top)"};
  if (!whole.is_object()) throw InputError(file.name, 0, "must be a JSON object");
  const Node data = root.has("data") ? Node{*root.find("data"), file.name, "data"} : root;
  if (!data.json.is_object()) data.fail("must be a mapping");
  std::vector<SpectrumRecord> records;
  const bool spectra = data.has("frequencyData");
  if (spectra) records = recordsOf(data["frequencyData"], spectralRecord);
  if (records.empty() && data.has("waves")) records = recordsOf(data["waves"], bulkRecord);
  if (records.empty()) data.fail("lacks records in 'frequencyData' or 'waves'");
  if (data.has("spotterId") && data["spotterId"].json.is_string()) {
    for (SpectrumRecord& record : records) record.location = data["spotterId"].json;
  }
  return records;
}

}  // namespace seaway::formats
