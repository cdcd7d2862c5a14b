#pragma once

#include <array>
#include <cstddef>

namespace seaway {

/// How a triangle lies in the water by the depths of its corners, positive where wet.
///
/// 0, 1, 2 or 3 wet corners; with one or two, `lone` is the corner on its own side, and the cuts
/// are where its edges to the next and to the one before reach the surface.
struct Wetness {
  int wet = 0;
  int lone = 0;
  double next = 0.0, before = 0.0;  ///< parts of those edges, from `lone`, in [0, 1]

  explicit Wetness(const std::array<double, 3>& depth) {
    const bool a = depth[0] > 0.0, b = depth[1] > 0.0, c = depth[2] > 0.0;
    wet = a + b + c;
    if (wet == 0 || wet == 3) return;
    const bool alone = wet == 1;
    lone = a == alone ? 0 : b == alone ? 1 : 2;
    const double own = depth[static_cast<std::size_t>(lone)];
    next = own / (own - depth[static_cast<std::size_t>((lone + 1) % 3)]);
    before = own / (own - depth[static_cast<std::size_t>((lone + 2) % 3)]);
  }
};

}  // namespace seaway
