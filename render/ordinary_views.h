#pragma once

#include "render/camera.h"

namespace seaway::render {

/// A view of the kind that Johanson quotes vertex efficiencies of 50–95 % for.
struct OrdinaryView {
  Camera camera;
  double significantWaveHeight = 0.0;  ///< m: of a sea that goes with it
};

/// The `number`-th of a fixed endless series, by which aims of the projector are judged: 3 … 300 m
/// up (even in the logarithm), any heading, 0 … 60° below the horizon, rolled by 10° at most, field
/// of view 35 … 75° high and 16:9, significant wave height 0 … 2.5 m.
OrdinaryView ordinaryView(unsigned number);

}  // namespace seaway::render
