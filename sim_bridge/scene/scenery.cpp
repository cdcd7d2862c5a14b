#include "sim_bridge/scene/scenery.h"

#include <spdlog/spdlog.h>

#include "sim_bridge/scene/raised_place_schema.h"

namespace seaway::bridge {

Mapping<SceneryObject> scenerySchema() {
  using S = SceneryObject;
  const Range compass = Range::within(-360.0, 360.0);
  const std::vector<std::pair<std::string, std::string>> axes{
      {"+x", "+x"}, {"-x", "-x"}, {"+y", "+y"}, {"-y", "-y"}, {"+z", "+z"}, {"-z", "-z"}};
  const auto place = raisedPlaceSchema<SceneryPlace>(
      "of the mesh's origin above the still-water level; above the water if it floats");
  const Mapping<HullFileSettings> file({
      number("unit_m", &HullFileSettings::metresPerUnit, "m", Range::above(0.0),
             "length of the file's unit"),
      choice("forward", &HullFileSettings::forward, axes, "axis of the file that heads forward"),
      choice("up", &HullFileSettings::up, axes, "axis of the file that points up (glTF: +y)"),
  });
  return Mapping<S>({
      name("name", &S::name, "unique among scenery"),
      text("mesh", &S::meshPath,
           "STL, OBJ or glTF file, relative to the scene; materials' base colours are drawn, "
           "textures are not",
           Need::required),
      mapping("file", &S::axes, file, "unit and axes of the file"),
      number("scale", &S::scale, "1", Range::above(0.0), "of the mesh, once in metres"),
      mapping("place", &S::place, place, "where the mesh's origin is", Need::required),
      number("heading_deg", &S::heading_deg, "°", compass, "true heading of the forward axis"),
      number("pitch_deg", &S::pitch_deg, "°", Range::within(-90.0, 90.0), "forward axis up"),
      number("roll_deg", &S::roll_deg, "°", compass, "right side down"),
      vector("colour", &S::colour, "", Range::within(0.0, 1.0),
             "linear reflectance of what has no material in the file: red, green, blue"),
      choice("floats", &S::floats, {{"true", true}, {"false", false}},
             "rises and tilts with waves longer than itself, without mass"),
  });
}

std::shared_ptr<const ColouredMesh> SceneryMeshes::read(const std::filesystem::path& file,
                                                        const HullFileSettings& axes) {
  for (const Known& known : known_) {
    if (known.file == file && known.axes.metresPerUnit == axes.metresPerUnit &&
        known.axes.forward == axes.forward && known.axes.up == axes.up) {
      return known.mesh;
    }
  }
  auto mesh = std::make_shared<const ColouredMesh>(readColouredMesh(file, axes));
  for (const std::string& remark : mesh->remarks) spdlog::warn("{}", remark);
  known_.push_back({file, axes, mesh});
  return mesh;
}

}  // namespace seaway::bridge
