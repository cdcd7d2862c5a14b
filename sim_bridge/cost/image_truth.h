#pragma once

#include <glm/vec2.hpp>
#include <string>
#include <vector>

#include "sim_bridge/scene_view.h"

namespace seaway::bridge {

struct StudyOptions;

/// "640x360".
std::string sizeText(glm::ivec2 size);

/// How far a picture is from the truth.
struct ImageErrors {
  double position = 0.0;  ///< place of the surface in the picture, rms away from silhouettes, px
  double depth = 0.0;     ///< of water pixels, median |drawn − marched|, m
  double height = 0.0;    ///< of the drawn surface against the field queried there, rms, m
};

/// What a scene's first camera sees at the scene's start, and where rays find it.
class ImageTruth {
 public:
  /// `scene`, which has a camera, and `sea` must outlive this object.
  ImageTruth(const Scene& scene, const Sea& sea, const StudyOptions& options);
  ImageTruth(const ImageTruth&) = delete;
  ImageTruth& operator=(const ImageTruth&) = delete;

  const render::View& view() const { return view_; }
  bool showsWater() const { return !marched_.empty(); }
  /// For a study's summary: ", camera 'bow', 640x360 pixels".
  const std::string& where() const { return where_; }

  ImageErrors errorsOf(const render::Frame& frame) const;

 private:
  /// A pixel whose true depth is known.
  struct TruePixel {
    glm::ivec2 pixel;
    double axialDepth;  // m
  };
  void marchRays(int stride);

  Simulation simulation_;
  SceneView sceneView_;
  EffectLedger ledger_;
  render::View view_;
  std::string where_;
  std::vector<TruePixel> marched_;
  render::Frame rays_;
};

}  // namespace seaway::bridge
