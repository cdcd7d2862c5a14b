#pragma once

#include <cstddef>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

namespace seaway::render {

/// sRGB colour, 8 bits a channel, row by row from the top left.
struct ColourImage {
  glm::ivec2 size{0};
  std::vector<std::uint8_t> rgb;  ///< 3 · size.x · size.y
};

/// Axial distance along the camera's view axis in metres, row by row from the top left; +inf where
/// nothing but sky is seen.
struct DepthImage {
  glm::ivec2 size{0};
  std::vector<float> metres;  ///< size.x · size.y
};

/// What a pixel shows; `ground` is what lies outside the water's outline.
enum class PixelClass : std::uint8_t { sky = 0, water = 1, object = 2, ground = 3 };

/// What a frame cost and how it was made.
struct FrameStats {
  std::string technique;
  std::string variant;                                   ///< of the projected grid
  std::string backend;                                   ///< such as "osmesa"
  std::string renderer;                                  ///< GL_RENDERER of the context
  std::vector<std::pair<std::string, double>> passesMs;  ///< wall ms, in order, GL finished
  std::vector<std::pair<std::string, double>> gpuMs;     ///< by timer queries, on hardware alone
  std::size_t vertices = 0;                              ///< water vertices processed
  double vertexEfficiency = 0.0;  ///< of those, the part inside the camera's frustum
  std::size_t boundRedraws = 0;   ///< frames drawn again because a height passed the bounds
};

/// A rendered view.
struct Frame {
  ColourImage colour;
  DepthImage depth;
  std::vector<PixelClass> classes;  ///< one a pixel
  /// Unit normals in the sea plane's axes, of water upwards, of sky 0; empty unless asked for.
  std::vector<glm::vec3> normals;
  FrameStats stats;
};

/// Makes room for a picture of `size` pixels and forgets the last frame's statistics; memory is kept.
void prepare(Frame& frame, glm::ivec2 size, bool withNormals);

}  // namespace seaway::render
