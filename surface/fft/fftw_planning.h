#pragma once

#include <mutex>

namespace seaway {

/// FFTW's planner, destruction included, is not thread-safe in either precision; executing a plan
/// is.
inline std::mutex& fftwPlanning() {
  static std::mutex mutex;
  return mutex;
}

}  // namespace seaway
