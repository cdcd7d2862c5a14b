// Where places lie in a grid of rings (RingLaw), a vector of them at a time. Once per instruction
// set (Highway's per-target include).

#if defined(SEAWAY_RENDER_RING_PLACE_INL_H_) == defined(HWY_TARGET_TOGGLE)
#ifdef SEAWAY_RENDER_RING_PLACE_INL_H_
#undef SEAWAY_RENDER_RING_PLACE_INL_H_
#else
#define SEAWAY_RENDER_RING_PLACE_INL_H_
#endif

#include "render/grid_layout.h"
#include "render/shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {

/// Row and column of a place, fractions between vertices, and how many of either a metre crosses.
struct RingPlace {
  Real row, column, rowsPerMetre, columnsPerMetre;
};

/// Angle of (x, y) from x in turns, [0, 1), within 1e-7; of (0, 0) any.
HWY_INLINE Real turnOf(Real x, Real y) {
  const Real wide = abs(x), high = abs(y);
  const Real slant = min(wide, high) / max(max(wide, high), 1e-30f);
  const Real eighth = Real(hn::Atan(Floats(), slant.v)) * 0.159154943f;
  const Real quarter = choose(high > wide, Real(0.25f) - eighth, eighth);
  const Real half = choose(x < 0.0f, Real(0.5f) - quarter, quarter);
  const Real turn = choose(y < 0.0f, Real(1.0f) - half, half);
  return choose(turn >= 1.0f, Real(0.0f), turn);
}

/// Row of a distance from the centre, m.
HWY_INLINE Real ringRow(const RingLaw& law, Real distance) {
  const auto inner = static_cast<float>(law.innermost);
  const Real fourth = max((distance - inner) * static_cast<float>(1.0 / law.growth), 0.0f);
  return choose(distance < inner, distance * (1.0f / inner), sqrt(sqrt(fourth)) + 1.0f);
}

/// `offset` m from the centre; rows and columns are held within `size`.
HWY_INLINE RingPlace ringPlace(const RingLaw& law, glm::ivec2 size, Real2 offset) {
  const float columns = size.x - 1.0f, rows = size.y - 1.0f;
  const Real distance = sqrt(dot(offset, offset));
  const Real row = clamp(ringRow(law, distance), 0.0f, rows);
  const Real ring = max(row - 1.0f, 0.5f);
  const Real outside = Real(static_cast<float>(0.25 / law.growth)) / (ring * ring * ring);
  const auto inside = static_cast<float>(1.0 / law.innermost);
  return {row, min(turnOf(offset.x, offset.y) * columns, columns),
          choose(row < 1.0f, Real(inside), min(outside, inside)),
          Real(columns * 0.159154943f) / max(distance, static_cast<float>(law.innermost))};
}

}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#endif
