#include "surface/disturbance/hull_footprint.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "surface/dispersion.h"
#include "surface/input_error.h"

namespace seaway {
namespace {

using Complex = std::complex<double>;

/// Without the checks for infinities that std::complex makes.
Complex product(Complex a, Complex b) {
  return {a.real() * b.real() - a.imag() * b.imag(), a.real() * b.imag() + a.imag() * b.real()};
}

double cross(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

struct AreaMoments {
  double area = 0.0;  // counter-clockwise is positive
  glm::dvec2 first{0.0};
};

AreaMoments momentsOf(std::span<const glm::dvec2> outline) {
  AreaMoments moments;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 a = outline[i], b = outline[(i + 1) % outline.size()];
    const double twice = cross(a, b);
    moments.area += twice / 2.0;
    moments.first += (a + b) * (twice / 6.0);
  }
  return moments;
}

/// ∫₀¹ e^(−ik·x) along an edge, k·e = `turn`, from the factors e^(−ik·x) at its ends.
Complex edgeMean(double turn, Complex from, Complex to) {
  // Near 0 the difference cancels; the mean of the ends errs by turn²/12, then by turn⁴/120.
  if (std::abs(turn) < 1e-3) return 0.5 * (from + to) * (1.0 + turn * turn / 12.0);
  return Complex(to.imag() - from.imag(), from.real() - to.real()) / -turn;
}

/// ∫∫ e^(−ik·x) over a polygon, by Stokes' theorem: (i/k²) Σ (k × e) mean(e^(−ik·x)) over the edges
/// e. `factors` holds e^(−ik·x) of its corners.
Complex polygonSpectrum(std::span<const glm::dvec2> outline, const AreaMoments& moments,
                        double extent, glm::dvec2 k, std::span<const Complex> factors) {
  if (outline.size() < 3) return 0.0;
  const double sense = moments.area < 0.0 ? -1.0 : 1.0;
  // The edges cancel to k²: below this, two terms of the series are better. Its error is (kx)²/2.
  if (glm::length(k) * extent < 1e-4) {
    return sense * Complex(moments.area, -glm::dot(k, moments.first));
  }
  Complex sum = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const std::size_t next = i + 1 < outline.size() ? i + 1 : 0;
    const glm::dvec2 edge = outline[next] - outline[i];
    sum += cross(k, edge) * edgeMean(glm::dot(k, edge), factors[i], factors[next]);
  }
  return sense * Complex(0.0, 1.0) * sum / glm::dot(k, k);
}

/// ∫ e^(kz) (a (1 − s) + b s) dz from z = top (s = 0) down to z = bottom (s = 1).
Complex layerIntegral(double k, double top, double bottom, Complex a, Complex b) {
  const double thickness = top - bottom;
  const double q = k * thickness;
  double mean, slope;  // ∫₀¹ e^(−qs) ds, ∫₀¹ s e^(−qs) ds
  if (std::abs(q) < 1e-3) {
    mean = 1.0 - q / 2.0 + q * q / 6.0 - q * q * q / 24.0;
    slope = 0.5 - q / 3.0 + q * q / 8.0 - q * q * q / 30.0;
  } else {
    mean = -std::expm1(-q) / q;
    slope = (mean - std::exp(-q)) / q;
  }
  return thickness * std::exp(k * top) * (a * (mean - slope) + b * slope);
}

void check(const std::vector<Waterline>& waterlines) {
  if (waterlines.size() < 2) throw InputError("a hull needs at least two waterlines");
  for (std::size_t i = 0; i < waterlines.size(); ++i) {
    const double z = waterlines[i].z;
    if (!(z <= 0.0) || !std::isfinite(z)) throw InputError("a waterline's height must be <= 0 m");
    if (i > 0 && !(z < waterlines[i - 1].z)) {
      throw InputError("waterlines must lie one below the other");
    }
    for (const glm::dvec2 point : waterlines[i].outline) {
      if (!std::isfinite(point.x) || !std::isfinite(point.y)) {
        throw InputError("a waterline's outline must be finite");
      }
    }
  }
}

}  // namespace

HullFootprint::HullFootprint(std::vector<Waterline> waterlines)
    : waterlines_(std::move(waterlines)) {
  check(waterlines_);
  bool any = false;
  for (const Waterline& waterline : waterlines_) {
    for (const glm::dvec2 point : waterline.outline) {
      lower_ = any ? glm::min(lower_, point) : point;
      upper_ = any ? glm::max(upper_, point) : point;
      any = true;
      extent_ = std::max(extent_, glm::length(point));
    }
  }
}

HullFootprint HullFootprint::box(double length, double beam, double draft) {
  const glm::dvec2 half(0.5 * length, 0.5 * beam);
  const std::vector<glm::dvec2> outline{
      {half.x, half.y}, {-half.x, half.y}, {-half.x, -half.y}, {half.x, -half.y}};
  return HullFootprint({{0.0, outline}, {-draft, outline}});
}

HullFootprint HullFootprint::wigley(double length, double beam, double draft, int waterlines) {
  constexpr int stations = 41;  // area of the polygons within 1/1600 of the parabola's
  std::vector<double> x(stations), z(static_cast<std::size_t>(waterlines)), breadths;
  for (int i = 0; i < stations; ++i)
    x[i] = length * (static_cast<double>(i) / (stations - 1) - 0.5);
  for (int j = 0; j < waterlines; ++j) z[j] = -draft * j / (waterlines - 1);
  for (const double height : z) {
    for (const double station : x) {
      const double along = 2.0 * station / length, down = height / draft;
      breadths.push_back(0.5 * beam * (1.0 - along * along) * (1.0 - down * down));
    }
  }
  return fromHalfBreadths(x, z, breadths);
}

