#pragma once

#include <iosfwd>
#include <string>

#include "sim_bridge/commands/command.h"

namespace seaway::bridge {

struct GalleryOptions {
  std::string list = "configs/gallery.yaml";
  std::string out;     ///< folder of the page; empty: none
  std::string golden;  ///< folder of small pictures; empty: none
  std::string backend = "osmesa";
};

/// `seaway gallery`: draws the pictures of a list.
///
/// With `out` a page, index.html, that holds them with camera, ms a frame, effects and the command
/// that draws each, and beside it NAME.png. With `golden` NAME.png of 240x135 pixels and
/// contact_sheet.png, four a row in the list's order. Files appear whole, the page last.
int runGallery(const GalleryOptions& options, std::ostream& out);
void addGalleryCommand(CLI::App& app, ChosenCommand& chosen);

}  // namespace seaway::bridge
