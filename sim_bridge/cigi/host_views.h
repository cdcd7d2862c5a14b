#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

#include "sim_bridge/cigi/packets.h"

namespace seaway::bridge::cigi {

/// One view of a host: where its eye is on an entity, and how wide it looks.
struct HostView {
  std::uint16_t entity = 0;
  double x = 0.0, y = 0.0, z = 0.0;  ///< m in the entity's body axes: forward, starboard, down
  double roll_deg = 0.0, pitch_deg = 0.0, yaw_deg = 0.0;  ///< relative to the entity
  double left_deg = -30.0, right_deg = 30.0;              ///< half angles
  double bottom_deg = -30.0, top_deg = 30.0;
  bool placed = false;  ///< a View Control has come for it
  bool isCentred() const;
};

/// The views of one host, by number, as its View Control and View Definition packets tell. What a
/// packet does not enable stays as it is. A packet for a group is for all views that are in it; a
/// view's group is that of its last View Definition.
class HostViews {
 public:
  void set(const ViewControl& control);
  /// False, and nothing changes, for a definition that is orthographic, mirrored, or wider than can
  /// be drawn.
  bool set(const ViewDefinition& definition);

  const std::map<std::uint16_t, HostView>& views() const { return views_; }

 private:
  template <class Action>
  void forEach(std::uint16_t view, std::uint8_t group, Action action);
  std::map<std::uint16_t, HostView> views_;
  std::map<std::uint16_t, std::uint8_t> groups_;
};

}  // namespace seaway::bridge::cigi
