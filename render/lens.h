#pragma once

#include <memory>
#include <optional>

#include "render/render_technique.h"

namespace seaway::render {

/// Where the lens shows what a pinhole would show at `place`, m at 1 m along the view axis, to the
/// right and downwards.
glm::dvec2 distorted(const Distortion& distortion, glm::dvec2 place);

/// The inverse: Newton's method along the way out from the view axis, on the sheet around it, where
/// neither side is turned over. `distorted` of what it finds is within 1e-12 · (1 + |seen|) of
/// `seen`; nothing where it comes to a fold, or to 89.9° from the view axis.
std::optional<glm::dvec2> undistorted(const Distortion& distortion, glm::dvec2 seen);

/// The picture that a lens needs, and where each of its own pixels lies in it.
struct LensMap {
  Camera wide;        ///< a pinhole that sees all that the lens does, without distortion
  glm::ivec2 size{};  ///< of the places: that of the lens' picture times its samples a side
  /// In pixels of `wide`, (0, 0) the centre of the top left one; row by row from the top left.
  std::vector<glm::vec2> places;
};

/// Each of `camera`'s pixels is seen by `samplesPerSide` ² places. `wide` has pixels as fine as the
/// finest of those. Throws InputError, with the coefficients, where the lens folds within the
/// picture or `wide` is larger than mostLensPixels.
LensMap lensMap(const Camera& camera, int samplesPerSide);

/// A picture that a lens' is made from has no more pixels: it, what draws it and the places read in
/// it take at most so many bytes each, 1.8 GB (`./test -R LensMemory`).
inline constexpr double lensBytesPerPixel = 54.0;
inline constexpr long long mostLensPixels = 1LL << 25;
inline constexpr int mostSamplesPerSide = 16;

/// Throws InputError unless pictures of `size` pixels can be drawn with as many samples a side.
void validateSamples(glm::ivec2 size, int samplesPerSide);

/// Draws pictures with distortion and with several samples a pixel by way of larger ones of
/// `technique`, which draws all others itself. Colour is the mean of linear radiance, read
/// bilinearly where the lens bends, before tone mapping; depth, normals, classes, instances and
/// foam are those of the pixel's centre: exactly so without distortion, else of the nearest pixel
/// of the larger picture. `Frame::stats` are the larger picture's with the pass "lens".
std::unique_ptr<RenderTechnique> makeLens(std::unique_ptr<RenderTechnique> technique);

}  // namespace seaway::render
