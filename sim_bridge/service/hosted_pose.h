#pragma once

namespace seaway::bridge {

/// Where a host says that a hull is and how it lies.
struct HostedPose {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
  double height = 0.0;       ///< of the body origin (BoxHull) above the still-water level, m
  double heading_deg = 0.0;  ///< true, of the bow
  double pitch_deg = 0.0;    ///< bow up
  double roll_deg = 0.0;     ///< starboard down
};

}  // namespace seaway::bridge
