#pragma once

#include <memory>
#include <utility>

#include "surface/water_surface.h"

namespace seaway::bridge {

/// A surface prepared for one time after another in memory that is kept: allocates only for a field
/// with more octaves. One thread at a time.
class PreparedSurface {
 public:
  PreparedSurface() : water_(calm().at(0.0)) {}

  /// Holds the surface, with what disturbs it now, for as long as it lives; one at a time.
  class Use {
   public:
    Use(PreparedSurface& prepared, std::shared_ptr<const WaterSurface> surface, double t)
        : surface_(std::move(surface)), water_(prepared.water_) {
      water_.moveTo(*surface_, t);
    }
    ~Use() {
      // What is kept must not hold a sea's wakes and layers.
      const SurfaceExtras& extras = water_.extras();
      if (water_.disturbances() || extras.events || extras.detail) water_.moveTo(calm(), 0.0);
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    const SurfaceAtTime& operator*() const { return water_; }
    const SurfaceAtTime* operator->() const { return &water_; }

   private:
    std::shared_ptr<const WaterSurface> surface_;
    SurfaceAtTime& water_;
  };

 private:
  static const WaterSurface& calm() {
    static const WaterSurface surface{WaveField({})};
    return surface;
  }
  SurfaceAtTime water_;
};

}  // namespace seaway::bridge
