#include "sim_bridge/commands/gallery.h"

#include <spdlog/fmt/fmt.h>

#include <CLI/CLI.hpp>
#include <iostream>

#include "render/headless_context.h"
#include "render/png.h"
#include "sim_bridge/commands/options.h"
#include "sim_bridge/gallery/gallery_drawing.h"
#include "sim_bridge/output/atomic_file.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/output/progress.h"
#include "sim_bridge/report/html_page.h"
#include "sim_bridge/scene/scene_loader.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

std::string memoryText(std::size_t bytes) {
  return bytes < 1024 ? fmt::format("{} B", bytes)
                      : fmt::format("{:.1f} MiB", static_cast<double>(bytes) / 1048576.0);
}

void addPicture(const Gallery& gallery, const GalleryPicture& picture, const DrawnPicture& drawn,
                HtmlPage& page) {
  const render::FrameStats& stats = drawn.frame.stats;
  page.heading(picture.name);
  page.picture(render::pngBytes(drawn.frame.colour), picture.caption);
  page.paragraph(fmt::format("{}, {}x{}, {} s. Drawn in {:.0f} ms by {}{}{} on {}.", drawn.seen,
                             picture.size.x, picture.size.y, picture.time, drawn.milliseconds,
                             stats.technique, stats.variant.empty() ? "" : "/", stats.variant,
                             stats.renderer));
  std::vector<std::vector<std::string>> rows;
  for (const EffectReport& effect : drawn.effects) {
    rows.push_back({std::string(effectName(effect.effect)), memoryText(effect.memoryBytes),
                    effect.costInside ? fmt::format("inside {}", effectName(*effect.costInside))
                                      : fmt::format("{:.2f} ms", 1e-3 * effect.costMicroseconds)});
  }
  page.table({"effect", "memory", "a frame"}, rows);
  page.code(commandOf(gallery, picture));
}

void writePage(const Gallery& gallery, const GalleryOptions& options, Progress& progress) {
  HtmlPage page("Seaway: gallery");
  page.paragraph(
      "Drawn on this machine. Milliseconds are the median of three frames after the first; memory "
      "and cost of effects are those of one of them, effects without a pass of their own inside "
      "another's.");
  const std::filesystem::path folder(options.out);
  std::size_t done = 0;
  for (const GalleryPicture& picture : gallery.pictures) {
    const DrawnPicture drawn = drawPicture(gallery, picture, picture.size, options.backend, 3);
    writePicture(folder / (picture.name + ".png"), drawn.frame.colour);
    addPicture(gallery, picture, drawn, page);
    progress.update(++done);
  }
  AtomicFile file(folder / "index.html");
  file.stream() << page.text();
  file.commit();
}

void writeGolden(const Gallery& gallery, const GalleryOptions& options, Progress& progress) {
  const std::filesystem::path folder(options.golden);
  std::vector<render::ColourImage> pictures;
  for (const GalleryPicture& picture : gallery.pictures) {
    pictures.push_back(drawPicture(gallery, picture, goldenSize, options.backend, 0).frame.colour);
    writePicture(folder / (picture.name + ".png"), pictures.back());
    progress.update(pictures.size());
  }
  writePicture(folder / "contact_sheet.png", contactSheet(pictures, 4));
}

}  // namespace

int runGallery(const GalleryOptions& options, std::ostream& out) {
  render::requireBackend(options.backend);
  if (options.out.empty() && options.golden.empty()) {
    throw InputError("gallery: --out or --golden is wanted, the folder to write to");
  }
  const Gallery gallery = loadGallery(options.list);
  for (const GalleryPicture& picture : gallery.pictures) loadScene(gallery.sceneOf(picture));
  for (const std::string* folder : {&options.out, &options.golden}) {
    if (!folder->empty()) requireWritableFolder(*folder);
  }
  if (!options.out.empty()) {
    Progress progress("pictures", gallery.pictures.size());
    writePage(gallery, options, progress);
    out << options.out << "/index.html: " << gallery.pictures.size() << " pictures\n";
  }
  if (!options.golden.empty()) {
    Progress progress("golden", gallery.pictures.size());
    writeGolden(gallery, options, progress);
    out << options.golden << ": " << gallery.pictures.size() << " pictures and contact_sheet.png\n";
  }
  return 0;
}

void addGalleryCommand(CLI::App& app, ChosenCommand& chosen) {
  auto* command =
      app.add_subcommand("gallery", "Draw a list of pictures: a page, or golden pictures of tests");
  auto options = std::make_shared<GalleryOptions>();
  command->add_option("LIST", options->list, "YAML file of pictures")->capture_default_str();
  command->add_option("--out", options->out, "folder of the page, index.html, and its pictures")
      ->check(mustBeNamed);
  command
      ->add_option("--golden", options->golden,
                   "folder of pictures of 240x135 pixels and their contact sheet: those that tests "
                   "compare with lie in tests/golden")
      ->check(mustBeNamed);
  addBackendOption(*command, options->backend);
  command->footer(
      "Example:\n  seaway gallery --out out/gallery\n  seaway gallery --golden tests/golden");
  command->callback([=, &chosen] { chosen = [=] { return runGallery(*options, std::cout); }; });
}

}  // namespace seaway::bridge
