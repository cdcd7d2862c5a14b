#pragma once

namespace seaway::bridge {

struct Place {
  double latitude_deg = 0.0;
  double longitude_deg = 0.0;
};

}  // namespace seaway::bridge
