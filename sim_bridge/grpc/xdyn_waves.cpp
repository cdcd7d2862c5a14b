#include "sim_bridge/grpc/xdyn_waves.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>

#include "sim_bridge/grpc/point_sampler.h"
#include "sim_bridge/grpc/sea_state.h"
#include "sim_bridge/grpc/xdyn_spectrum.h"
#include "sim_bridge/scene/yaml_value.h"
#include "surface/input_error.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge::rpc {
namespace {

template <class Grid>
std::vector<glm::dvec2> placesOf(const Grid& grid) {
  std::vector<glm::dvec2> places;
  places.reserve(static_cast<std::size_t>(grid.x_size()));
  for (int i = 0; i < grid.x_size(); ++i) places.push_back(planeFromXdyn(grid.x(i), grid.y(i)));
  return places;
}

template <class List>
std::size_t sizeOf(const List& list) {
  return static_cast<std::size_t>(list.size());
}

std::vector<LocalWave> wavesAt(const WaveField& field, glm::dvec2 place, double t) {
  try {
    return localWaves(field, place, t);
  } catch (const InputError& fault) {
    throw RpcFault(grpc::StatusCode::UNIMPLEMENTED, Refusal::badValue, fault.what());
  }
}

}  // namespace

void XdynWaves::setParameters(const SetParameterRequest& request, SetParameterResponse& response) {
  try {
    YamlValue state = parseYaml(request.parameters(), "parameters");
    std::erase_if(state.values, [](const YamlValue& value) {
      return value.name == "model" || value.name == "url";  // xdyn's own
    });
    if (!state.values.empty()) setSeaState(sea_, state);
  } catch (const InputError& fault) {
    response.set_error_message(fault.what());
  }
}

void XdynWaves::requireSizes(std::size_t x, std::size_t y) const {
  if (x != y) {
    throw badValue("x, y, z", std::to_string(x) + " and " + std::to_string(y) + " values",
                   "must be as many of each");
  }
  if (x > mostPoints_) {
    throw RpcFault(grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
                   "x: " + std::to_string(x) + " points are not allowed in one request; at most " +
                       std::to_string(mostPoints_) + " (--grpc-most-points)");
  }
}

void XdynWaves::attend(const std::vector<glm::dvec2>& places, double t) const {
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
  for (const glm::dvec2 place : places) {
    if (!WaveField::serves(place, t)) continue;
    least = glm::min(least, place);
    most = glm::max(most, place);
  }
  if (least.x > most.x) return;
  const WakeListener listener{0.5 * (least + most), 0.5 * glm::length(most - least), 0};
  sea_.attend(t, std::span(&listener, 1));
}

void XdynWaves::elevations(const XYTGrid& request, XYZTGrid& response,
                           const CallWatch& watch) const {
  requireSizes(sizeOf(request.x()), sizeOf(request.y()));
  const std::vector<glm::dvec2> places = placesOf(request);
  attend(places, request.t());
  const auto surface = sea_.surface();
  *response.mutable_x() = request.x();
  *response.mutable_y() = request.y();
  response.set_t(request.t());
  response.mutable_z()->Reserve(request.x_size());
  std::vector<SurfaceSample> samples(std::min(places.size(), PointSampler::pieceSize));
  for (std::size_t from = 0; from < places.size(); from += samples.size()) {
    watch.check();
    const std::size_t count = std::min(samples.size(), places.size() - from);
    surface->sample(std::span(places).subspan(from, count), request.t(), samples,
                    {.derivatives = false});
    for (std::size_t i = 0; i < count; ++i) response.add_z(-samples[i].height);
  }
}

