#pragma once

#include <condition_variable>
#include <deque>
#include <functional>
#include <glm/vec2.hpp>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "render/frame.h"
#include "render/render_technique.h"
#include "sim_bridge/scene/scene.h"
#include "sim_bridge/service/served_sea.h"
#include "surface/effects.h"

namespace seaway::bridge {

struct FrameRequest {
  std::string camera = {};  ///< of the scene, or that was set; empty: the scene's first
  std::optional<SceneCamera> own = std::nullopt;  ///< in place of `camera`
  double t = 0.0;                                 ///< s since the scene's epoch
  glm::ivec2 size{0};  ///< pixels, [1, 4096] each; 0, 0: the scene's `run.size`
  bool wantsNormals = false;
};

/// Pictures of a served sea as `seaway render` draws them: the surface that queries ask, hosts'
/// hulls, the scene's own. Thread-safe; one picture at a time, drawn on a thread of its own, which
/// may wait up to five seconds for the wakes, and what lies on the water, at the picture's time.
class FrameMaker {
 public:
  /// `backend` as in render::TechniqueChoice. `sea` must outlive the maker. Throws InputError for a
  /// backend that is not known.
  explicit FrameMaker(ServedSea& sea, std::string backend = "osmesa");
  ~FrameMaker();

  /// Throws InputError for a camera, time or size that is not allowed; std::runtime_error where
  /// drawing fails or the maker ends. The frame is the caller's for as long as it holds it.
  std::shared_ptr<const render::Frame> draw(const FrameRequest& request);

  /// A camera that a host sets, drawn from by its name from now on; nothing: it is gone. A mounted
  /// one stands on `hull` where that is there (0: on the first of its mount's hulls).
  void setCamera(const std::string& name, const std::optional<SceneCamera>& camera,
                 std::uint32_t hull = 0);
  /// Names that FrameRequest::camera takes.
  std::vector<std::string> cameras() const;

  /// What the effects of the picture drawn last did, and what that cost; empty before the first.
  std::vector<EffectReport> effects() const;

 private:
  struct Scenery;
  using Picture = std::shared_ptr<const render::Frame>;
  void run();
  Picture drawHere(const FrameRequest& request);
  struct Camera {
    SceneCamera scene;
    std::uint32_t hull = 0;
  };
  Camera cameraOf(const FrameRequest& request, const Scene& scene) const;

  ServedSea& sea_;
  const std::string backend_;

  mutable std::mutex mutex_;
  std::condition_variable posted_;
  std::deque<std::function<void()>> jobs_;
  bool ending_ = false;
  std::map<std::string, Camera> cameras_;
  std::vector<EffectReport> effects_;

  std::unique_ptr<Scenery> scenery_;  // the thread's own
  std::thread thread_;
};

}  // namespace seaway::bridge
