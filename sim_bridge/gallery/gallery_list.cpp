#include "sim_bridge/gallery/gallery_list.h"

#include <spdlog/fmt/fmt.h>

#include <set>

#include "sim_bridge/output/number_text.h"
#include "sim_bridge/scene/raised_place_schema.h"

namespace seaway::bridge {
namespace {

Mapping<GalleryPicture> pictureSchema() {
  using G = GalleryPicture;
  const Range compass = Range::within(-360.0, 360.0);
  const auto place = raisedPlaceSchema<CameraPlace>("above the still-water level");
  return Mapping<G>({
      name("name", &G::name, "of its files, unique"),
      text("scene", &G::scenePath, "scene file, relative to the list", Need::required),
      text("camera", &G::camera, "one of the scene's"),
      mapping("from", &G::from, place, "a camera of its own"),
      number("yaw_deg", &G::yaw_deg, "°", compass, "of such a camera"),
      number("pitch_deg", &G::pitch_deg, "°", Range::within(-90.0, 90.0), "of such a camera"),
      number("roll_deg", &G::roll_deg, "°", compass, "of such a camera"),
      number("fov_deg", &G::fieldOfView_deg, "°", Range::within(1.0, 170.0), "of such a camera"),
      number("time_s", &G::time, "s", Range::within(0.0, 1e9), "since the scene's epoch"),
      vector("size", &G::size, "pixels", Range::within(1, 8192), "width and height"),
      text("technique", &G::technique, "as in `seaway render`"),
      text("variant", &G::variant, "as in `seaway render`"),
      text("caption", &G::caption, "what it shows", Need::required),
  });
}

}  // namespace

Gallery loadGallery(const std::filesystem::path& file) {
  const Mapping<Gallery> schema({
      list("pictures", &Gallery::pictures, pictureSchema(), "the pictures, in order",
           Need::required),
  });
  const YamlValue document = readYaml(file);
  Gallery gallery = schema.read(document);
  gallery.file = file;
  const YamlValue& list = *document.find("pictures");
  if (gallery.pictures.empty()) list.fail("holds no picture");
  std::set<std::string> names;
  for (std::size_t i = 0; i < gallery.pictures.size(); ++i) {
    const GalleryPicture& picture = gallery.pictures[i];
    if (!names.insert(picture.name).second) {
      list.values[i].find("name")->fail("'" + picture.name + "' is there twice");
    }
    if (picture.camera.empty() == !picture.from.has_value()) {
      list.values[i].fail("needs exactly one of: camera, from");
    }
  }
  return gallery;
}

std::string commandOf(const Gallery& gallery, const GalleryPicture& p) {
  std::string command = fmt::format("seaway render {} --time {} --size {}x{}",
                                    gallery.sceneOf(p).lexically_normal().string(),
                                    numberText(p.time), p.size.x, p.size.y);
  if (p.from) {
    command += fmt::format(
        " --from={},{},{} --yaw {} --pitch {} --roll {} --fov {}", numberText(p.from->latitude_deg),
        numberText(p.from->longitude_deg), numberText(p.from->height), numberText(p.yaw_deg),
        numberText(p.pitch_deg), numberText(p.roll_deg), numberText(p.fieldOfView_deg));
  } else {
    command += " --camera " + p.camera;
  }
  if (p.technique != "projected_grid") command += " --technique " + p.technique;
  if (p.variant != "automatic") command += " --variant " + p.variant;
  return command + " --out " + p.name + ".png";
}

}  // namespace seaway::bridge
