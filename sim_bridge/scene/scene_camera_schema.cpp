#include "sim_bridge/scene/scene_camera_schema.h"

#include "sim_bridge/scene/raised_place_schema.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

const Range compass = Range::within(-360.0, 360.0);

Mapping<SceneIntrinsics> intrinsicsSchema() {
  using I = SceneIntrinsics;
  using P = render::Intrinsics;
  const auto pixels = [](std::string key, double P::*member, Range range, std::string summary) {
    return Field<I>{
        {std::move(key), "number", "px", range.text(), "", Need::required, std::move(summary), {}},
        [=](I& target, const YamlValue& value) {
          target.pixels.*member = readNumber(value, range, "px");
        }};
  };
  const Range focal{.least = 0.0, .most = 1e7, .leastIncluded = false};
  return Mapping<I>({
      pixels("fx_px", &P::fx, focal, "focal length, to the right"),
      pixels("fy_px", &P::fy, focal, "focal length, downwards"),
      pixels("cx_px", &P::cx, Range::any(), "principal point, to the right"),
      pixels("cy_px", &P::cy, Range::any(), "principal point, downwards"),
      vector("size", &I::size, "pixels", Range::within(1, 1 << 20),
             "width and height of the pictures that they are given for; pictures of another size "
             "show the same",
             Need::required),
  });
}

Mapping<render::Distortion> distortionSchema() {
  using D = render::Distortion;
  const Range any = Range::any();
  return Mapping<D>({
      number("k1", &D::k1, "1", any, "radial, of r²"),
      number("k2", &D::k2, "1", any, "radial, of r⁴"),
      number("k3", &D::k3, "1", any, "radial, of r⁶"),
      number("p1", &D::p1, "1", any, "tangential, downwards"),
      number("p2", &D::p2, "1", any, "tangential, to the right"),
  });
}

void requirePinhole(const SceneCamera& camera, const YamlValue& value) {
  render::Camera pinhole;
  if (camera.intrinsics) {
    if (const YamlValue* given = value.find("fov_deg"))
      given->fail("is not allowed beside intrinsics");
    pinhole.size = camera.intrinsics->size;
    pinhole.intrinsics = camera.intrinsics->pixels;
    try {
      validate(pinhole);
    } catch (const InputError& error) {
      value.find("intrinsics")->fail(error.what());
    }
  }
}

}  // namespace

Mapping<SceneCamera> cameraSchema() {
  using C = SceneCamera;
  const auto place = raisedPlaceSchema<CameraPlace>("above the still-water level");
  return Mapping<C>(
      {
          name("name", &C::name, "unique among cameras"),
          text("mount", &C::mount,
               "vessel that carries the camera; a fixed camera has `place` instead"),
          choice("stabilised", &C::stabilised, {{"true", true}, {"false", false}},
                 "carried along by the vessel's place and heading, but not heaving, rolling or "
                 "pitching"),
          vector("position_m", &C::position, "m", Range::within(-1000.0, 1000.0),
                 "on the mount: forward, to port, above its waterline at rest"),
          mapping("place", &C::place, place, "of a fixed camera"),
          number("yaw_deg", &C::yaw_deg, "°", compass,
                 "clockwise from the mount's bow; from true north for a fixed camera"),
          number("pitch_deg", &C::pitch_deg, "°", Range::within(-90.0, 90.0), "positive up"),
          number("roll_deg", &C::roll_deg, "°", compass, "positive right side down"),
          number("fov_deg", &C::fieldOfView_deg, "°", Range::within(1.0, 170.0),
                 "vertical field of view"),
          mapping(
              "intrinsics", &C::intrinsics, intrinsicsSchema(),
              "a pinhole in pixels, in place of fov_deg, by OpenCV's convention: whole numbers are "
              "pixels' centres, (0, 0) that of the top left one"),
          mapping("distortion", &C::distortion, distortionSchema(),
                  "Brown and Conrady's, of the lens, by OpenCV's convention; off without it"),
      },
      requirePinhole);
}

}  // namespace seaway::bridge
