#pragma once

#include <grpcpp/support/byte_buffer.h>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "seaway/v1/water.pb.h"
#include "sim_bridge/grpc/call_watch.h"
#include "sim_bridge/grpc/lanes.h"
#include "sim_bridge/grpc/water_host.h"
#include "sim_bridge/service/plane_placer.h"
#include "sim_bridge/service/prepared_surface.h"
#include "surface/water_kinematics.h"

namespace seaway::bridge::rpc {

/// Answers SampleRequest from a served sea. For one thread at a time; keeps its memory.
class PointSampler {
 public:
  /// `host` must outlive the sampler.
  explicit PointSampler(const WaterHost& host);

  /// As readMessage; the lists of points in the sea plane keep their memory too.
  static bool read(grpc::ByteBuffer& bytes, v1::SampleRequest& request);
  /// Batches of at most a piece are answered at once.
  static Lane laneOf(const v1::SampleRequest& request);

  /// Fills `response`; returns the number of points. Throws RpcFault for what is not allowed, and
  /// where `watch` says so, between pieces.
  std::size_t sample(const v1::SampleRequest& request, v1::SampleResponse& response,
                     const CallWatch& watch);

  static constexpr std::size_t pieceSize = 4096;  ///< points: a third of a millisecond

 private:
  /// What a request asks for, checked.
  struct Wanted {
    double time = 0.0;
    std::size_t points = 0;
    bool geodetic = false;
    bool height = false, slope = false, verticalVelocity = false, velocity = false,
         pressure = false, error = false;
    bool atHeights = false;  ///< velocity and pressure, not at the surface
    SampleOptions options;
  };
  struct Piece {
    std::size_t from, count;
  };
  /// All points, in the sea plane.
  struct Plane {
    std::span<const double> x, y;
  };

  Wanted read(const v1::SampleRequest& request) const;
  void readPoints(const v1::SampleRequest& request, Wanted& wanted) const;
  static void readQuantities(const v1::SampleRequest& request, Wanted& wanted);
  static void makeRoom(const Wanted& wanted, v1::SampleResponse& response);
  Plane placed(const v1::SampleRequest& request, const CallWatch& watch);
  SampleStatus attend(const Wanted& wanted, Plane plane);
  void samplePlain(const Wanted& wanted, Plane plane, const SurfaceAtTime& now, SampleStatus common,
                   const CallWatch& watch, v1::SampleResponse& response);
  void samplePiece(const v1::SampleRequest& request, const Wanted& wanted, Plane plane, Piece piece,
                   const SurfaceAtTime& now);
  void writeSurface(const Wanted& wanted, Piece piece, v1::SampleResponse& response);
  void moveSurface(Piece piece);
  void moveWater(const v1::SampleRequest& request, const Wanted& wanted, Piece piece,
                 const SurfaceAtTime& now);
  void writeMotion(const Wanted& wanted, Piece piece, v1::SampleResponse& response) const;
  void writeStatus(const Wanted& wanted, Piece piece, SampleStatus common,
                   v1::SampleResponse& response) const;
  /// A vector at a point of the plane, along the axes that the host uses.
  glm::dvec2 turned(const Wanted& wanted, std::size_t point, glm::dvec2 vector) const;

  const WaterHost* host_;
  PlanePlacer placer_;
  PreparedSurface surface_;
  std::vector<double> x_, y_;       // of geodetic points, as are
  std::vector<glm::dvec2> turns_;   // true east and north there
  std::vector<glm::dvec2> places_;  // of a piece, as are the rest
  std::vector<SurfaceSample> samples_;
  std::vector<glm::dvec3> depths_;
  std::vector<WaterKinematics> motions_;
  std::vector<std::uint32_t> statuses_;
};

}  // namespace seaway::bridge::rpc
