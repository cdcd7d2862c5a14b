#pragma once

#include <map>
#include <string>

namespace seaway::bench {

/// What a rival's answers are worth.
struct Accuracy {
  double heightError = 0.0;       ///< rms against the rival's own exact field, m
  double spectralResidual = 0.0;  ///< √(∫(M − S)²/∫S²) of what it stands for
  std::size_t memoryBytes = 0;
};

/// By benchmark name; names that only repeat another's answers are absent.
std::map<std::string, Accuracy> measureAccuracy();

}  // namespace seaway::bench
