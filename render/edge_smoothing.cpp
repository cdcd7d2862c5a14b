#include "render/edge_smoothing.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace seaway::render {
namespace {

constexpr float leastContrast = 12.0f;  // of 255: below this no edge is seen
constexpr float longestReach = 6.0f;    // pixels along the edge
constexpr float depthStep = 1.15f;      // ratio of distances that makes an outline

float lumaOf(glm::vec3 c) { return 0.299f * c.x + 0.587f * c.y + 0.114f * c.z; }

/// The picture before smoothing.
class Source {
 public:
  explicit Source(const ColourImage& image) : size_(image.size), rgb_(image.rgb) {}

  glm::vec3 texel(int x, int y) const {
    const std::uint8_t* c = &rgb_[3 * (static_cast<std::size_t>(y) * size_.x + x)];
    return {c[0], c[1], c[2]};
  }
  float luma(int x, int y) const { return lumaOf(texel(x, y)); }

  /// Bilinear colour at a pixel position; beyond the picture its edge goes on.
  glm::vec3 at(glm::vec2 p) const {
    p = glm::clamp(p, glm::vec2(0.0f), glm::vec2(size_ - 1));
    const glm::ivec2 low(p), high = glm::min(low + 1, size_ - 1);
    const glm::vec2 f = p - glm::vec2(low);
    return glm::mix(glm::mix(texel(low.x, low.y), texel(high.x, low.y), f.x),
                    glm::mix(texel(low.x, high.y), texel(high.x, high.y), f.x), f.y);
  }

 private:
  glm::ivec2 size_;
  std::vector<std::uint8_t> rgb_;
};

glm::vec3 smoothed(const Source& source, int x, int y) {
  const glm::vec3 here = source.texel(x, y);
  const float a = source.luma(x - 1, y - 1), b = source.luma(x + 1, y - 1),
              c = source.luma(x - 1, y + 1), d = source.luma(x + 1, y + 1), e = lumaOf(here);
  const float least = std::min({a, b, c, d, e}), most = std::max({a, b, c, d, e});
  if (most - least < leastContrast) return here;

  glm::vec2 along((c + d) - (a + b), (a + c) - (b + d));
  const float shortest = std::min(std::abs(along.x), std::abs(along.y)) + 2.0f;
  along = glm::clamp(along / shortest, -longestReach, longestReach);
  const glm::vec2 p(x, y);
  const glm::vec3 narrow = 0.5f * (source.at(p - along / 6.0f) + source.at(p + along / 6.0f));
  const glm::vec3 wide =
      0.5f * narrow + 0.25f * (source.at(p - 0.5f * along) + source.at(p + 0.5f * along));
  const float luma = lumaOf(wide);
  return luma < least || luma > most ? narrow : wide;
}

}  // namespace

void smoothEdges(ColourImage& colour, const DepthImage& depth,
                 std::span<const PixelClass> classes) {
  const glm::ivec2 size = colour.size;
  const Source source(colour);
  for (int y = 1; y + 1 < size.y; ++y) {
    for (int x = 1; x + 1 < size.x; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * size.x + x;
      const std::size_t neighbours[] = {i - 1, i + 1, i - size.x, i + size.x};
      bool outline = classes[i] == PixelClass::object;
      for (const std::size_t n : neighbours) {
        const float nearer = std::min(depth.metres[i], depth.metres[n]);
        const float farther = std::max(depth.metres[i], depth.metres[n]);
        outline |= classes[n] != classes[i] || farther > depthStep * nearer;
      }
      if (!outline) continue;
      const glm::vec3 result = smoothed(source, x, y);
      for (int k = 0; k < 3; ++k) {
        colour.rgb[3 * i + k] = static_cast<std::uint8_t>(result[k] + 0.5f);
      }
    }
  }
}

}  // namespace seaway::render
