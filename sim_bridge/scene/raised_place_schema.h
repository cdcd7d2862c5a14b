#pragma once

#include <string>
#include <utility>

#include "sim_bridge/scene/schema_fields.h"

namespace seaway::bridge {

/// Keys of a place with a height: `P` has latitude_deg, longitude_deg and height (m), of which
/// `summary` tells.
template <class P>
Mapping<P> raisedPlaceSchema(std::string summary) {
  return Mapping<P>({
      number("latitude_deg", &P::latitude_deg, "°", Range::within(-90.0, 90.0), "WGS84",
             Need::required),
      number("longitude_deg", &P::longitude_deg, "°", Range::within(-180.0, 360.0), "WGS84",
             Need::required),
      number("height_m", &P::height, "m", Range::within(-1000.0, 10000.0), std::move(summary)),
  });
}

}  // namespace seaway::bridge
