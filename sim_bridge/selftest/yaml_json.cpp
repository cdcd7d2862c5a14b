#include "sim_bridge/selftest/yaml_json.h"

#include <yaml-cpp/yaml.h>

#include <algorithm>

namespace seaway::bridge {
namespace {

using Json = nlohmann::ordered_json;

Json scalarOf(const std::string& text) {
  const Json parsed = Json::parse(text, nullptr, false);
  return parsed.is_number() ? parsed : Json(text);
}

void emit(const Json& value, YAML::Emitter& out) {
  if (value.is_object()) {
    out << YAML::BeginMap;
    for (const auto& [key, child] : value.items()) {
      out << YAML::Key << key << YAML::Value;
      emit(child, out);
    }
    out << YAML::EndMap;
  } else if (value.is_array()) {
    const bool short_ = std::none_of(value.begin(), value.end(),
                                     [](const Json& item) { return item.is_structured(); });
    out << (short_ ? YAML::Flow : YAML::Block) << YAML::BeginSeq;
    for (const Json& item : value) emit(item, out);
    out << YAML::EndSeq;
  } else if (value.is_string()) {
    out << value.get<std::string>();
  } else {
    out << value.dump();
  }
}

}  // namespace

Json jsonFromYaml(const YamlValue& value) {
  switch (value.kind) {
    case YamlValue::Kind::null:
      return Json::object();
    case YamlValue::Kind::scalar:
      return scalarOf(value.scalar);
    case YamlValue::Kind::list: {
      Json list = Json::array();
      for (const YamlValue& item : value.values) list.push_back(jsonFromYaml(item));
      return list;
    }
    case YamlValue::Kind::mapping: {
      Json mapping = Json::object();
      for (const YamlValue& entry : value.values) mapping[entry.name] = jsonFromYaml(entry);
      return mapping;
    }
  }
  return {};
}

std::string yamlFromJson(const Json& value) {
  YAML::Emitter out;
  emit(value, out);
  return std::string(out.c_str()) + "\n";
}

void makePathsAbsolute(Json& value, const std::filesystem::path& folder) {
  if (value.is_string()) {
    const auto file = (folder / value.get<std::string>()).lexically_normal();
    std::error_code ignored;
    if (std::filesystem::is_regular_file(file, ignored)) value = file.string();
  } else if (value.is_structured()) {
    for (Json& child : value) makePathsAbsolute(child, folder);
  }
}

}  // namespace seaway::bridge
