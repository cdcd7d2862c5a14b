#pragma once

#include <vector>

#include "sim_bridge/grpc/call_watch.h"
#include "sim_bridge/grpc/rpc_server.h"
#include "sim_bridge/grpc/xdyn_frame.h"
#include "sim_bridge/service/served_sea.h"
#include "wave_types.pb.h"

namespace seaway::bridge::rpc {

/// What xdyn's Waves service answers, from a served sea in xdyn's frame. Thread-safe.
///
/// Elevations are z of the surface, negative in a crest. Pressures are the waves' part alone,
/// velocities orbital, without the current; both 0 in the air, as xdyn's own models have it, NaN in
/// the bed and ashore. A sea with Perlin octaves has neither, nor a spectrum: UNIMPLEMENTED.
///
/// A spectrum has one entry an octave, which is the octave as it is at the place and time asked
/// (localWaves): Si = amplitude²/2 with Dj = 1, widths of frequency and direction being 1, so that
/// the height is Σ √(2 Si Dj) sin(k (x cos ψ + y sin ψ) − ωt + phase), xdyn's own sum.
class XdynWaves {
 public:
  XdynWaves(ServedSea& sea, std::size_t mostPoints) : sea_(sea), mostPoints_(mostPoints) {}

  /// YAML: keys of `sea.state` in a scene; xdyn's own `model` and `url` are passed over; none of
  /// them: the sea stays. What is not allowed is told in the response.
  void setParameters(const SetParameterRequest& request, SetParameterResponse& response);

  void elevations(const XYTGrid& request, XYZTGrid& response, const CallWatch& watch) const;
  void pressures(const XYZTGrid& request, DynamicPressuresResponse& response,
                 const CallWatch& watch) const;
  void velocities(const XYZTGrid& request, OrbitalVelocitiesResponse& response,
                  const CallWatch& watch) const;
  void spectrum(const SpectrumRequest& request, SpectrumResponse& response) const;
  void frequencies(AngularFrequenciesResponse& response) const;
  void directions(DirectionsResponse& response) const;

 private:
  void requireSizes(std::size_t x, std::size_t y) const;
  void attend(const std::vector<glm::dvec2>& places, double t) const;
  /// Calls `use` with the number of each point and its motion.
  template <class Use>
  void forEachMotion(const XYZTGrid& request, const CallWatch& watch, Use use) const;

  ServedSea& sea_;
  std::size_t mostPoints_;
};

/// Adds the service to a server that is not bound yet. `waves` must outlive it.
void addXdynService(RpcServer& server, XdynWaves& waves);

}  // namespace seaway::bridge::rpc
