#include "render/shading/sky_dome.h"

#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/packing.hpp>

#include "render/shading/sky_kernels.h"

namespace seaway::render {
namespace {

using Image = std::vector<glm::vec3>;

Image halved(const Image& image, int side) {
  Image result(static_cast<std::size_t>(side / 2) * (side / 2));
  for (int y = 0; y < side / 2; ++y) {
    const glm::vec3* above = &image[static_cast<std::size_t>(2 * y) * side];
    const glm::vec3* below = above + side;
    for (int x = 0; x < side / 2; ++x) {
      result[static_cast<std::size_t>(y) * (side / 2) + x] =
          0.25f * (above[2 * x] + above[2 * x + 1] + below[2 * x] + below[2 * x + 1]);
    }
  }
  return result;
}

glm::vec3 rounded(glm::vec3 direction) {
  return glm::normalize(glm::round(direction * 1000.0f) + glm::vec3(0.0f, 0.0f, 1e-3f));
}

}  // namespace

void SkyDome::drawFor(const SkyLights& wanted) {
  const SkyLights lights{rounded(wanted.sun), rounded(wanted.moon), wanted.moonPart};
  if (version_ > 0 && lights == drawnFor_) return;
  Image image(static_cast<std::size_t>(side) * side);
  tbb::parallel_for(0, side, [&](int row) {
    drawSkyRow(lights, row, side, &image[static_cast<std::size_t>(row) * side].x);
  });
  texels_.clear();
  for (int size = side; size >= 1; size /= 2) {
    const std::size_t start = texels_.size();
    texels_.resize(start + image.size());
    tbb::parallel_for(0, size, [&](int row) {
      const std::size_t first = static_cast<std::size_t>(row) * size;
      for (std::size_t i = first; i < first + size; ++i) {
        texels_[start + i] = glm::packF3x9_E1x5(image[i]);
      }
    });
    if (size == 1) mean_ = image.front();
    if (size > 1) image = halved(image, size);
  }
  drawnFor_ = lights;
  ++version_;
}

}  // namespace seaway::render
