#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <string>
#include <vector>

#include "tests/render/seas.h"

/// Cameras and seas that break simpler renderers.
namespace seaway::render::test {

/// Classes, depths and normals that fit together, all of them numbers.
inline void expectSane(const Frame& frame, glm::ivec2 size) {
  ASSERT_EQ(frame.classes.size(), static_cast<std::size_t>(size.x) * size.y);
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < frame.classes.size(); ++i) {
    const float depth = frame.depth.metres[i];
    const bool isSky = frame.classes[i] == PixelClass::sky;
    wrong += !(depth > 0.0f) || std::isinf(depth) != isSky;
  }
  EXPECT_EQ(wrong, 0u) << "depths that are no distances";
  wrong = 0;
  for (std::size_t i = 0; i < frame.normals.size(); ++i) {
    const float wanted = frame.classes[i] == PixelClass::sky ? 0.0f : 1.0f;
    // Those from OpenGL are half floats: 2⁻¹¹ of each part.
    wrong += !(std::abs(glm::length(frame.normals[i]) - wanted) < 2e-3f);
  }
  EXPECT_EQ(wrong, 0u) << "normals that have no unit length";
}

struct HardView {
  std::string name;
  WaterSurface water;
  Camera camera;
  double time = 3.0;
  bool showsWater = true;
};

inline constexpr glm::ivec2 hardPicture(48, 30);

inline std::vector<HardView> hardViews() {
  const WaterSurface still = stillSea(), moderate = groupSea(1.2, 6.0), storm = groupSea(9.0, 12.0),
                     huge = groupSea(30.0, 18.0);
  const auto at = [](glm::dvec3 place, double pitch, double roll = 0.0, double fov = 60.0,
                     glm::ivec2 size = hardPicture) {
    return cameraAt(place, pitch, roll, fov, size);
  };
  const double here = moderate.sample({3.0, 4.0}, 3.0).height;
  glm::dvec2 crest(0.0);
  for (int i = 0; i < 400; ++i) {
    const glm::dvec2 point(3.0 * i, 0.0);
    if (storm.sample(point, 3.0).height > storm.sample(crest, 3.0).height) crest = point;
  }
  const double top = storm.sample(crest, 3.0).height;
  return {{"on the surface", moderate, at({3, 4, here}, -5.0)},
          {"just below a crest", storm, at({crest, top - 0.02}, 10.0)},
          {"in the waves' volume, above water", storm, at({crest, top + 0.5}, -10.0, 20.0)},
          {"in the waves' volume, under water", storm, at({crest, top - 3.0}, 30.0)},
          {"a millimetre above still water", still, at({3, 4, 0.001}, 0.0, 0.0, 1.0)},
          {"still water", still, at({3, 4, 5.0}, -20.0)},
          {"waves of 30 m", huge, at({0, 0, 25.0}, -10.0)},
          {"straight down", moderate, at({5, 6, 20.0}, -90.0, 33.0)},
          {"straight up from below", moderate, at({5, 6, -5.0}, 90.0, 33.0)},
          {"straight up from above", moderate, at({5, 6, 20.0}, 90.0), 3.0, false},
          {"on its side", moderate, at({0, 0, 8.0}, -3.0, 90.0)},
          {"horizon on the upper edge", moderate, at({0, 0, 8.0}, -30.0)},
          {"horizon on the lower edge", moderate, at({0, 0, 8.0}, 28.4)},
          {"a view of a hundredth of a degree", moderate, at({0, 0, 6.0}, -3.0, 0.0, 0.01)},
          {"a view of 170 degrees", moderate, at({0, 0, 6.0}, -20.0, 10.0, 170.0)},
          {"one pixel", moderate, at({0, 0, 6.0}, -20.0, 0.0, 60.0, {1, 1})},
          {"150 km from the anchor after 1e7 s", moderate, at({-1.06e5, 1.06e5, 6.0}, -10.0), 1e7}};
}

}  // namespace seaway::render::test
