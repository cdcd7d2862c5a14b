#include "render/shading/pixel_shader.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "render/fresnel.h"
#include "render/shading/shading_tables.h"
#include "render/shading/sky_dome.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/shading/pixel_shader.cpp"
#include "hwy/foreach_target.h"
#include "render/shading/lanes-inl.h"
#include "render/shading/texels-inl.h"

#ifndef SEAWAY_TONE_TABLE
#define SEAWAY_TONE_TABLE
namespace seaway::render {
/// 256 times the sRGB bytes of exposed radiance, by its root: the root spreads the steps so that
/// none is larger than a third of a byte, of a linear curve near black than two thirds. One more
/// than steps, for fetches of words.
struct ToneTable {
  static constexpr int steps = 8192;
  static constexpr float perRoot = 2048.0f;  // up to 16, which is white
  std::array<std::uint16_t, steps + 1> fine{};
};
}  // namespace seaway::render
#endif

HWY_BEFORE_NAMESPACE();
namespace seaway::render {
namespace HWY_NAMESPACE {
namespace {

using glm::vec2;
using glm::vec3;

struct PixelShader : ShadingConstants {
  const std::uint32_t* skyTexels;
  const ShadingTables& tables = shadingTables();
  const float* foam;  // null where foam is off
  // Null where there are none.
  const LocalImage *mirrorImage, *belowImage, *windowImage, *depthsImage;
  const float *shadows, *waterline;
  const CoverTiles* shadowTiles;
  float shadowWidth;

  HWY_INLINE explicit PixelShader(const ShadingSources& sources)
      : ShadingConstants(sources.constants),
        skyTexels(sources.sky),
        foam(sources.constants.foamIsOn ? foamTable().texels.data() : nullptr),
        mirrorImage(sources.mirrored),
        belowImage(sources.below),
        windowImage(sources.window),
        depthsImage(sources.depths),
        shadows(sources.shadows),
        waterline(sources.waterline),
        shadowTiles(sources.shadowTiles),
        shadowWidth(static_cast<float>(sources.shadowWidth)) {}

