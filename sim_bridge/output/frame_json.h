#pragma once

#include <nlohmann/json_fwd.hpp>

#include "sim_bridge/scene_view.h"

namespace seaway::bridge {

/// A drawn frame and all that is told of it.
struct DescribedFrame {
  const Scene& scene;
  const Geodesy& geodesy;
  const std::string& camera;                 ///< its name
  const render::View& view;                  ///< what was drawn
  std::span<const SceneInstance> instances;  ///< of SceneView, for that view
  const render::Frame& frame;                ///< 2-D boxes need it drawn with `wantsLabels`
  const EffectLedger& effects;
};

/// Time, camera (place, attitude, pinhole, distortion), instances with poses and 2-D and 3-D boxes,
/// what labels stand for, effects. Every length in m, angle in degrees, pixel by OpenCV's
/// convention; the page itself states its conventions under "conventions".
nlohmann::ordered_json frameJson(const DescribedFrame& described);

}  // namespace seaway::bridge
