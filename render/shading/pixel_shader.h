#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec4.hpp>
#include <span>

#include "render/cover_tiles.h"
#include "render/local_image.h"
#include "render/render_technique.h"
#include "render/shading/shading_constants.h"

/// Shading on the processor, a vector of pixels at a time: sea_shading.glsl.h in C++.
namespace seaway::render {

/// How a pixel is shaded.
enum class ShadedAs : std::uint32_t {
  sky = 0,
  water = 1,
  underside = 2,
  object = 3,
  ground = 4,  ///< lit as an object
};

inline constexpr int pixelsPerSpan = 128;

/// A piece of a picture's row, ready to be shaded: at most `pixelsPerSpan` pixels, arrays readable
/// up to the next multiple of 16.
struct PixelSpan {
  int count = 0;
  glm::ivec2 first{0};       ///< the first pixel's column and row: where its dither is taken from
  glm::vec3 firstRay{0.0f};  ///< from the camera through the first pixel's centre, as long as
                             ///< 1 / the cosine to the view axis
  glm::vec3 rayStep{0.0f};   ///< from one pixel to the next
  alignas(64) ShadedAs kind[pixelsPerSpan];
  alignas(64) float axial[pixelsPerSpan];  ///< axial distance, m; any finite value for sky
  alignas(64) float slopeX[pixelsPerSpan], slopeY[pixelsPerSpan];
  alignas(64) float missingSlope[pixelsPerSpan], height[pixelsPerSpan];
  /// Read only where `hasCover`: foam on the water, smoothed water, oil.
  bool hasCover = false;
  alignas(64) float cover[3][pixelsPerSpan];
  /// Read only where `hasObjects`: normal and reflectance.
  bool hasObjects = false;
  alignas(64) float normal[3][pixelsPerSpan], reflectance[3][pixelsPerSpan];
  /// Read only where `hasPlaces`: an object at height z is really at level + scale (z − level), m
  /// from the eye.
  bool hasPlaces = false;
  alignas(64) float placeLevel[pixelsPerSpan], placeScale[pixelsPerSpan];
};

/// What a frame is shaded with.
struct ShadingSources {
  const ShadingConstants& constants;
  const std::uint32_t* sky = nullptr;       ///< SkyDome::texels; null: the sky is switched off
  const LocalImage* mirrored = nullptr;     ///< read where constants.mirrorIsOn
  const LocalImage* below = nullptr;        ///< read where constants.belowIsOn
  const LocalImage* window = nullptr;       ///< read where constants.windowIsOn
  const LocalImage* depths = nullptr;       ///< read where constants.depthsAreOn
  const float* shadows = nullptr;           ///< ShadowMaps::texels, where constants.shadowCount > 0
  int shadowWidth = 0;                      ///< texels from row to row
  const CoverTiles* shadowTiles = nullptr;  ///< ShadowMaps::tiles; null: shadows may fall anywhere
  const float* waterline = nullptr;         ///< Waterline::heights, where constants.waterlineIsOn
};

/// sRGB colours of a span's pixels, 3 bytes each. Pixels do not depend on their place in the span.
void shadeSpan(const ShadingSources& sources, const PixelSpan& span, std::uint8_t* rgb);

/// How radiance becomes colours.
struct ToneMapping {
  float exposure = 1.0f;
  ToneCurve curve = ToneCurve::filmic;
  bool dithers = false;
};

/// sRGB colours, 3 bytes each, of the linear radiance of a row's pixels from column and row `first`
/// on: what shadeSpan makes of it, to the bit.
void mapTones(std::span<const glm::vec3> radiance, const ToneMapping& tones, glm::ivec2 first,
              std::uint8_t* rgb);

/// Part of each of a span's pixels that is white with foam, [0, 1], where constants.foamIsOn; 0 but
/// for water. `parts` is aligned to 64 bytes and writable up to the next multiple of 16.
void foamParts(const ShadingSources& sources, const PixelSpan& span, float* parts);

/// Slopes that shading sees at pixels of water: those of waves and ripples in xy, and in z the
/// mean-square slope of all that a pixel cannot show, its roughness. For tests of the statistics;
/// `seen` as `radiance` below.
void slopesSeen(const ShadingSources& sources, const PixelSpan& span, glm::vec4* seen);

/// The same as RGB9E5 words, of which none is 0. `words` is writable up to the next multiple of 16.
void shadeSpan(const ShadingSources& sources, const PixelSpan& span, std::uint32_t* words);

/// Linear radiance of a span's pixels; `radiance` is writable up to the next multiple of 16.
void shadeSpan(const ShadingSources& sources, const PixelSpan& span, glm::vec4* radiance);

}  // namespace seaway::render
