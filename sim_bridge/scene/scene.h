#pragma once

#include <cstdint>
#include <filesystem>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "render/camera.h"
#include "render/render_technique.h"
#include "sim_bridge/scene/place.h"
#include "sim_bridge/scene/scene_events.h"
#include "sim_bridge/scene/scene_terrain.h"
#include "sim_bridge/scene/scenery.h"
#include "sim_bridge/scene/sea_state_file.h"
#include "sim_bridge/scene/vessel_model.h"
#include "surface/effects.h"
#include "surface/outline/water_outline.h"
#include "surface/spectra/two_peak_families.h"

/// A scene as its file gives it, checked. Angles are compass degrees as in the file (their names
/// say so); whoever uses them converts. Initial values are the defaults of the schema page.
namespace seaway::bridge {

/// Flat water.
struct CalmState {};

/// Which spectrum a parametric sea state has, by its key in the scene.
enum class SpectralFamily {
  jonswap,  ///< and Pierson–Moskowitz by H_m0 and T_p: γ = 1
  piersonMoskowitzOfWind,
  tma,
  ochiHubble,
  torsethaugen,
  swell,
  wmo,
};

/// How a parametric sea spreads over direction.
enum class Spreading {
  cosinePower,  ///< cos²ˢ with one s
  mitsuyasu,    ///< cos²ˢ with Mitsuyasu's s by frequency, of a wind
};

/// A sea state by the parameters of a spectrum. Which of them count depends on the family.
struct ParametricState {
  SpectralFamily family = SpectralFamily::jonswap;
  double significantWaveHeight = 0.0;            ///< H_m0, m
  double peakPeriod = 0.0;                       ///< T_p, s
  double peakEnhancement = 3.3;                  ///< γ
  double windSpeed = 0.0;                        ///< m/s at 19.5 m, of a Pierson–Moskowitz sea
  double width = 0.01;                           ///< of a swell's bell, Hz
  std::optional<OchiHubblePart> swell, windSea;  ///< of an Ochi–Hubble sea; else the most probable
  int code = 0;                                  ///< of the WMO's sea states
  double from_deg = 0.0;
  Spreading spreading = Spreading::cosinePower;
  double spreadExponent = 10.0;  ///< s of cos²ˢ((θ − θ_m)/2); infinite: one direction
  double spreadWind = 0.0;       ///< m/s at 10 m, for Mitsuyasu's spreading
  int octaves = 0;               ///< to fit; 0: 24 group octaves or 8 Perlin octaves
};

/// A sea state that `seaway fit` wrote.
struct FileState {
  std::string path;         ///< as in the scene
  FittedSeaState seaState;  ///< read by the loader
};

using SeaState = std::variant<CalmState, ParametricState, FileState, FittedSeaState>;

struct Current {
  double speed = 0.0;  ///< m/s
  double toward_deg = 0.0;
};

struct SeaSettings {
  Place anchor;
  double depth = std::numeric_limits<double>::infinity();  ///< m
  double waterLevel = 0.0;                                 ///< m above the geoid
  Current current;
  std::int64_t seed = 1;
  OctaveKind model = OctaveKind::group;  ///< of parametric states
  SeaState state;
  int stateLine = 0;                            ///< where `sea.state` stands in the file
  std::string outlinePath;                      ///< as in the scene; empty: water everywhere
  std::shared_ptr<const WaterOutline> outline;  ///< read by the loader
};

struct VesselStart {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double heading_deg = 0.0;  ///< true
};

/// What moves a vessel.
enum class VesselMotion {
  prescribed,  ///< the course that start, speed and turn give; it heaves, rolls and pitches
  free,        ///< loads on its mesh, its own propeller and rudder
};

struct SceneVessel {
  std::string name;
  std::string modelPath;  ///< as in the scene
  VesselModel model;      ///< read by the loader
  VesselStart start;
  double speed = 0.0;     ///< over ground, m/s
  double turn_deg = 0.0;  ///< compass degrees per second, positive to starboard
  VesselMotion motion = VesselMotion::prescribed;
  std::vector<Place> waypoints;           ///< of a free vessel, and of `seaway sail`
  std::shared_ptr<const HullModel> mesh;  ///< of a free vessel; made by the loader
};

/// Where a fixed camera stands.
struct CameraPlace {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height = 2.0;  ///< m above the still-water level
};

/// A camera's pinhole, for pictures of `size` pixels; others show the same, each axis scaled.
struct SceneIntrinsics {
  render::Intrinsics pixels;
  glm::ivec2 size{0};
};

struct SceneCamera {
  std::string name;
  std::string mount;                 ///< vessel; empty for a fixed camera
  bool stabilised = false;           ///< mounted, but does not heave, roll or pitch
  glm::dvec3 position{0.0};          ///< in the mount's body frame, m
  std::optional<CameraPlace> place;  ///< of a fixed camera
  double yaw_deg = 0.0;           ///< clockwise from the mount's bow, or from true north if fixed
  double pitch_deg = 0.0;         ///< up
  double roll_deg = 0.0;          ///< right side down
  double fieldOfView_deg = 60.0;  ///< vertical; not looked at where there are intrinsics
  std::optional<SceneIntrinsics> intrinsics;
  std::optional<render::Distortion> distortion;
};

struct Sun {
  double elevation_deg = 30.0;
  double azimuth_deg = 180.0;
};

struct Wind {
  double speed = 7.0;              ///< m/s at 12.5 m
  std::optional<double> from_deg;  ///< else it pushes no hull
};

struct SceneMoon {
  double elevation_deg = 30.0;
  double azimuth_deg = 180.0;
  double phase = 0.5;  ///< 0 new, 0.5 full, 1 new again
};

struct LightSettings {
  Sun sun;
  std::optional<SceneMoon> moon;
  Wind wind;
  double turbidity = 0.045;  ///< of the water, 1/m
  double visibility = 28e3;  ///< of the air, m
  render::ShadingTerms shading;
  render::ToneCurve toneCurve = render::ToneCurve::filmic;
  bool dithers = true;
};

/// A lamp that stands in the scene.
struct SceneLamp {
  std::string name;
  Place place;
  double height = 5.0;                  ///< m above the still-water level
  glm::vec3 colour{1.0f, 0.85f, 0.6f};  ///< linear
  double candela = 100.0;
};

/// Windows of the water in which vessels' waves run.
struct WakeAccuracy {
  double cell = 0.0;    ///< m; 0: by the length of the hull
  double window = 0.0;  ///< m; 0: by the length of the hull
  int most = 8;
};

/// Errors and costs: what `seaway tune` is asked for, what it foresees, what a run achieved.
struct Performance {
  std::optional<double> height;    ///< error of heights, one standard deviation, m
  std::optional<double> position;  ///< error of the sea's place in pictures, rms, px
  std::optional<double> query;     ///< of a height in large batches, ns a point
  std::optional<double> frame;     ///< of a frame, mean of the cameras, ms
  std::optional<double> step;      ///< of a step of the vessels, µs

