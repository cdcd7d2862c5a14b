#include "sim_bridge/commands/schema_command.h"

#include <CLI/CLI.hpp>
#include <iostream>
#include <nlohmann/json.hpp>

#include "sim_bridge/scene/scene_loader.h"

namespace seaway::bridge {
namespace {

struct Document {
  const char* name;
  const char* title;
  const char* files;
  std::vector<KeyDescription> keys;
};

std::vector<Document> documents() {
  return {
      {"scene", "Scenes", "configs/scenes/*.yaml", sceneSchema().describe()},
      {"vessel", "Vessels", "configs/vessels/*.yaml", vesselModelSchema().describe()},
      {"sea_state", "Sea states", "configs/sea_states/*.yaml", seaStateFileSchema().describe()}};
}

std::string pathOf(const std::string& parent, const KeyDescription& key) {
  return parent.empty() ? key.key : parent + "." + key.key;
}

// Keys of each item of a list stand under `list[]`.
std::string childPath(const std::string& path, const KeyDescription& key) {
  return key.type == "list of mappings" ? path + "[]" : path;
}

template <class Visit>
void visitKeys(const std::vector<KeyDescription>& keys, const std::string& parent, Visit&& visit) {
  for (const KeyDescription& key : keys) {
    const std::string path = pathOf(parent, key);
    visit(path, key);
    visitKeys(key.children, childPath(path, key), visit);
  }
}

std::string defaultShown(const KeyDescription& key) {
  if (key.need == Need::required) return "required";
  return key.defaultText.empty() ? "–" : "`" + key.defaultText + "`";
}

nlohmann::ordered_json asJson(const Document& document) {
  nlohmann::ordered_json keys = nlohmann::ordered_json::array();
  visitKeys(document.keys, "", [&](const std::string& path, const KeyDescription& key) {
    nlohmann::ordered_json entry{{"key", path},
                                 {"type", key.type},
                                 {"unit", key.unit},
                                 {"allowed", key.allowed},
                                 {"required", key.need == Need::required},
                                 {"summary", key.summary}};
    entry["default"] = key.defaultText.empty() ? nlohmann::ordered_json(nullptr)
                                               : nlohmann::ordered_json(key.defaultText);
    keys.push_back(std::move(entry));
  });
  return {{"name", document.name}, {"files", document.files}, {"keys", std::move(keys)}};
}

}  // namespace

std::string schemaPage() {
  std::string page =
      "# Keys of Seaway's files\n\n"
      "Written by `seaway schema`; a test keeps it true. Lengths are metres, times seconds, angles "
      "compass degrees (clockwise from north), `toward` or `from` as the key says. Paths are "
      "relative to the file that names them. Unknown keys are errors.\n";
  for (const Document& document : documents()) {
    page +=
        std::string("\n## ") + document.title + " (`" + document.files +
        "`)\n\n| key | type | unit | allowed | default | meaning |\n|---|---|---|---|---|---|\n";
    visitKeys(document.keys, "", [&](const std::string& path, const KeyDescription& key) {
      page += "| `" + path + "` | " + key.type + " | " + key.unit + " | " + key.allowed + " | " +
              defaultShown(key) + " | " + key.summary + " |\n";
    });
  }
  return page;
}

int runSchema(const SchemaOptions& options, std::ostream& out) {
  if (!options.json) {
    out << schemaPage();
    return 0;
  }
  nlohmann::ordered_json all = nlohmann::ordered_json::array();
  for (const Document& document : documents()) all.push_back(asJson(document));
  out << nlohmann::ordered_json{{"documents", all}}.dump(2) << '\n';
  return 0;
}

void addSchemaCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command =
      app.add_subcommand("schema", "Print every key of scene, vessel and sea state files");
  auto options = std::make_shared<SchemaOptions>();
  command->add_flag("--json", options->json, "machine-readable");
  command->footer("Example:\n  seaway schema > configs/SCHEMA.md");
  command->callback([=, &chosen] { chosen = [=] { return runSchema(*options, std::cout); }; });
}

}  // namespace seaway::bridge
