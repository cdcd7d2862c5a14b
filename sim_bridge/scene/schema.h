#pragma once

#include <cstdint>
#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/yaml_value.h"

/// Schemas of YAML files. One table (scene_schema.cpp and its like) says for every key what it is
/// called, its unit, range, default and meaning, and which member of a struct it fills: reading,
/// checking and the schema page all follow it.
namespace seaway::bridge {

/// Numbers that a key allows.
struct Range {
  double least = -std::numeric_limits<double>::infinity();
  double most = std::numeric_limits<double>::infinity();
  bool leastIncluded = true;
  bool mostIncluded = true;
  bool infinityAllowed = false;  ///< +inf, whatever `most` says

  static Range any() { return {}; }
  static Range above(double bound) { return {.least = bound, .leastIncluded = false}; }
  static Range atLeast(double bound) { return {.least = bound}; }
  static Range within(double least, double most) { return {.least = least, .most = most}; }
  static Range between(double least, double most) {
    return {.least = least, .most = most, .leastIncluded = false, .mostIncluded = false};
  }
  Range orInfinite() const {
    Range range = *this;
    range.infinityAllowed = true;
    return range;
  }

  bool holds(double value) const;
  std::string text() const;      ///< "> 0", "[-90, 90]", "finite"
  std::string sentence() const;  ///< "must be > 0", "must be in [-90, 90]"
};

enum class Need { required, optional };

/// One key as the schema page shows it.
struct KeyDescription {
  std::string key;
  std::string type;
  std::string unit;
  std::string allowed;
  std::string defaultText;  ///< empty where required, or where the absence itself means something
  Need need = Need::optional;
  std::string summary;
  std::vector<KeyDescription> children;  ///< keys of a mapping, or of each mapping in a list
  std::optional<Range> range{};          ///< of numbers, whole ones too
  std::vector<std::string> words{};      ///< that a word may be
  int components = 0;                    ///< of a list of numbers
};

/// One key: its description and how it fills a `T`.
template <class T>
struct Field {
  KeyDescription description;
  std::function<void(T&, const YamlValue&)> read;
};

// Reading of single values; each throws InputError naming file, line, key, value and what is
// allowed.
double readNumber(const YamlValue& value, const Range& range, const std::string& unit);
std::int64_t readInteger(const YamlValue& value, std::int64_t least, std::int64_t most);
std::string readText(const YamlValue& value);
std::string readName(const YamlValue& value);  ///< letters, digits, '_' and '-': also file names
const YamlValue& requireKind(const YamlValue& value, YamlValue::Kind kind, const char* wanted);
[[noreturn]] void failUnknownKey(const YamlValue& value, const std::vector<std::string>& known);
[[noreturn]] void failChoice(const YamlValue& value, const std::vector<std::string>& choices);

/// The candidate with the fewest edits from `word`; empty when none is near.
std::string nearestName(const std::string& word, const std::vector<std::string>& candidates);

/// Checks a `value` from the command line against the range of a key. Throws InputError.
void requireInRange(const std::string& name, double value, const Range& range,
                    const std::string& unit);

/// How a mapping's keys fill a `T`.
template <class T>
class Mapping {
 public:
  using Check = std::function<void(const T&, const YamlValue&)>;

  Mapping(std::vector<Field<T>> fields, Check check = nullptr)
      : fields_(std::move(fields)), check_(std::move(check)) {}

  /// A mapping of which exactly one key is given.
  static Mapping oneOf(std::vector<Field<T>> fields) {
    Mapping mapping(std::move(fields));
    mapping.exactlyOne_ = true;
    return mapping;
  }

  void read(T& target, const YamlValue& value) const {
    if (value.kind != YamlValue::Kind::null) {
      requireKind(value, YamlValue::Kind::mapping, "a mapping of keys to values");
    }
    for (const YamlValue& entry : value.values) {
      const Field<T>* field = find(entry.name);
      if (!field) failUnknownKey(entry, names());
      field->read(target, entry);
    }
    requireKeys(value);
    if (check_) check_(target, value);
  }

  T read(const YamlValue& value) const {
    T target{};
    read(target, value);
    return target;
  }

  bool exactlyOne() const { return exactlyOne_; }

  std::vector<KeyDescription> describe() const {
    std::vector<KeyDescription> descriptions;
    for (const Field<T>& field : fields_) descriptions.push_back(field.description);
    return descriptions;
  }

 private:
  const Field<T>* find(const std::string& name) const {
    for (const Field<T>& field : fields_) {
      if (field.description.key == name) return &field;
    }
    return nullptr;
  }

  std::vector<std::string> names() const {
    std::vector<std::string> all;
    for (const Field<T>& field : fields_) all.push_back(field.description.key);
    return all;
  }

  void requireKeys(const YamlValue& value) const {
    if (exactlyOne_ && value.values.size() != 1) {
      std::string all;
      for (const std::string& name : names()) all += (all.empty() ? "" : ", ") + name;
      value.fail("needs exactly one of: " + all);
    }
    for (const Field<T>& field : fields_) {
      const KeyDescription& wanted = field.description;
      if (wanted.need == Need::required && !value.find(wanted.key)) {
        value.fail("lacks '" + wanted.key + "' (" + wanted.summary + ")");
      }
    }
  }

  std::vector<Field<T>> fields_;
  Check check_;
  bool exactlyOne_ = false;
};

}  // namespace seaway::bridge
