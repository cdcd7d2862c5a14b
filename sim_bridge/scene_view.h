#pragma once

#include <string>
#include <vector>

#include "render/render_technique.h"
#include "sim_bridge/simulation.h"

namespace seaway::bridge {

/// A vessel of a scene, by its number, where it is at a moment.
struct PlacedVessel {
  std::size_t vessel = 0;
  VesselPose pose;
};

/// What there is to see at one time. Refers to its parts, which must outlive it.
struct SceneMoment {
  double time = 0.0;  ///< s since the scene's epoch
  const WaterSurface* water = nullptr;
  const Geodesy* geodesy = nullptr;
  std::span<const PlacedVessel> vessels;
};

/// Something of a scene that pictures tell apart, by SceneObject::instance.
struct SceneInstance {
  std::string name;
  std::string kind;  ///< "vessel"
  const render::SceneObject* object = nullptr;
};

/// A camera of a scene at a moment: its place, attitude and field of view. A mounted one stands on
/// the first of `moment`'s vessels that is its mount. Throws InputError where there is none.
render::Camera placedCamera(const Scene& scene, const SceneCamera& camera,
                            const SceneMoment& moment, glm::ivec2 size);

/// What pictures of a scene need beside the simulation: the vessels' meshes, made once.
class SceneView {
 public:
  /// `scene` must outlive this object.
  explicit SceneView(const Scene& scene);

  /// The view of one camera at the simulation's time. Refers to the simulation's water, to `ledger`
  /// and to this object: valid until the next call or until one of them goes.
  render::View view(const Simulation& simulation, const SceneCamera& camera, glm::ivec2 size,
                    EffectLedger& ledger);
  /// The same of any moment, to whose water it refers.
  render::View view(const SceneMoment& moment, const SceneCamera& camera, glm::ivec2 size,
                    EffectLedger& ledger);

  /// What the last view's objects are that have an instance: of a vessel its number in the scene, from
  /// 1 on. Valid as long as that view.
  const std::vector<SceneInstance>& instances() const { return instances_; }

 private:
  const Scene* scene_;
  std::vector<render::Mesh> meshes_;
  std::vector<PlacedVessel> vessels_;
  std::vector<render::SceneObject> objects_;
  std::vector<SceneInstance> instances_;
};

/// Simulation::replayed with a progress bar.
Simulation replayWithProgress(const Scene& scene, const Sea& sea, double t);

/// The scene's camera of that name; the first for an empty name. Throws InputError where there is
/// none, with the nearest name there is.
const SceneCamera& findCamera(const Scene& scene, const std::string& name);

}  // namespace seaway::bridge
