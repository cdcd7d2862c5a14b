#include "sim_bridge/grpc/point_sampler.h"

#include <google/protobuf/io/coded_stream.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_bridge/grpc/message_codec.h"
#include "sim_bridge/service/listener_of.h"
#include "sim_bridge/service/wave_arrays.h"
#include "surface/constants.h"

namespace seaway::bridge::rpc {
namespace {

using v1::SampleRequest;
using v1::SampleResponse;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

template <class List>
std::size_t sizeOf(const List& list) {
  return static_cast<std::size_t>(list.size());
}

std::size_t pointsOf(const SampleRequest& request) {
  return request.has_geodetic() ? sizeOf(request.geodetic().latitude_deg())
                                : sizeOf(request.plane().x_m());
}

void requireSameSize(const char* fields, std::size_t first, std::size_t second) {
  if (first == second) return;
  throw badValue(fields, std::to_string(first) + " and " + std::to_string(second) + " values",
                 "must be as many of each");
}

void requireNotNegative(const char* field, double value) {
  if (!(value >= 0.0) || std::isinf(value)) throw badValue(field, value, "must be >= 0 and finite");
}

/// Room in a list that is empty; all of it is written later.
template <class List>
void makeRoomIn(List& list, std::size_t size) {
  list.Reserve(static_cast<int>(size));
  list.AddNAlreadyReserved(static_cast<int>(size));
}

template <class Value>
std::span<const Value> spanOf(const google::protobuf::RepeatedField<Value>& list) {
  return {list.data(), sizeOf(list)};
}

}  // namespace

PointSampler::PointSampler(const WaterHost& host) : host_(&host), placer_(host.sea.geodesy()) {}

bool PointSampler::read(grpc::ByteBuffer& bytes, SampleRequest& request) {
  // What is of a oneof goes when the message is cleared: its lists would grow again, piece by
  // piece.
  std::unique_ptr<v1::PlanePoints> plane(request.release_plane());
  if (!plane) return readMessage(bytes, request);
  plane->Clear();
  request.Clear();
  request.set_allocated_plane(plane.release());
  {
    grpc::ProtoBufferReader reader(&bytes);
    google::protobuf::io::CodedInputStream input(&reader);
    const bool read = reader.status().ok() && request.MergeFromCodedStream(&input) &&
                      input.ConsumedEntireMessage();
    const bool empty =
        request.has_plane() && request.plane().x_m().empty() && request.plane().y_m().empty();
    if (read && !empty) {
      bytes.Clear();
      return true;
    }
  }
  return readMessage(bytes, request);  // malformed, or perhaps without any points: not even none
}

Lane PointSampler::laneOf(const SampleRequest& request) {
  return pointsOf(request) <= pieceSize ? Lane::here : Lane::large;
}

void PointSampler::readPoints(const SampleRequest& request, Wanted& wanted) const {
  wanted.points = pointsOf(request);
  if (wanted.points > host_->limits.points) {
    throw RpcFault(
        grpc::StatusCode::RESOURCE_EXHAUSTED, Refusal::tooLarge,
        "points: " + std::to_string(wanted.points) + " are not allowed in one request; at most " +
            std::to_string(host_->limits.points) + " (--grpc-most-points): split the batch");
  }
  wanted.geodetic = request.has_geodetic();
  if (wanted.geodetic) {
    requireSameSize("geodetic.latitude_deg, longitude_deg", wanted.points,
                    sizeOf(request.geodetic().longitude_deg()));
  } else if (request.has_plane()) {
    requireSameSize("plane.x_m, y_m", wanted.points, sizeOf(request.plane().y_m()));
  } else {
    throw badValue("points", "nothing", "must be plane or geodetic");
  }
  const std::size_t heights = sizeOf(request.height_m());
  if (heights > 1 && heights != wanted.points) {
    throw badValue("height_m", std::to_string(heights) + " values",
                   "must be none, one, or one a point (" + std::to_string(wanted.points) + ")");
  }
  wanted.atHeights = heights > 0;
}

void PointSampler::readQuantities(const SampleRequest& request, Wanted& wanted) {
  wanted.height = request.quantities().empty();
  for (const int quantity : request.quantities()) {
    switch (quantity) {
      case v1::QUANTITY_HEIGHT:
        wanted.height = true;
        break;
      case v1::QUANTITY_SLOPE:
        wanted.slope = true;
        break;
      case v1::QUANTITY_VERTICAL_VELOCITY:
        wanted.verticalVelocity = true;
        break;
      case v1::QUANTITY_ORBITAL_VELOCITY:
        wanted.velocity = true;
        break;
      case v1::QUANTITY_PRESSURE:
        wanted.pressure = true;
        break;
      case v1::QUANTITY_ERROR:
        wanted.error = true;
        break;
      default:
        throw badValue("quantities", static_cast<double>(quantity), "must be in [1, 6]");
    }
  }
  wanted.options.derivatives = wanted.slope || wanted.verticalVelocity;
  wanted.options.orbitalVelocity = wanted.velocity && !wanted.atHeights;
}

PointSampler::Wanted PointSampler::read(const SampleRequest& request) const {
  Wanted wanted;
  readPoints(request, wanted);
  readQuantities(request, wanted);
  wanted.time = host_->timeOf(request);
  requireNotNegative("tolerance_m", request.tolerance_m());
  requireNotNegative("shortest_wavelength_m", request.shortest_wavelength_m());
  wanted.options.tolerance = request.tolerance_m();
  wanted.options.shortestWavelength = request.shortest_wavelength_m();
  wanted.options.excludeVessel = host_->ownWakeOf(request.exclude_hull(), "exclude_hull");
  return wanted;
}

void PointSampler::makeRoom(const Wanted& wanted, SampleResponse& response) {
  const std::size_t n = wanted.points;
  if (wanted.height) makeRoomIn(*response.mutable_height_m(), n);
  if (wanted.slope) {
    makeRoomIn(*response.mutable_slope_east(), n);
    makeRoomIn(*response.mutable_slope_north(), n);
  }
  if (wanted.verticalVelocity) makeRoomIn(*response.mutable_vertical_velocity_m_s(), n);
  if (wanted.velocity) {
    makeRoomIn(*response.mutable_velocity_east_m_s(), n);
    makeRoomIn(*response.mutable_velocity_north_m_s(), n);
    makeRoomIn(*response.mutable_velocity_up_m_s(), n);
  }
  if (wanted.pressure) {
    makeRoomIn(*response.mutable_pressure_pa(), n);
    makeRoomIn(*response.mutable_dynamic_pressure_pa(), n);
  }
  if (wanted.error) {
    makeRoomIn(*response.mutable_error_m(), n);
    makeRoomIn(*response.mutable_bound_m(), n);
  }
}

PointSampler::Plane PointSampler::placed(const SampleRequest& request, const CallWatch& watch) {
  const v1::GeodeticPoints& points = request.geodetic();
  const std::size_t count = sizeOf(points.latitude_deg());
  x_.resize(count);
  y_.resize(count);
  turns_.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    // Scattered points take a microsecond each.
    if (i % pieceSize == 0) watch.check();
    const PlacedPoint point = placer_.place(points.latitude_deg(static_cast<int>(i)),
                                            points.longitude_deg(static_cast<int>(i)));
    x_[i] = point.position.x;
    y_[i] = point.position.y;
    turns_[i] = point.turn;
  }
  return {x_, y_};
}

