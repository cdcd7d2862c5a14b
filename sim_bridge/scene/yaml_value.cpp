#include "sim_bridge/scene/yaml_value.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <fstream>
#include <iterator>

#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

// Aliases can make a small file unfold without end; no scene comes near these.
constexpr int deepest = 32;
constexpr std::size_t mostValues = 1'000'000;

class Converter {
 public:
  explicit Converter(std::shared_ptr<const std::filesystem::path> file) : file_(std::move(file)) {}

  YamlValue convert(const YAML::Node& node, const std::string& name, const std::string& key,
                    int depth) {
    YamlValue value;
    value.name = name;
    value.key = key;
    value.file = file_;
    value.line = node.Mark().line + 1;
    if (depth > deepest || ++count_ > mostValues) value.fail("is nested too deep or too large");
    if (node.IsScalar()) {
      value.kind = YamlValue::Kind::scalar;
      value.scalar = node.Scalar();
    } else if (node.IsSequence()) {
      addItems(value, node, depth);
    } else if (node.IsMap()) {
      addEntries(value, node, depth);
    }
    return value;
  }

 private:
  void addItems(YamlValue& list, const YAML::Node& node, int depth) {
    list.kind = YamlValue::Kind::list;
    for (const YAML::Node& item : node) {
      const std::string name = "[" + std::to_string(list.values.size()) + "]";
      list.values.push_back(convert(item, name, list.key + name, depth + 1));
    }
  }

  void addEntries(YamlValue& mapping, const YAML::Node& node, int depth) {
    mapping.kind = YamlValue::Kind::mapping;
    for (const auto& entry : node) {
      if (!entry.first.IsScalar()) mapping.fail("has a key that is not plain text");
      const std::string name = entry.first.Scalar();
      const bool again = mapping.find(name) != nullptr;
      YamlValue value = convert(entry.second, name,
                                mapping.key.empty() ? name : mapping.key + "." + name, depth + 1);
      value.line = entry.first.Mark().line + 1;  // a nested value's own mark is a line too far
      if (again) value.fail("is given twice");
      mapping.values.push_back(std::move(value));
    }
  }

  std::shared_ptr<const std::filesystem::path> file_;
  std::size_t count_ = 0;
};

}  // namespace

const YamlValue* YamlValue::find(std::string_view childName) const {
  if (kind != Kind::mapping) return nullptr;
  const auto found = std::find_if(values.begin(), values.end(),
                                  [&](const YamlValue& value) { return value.name == childName; });
  return found == values.end() ? nullptr : &*found;
}

std::string YamlValue::shown() const {
  switch (kind) {
    case Kind::null:
      return "nothing";
    case Kind::scalar:
      return scalar.empty() ? "''" : scalar;
    case Kind::list:
      return "a list";
    case Kind::mapping:
      return "a mapping";
  }
  return "";
}

void YamlValue::fail(const std::string& what) const {
  throw InputError(file->string(), line, (key.empty() ? "" : "key '" + key + "': ") + what);
}

YamlValue parseYaml(const std::string& text, const std::filesystem::path& file) {
  try {
    const std::vector<YAML::Node> documents = YAML::LoadAll(text);
    if (documents.size() > 1) {
      throw InputError(file.string(), documents[1].Mark().line + 1,
                       "a second YAML document starts here; a file holds one");
    }
    return Converter(std::make_shared<const std::filesystem::path>(file))
        .convert(documents.empty() ? YAML::Node() : documents[0], "", "", 0);
  } catch (const YAML::Exception& fault) {
    throw InputError(
        file.string(), fault.mark.line + 1,
        "not valid YAML: " + fault.msg + " (column " + std::to_string(fault.mark.column + 1) + ")");
  }
}

YamlValue readYaml(const std::filesystem::path& file) {
  std::error_code ignored;
  if (!std::filesystem::exists(file, ignored)) throw InputError(file.string(), 0, "no such file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream || std::filesystem::is_directory(file, ignored)) {
    throw InputError(file.string(), 0, "cannot be read");
  }
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parseYaml(text, file);
}

}  // namespace seaway::bridge
