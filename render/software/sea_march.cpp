#include "render/software/sea_march.h"

#include <cmath>

#include "render/shading/pixel_shader.h"
#include "surface/constants.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/software/sea_march.cpp"
#include "hwy/foreach_target.h"
#include "render/shading/lanes-inl.h"
#include "render/software/ring_place-inl.h"

#ifndef SEAWAY_MARCH_INPUT
#define SEAWAY_MARCH_INPUT
namespace seaway::render {
struct MarchInput {
  glm::ivec2 size;
  RingLaw law;
  const float* heights;
  glm::vec3 forward, right, down;  // ray = forward + x right + y down, x and y in pixels
  float cameraHeight, bound, nearest, reach;
  int steps;
  float side;  // 1 above the water, −1 below
};
}  // namespace seaway::render
#endif

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

constexpr float perDrop = static_cast<float>(0.5 / earthMeanRadius);
constexpr float none = 1e30f;

/// A fraction of the way between two vertices of a row or column of `count`.
struct Between {
  VI low;
  Real part;
};
HWY_INLINE Between between(Real at, int count) {
  const Real low = min(floor(at), count - 2.0f);
  return {toInt(low), at - low};
}

HWY_INLINE Real heightAt(const MarchInput& in, Between row, Between column) {
  const VI at = hn::Add(hn::Mul(row.low, setInt(in.size.x)), column.low);
  const VI beyond = hn::Add(at, setInt(in.size.x)), one = setInt(1);
  const Real near = mix(gather(in.heights, at), gather(in.heights, hn::Add(at, one)), column.part);
  const Real far =
      mix(gather(in.heights, beyond), gather(in.heights, hn::Add(beyond, one)), column.part);
  return mix(near, far, row.part);
}

/// Positive distances at which a ray of axial length 1 is `level` m above still water; `none` where
/// it never is.
struct Roots {
  Real near, far;
};
HWY_INLINE Roots crossings(const MarchInput& in, Real3 ray, Real curve, Real level) {
  const Real off = Real(in.cameraHeight) - level;
  const Real square = ray.z * ray.z - Real(4.0f) * curve * off;
  const Real root = sqrt(max(square, 0.0f));
  const Real q = choose(ray.z < 0.0f, root - ray.z, -root - ray.z) * 0.5f;
  const Real safe = choose(abs(q) < 1e-12f, Real(1e-12f), q);
  const auto kept = [&](Real s) HWY_ATTR {
    return choose(square >= 0.0f, choose(s > in.nearest, s, Real(none)), Real(none));
  };
  const Real a = kept(exactQuotient(off, safe)), b = kept(exactQuotient(q, curve));
  return {min(a, b), max(a, b)};
}

/// The first stretch of a ray on which it may meet a wave; empty where it begins at `none`.
HWY_INLINE Roots stretch(const MarchInput& in, Real3 ray, Real curve) {
  const Roots top = crossings(in, ray, curve, in.bound);
  const Roots bottom = crossings(in, ray, curve, -in.bound);
  if (in.cameraHeight > in.bound) return {top.near, min(top.far, bottom.near)};
  if (in.cameraHeight < -in.bound) return {bottom.near, min(bottom.far, top.near)};
  return {Real(in.nearest), min(top.near, bottom.near)};
}

HWY_INLINE Real marched(const MarchInput& in, Real3 ray, Real scene) {
  const Real level = ray.x * ray.x + ray.y * ray.y;
  const Real perMetre = sqrt(level);
  const Real curve = max(level * perDrop, 1e-20f);
  const Roots range = stretch(in, ray, curve);
  const Real farthest = min(min(range.far, scene), Real(in.reach) / max(perMetre, 1e-9f));
  const Mask meets = range.near < farthest;
  Real crossing(none);
  if (!anyOf(meets)) return crossing;
  const Real begin = choose(meets, range.near, 1.0f), end = choose(meets, farthest, 2.0f);
  const Between column =
      between(min(turnOf(ray.x, ray.y) * (in.size.x - 1.0f), in.size.x - 1.0f), in.size.x);
  const auto above = [&](Real s) HWY_ATTR {
    const Real row = clamp(ringRow(in.law, s * perMetre), 0.0f, in.size.y - 1.0f);
    const Real bare = Real(in.cameraHeight) + s * (ray.z + s * curve);
    return (bare - heightAt(in, between(row, in.size.y), column)) * in.side;
  };
  const Real shrink = exp(exactLog2(begin / end) * (0.69314718f / static_cast<float>(in.steps)));
  Real s = end, height = above(end);
  Real dry(0.0f), dryHeight(0.0f), wet(0.0f), wetHeight(0.0f);
  for (int i = 1; i <= in.steps; ++i) {
    const Real next = i == in.steps ? begin : s * shrink, nextHeight = above(next);
    const Mask leaves = height < 0.0f && nextHeight >= 0.0f;
    dry = choose(leaves, next, dry);
    dryHeight = choose(leaves, nextHeight, dryHeight);
    wet = choose(leaves, s, wet);
    wetHeight = choose(leaves, height, wetHeight);
    s = next;
    height = nextHeight;
  }
  const Mask found = meets && dry > 0.0f;
  for (int i = 0; i < 3; ++i) {
    const Real part = dryHeight / max(dryHeight - wetHeight, 1e-12f);
    const Real middle = mix(dry, wet, clamp(part, 0.02f, 0.98f)), here = above(middle);
    const Mask isDry = here >= 0.0f;
    dry = choose(isDry, middle, dry);
    dryHeight = choose(isDry, here, dryHeight);
    wet = choose(isDry, wet, middle);
    wetHeight = choose(isDry, wetHeight, here);
  }
  const Real last =
      mix(dry, wet, clamp(dryHeight / max(dryHeight - wetHeight, 1e-12f), 0.0f, 1.0f));
  return choose(found, last, crossing);
}

