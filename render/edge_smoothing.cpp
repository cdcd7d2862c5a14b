#include "render/edge_smoothing.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <cstring>
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
  const std::vector<std::uint8_t>& rgb_;
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

/// A smoothed pixel, before it is put into the picture.
struct Change {
  std::size_t at;
  std::uint8_t rgb[3];
};

/// Marks the inner pixels of row y that lie on an outline: 1.
void markOutlines(const DepthImage& depth, std::span<const PixelClass> classes, int y,
                  std::vector<std::uint8_t>& outline) {
  const int across = depth.size.x;
  const float* d = depth.metres.data() + static_cast<std::size_t>(y) * across;
  const auto* c =
      reinterpret_cast<const std::uint8_t*>(classes.data()) + static_cast<std::size_t>(y) * across;
  constexpr auto object = static_cast<std::uint8_t>(PixelClass::object);
  for (int x = 1; x + 1 < across; ++x) {
    const std::uint8_t here = c[x];
    outline[x] = (here == object) | (c[x - 1] != here) | (c[x + 1] != here) |
                 (c[x - across] != here) | (c[x + across] != here);
  }
  for (int x = 1; x + 1 < across; ++x) {
    const float here = d[x];
    const float farthest =
        std::max(std::max(d[x - 1], d[x + 1]), std::max(d[x - across], d[x + across]));
    const float nearest =
        std::min(std::min(d[x - 1], d[x + 1]), std::min(d[x - across], d[x + across]));
    outline[x] |= (farthest > depthStep * here) | (here > depthStep * nearest);
  }
}

}  // namespace

void smoothEdges(ColourImage& colour, const DepthImage& depth, std::span<const PixelClass> classes,
                 std::span<const std::uint8_t> isSmooth) {
  const glm::ivec2 size = colour.size;
  if (size.x < 3 || size.y < 3) return;
  const Source source(colour);
  std::vector<std::vector<Change>> changes(size.y);
  tbb::parallel_for(1, size.y - 1, [&](int y) {
    std::vector<std::uint8_t> outline(size.x);
    markOutlines(depth, classes, y, outline);
    const auto next = [&](int x) {  // on an outline, from x on
      const void* found = std::memchr(&outline[x], 1, outline.size() - x);
      return found ? static_cast<int>(static_cast<const std::uint8_t*>(found) - outline.data())
                   : size.x;
    };
    for (int x = next(1); x < size.x; x = next(x + 1)) {
      if (!isSmooth.empty() && isSmooth[static_cast<std::size_t>(y) * size.x + x] != 0) continue;
      const glm::vec3 made = smoothed(source, x, y);
      if (made == source.texel(x, y)) continue;
      const glm::vec3 result = made + 0.5f;
      changes[y].push_back(
          {3 * (static_cast<std::size_t>(y) * size.x + x),
           {static_cast<std::uint8_t>(result.x), static_cast<std::uint8_t>(result.y),
            static_cast<std::uint8_t>(result.z)}});
    }
  });
  for (const auto& row : changes) {
    for (const Change& change : row) std::copy_n(change.rgb, 3, &colour.rgb[change.at]);
  }
}

}  // namespace seaway::render
