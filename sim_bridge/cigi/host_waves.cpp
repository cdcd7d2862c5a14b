#include "sim_bridge/cigi/host_waves.h"

#include <cmath>

namespace seaway::bridge::cigi {

bool HostWaves::set(const WaveControl& control) {
  if (!control.enabled) {
    changed_ |= waves_.erase(control.wave) > 0;
    return true;
  }
  const HostWave wave{control.height, control.wavelength, control.period, control.direction,
                      control.phase};
  for (const double value :
       {wave.height, wave.wavelength, wave.period, wave.toward_deg, wave.phase_deg}) {
    if (!std::isfinite(value)) return false;
  }
  if (wave.height < 0.0 || !(wave.wavelength > 0.0 || wave.period > 0.0)) return false;
  const auto found = waves_.find(control.wave);
  if (found != waves_.end() && found->second == wave) return true;
  waves_[control.wave] = wave;
  changed_ = true;
  return true;
}

bool HostWaves::changed(std::vector<HostWave>& waves) {
  if (!changed_) return false;
  changed_ = false;
  waves.clear();
  for (const auto& [number, wave] : waves_) waves.push_back(wave);
  return true;
}

}  // namespace seaway::bridge::cigi
