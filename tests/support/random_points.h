#pragma once

#include <cstddef>
#include <glm/vec2.hpp>
#include <random>
#include <vector>

namespace seaway::test_support {

/// `count` points of the square of half-width `reach` m about the anchor, always the same.
inline std::vector<glm::dvec2> randomPoints(std::size_t count, double reach) {
  std::mt19937_64 random(5);
  std::uniform_real_distribution<double> uniform(-reach, reach);
  std::vector<glm::dvec2> points(count);
  for (glm::dvec2& point : points) point = {uniform(random), uniform(random)};
  return points;
}

}  // namespace seaway::test_support