  /// Number of a texel of a local picture; where there is none, of any, and `inside` 0.
  HWY_INLINE VI localTexel(Real column, Real row, glm::vec2 size, Real& inside) const {
    const Mask there = column >= 0.0f && row >= 0.0f && column < size.x && row < size.y;
    inside = choose(there, 1.0f, 0.0f);
    return toInt((row * size.x + column) * inside);
  }
  HWY_INLINE Real localNearness(const LocalImage* image, glm::vec2 least, glm::vec2 size,
                                Real2 pixel) const {
    // Far off pixels are held where their numbers are exact.
    const Real column = clamp(floor(pixel.x + 0.5f) - least.x, -1.0f, size.x);
    const Real row = clamp(floor(pixel.y + 0.5f) - least.y, -1.0f, size.y);
    Real inside;
    const VI at = localTexel(column, row, size, inside);
    if (!anyOf(inside > 0.0f)) return inside;
    return gather(image->nearness.data(), at) * inside;
  }
  HWY_INLINE Real3 localLight(const LocalImage* image, glm::vec2 least, glm::vec2 size, Real2 pixel,
                              Real& part) const {
    const Real x = clamp(pixel.x - least.x, -2.0f, size.x + 1.0f);
    const Real y = clamp(pixel.y - least.y, -2.0f, size.y + 1.0f);
    const Real column = floor(x), row = floor(y);
    SharedExponentSum light;
    part = Real(0.0f);
    for (int i = 0; i < 4; ++i) {
      const float across = static_cast<float>(i & 1), along = static_cast<float>(i >> 1);
      Real inside;
      const VI at = localTexel(column + across, row + along, size, inside);
      const Real weight =
          inside * abs(x - column - (1.0f - across)) * abs(y - row - (1.0f - along));
      const VU word = gather(image->light.data(), at);
      const Mask covered = {hn::RebindMask(Floats(), hn::Ne(word, hn::Zero(Words())))};
      const Real shown = choose(covered, weight, 0.0f);
      light.add(word, shown);
      part = part + shown;
    }
    return light.light();
  }
  HWY_INLINE Real mirrorNearness(Real2 pixel) const {
    return localNearness(mirrorImage, mirrorLeast, mirrorSize, pixel);
  }
  HWY_INLINE Real3 mirrorLight(Real2 pixel, Real& part) const {
    return localLight(mirrorImage, mirrorLeast, mirrorSize, pixel, part);
  }
  HWY_INLINE Real belowNearness(Real2 pixel) const {
    return localNearness(belowImage, belowLeast, belowSize, pixel);
  }
  HWY_INLINE Real3 belowLight(Real2 pixel, Real& part) const {
    return localLight(belowImage, belowLeast, belowSize, pixel, part);
  }
  HWY_INLINE Real3 windowLight(Real2 pixel, Real& part) const {
    return localLight(windowImage, windowLeast, windowSize, pixel, part);
  }
  HWY_INLINE Real depthsNearness(Real2 pixel) const {
    return localNearness(depthsImage, depthsLeast, depthsSize, pixel);
  }
  HWY_INLINE Real3 depthsLight(Real2 pixel, Real& part) const {
    return localLight(depthsImage, depthsLeast, depthsSize, pixel, part);
  }
  /// Whether tiles hold anything within `margin` of the box of two places, for pixels that are
  /// `asked`.
  static HWY_INLINE bool mayHold(const CoverTiles& tiles, Real2 from, Real2 to, Real asked,
                                 float margin) {
    const Floats f;
    const Mask who = asked > 0.0f;
    const auto least = [&](Real a, Real b) HWY_ATTR {
      const Real low = choose(who, min(a, b), 1e6f);
      const float found = hn::GetLane(hn::MinOfLanes(f, low.v));
      return static_cast<int>(std::fmin(std::fmax(found, -1e6f), 1e6f) - margin) - 1;
    };
    const auto most = [&](Real a, Real b) HWY_ATTR {
      const Real high = choose(who, max(a, b), -1e6f);
      const float found = hn::GetLane(hn::MaxOfLanes(f, high.v));
      return static_cast<int>(std::fmin(std::fmax(found, -1e6f), 1e6f) + margin) + 1;
    };
    return tiles.mayHold({least(from.x, to.x), least(from.y, to.y)},
                         {most(from.x, to.x), most(from.y, to.y)});
  }
  HWY_INLINE bool mirrorMayShow(Real2 from, Real2 to, Real asked) const {
    if (!anyOf(asked > 0.0f)) return false;
    const Real2 least(mirrorLeast.x, mirrorLeast.y);
    return mayHold(mirrorImage->tiles, from - least, to - least, asked, 1.0f);
  }
  HWY_INLINE bool shadowMayFall(int i, Real2 at, Real asked) const {
    if (!anyOf(asked > 0.0f)) return false;
    return !shadowTiles || mayHold(shadowTiles[i], at, at, asked, 1.5f);
  }
  // Numbers of texels stay below 2²⁴: exact in float.
  HWY_INLINE Real shadowHeight(Real column, Real row) const {
    return gather(shadows, toInt(row * shadowWidth + column));
  }
  HWY_INLINE Real waterlineHeight(Real column, Real row) const {
    return gather(waterline, toInt(row * (waterlineCells + 1.0f) + column));
  }

  HWY_INLINE void addSky(Real2 coordinate, Real level, Real weight, SharedExponentSum& sum) const {
    const Level l = levelOf(SkyDome::side, level);
    const Real2 place(coordinate.x * l.side - 0.5f, coordinate.y * l.side - 0.5f);
    addBilinear(skyTexels, clampedCorners(place, l.side, l.side, l.start), weight, sum);
  }
  HWY_INLINE Real3 skyTexel(Real2 coordinate, Real level) const {
    if (!skyIsOn) return Real3(skyLight);
    const Real clamped = clamp(level, 0.0f, SkyDome::levels - 1.0f);
    const Real low = floor(clamped), part = clamped - low;
    SharedExponentSum sum;
    addSky(coordinate, low, 1.0f - part, sum);
    if (anyOf(part > 0.0f)) addSky(coordinate, min(low + 1.0f, SkyDome::levels - 1.0f), part, sum);
    return sum.light();
  }

