#include "sim_bridge/selftest/hard_case.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <stdexcept>

#include "sim_bridge/scene/schema_fields.h"
#include "sim_bridge/selftest/served_case.h"
#include "sim_bridge/selftest/yaml_json.h"

namespace seaway::bridge {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

/// A folder of its own that goes with the object.
class Workplace {
 public:
  Workplace() {
    std::string pattern = (fs::temp_directory_path() / "seaway_selftest_XXXXXX").string();
    if (!mkdtemp(pattern.data())) throw std::runtime_error("no temporary folder can be made");
    path_ = pattern;
  }
  ~Workplace() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Workplace(const Workplace&) = delete;
  Workplace& operator=(const Workplace&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// Puts `value` where a path such as `cameras[0].pitch_deg` says; what is not there is made.
void put(Json& scene, const std::string& path, const Json& value) {
  std::string pointer;
  for (const char c : path) {
    if (c == '.' || c == '[') pointer += '/';
    if (c != '.' && c != '[' && c != ']') pointer += c;
  }
  scene[Json::json_pointer("/" + pointer)] = value;
}

std::vector<std::string> wordsOf(const YamlValue& value) {
  requireKind(value, YamlValue::Kind::list, "a list of words");
  std::vector<std::string> words;
  for (const YamlValue& item : value.values) words.push_back(readText(item));
  return words;
}

const Mapping<Expectation>& expectationSchema() {
  static const Mapping<Expectation> schema({
      choice("status", &Expectation::status,
             {{"works", Expected::works},
              {"refuses", Expected::refuses},
              {"either", Expected::either}},
             "how it ends"),
      text("says", &Expectation::says, "regular expression that its output matches"),
      choice("names_line", &Expectation::namesFile, {{"true", true}, {"false", false}},
             "whether a refusal names file and line"),
  });
  return schema;
}

/// A case as the file has it.
struct Entry {
  HardCase result;
  std::string base;
  Json replaced = Json::object();
};

Field<Entry> field(const char* key, const char* type, const char* summary, Need need,
                   std::function<void(Entry&, const YamlValue&)> read) {
  return {{key, type, "", "", "", need, summary, {}}, std::move(read)};
}

Mapping<Entry> caseSchema() {
  const auto textInto = [](std::string HardCase::*member) {
    return [=](Entry& entry, const YamlValue& value) { entry.result.*member = readText(value); };
  };
  return Mapping<Entry>({
      field("name", "text", "of the case", Need::required, textInto(&HardCase::name)),
      field("area", "text", "what it is of", Need::required, textInto(&HardCase::area)),
      field("property", "text", "what must hold", Need::required, textInto(&HardCase::property)),
      text("scene", &Entry::base, "scene file, relative to this one"),
      field("with", "mapping", "values that are put into the scene, by their paths", Need::optional,
            [](Entry& entry, const YamlValue& value) { entry.replaced = jsonFromYaml(value); }),
      field("command", "list", "words of the command line, SCENE and OUT in them", Need::required,
            [](Entry& entry, const YamlValue& value) { entry.result.arguments = wordsOf(value); }),
      field("expect", "mapping", "how it ends", Need::optional,
            [](Entry& entry, const YamlValue& value) {
              entry.result.expectation = expectationSchema().read(value);
            }),
  });
}

struct Catalogue {
  std::vector<Entry> cases;
  std::vector<HardTests> tests;
};

const Mapping<Catalogue>& catalogueSchema() {
  using T = HardTests;
  static const Mapping<Catalogue> schema({
      list("cases", &Catalogue::cases, caseSchema(), "tried by `seaway selftest`"),
      list("tests", &Catalogue::tests,
           Mapping<T>({
               text("area", &T::area, "what they are of", Need::required),
               text("covers", &T::covers, "what is hard", Need::required),
               text("tests", &T::tests, "regular expression of their names", Need::required),
           }),
           "tried by `ctest -L hard`"),
  });
  return schema;
}

void write(const fs::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  if (!stream.flush()) throw std::runtime_error(file.string() + " cannot be written");
}

}  // namespace

HardCases readHardCases(const fs::path& file) {
  Catalogue catalogue = catalogueSchema().read(readYaml(file));
  HardCases all{{}, std::move(catalogue.tests)};
  for (Entry& entry : catalogue.cases) {
    if (!entry.base.empty()) {
      const fs::path base = fs::absolute(file.parent_path() / entry.base).lexically_normal();
      entry.result.scene = jsonFromYaml(readYaml(base));
      makePathsAbsolute(entry.result.scene, base.parent_path());
      for (const auto& [path, value] : entry.replaced.items()) {
        put(entry.result.scene, path, value);
      }
    }
    all.cases.push_back(std::move(entry.result));
  }
  return all;
}

std::string tryCase(const HardCase& hardCase, const fs::path& program, const ChildLimits& limits,
                    double* seconds) {
  const Workplace place;
  const fs::path scene = place.path() / "scene.yaml", out = place.path() / "out";
  if (!hardCase.scene.is_null()) write(scene, yamlFromJson(hardCase.scene));
  fs::create_directory(out);
  std::vector<std::string> arguments;
  for (std::string word : hardCase.arguments) {
    if (word == "SCENE") word = scene.string();
    if (word.starts_with("OUT")) word = out.string() + word.substr(3);
    arguments.push_back(std::move(word));
  }
  std::string served;
  ChildLimits within = limits;
  if (hardCase.endpoints > 0) {
    within.isEnough = [&](const std::string& err) {
      return askService(err, hardCase.endpoints, served);
    };
  }
  const ChildOutcome outcome = runProgram(program, arguments, within);
  if (seconds) *seconds = outcome.seconds;
  const std::string fault = faultOf(outcome, hardCase.expectation, out);
  return fault.empty() ? served : fault;
}

}  // namespace seaway::bridge