void March(const MarchInput& in, const Strip* scene, Strip& strip) {
  const Floats f;
  const int lanes = static_cast<int>(laneCount());
  for (int line = 0; line < strip.rows; ++line) {
    const std::size_t first = static_cast<std::size_t>(line) * strip.stride;
    const float y = static_cast<float>(strip.top + line) + 0.5f;
    for (int i = 0; i < strip.width; i += lanes) {
      const Real x = Real(hn::Iota(f, static_cast<float>(i))) + 0.5f;
      const Real3 ray = Real3(in.forward) + Real3(in.right) * x + Real3(in.down) * Real(y);
      Real farthest(none);
      if (scene) {
        const Real inverse = hn::LoadU(f, scene->inverse.data() + first + i);
        farthest = choose(inverse > 0.0f, Real(1.0f) / max(inverse, 1e-20f), farthest);
      }
      const Real s = marched(in, ray, farthest);
      const Real inverse = choose(s < none, exactQuotient(1.0f, s), 0.0f);
      hn::StoreU(inverse.v, f, strip.inverse.data() + first + i);
    }
  }
}

void FillSlopes(const MarchInput& in, PixelSpan& span) {
  const Floats f;
  for (int i = 0; i < span.count; i += static_cast<int>(laneCount())) {
    const Real index = hn::Iota(f, static_cast<float>(i));
    const Real axial = hn::Load(f, span.axial + i);
    const Real3 ray = Real3(span.firstRay) + Real3(span.rayStep) * index;
    const Real2 place(ray.x * axial, ray.y * axial);
    const RingPlace here = ringPlace(in.law, in.size, place);
    const Real d = Real(1.0f) / min(here.rowsPerMetre, here.columnsPerMetre);
    const auto height = [&](Real x, Real y) HWY_ATTR {
      const RingPlace at = ringPlace(in.law, in.size, {place.x + x, place.y + y});
      return heightAt(in, between(at.row, in.size.y), between(at.column, in.size.x));
    };
    const Real still(0.0f), half = Real(0.5f) / d;
    hn::Store(((height(d, still) - height(-d, still)) * half).v, f, span.slopeX + i);
    hn::Store(((height(still, d) - height(still, -d)) * half).v, f, span.slopeY + i);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(March);
HWY_EXPORT(FillSlopes);

namespace {

MarchInput inputFor(const Camera& camera) {
  MarchInput input{};
  const Intrinsics pinhole = camera.pinhole();
  const glm::dvec2 pixel = camera.pixelExtent(), middle(pinhole.cx + 0.5, pinhole.cy + 0.5);
  const glm::dvec3 right = -camera.left() * pixel.x, down = -camera.up() * pixel.y;
  input.right = glm::vec3(right);
  input.down = glm::vec3(down);
  input.forward = glm::vec3(camera.forward() - middle.x * right - middle.y * down);
  input.cameraHeight = static_cast<float>(camera.position.z);
  input.nearest = static_cast<float>(camera.nearDistance);
  return input;
}

}  // namespace

void SeaMarch::fill(const SeaGrid& grid, const GridLayout& layout, const Camera& camera,
                    double bound, int steps, bool cameraIsUnderWater) {
  size_ = grid.size();
  law_ = *layout.rings;
  heights_ = grid.height().data();
  camera_ = camera;
  bound_ = bound;
  steps_ = steps;
  isUnderWater_ = cameraIsUnderWater;
}

void SeaMarch::march(const Strip* scene, Strip& strip) const {
  MarchInput input = inputFor(camera_);
  input.size = size_;
  input.law = law_;
  input.heights = heights_;
  // Still water has a crossing too.
  input.bound = static_cast<float>(bound_ + 1e-3 + 1e-6 * std::abs(camera_.position.z));
  input.reach = static_cast<float>(law_.radius(size_.y - 1));
  input.steps = steps_;
  input.side = isUnderWater_ ? -1.0f : 1.0f;
  HWY_DYNAMIC_DISPATCH(March)(input, scene, strip);
}

void SeaMarch::fillSlopes(PixelSpan& span) const {
  MarchInput input{};
  input.size = size_;
  input.law = law_;
  input.heights = heights_;
  HWY_DYNAMIC_DISPATCH(FillSlopes)(input, span);
}

}  // namespace seaway::render
#endif