  /// Part of a pattern's variance that is left at a level, and `here` at the whole level before it.
  /// Neighbours mostly share that one.
  HWY_INLINE Real keptBetween(const float (&kept)[8], Real level, Real whole, Real& here) const {
    Real next;
    const float first = hn::GetLane(whole.v);
    if (anyOf(abs(whole - first) > 0.0f)) {
      const VI index = toInt(whole);
      here = gather(kept, index);
      next = gather(kept, hn::Add(index, setInt(1)));
    } else {
      here = Real(kept[static_cast<int>(first)]);
      next = Real(kept[static_cast<int>(first) + 1]);
    }
    return mix(here, next, level - whole);
  }

  HWY_INLINE Real3 rippleMoments(Real2 coordinate, Real level) const {
    const Real clamped = clamp(level, 0.0f, rippleLastLevel), whole = floor(clamped);
    Real here;
    const Real kept = keptBetween(rippleKept, clamped, whole, here);
    const Level l = levelOf(ShadingTables::rippleSide, whole);
    const Real2 place(coordinate.x * l.side - 0.5f, coordinate.y * l.side - 0.5f);
    const Corners c = wrappedCorners(place, l.side, l.start);
    const CornerTexels texels = gatherCorners(tables.ripples.data(), c);
    const Real2 a = rippleTexel(texels.low.first), b = rippleTexel(texels.high.first);
    const Real2 low = a + (rippleTexel(texels.low.second) - a) * c.part.x;
    const Real2 high = b + (rippleTexel(texels.high.second) - b) * c.part.x;
    const Real scale = sqrt(kept / max(here, 1e-6f)) * (ShadingTables::rippleSpan / 32767.0f);
    const Real2 slope = (low + (high - low) * c.part.y) * scale;
    return {slope.x, slope.y, kept};
  }

  /// The foam's pattern and the part of its variance that is left at a level.
  HWY_INLINE Real2 foamTexel(Real2 coordinate, Real level) const {
    const Real clamped = clamp(level, 0.0f, foamLastLevel), whole = floor(clamped);
    Real here;
    const Real kept = keptBetween(foamKept, clamped, whole, here);
    const Level l = levelOf(FoamTable::side, whole);
    const Real2 place(coordinate.x * l.side - 0.5f, coordinate.y * l.side - 0.5f);
    return {bilinear(foam, wrappedCorners(place, l.side, l.start)), kept};
  }