template <class Use>
void XdynWaves::forEachMotion(const XYZTGrid& request, const CallWatch& watch, Use use) const {
  requireSizes(sizeOf(request.x()), sizeOf(request.y()));
  requireSizes(sizeOf(request.x()), sizeOf(request.z()));
  const std::vector<glm::dvec2> places = placesOf(request);
  attend(places, request.t());
  const auto surface = sea_.surface();
  if (!surface->waves().lists().perlins.empty()) {
    throw RpcFault(grpc::StatusCode::UNIMPLEMENTED, Refusal::badValue,
                   "the sea's Perlin octaves have no orbital motion");
  }
  const bool served = WaveField::serves({}, request.t());
  const SurfaceAtTime now = surface->at(served ? request.t() : 0.0);
  std::vector<WaterKinematics> motions(std::min(places.size(), PointSampler::pieceSize));
  std::vector<glm::dvec3> points(motions.size());
  for (std::size_t from = 0; from < places.size(); from += motions.size()) {
    watch.check();
    const std::size_t count = std::min(motions.size(), places.size() - from);
    for (std::size_t i = 0; i < count; ++i) {
      points[i] = {places[from + i], -request.z(static_cast<int>(from + i))};
    }
    sampleKinematics(now, std::span(points).first(count), motions);
    for (std::size_t i = 0; i < count; ++i) {
      WaterKinematics& motion = motions[i];
      const bool ashore = (now.outline() && !now.outline()->contains(places[from + i])) ||
                          (now.terrain() && !(motion.surfaceHeight > now.bedAt(places[from + i])));
      if (has(motion.status, SampleStatus::aboveSurface)) {
        motion.dynamicPressure = 0.0;
        motion.velocity = glm::dvec3(0.0);
      }
      if (ashore || !served) {
        motion.dynamicPressure = std::numeric_limits<double>::quiet_NaN();
        motion.velocity = glm::dvec3(motion.dynamicPressure);
      }
      use(motion);
    }
  }
}

void XdynWaves::pressures(const XYZTGrid& request, DynamicPressuresResponse& response,
                          const CallWatch& watch) const {
  forEachMotion(request, watch,
                [&](const WaterKinematics& motion) { response.add_pdyn(motion.dynamicPressure); });
  *response.mutable_x() = request.x();
  *response.mutable_y() = request.y();
  *response.mutable_z() = request.z();
  response.set_t(request.t());
}

void XdynWaves::velocities(const XYZTGrid& request, OrbitalVelocitiesResponse& response,
                           const CallWatch& watch) const {
  forEachMotion(request, watch, [&](const WaterKinematics& motion) {
    const glm::dvec3 velocity = xdynFromPlane(motion.velocity);
    response.add_vx(velocity.x);
    response.add_vy(velocity.y);
    response.add_vz(velocity.z);
  });
  *response.mutable_x() = request.x();
  *response.mutable_y() = request.y();
  *response.mutable_z() = request.z();
  response.set_t(request.t());
}

void XdynWaves::spectrum(const SpectrumRequest& request, SpectrumResponse& response) const {
  const glm::dvec2 place = planeFromXdyn(request.x(), request.y());
  if (!WaveField::serves(place, request.t())) {
    throw badValue("x, y, t", "a place or time that far", "must be finite, within 1e12");
  }
  for (const LocalWave& wave : wavesAt(sea_.surface()->waves(), place, request.t())) {
    Spectrum* entry = response.add_spectrum();
    entry->add_si(0.5 * wave.amplitude * wave.amplitude);
    entry->add_dj(1.0);
    entry->add_omega(wave.frequency);
    entry->add_psi(wave.direction);
    entry->add_k(wave.waveNumber);
    entry->add_phase()->add_phase(wave.phase);
  }
}

void XdynWaves::frequencies(AngularFrequenciesResponse& response) const {
  for (const LocalWave& wave : wavesAt(sea_.surface()->waves(), {}, 0.0)) {
    response.add_angular_frequencies()->add_omegas(wave.frequency);
  }
}

void XdynWaves::directions(DirectionsResponse& response) const {
  for (const LocalWave& wave : wavesAt(sea_.surface()->waves(), {}, 0.0)) {
    response.add_directions()->add_psis(wave.direction);
  }
}

}  // namespace seaway::bridge::rpc
