#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct SchemaOptions {
  bool json = false;
};

/// `seaway schema`: every key of scene, vessel and sea state files.
int runSchema(const SchemaOptions& options, std::ostream& out);
void addSchemaCommand(CLI::App& app, ChosenCommand& chosen);

/// The page as Markdown: configs/SCHEMA.md.
std::string schemaPage();

}  // namespace seaway::bridge