  HWY_INLINE Corners fresnelCorners(Real rootCosine, Real deviation) const {
    constexpr int columns = ShadingTables::fresnelColumns, rows = ShadingTables::fresnelRows;
    const float rowsPerSlope = (rows - 1) / static_cast<float>(fresnelTableRoughest);
    return clampedCorners({rootCosine * Real(columns - 1.0f), deviation * Real(rowsPerSlope)},
                          static_cast<float>(columns), static_cast<float>(rows), setInt(0));
  }
  HWY_INLINE Real2 roughMirror(Real rootCosine, Real deviation) const {
    const Corners c = fresnelCorners(rootCosine, deviation);
    const CornerTexels texels = gatherCorners(tables.mirror.data(), c);
    const auto decode = [](VU word) HWY_ATTR {
      return Real2(bitField<0, 16>(word), bitField<16, 16>(word));
    };
    const Real2 a = decode(texels.low.first), d = decode(texels.high.first);
    const Real2 low = a + (decode(texels.low.second) - a) * c.part.x;
    const Real2 high = d + (decode(texels.high.second) - d) * c.part.x;
    return (low + (high - low) * c.part.y) * Real(1.0f / 65535.0f);
  }
  HWY_INLINE Real roughArea(Real rootCosine, Real deviation) const {
    return bilinear(tables.area.data(), fresnelCorners(rootCosine, deviation));
  }

#define SHADER HWY_INLINE
#define INOUT(type) type&
#include "render/shading/night_lights.glsl.h"
#include "render/shading/optics.glsl.h"
#include "render/shading/rain_rings.glsl.h"
#include "render/shading/sea_shading.glsl.h"
#include "render/shading/shadows.glsl.h"
#include "render/shading/under_water.glsl.h"
#include "render/shading/waterline.glsl.h"
#undef SHADER
#undef INOUT
};

HWY_INLINE Mask isKind(VU kinds, ShadedAs kind) {
  const Words w;
  return {hn::RebindMask(Floats(), hn::Eq(kinds, hn::Set(w, static_cast<std::uint32_t>(kind))))};
}

/// What is added to ToneTable's numbers before they are cut to bytes: a half, or what dithers.
HWY_INLINE VI roundings(PixelShader& shader, Real column, Real row) {
  if (!shader.dithers) return setInt(128);
  return toInt(floor(min(shader.ditherAt(column, row) * 256.0f, 255.0f)));
}

HWY_INLINE VI toneByte(const ToneTable& tones, Real exposed, VI rounding) {
  const Real root = sqrt(max(exposed, 0.0f)) * ToneTable::perRoot;
  const VI at = toInt(min(root + 0.5f, ToneTable::steps - 1.0f));
  const auto* from = reinterpret_cast<const std::int32_t*>(tones.fine.data());
  const VI word = hn::GatherOffset(Ints(), from, hn::ShiftLeft<1>(at));
  return hn::ShiftRight<8>(hn::Add(hn::And(word, setInt(0xFFFF)), rounding));
}

HWY_INLINE Real3 radianceAt(PixelShader& shader, const PixelSpan& span, int i) {
  const Floats f;
  const Real index = hn::Iota(f, static_cast<float>(i));
  const Real3 ray = Real3(span.firstRay) + Real3(span.rayStep) * index;
  const Real rayLength = sqrt(dot(ray, ray));
  const VU kinds = hn::Load(Words(), reinterpret_cast<const std::uint32_t*>(span.kind + i));
  const Mask sky = isKind(kinds, ShadedAs::sky), water = isKind(kinds, ShadedAs::water);
  const Mask underside = isKind(kinds, ShadedAs::underside);
  const Mask object = isKind(kinds, ShadedAs::object) || isKind(kinds, ShadedAs::ground);

  Real3 radiance(0.0f, 0.0f, 0.0f);
  if (anyOf(sky)) radiance = shader.skyPixel(ray / rayLength);
  const Real axial = hn::Load(f, span.axial + i);
  const Real3 relative = ray * axial;
  const Real distance = rayLength * axial;
  const Real2 slope(hn::Load(f, span.slopeX + i), hn::Load(f, span.slopeY + i));
  Real3 cover(0.0f, 0.0f, 0.0f);
  if (span.hasCover) {
    cover = Real3(hn::Load(f, span.cover[0] + i), hn::Load(f, span.cover[1] + i),
                  hn::Load(f, span.cover[2] + i));
  }
  if (anyOf(water)) {
    radiance =
        choose(water,
               shader.waterRadiance(relative, distance, slope, hn::Load(f, span.missingSlope + i),
                                    hn::Load(f, span.height + i), cover),
               radiance);
  }
  if (anyOf(underside)) {
    radiance = choose(
        underside,
        shader.undersideRadiance(relative, distance, slope, hn::Load(f, span.missingSlope + i)),
        radiance);
  }
  if (anyOf(object)) {
    const auto load = [&](const float(&from)[3][pixelsPerSpan]) HWY_ATTR {
      return Real3(hn::Load(f, from[0] + i), hn::Load(f, from[1] + i), hn::Load(f, from[2] + i));
    };
    Real3 place = relative;
    if (span.hasPlaces) {
      const Real level = hn::Load(f, span.placeLevel + i);
      place.z = level + Real(hn::Load(f, span.placeScale + i)) * (place.z - level);
    }
    radiance = choose(
        object,
        shader.objectRadiance(relative, distance, load(span.normal), load(span.reflectance), place),
        radiance);
  }
  return radiance;
}

void ShadeRadiance(const ShadingSources& sources, const PixelSpan& span, glm::vec4* to) {
  PixelShader shader(sources);
  for (int i = 0; i < span.count; i += static_cast<int>(laneCount())) {
    const Real3 radiance = radianceAt(shader, span, i);
    hn::StoreInterleaved4(radiance.x.v, radiance.y.v, radiance.z.v, hn::Zero(Floats()), Floats(),
                          &to[i].x);
  }
}

void ShadeWords(const ShadingSources& sources, const PixelSpan& span, std::uint32_t* to) {
  PixelShader shader(sources);
  for (int i = 0; i < span.count; i += static_cast<int>(laneCount())) {
    hn::StoreU(sharedExponentWord(radianceAt(shader, span, i)), Words(), to + i);
  }
}

void FoamParts(const ShadingSources& sources, const PixelSpan& span, float* parts) {
  PixelShader shader(sources);
  const Floats f;
  for (int i = 0; i < span.count; i += static_cast<int>(laneCount())) {
    const Real index = hn::Iota(f, static_cast<float>(i));
    const Real3 ray = Real3(span.firstRay) + Real3(span.rayStep) * index;
    const Real axial = hn::Load(f, span.axial + i);
    const Real lying = span.hasCover ? Real(hn::Load(f, span.cover[0] + i)) : Real(0.0f);
    const Real2 slope(hn::Load(f, span.slopeX + i), hn::Load(f, span.slopeY + i));
    const Real part =
        shader.foamPart(ray * axial, sqrt(dot(ray, ray)) * axial, slope,
                        hn::Load(f, span.missingSlope + i), hn::Load(f, span.height + i), lying);
    const VU kinds = hn::Load(Words(), reinterpret_cast<const std::uint32_t*>(span.kind + i));
    hn::Store(choose(isKind(kinds, ShadedAs::water), part, Real(0.0f)).v, f, parts + i);
  }
}

void SlopesSeen(const ShadingSources& sources, const PixelSpan& span, glm::vec4* to) {
  const Floats f;
  PixelShader shader(sources);
  for (int i = 0; i < span.count; i += static_cast<int>(laneCount())) {
    const Real3 ray =
        Real3(span.firstRay) + Real3(span.rayStep) * Real(hn::Iota(f, static_cast<float>(i)));
    const Real3 relative = ray * Real(hn::Load(f, span.axial + i));
    const Real distance = sqrt(dot(relative, relative));
    Real2 slope(hn::Load(f, span.slopeX + i), hn::Load(f, span.slopeY + i));
    const Real footprint = shader.footprintOn(-relative / distance, distance, slope);
    Real waves = hn::Load(f, span.missingSlope + i), rippled;
    const Real finer =
        shader.seenSlope(relative, footprint, Real3(0.0f, 0.0f, 0.0f), slope, waves, rippled);
    const Real rough = waves + finer;
    hn::StoreInterleaved4(slope.x.v, slope.y.v, rough.v, hn::Zero(f), f, &to[i].x);
  }
}

void ShadeSpan(const ShadingSources& sources, const ToneTable& tones, const PixelSpan& span,
               std::uint8_t* rgb) {
  const hn::Rebind<std::uint8_t, Floats> bytes;
  const int lanes = static_cast<int>(laneCount());
  PixelShader shader(sources);
  alignas(64) std::uint8_t colours[3 * pixelsPerSpan + 3 * 64];
  for (int i = 0; i < span.count; i += lanes) {
    const Real3 radiance = radianceAt(shader, span, i);
    const VI rounding = roundings(shader, hn::Iota(Floats(), static_cast<float>(span.first.x + i)),
                                  Real(span.first.y));
    const auto encode = [&](Real linear) HWY_ATTR {
      return hn::DemoteTo(bytes, toneByte(tones, linear * shader.exposure, rounding));
    };
    hn::StoreInterleaved3(encode(radiance.x), encode(radiance.y), encode(radiance.z), bytes,
                          colours + 3 * i);
  }
  std::memcpy(rgb, colours, 3 * static_cast<std::size_t>(span.count));
}

void MapTones(std::span<const glm::vec3> radiance, const ToneTable& tones,
              const ToneMapping& mapping, glm::ivec2 first, std::uint8_t* rgb) {
  ShadingConstants constants;
  constants.dithers = mapping.dithers;
  PixelShader shader(ShadingSources{constants});
  const Floats f;
  const std::size_t lanes = laneCount();
  alignas(64) float column[16], exposed[3][16];
  alignas(64) std::int32_t bytes[16];
  for (std::size_t i = 0; i < radiance.size(); i += lanes) {
    const std::size_t some = std::min(lanes, radiance.size() - i);
    for (std::size_t k = 0; k < some; ++k) {
      column[k] = static_cast<float>(first.x) + static_cast<float>(i + k);
      for (int c = 0; c < 3; ++c) exposed[c][k] = radiance[i + k][c] * mapping.exposure;
    }
    const VI rounding = roundings(shader, hn::Load(f, column), Real(static_cast<float>(first.y)));
    for (int c = 0; c < 3; ++c) {
      hn::Store(toneByte(tones, hn::Load(f, exposed[c]), rounding), Ints(), bytes);
      for (std::size_t k = 0; k < some; ++k) {
        rgb[3 * (i + k) + c] = static_cast<std::uint8_t>(bytes[k]);
      }
    }
  }
}

void FillTones(ToneCurve curve, ToneTable& tones) {
  ShadingConstants constants;
  constants.toneCurve = static_cast<int>(curve);
  PixelShader shader(ShadingSources{constants});
  for (int i = 0; i < ToneTable::steps; ++i) {
    const float root = static_cast<float>(i) / ToneTable::perRoot;
    const Real3 shown = shader.toneMapped(Real3(glm::vec3(root * root)));
    const double linear = hn::GetLane(shown.x.v);
    const double encoded =
        linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055;
    tones.fine[i] = static_cast<std::uint16_t>(256.0 * 255.0 * std::min(encoded, 1.0) + 0.5);
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace seaway::render
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace seaway::render {

HWY_EXPORT(ShadeSpan);
HWY_EXPORT(ShadeRadiance);
HWY_EXPORT(ShadeWords);
HWY_EXPORT(FoamParts);
HWY_EXPORT(SlopesSeen);
HWY_EXPORT(FillTones);
HWY_EXPORT(MapTones);

void slopesSeen(const ShadingSources& sources, const PixelSpan& span, glm::vec4* seen) {
  HWY_DYNAMIC_DISPATCH(SlopesSeen)(sources, span, seen);
}

void shadeSpan(const ShadingSources& sources, const PixelSpan& span, glm::vec4* radiance) {
  HWY_DYNAMIC_DISPATCH(ShadeRadiance)(sources, span, radiance);
}

void shadeSpan(const ShadingSources& sources, const PixelSpan& span, std::uint32_t* words) {
  HWY_DYNAMIC_DISPATCH(ShadeWords)(sources, span, words);
}

namespace {

const ToneTable& toneTable(ToneCurve curve) {
  static const auto tones = [] {
    std::array<ToneTable, 3> made;
    for (int i = 0; i < 3; ++i) HWY_DYNAMIC_DISPATCH(FillTones)(static_cast<ToneCurve>(i), made[i]);
    return made;
  }();
  return tones[static_cast<std::size_t>(curve)];
}

}  // namespace

void shadeSpan(const ShadingSources& sources, const PixelSpan& span, std::uint8_t* rgb) {
  const auto curve = static_cast<ToneCurve>(sources.constants.toneCurve);
  HWY_DYNAMIC_DISPATCH(ShadeSpan)(sources, toneTable(curve), span, rgb);
}

void mapTones(std::span<const glm::vec3> radiance, const ToneMapping& tones, glm::ivec2 first,
              std::uint8_t* rgb) {
  HWY_DYNAMIC_DISPATCH(MapTones)(radiance, toneTable(tones.curve), tones, first, rgb);
}

void foamParts(const ShadingSources& sources, const PixelSpan& span, float* parts) {
  if (!sources.constants.foamIsOn) {
    std::fill_n(parts, span.count, 0.0f);
    return;
  }
  HWY_DYNAMIC_DISPATCH(FoamParts)(sources, span, parts);
}

}  // namespace seaway::render
#endif
