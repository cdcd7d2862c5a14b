#include <cmath>

#include "sim_bridge/capi/handles.h"
#include "sim_bridge/capi/prepared_water.h"
#include "sim_bridge/scene/vessel_hull.h"
#include "sim_bridge/vessel/hull_source.h"
#include "surface/hull/hull_loads.h"

namespace seaway::bridge::capi {
namespace {

seaway_hull_options hullDefaults() {
  const HullCoefficients c;
  seaway_hull_options options{};
  options.struct_size = sizeof options;
  options.level = SEAWAY_MESH_DYNAMIC;
  options.metres_per_unit = 1.0;
  options.shortest_wavelength = -1.0;
  options.form_drag = c.formDrag;
  options.skin_friction = -1.0;
  options.slamming = c.slamming;
  options.wind_drag = c.windDrag;
  options.damping[0] = c.heaveDamping;
  options.damping[1] = c.rollDamping;
  options.damping[2] = c.pitchDamping;
  options.triangles = 800;
  return options;
}

glm::dvec3 vectorOf(const double (&numbers)[3]) { return {numbers[0], numbers[1], numbers[2]}; }

void put(double (&out)[3], const glm::dvec3& vector) {
  out[0] = vector.x;
  out[1] = vector.y;
  out[2] = vector.z;
}

LoadLevel levelOf(std::uint32_t level) {
  switch (level) {
    case SEAWAY_COLUMNS:
      return LoadLevel::columns;
    case SEAWAY_MESH:
      return LoadLevel::mesh;
    case SEAWAY_MESH_DYNAMIC:
      return LoadLevel::meshDynamic;
  }
  throw CallError(SEAWAY_BAD_ARGUMENT, "options.level is " + std::to_string(level) +
                                           "; must be a seaway_load_level, 0 to 2");
}

HullSettings settingsOf(const seaway_hull_options& given) {
  HullSettings settings;
  settings.level = levelOf(given.level);
  settings.mass = given.mass;
  settings.centreOfGravity = vectorOf(given.centre_of_gravity);
  settings.gyradii = vectorOf(given.gyradii);
  if (!(given.shortest_wavelength < 0.0)) settings.shortestWavelength = given.shortest_wavelength;
  HullCoefficients& c = settings.coefficients;
  c.formDrag = given.form_drag;
  if (!(given.skin_friction < 0.0)) c.skinFriction = given.skin_friction;
  c.slamming = given.slamming;
  c.windDrag = given.wind_drag;
  c.heaveDamping = given.damping[0];
  c.rollDamping = given.damping[1];
  c.pitchDamping = given.damping[2];
  std::copy(std::begin(given.added_mass), std::end(given.added_mass), c.addedMass.begin());
  return settings;
}

template <class Load>
seaway_status make(const seaway_hull_options* options, seaway_hull** out, const Load& load) {
  if (out) *out = nullptr;
  return guarded([&] {
    require(out, "hull");
    requireStruct(options, "options");
    const HullSettings settings = settingsOf(*options);
    *out = reinterpret_cast<seaway_hull*>(
        new HullHandle(std::make_shared<HullModel>(load(*options), settings)));
  });
}

TriangleMesh meshOf(std::size_t vertexCount, const double* vertices, std::size_t triangleCount,
                    const std::uint32_t* triangles) {
  require(vertices, "vertices");
  require(triangles, "triangles");
  TriangleMesh mesh;
  for (std::size_t i = 0; i < vertexCount; ++i) {
    const glm::dvec3 vertex(vertices[3 * i], vertices[3 * i + 1], vertices[3 * i + 2]);
    requireThat(std::isfinite(vertex.x + vertex.y + vertex.z),
                [&] { return "vertex " + std::to_string(i) + " is not finite"; });
    mesh.vertices.push_back(vertex);
  }
  for (std::size_t i = 0; i < triangleCount; ++i) {
    const TriangleMesh::Triangle corners(triangles[3 * i], triangles[3 * i + 1],
                                         triangles[3 * i + 2]);
    for (int k = 0; k < 3; ++k) {
      requireThat(corners[k] < vertexCount, [&] {
        return "triangle " + std::to_string(i) + " has vertex " + std::to_string(corners[k]) +
               "; there are " + std::to_string(vertexCount);
      });
    }
    mesh.triangles.push_back(corners);
  }
  return mesh;
}

HullPose poseOf(const seaway_body& body) {
  const glm::dquat given(body.attitude[0], body.attitude[1], body.attitude[2], body.attitude[3]);
  const double length = glm::length(given);
  // NaN, of which loads() tells by its status, passes.
  requireThat(!(std::abs(length - 1.0) > 1e-3), "body.attitude is no unit quaternion");
  return {vectorOf(body.position), given / length, vectorOf(body.velocity),
          vectorOf(body.angular_velocity)};
}

void put(double (&force)[3], double (&moment)[3], const Load& load) {
  put(force, load.force);
  put(moment, load.moment);
}

void write(const HullLoads& loads, seaway_loads& out) {
  out.status = static_cast<std::uint32_t>(loads.status);
  put(out.force, out.moment, loads.total());
  put(out.buoyancy_force, out.buoyancy_moment, loads.buoyancy);
  put(out.drag_force, out.drag_moment, loads.drag);
  put(out.radiation_force, out.radiation_moment, loads.radiation);
  put(out.wind_force, out.wind_moment, loads.wind);
  std::copy(loads.addedMass.begin(), loads.addedMass.end(), out.added_mass);
  put(out.water_acceleration, loads.waterAcceleration);
  out.submerged_volume = loads.submergedVolume;
  out.wetted_area = loads.wettedArea;
  out.left_out = loads.leftOut;
}

void write(const HullModel& hull, seaway_hull_facts& out) {
  out.triangles = static_cast<std::uint32_t>(hull.mesh().triangles.size());
  out.mass = hull.settings().mass;
  put(out.centre_of_gravity, hull.settings().centreOfGravity);
  put(out.lower, hull.bounds().lower);
  put(out.upper, hull.bounds().upper);
  out.rest_height = hull.restHeight();
  out.rest_volume = hull.atRest().volume;
  out.shortest_wavelength = hull.shortestWavelength();
}

constexpr seaway_load_options loadDefaults{sizeof(seaway_load_options), 0, NAN, NAN};

LoadOptions optionsOf(const CoupledSea& sea, const CoupledSea::Moment& moment,
                      const seaway_load_options& given) {
  LoadOptions options;
  options.ownWake = excludedWake(sea, moment, given.own_vessel);
  if (std::isnan(given.wind_east) && std::isnan(given.wind_north)) return options;
  requireThat(std::isfinite(given.wind_east + given.wind_north),
              "options.wind_east and wind_north must be finite, or both NaN for no wind");
  options.wind = glm::dvec2(given.wind_east, given.wind_north);
  return options;
}

}  // namespace
}  // namespace seaway::bridge::capi

