#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "sim_bridge/scene/scene.h"
#include "sim_bridge/vessel/vessel.h"
#include "surface/disturbance/layers/vessel_trail.h"
#include "surface/disturbance/surface_detail.h"
#include "surface/effects.h"
#include "surface/geodesy.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

struct Sea;

/// A scene's splashes and rain, as far as its effects are not off; null where there are none.
/// Throws InputError for events that cannot be.
std::shared_ptr<const SurfaceEvents> sceneEvents(const Scene& scene, const Geodesy& geodesy,
                                                 const SurfaceEvents::Water& water);

/// The library's source of ripples that a scene's is.
RippleSource rippleSource(const SceneRipples& ripples, const Geodesy& geodesy);

/// What lies on a scene's water and ripples it, followed through time: vessels' trails, the foam of
/// splashes, layers of the scene, pools of ripples.
///
/// Trails are painted in strokes at times of a grid of their own, from the past that a trail shows
/// on, before the scene's epoch too: whoever begins when sees the same. Nothing called for: nothing
/// is held. A copy is a snapshot; it shares tiles until one of the two moves on.
class SceneDetail {
 public:
  /// Reads the files of layers. `scene` and `sea` must outlive this object and its copies. Throws
  /// InputError for a file that cannot be read.
  SceneDetail(const Scene& scene, const Sea& sea);

  /// Brings all to time `t`, later than before. Charges `ledger`. `vessels` are the scene's, moved
  /// to `t` if free; without them free vessels leave trails on the course before the epoch alone.
  void advance(double t, std::span<const Vessel> vessels, EffectLedger* ledger = nullptr);
  void advance(double t, EffectLedger* ledger = nullptr) { advance(t, {}, ledger); }

  /// Other waves from now on, of a sea that is else the same and outlives this object.
  void setSea(const Sea& sea) { sea_ = &sea; }

  /// A hull that is none of the vessels that `advance` knows of: one that a host sails.
  struct Guest {
    TrailHull hull;
    std::function<CoursePoint(double)> placeAt;  ///< until `to`, and as far back as it goes
    double from = 0.0, to = 0.0;                 ///< s: when its trail is wanted
  };
  /// Leaves a guest's trail, in whole strokes; to be seen after the next `advance`. Returns until
  /// when it is left, s, for the next `from`. Where trails are off nothing is left.
  double leaveTrail(const Guest& guest);
  /// How far back what was left shows, s.
  double memory() const;

  /// Whether there can ever be anything, guests' trails apart.
  bool canShow() const { return !trails_.empty() || !patches_.empty() || !pools_.empty(); }

  /// Whether ripples may ever move the water within `radius` m of a place.
  bool mayRipple(glm::dvec2 place, double radius) const;

  /// Vessels that are not on their courses from now on, by their place in the scene: they leave no
  /// trails there. For those who give `advance` no vessels.
  void setAway(std::vector<bool> vessels) { away_ = std::move(vessels); }

  /// From when to before when `detail` is what it would be at that time, s: strokes and pools have
  /// steps. After an `advance`.
  struct Span {
    double from, to;
    bool covers(double t) const { return t >= from && t < to; }
  };
  Span span() const;

  /// As of the last `advance`; null where there is nothing.
  std::shared_ptr<const SurfaceDetail> detail() const { return detail_; }

  /// Writes or reads the state as of time `t`, that of the last `advance`: see
  /// surface/state_archive.h.
  template <class Archive>
  void archive(Archive& archive, double t);

 private:
  struct Patch {
    double time;
    std::function<void(SceneDetail&)> paint;
  };
  void addPatches();
  bool paint(double t, std::span<const Vessel> vessels, EffectLedger* ledger);
  void paintStroke(long long stroke, std::span<const Vessel> vessels);
  void followHosted(std::span<const Vessel> vessels);
  SurfaceLayer& layer(LayerKind kind);
  bool advancePools(double t, EffectLedger* ledger);
  void report(double t, EffectLedger* ledger) const;
  std::shared_ptr<const SurfaceDetail> snapshot() const;

  const Scene* scene_;
  const Sea* sea_;
  struct Trail {
    TrailHull hull;
    Course course;
    std::size_t vessel;  // by its place in the scene
    bool free;
  };
  std::vector<Trail> trails_;  // of vessels under way
  std::vector<bool> away_;
  std::vector<Patch> patches_;  // by time; those before nextPatch_ are painted
  std::size_t nextPatch_ = 0;
  std::optional<SurfaceLayer> foam_, smooth_, oil_;
  std::vector<RipplePool> pools_;
  std::optional<long long> nextStroke_;
  bool guestsPainted_ = false;  // since the last advance
  double time_ = 0.0;           // of the last advance
  std::shared_ptr<const SurfaceDetail> detail_;
};

}  // namespace seaway::bridge
