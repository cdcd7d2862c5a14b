#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <limits>
#include <memory>
#include <mutex>
#include <optional>
#include <set>
#include <span>
#include <stop_token>
#include <thread>
#include <utility>
#include <vector>

#include "sim_bridge/scene_view.h"
#include "sim_bridge/service/free_voyage.h"
#include "sim_bridge/service/hosted_pose.h"
#include "sim_bridge/service/meter.h"
#include "sim_bridge/service/served_fleet.h"
#include "sim_bridge/service/served_scene.h"
#include "sim_bridge/service/wake_attention.h"
#include "surface/disturbance/published.h"
#include "surface/effects.h"
#include "surface/water_surface.h"

namespace seaway::bridge {

class FreeSailing;
class WakeKeeper;

/// A vessel that is there at some time: one that a host sails, or one on the scene's course.
struct ServedHull : PlacedVessel {
  std::uint32_t hull = 0;  ///< the host's; 0: of the scene
  bool outOfTime = false;  ///< a free one whose place at this time is not known: the nearest known
};

/// Everything at one time: what a picture is drawn of.
struct ServedMoment {
  double time = 0.0;
  std::shared_ptr<const ServedScene> scene;
  std::shared_ptr<const WaterSurface> surface;
  std::vector<ServedHull> hulls;  ///< by vessel
};

/// The one sea that all endpoints of a service ask and change. Thread-safe: readers take the
/// surface without waiting, nobody waits for wakes, and what others wait for takes microseconds.
///
/// What lies on the water and ripples it (SceneDetail) follows the latest time that was asked for
/// in the last five seconds, on a thread of its own, as far as the scene has any. Vessels that
/// hosts sail leave their trail along the poses that they were given (HostedTrails).
///
/// Free vessels sail to that time too (FreeSailing), step by step, on another thread: an answer
/// that is ahead of them says `wakeOutOfTime` near them, and pictures wait. Their last 30 s are
/// remembered. Where the time goes farther back they sail again from the epoch, in the waves of
/// now; so they do where a host lets go of a vessel that they may have met. A leap of more than a
/// day ahead is not sailed.
///
/// Without either the sea is a function of t alone. Wakes are there for a span of time (WakeKeeper,
/// WakeAttention), brought on by a thread of the sea's own where somebody asks near them
/// (`attend`); answers outside that span say `wakeOutOfTime`. Where a scene switches wakes off
/// there is no thread.
class ServedSea {
 public:
  ServedSea(const Scene& scene, Sea sea);
  ~ServedSea();

  /// The scene as it is now: hold it while you look at it, for another may be loaded.
  std::shared_ptr<const Scene> scene() const noexcept;
  /// Of every scene that is served: it stays.
  const Geodesy& geodesy() const { return geodesy_; }
  Meters& meters() { return meters_; }

  /// The surface as it is now, wakes included; never null. Take it once a request.
  std::shared_ptr<const WaterSurface> surface() const noexcept { return surface_.latest(); }

  /// Other waves from now on. Throws InputError for octaves that are no field; the sea is then as
  /// before.
  void setOctaves(std::vector<Octave> octaves);
  /// The scene's own waves again.
  void restoreOctaves();
  /// Grows each time that the sea gets other waves.
  std::uint64_t wavesVersion() const { return wavesVersion_; }

  /// Another scene from now on. Hosts' hulls stay where the scene has a vessel of the same name,
  /// waves that a host has set stay too; wakes begin anew. Throws InputError for a scene with
  /// another anchor, where hosts' places would be others; the old one is then served on.
  void replaceScene(const Scene& scene, Sea sea);

  /// A hull of the scene's vessel `index` that a host sails, in place of the scene's own from its
  /// first pose on; 0 where there is no such vessel.
  std::uint32_t addHull(std::size_t index);
  void removeHull(std::uint32_t hull);
  /// Puts a hull somewhere at time `t`. False, and nothing changes, for a hull that is not there, a
  /// number that is not finite, a place out of the geodesy's range, or a time not after the last;
  /// a time more than a second before it means that the host begins again.
  bool place(std::uint32_t hull, double t, const HostedPose& pose);
  /// For SampleOptions::excludeVessel of points on the hull itself; 0 where it feels its own waves.
  std::uint32_t ownWake(std::uint32_t hull) const;

  /// All hulls at `t`: hosts' where they were placed (ServedFleet::at), the others on the scene's
  /// courses, lying on the water as it is in the mean under them.
  std::vector<ServedHull> hulls(double t) const { return moment(t).hulls; }
  /// The same with the scene and the surface that go with it.
  ServedMoment moment(double t) const;
  /// How a vessel of the scene would lie on the water.
  VesselPose afloat(std::size_t vessel, glm::dvec2 position, double direction, double t) const;

