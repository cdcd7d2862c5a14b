#include "sim_bridge/grpc/point_sampler.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

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

template <class List>
void resize(List& list, std::size_t size) {
  list.Resize(static_cast<int>(size), 0);
}

}  // namespace

PointSampler::PointSampler(const WaterHost& host) : host_(&host), placer_(host.sea.geodesy()) {}

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
  if (wanted.height) resize(*response.mutable_height_m(), n);
  if (wanted.slope) {
    resize(*response.mutable_slope_east(), n);
    resize(*response.mutable_slope_north(), n);
  }
  if (wanted.verticalVelocity) resize(*response.mutable_vertical_velocity_m_s(), n);
  if (wanted.velocity) {
    resize(*response.mutable_velocity_east_m_s(), n);
    resize(*response.mutable_velocity_north_m_s(), n);
    resize(*response.mutable_velocity_up_m_s(), n);
  }
  if (wanted.pressure) {
    resize(*response.mutable_pressure_pa(), n);
    resize(*response.mutable_dynamic_pressure_pa(), n);
  }
  if (wanted.error) {
    resize(*response.mutable_error_m(), n);
    resize(*response.mutable_bound_m(), n);
  }
}

void PointSampler::place(const SampleRequest& request, const Wanted& wanted,
                         const CallWatch& watch) {
  places_.resize(wanted.points);
  if (!wanted.geodetic) {
    for (std::size_t i = 0; i < wanted.points; ++i) {
      places_[i] = {request.plane().x_m(static_cast<int>(i)),
                    request.plane().y_m(static_cast<int>(i))};
    }
    return;
  }
  turns_.resize(wanted.points);
  for (std::size_t i = 0; i < wanted.points; ++i) {
    // Scattered points take a microsecond each.
    if (i % pieceSize == 0) watch.check();
    const PlacedPoint point = placer_.place(request.geodetic().latitude_deg(static_cast<int>(i)),
                                            request.geodetic().longitude_deg(static_cast<int>(i)));
    places_[i] = point.position;
    turns_[i] = point.turn;
  }
}

SampleStatus PointSampler::attend(const Wanted& wanted) {
  glm::dvec2 least(std::numeric_limits<double>::infinity()), most = -least;
  for (const glm::dvec2 place : places_) {
    if (!WaveField::serves(place, wanted.time)) continue;
    least = glm::min(least, place);
    most = glm::max(most, place);
  }
  if (least.x > most.x) return SampleStatus::ok;
  const WakeListener listener{0.5 * (least + most), 0.5 * glm::length(most - least),
                              wanted.options.excludeVessel};
  return host_->sea.attend(wanted.time, std::span(&listener, 1));
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
  motions_.resize(piece.count);
  depths_.resize(piece.count);
  const bool oneForAll = request.height_m_size() == 1;
  for (std::size_t i = 0; i < piece.count; ++i) {
    const int which = oneForAll ? 0 : static_cast<int>(piece.from + i);
    depths_[i] = {places_[piece.from + i], request.height_m(which)};
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
    if (response.status().empty()) resize(*response.mutable_status(), wanted.points);
    response.set_status(static_cast<int>(piece.from + i), static_cast<std::uint32_t>(status));
  }
}

std::size_t PointSampler::sample(const SampleRequest& request, SampleResponse& response,
                                 const CallWatch& watch) {
  const Wanted wanted = read(request);
  response.set_id(request.id());
  response.set_time_s(wanted.time);
  makeRoom(wanted, response);
  place(request, wanted, watch);
  const SampleStatus common = attend(wanted);
  const auto surface = host_->sea.surface();
  const bool motion = wanted.velocity || wanted.pressure;
  const bool timeServed = WaveField::serves({}, wanted.time);
  std::optional<SurfaceAtTime> now;
  if (motion && wanted.atHeights) now = surface->at(timeServed ? wanted.time : 0.0);
  for (Piece piece{0, 0}; piece.from < wanted.points; piece.from += piece.count) {
    if (piece.from > 0) watch.check();
    piece.count = std::min(pieceSize, wanted.points - piece.from);
    samples_.resize(std::max(samples_.size(), piece.count));
    const std::span<SurfaceSample> samples(samples_.data(), piece.count);
    surface->sample(std::span(places_).subspan(piece.from, piece.count), wanted.time, samples,
                    wanted.options);
    if (now) moveWater(request, wanted, piece, *now);
    if (motion && !now) moveSurface(piece);
    if (motion) writeMotion(wanted, piece, response);
    writeSurface(wanted, piece, response);
    writeStatus(wanted, piece, common, response);
  }
  return wanted.points;
}

}  // namespace seaway::bridge::rpc
