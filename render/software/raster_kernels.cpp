#include "render/software/raster_kernels.h"

#include "render/software/screen_grid.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/software/raster_kernels.cpp"
#include "hwy/foreach_target.h"
#include "render/shading/lanes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

// Both neighbours cover their common edge with this to spare, pixels: rounding leaves no gap.
constexpr float slack = 1.0f / 1024.0f;

/// Triangles of a vector of quads, one array a constant.
struct Triangles {
  alignas(64) float edge[3][quadsPerBatch],
      acrossEdge[3][quadsPerBatch], downEdge[3][quadsPerBatch];
  alignas(64) float depth[quadsPerBatch], acrossDepth[quadsPerBatch], downDepth[quadsPerBatch];
  alignas(64) float least[quadsPerBatch], most[quadsPerBatch];
  alignas(64) std::int32_t left[quadsPerBatch], right[quadsPerBatch];
  alignas(64) std::int32_t top[quadsPerBatch], bottom[quadsPerBatch];
};

struct Corner {
  Real x, y, inverse;
};

HWY_INLINE Corner load(const float* x, const float* y, const float* inverse, std::size_t at) {
  const Floats f;
  return {hn::LoadU(f, x + at), hn::LoadU(f, y + at), hn::LoadU(f, inverse + at)};
}

HWY_INLINE Real min3(Real a, Real b, Real c) { return min(min(a, b), c); }
HWY_INLINE Real max3(Real a, Real b, Real c) { return max(max(a, b), c); }

/// Sets up a vector of triangles and stores them at `at`. Positions are taken relative to the first
/// pixel of each triangle's box, so that large picture coordinates cost no precision.
HWY_INLINE void setUp(const Corner (&p)[3], const StripPixels& strip, Triangles& out, int at) {
  const Floats f;
  const Real last = static_cast<float>(strip.width - 1);
  const Real firstRow = static_cast<float>(strip.top);
  const Real lastRow = static_cast<float>(strip.top + strip.rows - 1);
  const Real left = max(Real(hn::Ceil((min3(p[0].x, p[1].x, p[2].x) - slack).v)), 0.0f);
  const Real right = min(floor(max3(p[0].x, p[1].x, p[2].x) + slack), last);
  const Real top = max(Real(hn::Ceil((min3(p[0].y, p[1].y, p[2].y) - slack).v)), firstRow);
  const Real bottom = min(floor(max3(p[0].y, p[1].y, p[2].y) + slack), lastRow);
  const Real area = (p[1].x - p[0].x) * (p[2].y - p[0].y) - (p[1].y - p[0].y) * (p[2].x - p[0].x);
  const Real turn = choose(area < 0.0f, -1.0f, 1.0f);
  for (int k = 0; k < 3; ++k) {
    const Corner &from = p[k], &to = p[k == 2 ? 0 : k + 1];
    const Real across = (from.y - to.y) * turn, down = (to.x - from.x) * turn;
    const Real edge = across * (left - from.x) + down * (top - from.y);
    hn::Store((edge + (abs(across) + abs(down)) * slack).v, f, out.edge[k] + at);
    hn::Store(across.v, f, out.acrossEdge[k] + at);
    hn::Store(down.v, f, out.downEdge[k] + at);
  }
  // A triangle without area lies on its edges; its depth is one corner's, kept within bounds.
  const Real perArea = choose(abs(area) > 1e-12f, exactQuotient(1.0f, area), 0.0f);
  const Real d1 = p[1].inverse - p[0].inverse, d2 = p[2].inverse - p[0].inverse;
  const Real acrossDepth = (d1 * (p[2].y - p[0].y) - d2 * (p[1].y - p[0].y)) * perArea;
  const Real downDepth = (d2 * (p[1].x - p[0].x) - d1 * (p[2].x - p[0].x)) * perArea;
  const Real depth = p[0].inverse + acrossDepth * (left - p[0].x) + downDepth * (top - p[0].y);
  hn::Store(depth.v, f, out.depth + at);
  hn::Store(acrossDepth.v, f, out.acrossDepth + at);
  hn::Store(downDepth.v, f, out.downDepth + at);
  hn::Store(min3(p[0].inverse, p[1].inverse, p[2].inverse).v, f, out.least + at);
  hn::Store(max3(p[0].inverse, p[1].inverse, p[2].inverse).v, f, out.most + at);
  const Ints i;
  hn::Store(toInt(left), i, out.left + at);
  hn::Store(toInt(right), i, out.right + at);
  hn::Store(toInt(top), i, out.top + at);
  hn::Store(toInt(bottom), i, out.bottom + at);
}