SampleStatus PointSampler::attend(const Wanted& wanted, Plane plane) {
  const auto listener = listenerOf(plane.x, plane.y, wanted.time, wanted.options.excludeVessel);
  return listener ? host_->sea.attend(wanted.time, std::span(&*listener, 1)) : SampleStatus::ok;
}

glm::dvec2 PointSampler::turned(const Wanted& wanted, std::size_t point, glm::dvec2 v) const {
  if (!wanted.geodetic) return v;
  const glm::dvec2 turn = turns_[point];
  return {turn.x * v.x + turn.y * v.y, turn.x * v.y - turn.y * v.x};
}

void PointSampler::writeSurface(const Wanted& wanted, Piece piece, SampleResponse& response) {
  double* height = wanted.height ? response.mutable_height_m()->mutable_data() : nullptr;
  double error = response.largest_error_m(), bound = response.largest_bound_m();
  for (std::size_t i = 0; i < piece.count; ++i) {
    const SurfaceSample& sample = samples_[i];
    if (height) height[piece.from + i] = sample.height;
    error = std::max(error, sample.error);
    bound = std::max(bound, sample.bound);
  }
  response.set_largest_error_m(error);
  response.set_largest_bound_m(bound);
  const auto write = [&](bool asked, auto* list, auto value) {
    if (!asked) return;
    float* out = list->mutable_data() + piece.from;
    for (std::size_t i = 0; i < piece.count; ++i) out[i] = static_cast<float>(value(i));
  };
  const auto slope = [&](std::size_t i) {
    return turned(wanted, piece.from + i, samples_[i].slope);
  };
  write(wanted.slope, response.mutable_slope_east(), [&](std::size_t i) { return slope(i).x; });
  write(wanted.slope, response.mutable_slope_north(), [&](std::size_t i) { return slope(i).y; });
  write(wanted.verticalVelocity, response.mutable_vertical_velocity_m_s(),
        [&](std::size_t i) { return samples_[i].verticalVelocity; });
  write(wanted.error, response.mutable_error_m(), [&](std::size_t i) { return samples_[i].error; });
  write(wanted.error, response.mutable_bound_m(), [&](std::size_t i) { return samples_[i].bound; });
}