  /// Who asks, and when: returns at once, and the sea's thread brings the wakes there. The status,
  /// which belongs to that of each answer, says `wakeOutOfTime` where wakes are near a listener and
  /// are not there at `t` now, and for listeners near ripples that are those of a time more than
  /// half a second away.
  SampleStatus attend(double t, std::span<const WakeListener> listeners);
  /// Whether the scene has vessels that sail by themselves, in steps: somebody has to `attend`.
  bool hasFreeVessels() const noexcept { return scene_.latest()->anyFree; }
  /// The time that was asked for last, s; 0 before any.
  double lastTime() const { return lastTime_; }
  /// Waits until wakes, and what lies on the water, are as they were called for before: true; not
  /// longer than `seconds`: false.
  bool awaitWakes(double seconds) const;
  /// From when to when wakes are there; nothing where there are none.
  std::optional<std::pair<double, double>> wakeSpan() const;

  struct WakeFigures {
    std::size_t running = 0;
    std::size_t memoryBytes = 0;
  };
  WakeFigures wakeFigures() const;
  /// What the effects that SceneDetail charges did last; empty before that.
  std::vector<EffectReport> detailEffects() const;

 private:
  void publish();
  void keepWakes(const std::stop_token& stop);
  void bringWakes(std::unique_ptr<WakeKeeper>& keeper, std::unique_lock<std::mutex>& lock);
  void attendSailing(double t, std::chrono::steady_clock::time_point now);
  void keepSailing(const std::stop_token& stop);
  void bringSailing(std::unique_ptr<FreeSailing>& sailing, std::unique_lock<std::mutex>& lock,
                    const std::stop_token& stop);
  std::vector<PlacedVessel> hostedAt(double t) const;
  std::shared_ptr<const WaveField> hostWaves();
  bool knowsFree(double t) const;
  glm::dvec2 freePlace(std::size_t vessel, double t, double& reach) const;
  struct DetailKeeping;
  std::optional<double> detailTime(const FreeVoyage* voyage) const;
  void bringDetail(DetailKeeping& keeping, std::unique_lock<std::mutex>& lock);
  SampleStatus attendDetail(double t, std::span<const WakeListener> listeners,
                            std::chrono::steady_clock::time_point now);
  void keepDetail(const std::stop_token& stop);
  void setDetail(std::shared_ptr<const SurfaceDetail> detail, const ServedScene& of);
  void setFeed(std::shared_ptr<const DisturbanceFeed> feed, const ServedScene& of);
  void findNear(double t, const WakeListener& listener, std::vector<std::uint32_t>& out) const;
  bool isBrought(double t, std::uint32_t wake) const;
  std::vector<bool> hostedVessels() const;

  const Geodesy geodesy_;
  std::atomic<double> lastTime_{0.0};
  std::atomic<std::uint64_t> wavesVersion_{0}, posesBeforeEpoch_{0};
  Meters meters_;
  Published<WaterSurface> surface_;
  Published<ServedScene> scene_;

  // What the surface is made of. Taken after noting_, where both are.
  std::mutex composing_;
  std::shared_ptr<const ServedScene> composed_;
  std::shared_ptr<const WaveField> hostWaves_;  // null: the scene's
  std::shared_ptr<const DisturbanceFeed> feed_;
  std::shared_ptr<const SurfaceDetail> detail_;

  // What hosts do; held for microseconds alone.
  mutable std::mutex noting_;
  mutable std::condition_variable_any called_, brought_;
  std::shared_ptr<const ServedScene> noted_;
  ServedFleet fleet_;
  WakeAttention attention_;
  std::uint64_t calls_ = 0, answers_ = 0;  // of the thread: asked for, and done
  bool wanted_ = false;
  double coveredFrom_ = 1.0, coveredTo_ = 0.0;  // s: where the thread has brought the wakes
  std::set<std::uint32_t> broughtWakes_;        // of these hulls, as far as they make any
  std::vector<std::uint32_t> near_;
  WakeFigures figures_;

  // The same of other threads: the latest time asked for lately.
  struct Asked {
    double time = -std::numeric_limits<double>::infinity();
    std::chrono::steady_clock::time_point heard{};
    std::uint64_t calls = 0, answers = 0;
    bool wanted = false;

    bool follow(double t, std::chrono::steady_clock::time_point now);
    bool call();  // true: nobody has before
  };
  struct DetailAsked : Asked {
    bool anyGuests = false;  // hosts' hulls have left trails
    std::optional<SceneDetail::Span> brought;
    std::vector<EffectReport> effects;
  } detailAsked_;
  Asked sailingAsked_;
  bool tooFarToSail_ = false;
  std::shared_ptr<const FreeVoyage> voyage_;  // of noted_; null without free vessels

  std::jthread thread_, detailThread_, sailingThread_;  // go first
};

}  // namespace seaway::bridge
