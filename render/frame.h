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
  /// Linear radiance of the pixels that `colour` shows, before exposure and tone mapping, in the units
  /// of ShadingConstants; empty unless asked for. Without the smoothing of edges that `colour` has.
  std::vector<glm::vec3> radiance;
  float exposure = 1.0f;  ///< what radiance is multiplied by before tone mapping
  /// SceneObject::instance of what a pixel's centre shows, 0 for all else; empty unless asked for.
  std::vector<std::uint16_t> instances;
  /// Part of a water pixel that is white with foam, 0 to 255, 0 for all else; empty unless asked for.
  std::vector<std::uint8_t> foam;
  /// Unit normals in the sea plane's axes, of water upwards, of sky 0; empty unless asked for.
  std::vector<glm::vec3> normals;
  FrameStats stats;
};

/// What a frame holds beside colour, depth and classes.
struct FrameContents {
  bool normals = false;   ///< Frame::normals
  bool radiance = false;  ///< Frame::radiance
  bool labels = false;    ///< Frame::instances and Frame::foam
};

/// Makes room for a picture of `size` pixels and forgets the last frame's statistics; memory is kept.
void prepare(Frame& frame, glm::ivec2 size, const FrameContents& contents);

}  // namespace seaway::render