void PointSampler::moveSurface(Piece piece) {
  motions_.resize(piece.count);
  for (std::size_t i = 0; i < piece.count; ++i) {
    const SurfaceSample& sample = samples_[i];
    // Nothing weighs on the surface: the waves' part and the water's weight cancel there.
    const double weight = seaWaterDensity * standardGravity * sample.height;
    const double gauge = std::isnan(sample.height) ? nan : 0.0;
    motions_[i] = {sample.height, sample.orbitalVelocity, glm::dvec3(nan), weight, gauge, {}};
  }
}

void PointSampler::moveWater(const SampleRequest& request, const Wanted& wanted, Piece piece,
                             const SurfaceAtTime& now) {
  motions_.assign(piece.count, {nan, glm::dvec3(nan), glm::dvec3(nan), nan, nan, {}});
  if (!WaveField::serves({}, wanted.time)) return;
  depths_.resize(piece.count);
  const bool oneForAll = request.height_m_size() == 1;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const int which = oneForAll ? 0 : static_cast<int>(piece.from + i);
    depths_[i] = {places_[i], request.height_m(which)};
  }
  sampleKinematics(now, depths_, motions_, wanted.options);
  for (std::size_t i = 0; i < piece.count; ++i) {
    if (std::isnan(samples_[i].height)) {  // ashore, or not served
      motions_[i] = {nan, glm::dvec3(nan), glm::dvec3(nan), nan, nan, {}};
    }
    samples_[i].status |= motions_[i].status;
  }
}

void PointSampler::writeMotion(const Wanted& wanted, Piece piece, SampleResponse& response) const {
  const auto write = [&](auto* list, auto value) {
    float* out = list->mutable_data() + piece.from;
    for (std::size_t i = 0; i < piece.count; ++i) out[i] = static_cast<float>(value(i));
  };
  if (wanted.velocity) {
    const auto level = [&](std::size_t i) {
      return turned(wanted, piece.from + i, glm::dvec2(motions_[i].velocity));
    };
    write(response.mutable_velocity_east_m_s(), [&](std::size_t i) { return level(i).x; });
    write(response.mutable_velocity_north_m_s(), [&](std::size_t i) { return level(i).y; });
    write(response.mutable_velocity_up_m_s(),
          [&](std::size_t i) { return motions_[i].velocity.z; });
  }
  if (wanted.pressure) {
    write(response.mutable_pressure_pa(), [&](std::size_t i) { return motions_[i].pressure; });
    write(response.mutable_dynamic_pressure_pa(),
          [&](std::size_t i) { return motions_[i].dynamicPressure; });
  }
}