/// One triangle of a batch into its box of pixels.
HWY_INLINE void drawTriangle(const Triangles& t, int i, const StripPixels& strip) {
  const Floats f;
  const int lanes = static_cast<int>(laneCount());
  const int left = t.left[i], right = t.right[i], bottom = t.bottom[i];
  const Real iota = hn::Iota(f, 0.0f);
  const Real across[3] = {t.acrossEdge[0][i], t.acrossEdge[1][i], t.acrossEdge[2][i]};
  const Real acrossDepth = t.acrossDepth[i];
  Real e0 = Real(t.edge[0][i]) + across[0] * iota, e1 = Real(t.edge[1][i]) + across[1] * iota;
  Real e2 = Real(t.edge[2][i]) + across[2] * iota;
  Real depth = Real(t.depth[i]) + acrossDepth * iota;
  const Real down0 = t.downEdge[0][i], down1 = t.downEdge[1][i], down2 = t.downEdge[2][i];
  const Real downDepth = t.downDepth[i], least = t.least[i], most = t.most[i];
  float* row = strip.inverse + static_cast<std::size_t>(t.top[i] - strip.top) * strip.stride + left;
  for (int y = t.top[i]; y <= bottom; ++y, row += strip.stride) {
    // Pixels past the box are outside the triangle by its edges; those past the picture are never
    // read.
    for (int x = 0; x <= right - left; x += lanes) {
      const Real on = static_cast<float>(x);
      const Mask inside =
          min3(e0 + across[0] * on, e1 + across[1] * on, e2 + across[2] * on) >= Real(0.0f);
      const Real value = clamp(depth + acrossDepth * on, least, most);
      const Real there = hn::LoadU(f, row + x);
      const Mask nearer = inside && value > there;
      hn::BlendedStore(value.v, nearer.m, f, row + x);
    }
    e0 = e0 + down0;
    e1 = e1 + down1;
    e2 = e2 + down2;
    depth = depth + downDepth;
  }
}

void DrawQuads(const float* x, const float* y, const float* inverse, std::size_t nextRow, int count,
               const StripPixels& strip) {
  Triangles first, second;
  const int lanes = static_cast<int>(laneCount());
  for (int i = 0; i < count; i += lanes) {
    const Corner a = load(x, y, inverse, i), b = load(x, y, inverse, i + 1);
    const Corner c = load(x, y, inverse, nextRow + i), d = load(x, y, inverse, nextRow + i + 1);
    setUp({a, b, c}, strip, first, i);
    setUp({b, d, c}, strip, second, i);
  }
  for (int i = 0; i < count; ++i) {
    if (first.left[i] <= first.right[i] && first.top[i] <= first.bottom[i]) {
      drawTriangle(first, i, strip);
    }
    if (second.left[i] <= second.right[i] && second.top[i] <= second.bottom[i]) {
      drawTriangle(second, i, strip);
    }
  }
}

void DrawSpan(const TrianglePlanes& t, int width, float* inverse, unsigned* object,
              unsigned which) {
  const Floats f;
  const Words w;
  const int lanes = static_cast<int>(laneCount());
  for (int x = 0; x < width; x += lanes) {
    const Real on = hn::Iota(f, static_cast<float>(x));
    const Mask inside = min3(Real(t.edge[0]) + Real(t.acrossEdge[0]) * on,
                             Real(t.edge[1]) + Real(t.acrossEdge[1]) * on,
                             Real(t.edge[2]) + Real(t.acrossEdge[2]) * on) >= Real(0.0f) &&
                        on < Real(static_cast<float>(width));
    const Real value = clamp(Real(t.depth) + Real(t.acrossDepth) * on, t.least, t.most);
    const Mask nearer = inside && value > Real(hn::LoadU(f, inverse + x));
    hn::BlendedStore(value.v, nearer.m, f, inverse + x);
    if (object) {
      hn::BlendedStore(hn::Set(w, which), hn::RebindMask(w, nearer.m), w, object + x);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(DrawQuads);
HWY_EXPORT(DrawSpan);

void drawQuads(const float* x, const float* y, const float* inverse, std::size_t nextRow, int count,
               const StripPixels& strip) {
  HWY_DYNAMIC_DISPATCH(DrawQuads)(x, y, inverse, nextRow, count, strip);
}
void drawSpan(const TrianglePlanes& planes, int width, float* inverse, unsigned* object,
              unsigned which) {
  HWY_DYNAMIC_DISPATCH(DrawSpan)(planes, width, inverse, object, which);
}

}  // namespace seaway::render
#endif
