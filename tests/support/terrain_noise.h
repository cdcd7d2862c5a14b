#pragma once

#include <png.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <vector>

/// What the makers of maps of heights share.

inline double knot(int x, int y) {
  std::uint32_t h =
      static_cast<std::uint32_t>(x) * 0x9E3779B1u ^ static_cast<std::uint32_t>(y) * 0x85EBCA77u;
  h = (h ^ h >> 15) * 0x2C1B3C6Du;
  h = (h ^ h >> 12) * 0x297A2D39u;
  return (h ^ h >> 15) / 2147483648.0 - 1.0;
}

/// Noise of a size in m, about [−1, 1]: two turned lattices, so that neither is seen.
inline double noise(glm::dvec2 place, double size) {
  double sum = 0.0;
  for (const glm::dvec2 turn : {glm::dvec2(0.8, 0.6), glm::dvec2(-0.28, 0.96)}) {
    const glm::dvec2 turned(turn.x * place.x - turn.y * place.y,
                            turn.y * place.x + turn.x * place.y);
    const glm::dvec2 at = turned / size + 37.0 * turn, corner = glm::floor(at), part = at - corner;
    const glm::dvec2 w = part * part * part * (part * (part * 6.0 - 15.0) + 10.0);
    const int x = static_cast<int>(corner.x), y = static_cast<int>(corner.y);
    sum += glm::mix(glm::mix(knot(x, y), knot(x + 1, y), w.x),
                    glm::mix(knot(x, y + 1), knot(x + 1, y + 1), w.x), w.y);
  }
  return 0.75 * sum;
}

/// Ridges up to `largest` m apart: sums of folded noise, about [0, 1].
inline double ridges(glm::dvec2 place, double largest) {
  double sum = 0.0, weight = 0.5;
  for (double size = largest; size > largest / 18.0; size *= 0.46) {
    sum += weight * (1.0 - std::abs(noise(place + size * 7.0, size)));
    weight *= 0.5;
  }
  return sum;
}

/// Writes square rows of grey from the north; returns an exit status.
inline int writeGrey(const char* file, int side, const std::vector<std::uint16_t>& grey) {
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  image.width = image.height = static_cast<png_uint_32>(side);
  image.format = PNG_FORMAT_LINEAR_Y;
  if (png_image_write_to_file(&image, file, 0, grey.data(), 0, nullptr)) return 0;
  return std::fprintf(stderr, "%s: %s\n", file, image.message), 1;
}
