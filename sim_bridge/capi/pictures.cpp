#include <algorithm>
#include <cmath>

#include "render/headless_context.h"
#include "sim_bridge/capi/handles.h"
#include "sim_bridge/output/number_text.h"
#include "sim_bridge/output/picture_file.h"
#include "sim_bridge/scene_view.h"

namespace seaway::bridge::capi {
namespace {

constexpr std::uint32_t longestSide = 8192;

seaway_camera cameraDefaults() {
  seaway_camera camera{};
  camera.struct_size = sizeof camera;
  camera.height = 2.0;
  camera.field_of_view_deg = 60.0;
  return camera;
}
constexpr seaway_render_options renderDefaults{sizeof(seaway_render_options), 0, 0, 0, nullptr};
constexpr seaway_image noImage{sizeof(seaway_image), 0, 0, 0, nullptr, 0, nullptr, 0};

void requireWithin(const char* name, double value, double least, double most) {
  requireThat(value >= least && value <= most,
              std::string("camera.") + name + " is " + numberText(value) + "; must be in [" +
                  numberText(least) + ", " + numberText(most) + "]");
}

void requireMount(const Scene& scene, const std::string& mount) {
  const auto& vessels = scene.vessels;
  const bool known = std::any_of(vessels.begin(), vessels.end(),
                                 [&](const SceneVessel& vessel) { return vessel.name == mount; });
  if (!known)
    throw CallError(SEAWAY_NOT_FOUND, "camera.mount: no vessel is called '" + mount + "'");
}

SceneCamera cameraOf(const CoupledSea& sea, const seaway_camera& given) {
  SceneCamera camera;  // nameless, unlike those of scenes
  requireWithin("yaw_deg", given.yaw_deg, -720.0, 720.0);
  requireWithin("pitch_deg", given.pitch_deg, -90.0, 90.0);
  requireWithin("roll_deg", given.roll_deg, -360.0, 360.0);
  requireWithin("field_of_view_deg", given.field_of_view_deg, 0.01, 179.0);
  camera.yaw_deg = given.yaw_deg;
  camera.pitch_deg = given.pitch_deg;
  camera.roll_deg = given.roll_deg;
  camera.fieldOfView_deg = given.field_of_view_deg;
  if (given.mount) {
    camera.mount = given.mount;
    requireMount(sea.scene(), camera.mount);
    camera.stabilised = given.stabilised != 0;
    camera.position = {given.position[0], given.position[1], given.position[2]};
    for (int i = 0; i < 3; ++i) requireWithin("position", camera.position[i], -1e4, 1e4);
    return camera;
  }
  requireWithin("height", given.height, -1e5, 1e6);
  const bool near =
      sea.geodesy().seaPlaneFromGeodetic(given.latitude_deg, given.longitude_deg).inRange;
  requireThat(near, "camera.latitude_deg and longitude_deg are not within 500 km of the anchor");
  camera.place = CameraPlace{given.latitude_deg, given.longitude_deg, given.height};
  return camera;
}

SceneCamera sceneCamera(const Scene& scene, const char* name) {
  try {
    return findCamera(scene, name ? name : "");
  } catch (const InputError& fault) {
    throw CallError(SEAWAY_NOT_FOUND, fault.what());
  }
}

glm::ivec2 sizeOf(const seaway_image& image, const Scene& scene) {
  if (image.width == 0 && image.height == 0) return scene.run.size;
  const bool sound = image.width >= 1 && image.width <= longestSide && image.height >= 1 &&
                     image.height <= longestSide;
  requireThat(sound, "image is " + std::to_string(image.width) + "x" +
                         std::to_string(image.height) + "; each must be in [1, 8192], or both 0");
  return glm::ivec2(image.width, image.height);
}

void requireRoom(const char* name, const void* buffer, std::size_t given, std::size_t needed) {
  if (!buffer || given >= needed) return;
  throw CallError(SEAWAY_BUFFER_TOO_SMALL, std::string("image.") + name + " is " +
                                               std::to_string(given) + "; needed are " +
                                               std::to_string(needed));
}

render::TechniqueChoice choiceOf(const seaway_render_options& given, const Scene& scene) {
  render::TechniqueChoice choice;
  choice.grid = scene.accuracy.grid;
  if (given.grid_columns != 0 || given.grid_rows != 0) {
    const auto sound = [](std::uint32_t n) { return n >= 2 && n <= 4096; };
    requireThat(sound(given.grid_columns) && sound(given.grid_rows),
                "options.grid_columns and grid_rows must each be in [2, 4096], or both 0");
    choice.grid = glm::ivec2(given.grid_columns, given.grid_rows);
  }
  if (given.backend) choice.backend = given.backend;
  render::requireBackend(choice.backend);
  return choice;
}

}  // namespace
}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_camera_init(seaway_camera* camera, size_t size) {
  initialise(camera, size, cameraDefaults());
}
void seaway_render_options_init(seaway_render_options* options, size_t size) {
  initialise(options, size, renderDefaults);
}
void seaway_image_init(seaway_image* image, size_t size) { initialise(image, size, noImage); }

size_t seaway_sea_camera_count(const seaway_sea* sea) {
  return sea ? seaOf(sea).scene().cameras.size() : 0;
}

const char* seaway_sea_camera_name(const seaway_sea* sea, size_t camera) {
  if (camera >= seaway_sea_camera_count(sea)) return nullptr;
  return seaOf(sea).scene().cameras[camera].name.c_str();
}

seaway_status seaway_sea_picture_size(const seaway_sea* handle, uint32_t* width, uint32_t* height) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    require(width, "width");
    require(height, "height");
    *width = static_cast<uint32_t>(sea.scene().run.size.x);
    *height = static_cast<uint32_t>(sea.scene().run.size.y);
  });
}

seaway_status seaway_sea_render(seaway_sea* handle, const char* name, const seaway_camera* own,
                                const seaway_render_options* given, const seaway_image* image) {
  return guarded([&] {
    CoupledSea& sea = seaOf(handle);
    requireStruct(image, "image");
    if (own) requireStruct(own, "own");
    const SceneCamera camera = own ? cameraOf(sea, *own) : sceneCamera(sea.scene(), name);
    const seaway::render::TechniqueChoice choice =
        choiceOf(optionsOr(given, renderDefaults, "options"), sea.scene());
    const glm::ivec2 size = sizeOf(*image, sea.scene());
    const size_t pixels = static_cast<size_t>(size.x) * static_cast<size_t>(size.y);
    requireRoom("rgb_size", image->rgb, image->rgb_size, 3 * pixels);
    requireRoom("depth_size", image->depth, image->depth_size, pixels);
    requireMemoryForPicture(size);
    sea.draw(camera, size, choice, [&](const seaway::render::Frame& frame) {
      if (image->rgb) std::copy_n(frame.colour.rgb.data(), 3 * pixels, image->rgb);
      if (image->depth) std::copy_n(frame.depth.metres.data(), pixels, image->depth);
    });
  });
}

}  // extern "C"