void PointSampler::writeStatus(const Wanted& wanted, Piece piece, SampleStatus common,
                               SampleResponse& response) const {
  for (std::size_t i = 0; i < piece.count; ++i) {
    const SampleStatus status = samples_[i].status | common;
    if (status == SampleStatus::ok) continue;
    if (response.status().empty()) {
      response.mutable_status()->Resize(static_cast<int>(wanted.points), 0);
    }
    response.set_status(static_cast<int>(piece.from + i), static_cast<std::uint32_t>(status));
  }
}

void PointSampler::samplePiece(const SampleRequest& request, const Wanted& wanted, Plane plane,
                               Piece piece, const SurfaceAtTime& now) {
  places_.resize(piece.count);
  samples_.resize(piece.count);
  for (std::size_t i = 0; i < piece.count; ++i) {
    places_[i] = {plane.x[piece.from + i], plane.y[piece.from + i]};
  }
  now.sample(places_, samples_, wanted.options);
  if (!wanted.velocity && !wanted.pressure) return;
  wanted.atHeights ? moveWater(request, wanted, piece, now) : moveSurface(piece);
}

// Straight from the request's lists into the answer's.
void PointSampler::samplePlain(const Wanted& wanted, Plane plane, const SurfaceAtTime& now,
                               SampleStatus common, const CallWatch& watch,
                               SampleResponse& response) {
  statuses_.resize(wanted.points);
  WaveArrays<float> all{.status = statuses_.data()};
  if (wanted.height) all.height = response.mutable_height_m()->mutable_data();
  if (wanted.slope) {
    all.slopeEast = response.mutable_slope_east()->mutable_data();
    all.slopeNorth = response.mutable_slope_north()->mutable_data();
  }
  if (wanted.verticalVelocity) {
    all.verticalVelocity = response.mutable_vertical_velocity_m_s()->mutable_data();
  }
  if (wanted.error) {
    all.error = response.mutable_error_m()->mutable_data();
    all.bound = response.mutable_bound_m()->mutable_data();
  }
  for (std::size_t from = 0; from < wanted.points; from += pieceSize) {
    if (from > 0) watch.check();
    const std::size_t count = std::min(pieceSize, wanted.points - from);
    sampleWaves(now, plane.x.subspan(from, count), plane.y.subspan(from, count), wanted.options,
                common, from == 0 ? all : partOf(all, from));
  }
  const LargestFaults largest = largestFaults(now, plane.x, plane.y, wanted.options);
  response.set_largest_error_m(largest.error);
  response.set_largest_bound_m(largest.bound);
  std::uint32_t any = 0;  // without a way out of the loop, which a compiler makes vectors of
  for (const std::uint32_t each : statuses_) any |= each;
  if (any != 0) response.mutable_status()->Add(statuses_.begin(), statuses_.end());
}

std::size_t PointSampler::sample(const SampleRequest& request, SampleResponse& response,
                                 const CallWatch& watch) {
  const Wanted wanted = read(request);
  response.set_id(request.id());
  response.set_time_s(wanted.time);
  makeRoom(wanted, response);
  const Plane plane = wanted.geodetic
                          ? placed(request, watch)
                          : Plane{spanOf(request.plane().x_m()), spanOf(request.plane().y_m())};
  const SampleStatus common = attend(wanted, plane);
  const PreparedSurface::Use now(surface_, host_->sea.surface(), wanted.time);
  const bool motion = wanted.velocity || wanted.pressure;
  if (!wanted.geodetic && !motion && isPlain(*now, wanted.options)) {
    samplePlain(wanted, plane, *now, common, watch, response);
    return wanted.points;
  }
  for (Piece piece{0, 0}; piece.from < wanted.points; piece.from += piece.count) {
    if (piece.from > 0) watch.check();
    piece.count = std::min(pieceSize, wanted.points - piece.from);
    samplePiece(request, wanted, plane, piece, *now);
    if (motion) writeMotion(wanted, piece, response);
    writeSurface(wanted, piece, response);
    writeStatus(wanted, piece, common, response);
  }
  return wanted.points;
}

}  // namespace seaway::bridge::rpc