HullFootprint HullFootprint::fromHalfBreadths(std::span<const double> stations,
                                              std::span<const double> heights,
                                              std::span<const double> halfBreadths) {
  if (stations.size() < 2 || halfBreadths.size() != stations.size() * heights.size()) {
    throw InputError("half-breadths must be one for each station and height, two stations or more");
  }
  std::vector<Waterline> waterlines;
  for (std::size_t j = 0; j < heights.size(); ++j) {
    Waterline waterline{heights[j], {}};
    const auto breadths = halfBreadths.subspan(j * stations.size(), stations.size());
    for (std::size_t i = 0; i < stations.size(); ++i) {
      if (!(breadths[i] >= 0.0)) throw InputError("a half-breadth must be >= 0 m");
      waterline.outline.emplace_back(stations[i], -breadths[i]);
    }
    for (std::size_t i = stations.size(); i-- > 0;) {
      waterline.outline.emplace_back(stations[i], breadths[i]);
    }
    waterlines.push_back(std::move(waterline));
  }
  return HullFootprint(std::move(waterlines));
}

HullFootprint HullFootprint::collapsedOntoCentreplane() const {
  HullFootprint thin = *this;
  thin.thin_ = true;
  return thin;
}

std::complex<double> HullFootprint::overDepth(double number, double depth,
                                              std::span<const Complex> areas) const {
  const bool deep = std::isinf(depth);
  Complex falling = 0.0, mirrored = 0.0;  // parts with e^(kz) and with e^(−k(z + 2d))
  for (std::size_t i = 1; i < waterlines_.size(); ++i) {
    const double top = waterlines_[i - 1].z, bottom = waterlines_[i].z;
    falling += layerIntegral(number, top, bottom, areas[i - 1], areas[i]);
    // The image's layer lies upside down about −2d: its top is the mirror of the bottom.
    if (!deep) {
      mirrored +=
          layerIntegral(number, -2.0 * depth - bottom, -2.0 * depth - top, areas[i], areas[i - 1]);
    }
  }
  return deep ? falling : (falling + mirrored) / (1.0 + std::exp(-2.0 * number * depth));
}

std::complex<double> HullFootprint::spectrum(glm::dvec2 k, double depth) const {
  const glm::dvec2 seen = thin_ ? glm::dvec2(k.x, 0.0) : k;
  std::vector<Complex> areas, factors;
  for (std::size_t i = 0; i < waterlines_.size(); ++i) {
    const auto& outline = waterlines_[i].outline;
    factors.clear();
    for (const glm::dvec2 point : outline)
      factors.push_back(std::polar(1.0, -glm::dot(seen, point)));
    areas.push_back(polygonSpectrum(outline, momentsOf(outline), extent_, seen, factors));
  }
  return overDepth(glm::length(k), depth, areas);
}

std::vector<std::complex<float>> HullFootprint::tabulate(double spacing, int alongX, int alongY,
                                                         double depth) const {
  // Factors of the corners are products of one of k_x and one of k_y: no sine per corner and entry.
  std::vector<glm::dvec2> corners;
  std::vector<AreaMoments> moments;
  for (const Waterline& waterline : waterlines_) {
    corners.insert(corners.end(), waterline.outline.begin(), waterline.outline.end());
    moments.push_back(momentsOf(waterline.outline));
  }
  const std::size_t count = corners.size(), columns = static_cast<std::size_t>(alongX) + 1;
  std::vector<Complex> ofX(columns * count), ofY(count), factors(count), areas(moments.size());
  for (std::size_t x = 0; x < columns; ++x) {
    for (std::size_t i = 0; i < count; ++i) {
      ofX[x * count + i] = std::polar(1.0, -spacing * static_cast<double>(x) * corners[i].x);
    }
  }
  std::vector<std::complex<float>> table;
  table.reserve(columns * (2 * static_cast<std::size_t>(alongY) + 1));
  for (int y = -alongY; y <= alongY; ++y) {
    const double ky = spacing * y, seenY = thin_ ? 0.0 : ky;
    for (std::size_t i = 0; i < count; ++i) ofY[i] = std::polar(1.0, -seenY * corners[i].y);
    for (std::size_t x = 0; x < columns; ++x) {
      const glm::dvec2 k(spacing * static_cast<double>(x), seenY);
      for (std::size_t i = 0; i < count; ++i) factors[i] = product(ofX[x * count + i], ofY[i]);
      std::size_t first = 0;
      for (std::size_t line = 0; line < waterlines_.size(); ++line) {
        const auto& outline = waterlines_[line].outline;
        areas[line] = polygonSpectrum(outline, moments[line], extent_, k,
                                      std::span(factors).subspan(first, outline.size()));
        first += outline.size();
      }
      table.emplace_back(overDepth(std::hypot(k.x, ky), depth, areas));
    }
  }
  return table;
}

double HullFootprint::volume() const { return spectrum({0.0, 0.0}, deepWater).real(); }

}  // namespace seaway