  bool any() const { return height || position || query || frame || step; }
};

struct Accuracy {
  double motionTolerance = 0.0;  ///< height that vessels' samples may leave out, m (1 σ)
  glm::ivec2 grid{256, 256};     ///< vertices of the projected grid, across and along
  LayerAccuracy layers;
  WakeAccuracy wakes;
  Performance wanted;  ///< height and position alone
};

struct RunSettings {
  double duration = 20.0;  ///< s
  double framesPerSecond = 2.0;
  glm::ivec2 size{1280, 720};  ///< pixels
  double step = 0.02;          ///< s
};

struct Scene {
  std::filesystem::path file;
  SeaSettings sea;
  std::vector<SceneVessel> vessels;
  std::vector<SceneryObject> scenery;
  std::vector<SceneCamera> cameras;
  std::vector<SceneSplash> splashes;
  SceneRain rain;
  std::vector<SceneRipples> ripples;
  std::vector<SceneLayer> layers;
  SceneTerrain terrain;
  LightSettings light;
  std::vector<SceneLamp> lamps;
  EffectSettings effects{};
  Accuracy accuracy;
  Performance budget;  ///< query, frame and step alone
  Performance tuned;   ///< what `seaway tune` foresaw with these settings
  RunSettings run;
};

}  // namespace seaway::bridge
