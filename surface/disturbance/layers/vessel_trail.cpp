#include "surface/disturbance/layers/vessel_trail.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "surface/angles.h"
#include "surface/constants.h"
#include "surface/field/lattice_hash.h"

namespace seaway {
namespace {

double smooth01(double low, double high, double x) {
  const double f = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return f * f * (3.0 - 2.0 * f);
}

/// Smooth noise of [0, 1] with patches of `size` m.
double patches(glm::dvec2 point, double size) {
  const glm::dvec2 place = point / size, cell = glm::floor(place), f = place - cell;
  const glm::dvec2 w = f * f * (3.0 - 2.0 * f);
  const auto corner = [&](double dx, double dy) {
    const std::uint32_t hash =
        cornerHash(cellBits(cell.x + dx), cellBits(cell.y + dy), {0x70A11u, 0xF0A3u});
    return static_cast<double>(hash >> 16) / 65536.0;
  };
  return glm::mix(glm::mix(corner(0, 0), corner(1, 0), w.x),
                  glm::mix(corner(0, 1), corner(1, 1), w.x), w.y);
}

/// Raggedness of foam: 1 on average, at scales from a third of a hull's beam down.
double ragged(glm::dvec2 point, double beam) {
  return 0.25 + 0.6 * patches(point, 0.8 * beam) + 0.5 * patches(point, 0.31 * beam) +
         0.4 * patches(point, 0.13 * beam);
}

/// A piece of a hull's path: points are told how far along it they lie, [0, 1], and how far aside.
struct Stretch {
  glm::dvec2 from, to;

  double length() const { return glm::length(to - from); }
  /// Aside in m, negative to starboard; nothing beyond the ends.
  bool meets(glm::dvec2 point, double& aside) const {
    const glm::dvec2 along = to - from, offset = point - from;
    const double square = glm::dot(along, along);
    const double part = glm::dot(offset, along) / square;
    aside = (along.x * offset.y - along.y * offset.x) / std::sqrt(square);
    return part >= 0.0 && part < 1.0;
  }
};

template <class CoverAcross>
void stroke(const Stretch& stretch, double halfWidth, double t, const glm::dvec2& water,
            double beam, const CoverAcross& coverAcross, SurfaceLayer& layer) {
  // A cell more: a stroke shorter than that would fall between centres.
  if (!(stretch.length() > 0.0)) return;
  const glm::dvec2 lower = glm::min(stretch.from, stretch.to) - halfWidth;
  const glm::dvec2 upper = glm::max(stretch.from, stretch.to) + halfWidth;
  layer.paint(lower, upper, t, [&](glm::dvec2 point) {
    double aside = 0.0;
    if (!stretch.meets(point, aside)) return 0.0f;
    const double across = std::abs(aside) / halfWidth;
    if (across >= 1.0) return 0.0f;
    return static_cast<float>(coverAcross(across) * ragged(point - water, beam));
  });
}

/// Ages at which a trail is widened, s, and its width then, in widths at the stern.
struct Station {
  double age, width;
};
constexpr Station foamStations[] = {{4.0, 1.25}, {10.0, 1.5}, {22.0, 1.8}};
constexpr Station smoothStations[] = {{8.0, 1.4}, {25.0, 1.8}, {60.0, 2.2}, {115.0, 2.5}};

constexpr double leastSpeed = 0.25;  // m/s

}  // namespace

double trailStrength(const TrailHull& hull, double speed) {
  const double froude = std::abs(speed) / std::sqrt(standardGravity * hull.length);
  return 0.9 * smooth01(0.1, 0.5, froude);
}

void paintTrail(const TrailHull& hull, const std::function<TrailPose(double)>& poseAt, double from,
                double to, SurfaceLayer& foam, SurfaceLayer& smooth) {
  const TrailPose now = poseAt(to);
  const double speed = glm::length(now.velocity);
  if (!(speed >= leastSpeed)) return;
  const double strength = trailStrength(hull, speed), half = 0.5 * hull.beam;
  const double astern = glm::dot(now.velocity, unitVector(now.direction)) < 0.0 ? -1.0 : 1.0;
  // The path of a point of the hull, `ahead` of amidships in the direction it moves.
  const auto stretchAt = [&](double age, double ahead) {
    const auto place = [&](double t) {
      const TrailPose pose = poseAt(t);
      // Where the water that it was in has got to since.
      return pose.position + foam.settings().drift * age +
             astern * ahead * unitVector(pose.direction);
    };
    return Stretch{place(from - age), place(to - age)};
  };
  const glm::dvec2 water = foam.settings().drift * to;

  if (strength > 0.02) {
    // Along the sides from the shoulders on, and behind the stern.
    stroke(
        stretchAt(0.0, 0.25 * hull.length), 1.12 * half, to, water, hull.beam,
        [&](double v) {
          return 0.75 * strength * smooth01(0.74, 0.86, v) * (1.0 - smooth01(0.92, 1.0, v));
        },
        foam);
    // From well under the hull on: a stroke is left when it is over.
    stroke(
        stretchAt(0.0, -0.27 * hull.length), 0.9 * half, to, water, hull.beam,
        [&](double v) { return strength * (1.0 - 0.75 * smooth01(0.35, 1.0, v)); }, foam);
    for (const Station& station : foamStations) {
      const double left = std::exp(-station.age / foam.settings().decayTime);
      stroke(
          stretchAt(station.age, -0.42 * hull.length), station.width * half, to, water, hull.beam,
          [&](double v) {
            return 0.8 * strength * left * smooth01(0.25, 0.6, v) * (1.0 - smooth01(0.62, 1.0, v));
          },
          foam);
    }
  }
  const double calm = 0.95 * smooth01(leastSpeed, 2.0, speed);
  const auto lay = [&](double age, double width) {
    stroke(
        stretchAt(age, -0.4 * hull.length), width * half, to, water, hull.beam,
        [&](double v) { return calm * (1.0 - smooth01(0.55, 1.0, v)); }, smooth);
  };
  lay(0.0, 1.1);
  for (const Station& station : smoothStations) lay(station.age, 1.1 * station.width);
}

Painted paintPatch(glm::dvec2 place, double radius, double cover, double t, SurfaceLayer& layer) {
  const glm::dvec2 water = layer.settings().drift * t;
  return layer.paint(place - radius, place + radius, t, [&](glm::dvec2 point) {
    const double far = glm::length(point - place) / radius;
    const double uneven = ragged(point - water, radius);
    return static_cast<float>(cover * (1.0 - smooth01(0.45, 0.7 + 0.3 * uneven / 1.75, far)) *
                              std::min(0.4 + 0.6 * uneven, 1.0));
  });
}

}  // namespace seaway
