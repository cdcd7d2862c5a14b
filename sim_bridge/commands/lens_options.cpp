#include "sim_bridge/commands/lens_options.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>

#include "render/lens.h"
#include "surface/angles.h"
#include "surface/input_error.h"

namespace seaway::bridge {
namespace {

std::vector<double> numbersIn(const std::string& option, const std::string& text,
                              const std::string& shape, std::size_t least, std::size_t most) {
  std::vector<double> numbers;
  for (const std::string& part : CLI::detail::split(text, ',')) {
    double value = 0.0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), value);
    if (error != std::errc{} || end != part.data() + part.size() || !std::isfinite(value)) {
      throw InputError(option + ": '" + text + "' is not " + shape);
    }
    numbers.push_back(value);
  }
  if (numbers.size() < least || numbers.size() > most) {
    throw InputError(option + ": '" + text + "' is not " + shape);
  }
  return numbers;
}

}  // namespace

void addLensOptions(CLI::App& command, LensOptions& options) {
  command.add_option("--intrinsics", options.intrinsics,
                     "FX,FY,CX,CY in pixels of --size by OpenCV's convention, whole numbers being "
                     "pixels' centres (default: the camera's own)");
  command.add_option("--distortion", options.distortion,
                     "K1,K2,P1,P2[,K3] of the lens, OpenCV's (default: the camera's own)");
}

void addSamplesOption(CLI::App& command, int& samples) {
  command.add_option("--aa", samples,
                     "N: a pixel's colour is the mean radiance of N x N samples, N <= 16 and at "
                     "most 33554432 in all (1)");
}

void applyLens(const LensOptions& options, glm::ivec2 size, SceneCamera& camera) {
  if (!options.intrinsics.empty()) {
    const auto n = numbersIn("--intrinsics", options.intrinsics,
                             "FX,FY,CX,CY, such as 1000,1000,639.5,359.5", 4, 4);
    camera.intrinsics = SceneIntrinsics{{n[0], n[1], n[2], n[3]}, size};
  }
  if (!options.distortion.empty()) {
    const auto n = numbersIn("--distortion", options.distortion,
                             "K1,K2,P1,P2 or K1,K2,P1,P2,K3, such as -0.3,0.1,0.001,0", 4, 5);
    camera.distortion = render::Distortion{n[0], n[1], n.size() > 4 ? n[4] : 0.0, n[2], n[3]};
  }
  render::validateSamples(size, options.samples);
  render::Camera seen;
  seen.size = size;
  seen.verticalFieldOfView = radiansFromDegrees(camera.fieldOfView_deg);
  if (camera.intrinsics) {
    seen.intrinsics = scaled(camera.intrinsics->pixels, camera.intrinsics->size, size);
  }
  seen.distortion = camera.distortion;
  validate(seen);
  const bool isBent = seen.distortion && !seen.distortion->isNone();
  if (isBent) render::lensMap(seen, options.samples);  // throws where it cannot be drawn
}

}  // namespace seaway::bridge
