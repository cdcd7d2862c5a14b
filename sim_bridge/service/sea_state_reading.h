#pragma once

#include <cstdint>
#include <mutex>
#include <optional>

#include "sim_bridge/service/served_sea.h"

namespace seaway::bridge {

/// A sea state by its bulk figures; nothing where it is not known.
struct SeaStateFigures {
  std::optional<double> significantWaveHeight;  ///< H_m0, m
  std::optional<double> peakPeriod;             ///< T_p, s
  std::optional<double> from_deg;               ///< mean direction, clockwise from true north
};

/// What a scene asks of its sea.
SeaStateFigures askedSeaState(const Scene& scene, const Sea& sea);

/// What waves really are, without wakes: H_m0 as realisedSignificantWaveHeight has it, T_p and
/// direction as a buoy at the anchor reads them in two hours.
SeaStateFigures realisedSeaState(const WaterSurface& surface, const Geodesy& geodesy);

/// realisedSeaState of a served sea, read again only when its waves are others. Thread-safe.
class SeaStateReading {
 public:
  SeaStateFigures of(const ServedSea& sea);

 private:
  std::mutex mutex_;
  std::optional<std::uint64_t> version_;
  SeaStateFigures figures_;
};

}  // namespace seaway::bridge
