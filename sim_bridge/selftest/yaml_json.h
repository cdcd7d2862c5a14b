#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "sim_bridge/scene/yaml_value.h"

namespace seaway::bridge {

/// A YAML value as JSON; scalars that are numbers in JSON too become such, other ones are text.
nlohmann::ordered_json jsonFromYaml(const YamlValue& value);

/// JSON as YAML text.
std::string yamlFromJson(const nlohmann::ordered_json& value);

/// Every text that names a file seen from `folder` becomes that file's absolute path.
void makePathsAbsolute(nlohmann::ordered_json& value, const std::filesystem::path& folder);

}  // namespace seaway::bridge