using namespace seaway::bridge;
using namespace seaway::bridge::capi;

extern "C" {

void seaway_hull_options_init(seaway_hull_options* options, size_t size) {
  initialise(options, size, hullDefaults());
}
void seaway_hull_facts_init(seaway_hull_facts* facts, size_t size) {
  initialise(facts, size, seaway_hull_facts{});
}
void seaway_body_init(seaway_body* body, size_t size) {
  seaway_body upright{};
  upright.attitude[0] = 1.0;
  initialise(body, size, upright);
}
void seaway_load_options_init(seaway_load_options* options, size_t size) {
  initialise(options, size, loadDefaults);
}
void seaway_loads_init(seaway_loads* loads, size_t size) {
  initialise(loads, size, seaway_loads{});
}

seaway_status seaway_hull_from_file(const char* name, const seaway_hull_options* options,
                                    seaway_hull** hull) {
  return make(options, hull, [&](const seaway_hull_options& given) {
    require(name, "file_or_shape");
    return hullByName(name, {.metresPerUnit = given.metres_per_unit}, given.triangles);
  });
}

seaway_status seaway_hull_from_triangles(size_t vertex_count, const double* vertices,
                                         size_t triangle_count, const uint32_t* triangles,
                                         const seaway_hull_options* options, seaway_hull** hull) {
  return make(options, hull, [&](const seaway_hull_options&) {
    return meshOf(vertex_count, vertices, triangle_count, triangles);
  });
}

seaway_status seaway_hull_from_vessel(const seaway_sea* handle, size_t vessel, seaway_hull** hull) {
  if (hull) *hull = nullptr;
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    require(hull, "hull");
    requireVessel(sea, vessel);
    const VesselModel& model = sea.scene().vessels[vessel].model;
    *hull = reinterpret_cast<seaway_hull*>(new HullHandle(hullModelOf(model.mesh, model.hull)));
  });
}

void seaway_hull_destroy(seaway_hull* hull) { delete reinterpret_cast<HullHandle*>(hull); }

seaway_status seaway_hull_describe(const seaway_hull* hull, seaway_hull_facts* facts) {
  return guarded([&] {
    const seaway::HullModel& model = hullOf(hull);
    requireStruct(facts, "facts");
    write(model, *facts);
  });
}

seaway_status seaway_sea_hull_loads(const seaway_sea* handle, const seaway_hull* hull, double time,
                                    const seaway_body* body, const seaway_load_options* given,
                                    seaway_loads* out) {
  return guarded([&] {
    const CoupledSea& sea = seaOf(handle);
    const seaway::HullModel& model = hullOf(hull);
    requireStruct(body, "body");
    requireStruct(out, "loads");
    const PreparedWater prepared(sea, time);
    const seaway::LoadOptions options =
        optionsOf(sea, prepared.moment(), optionsOr(given, loadDefaults, "options"));
    thread_local seaway::LoadScratch scratch;
    write(loads(model, poseOf(*body), prepared.water(), scratch, options), *out);
  });
}

}  // extern "C"
