#include "render/ordinary_views.h"

#include <cmath>
#include <random>

#include "surface/angles.h"
#include "surface/constants.h"

namespace seaway::render {

OrdinaryView ordinaryView(unsigned number) {
  std::mt19937_64 random(number);
  // The standard's distributions differ between libraries.
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(random() >> 11) * 0x1p-53;
  };
  OrdinaryView view;
  view.significantWaveHeight = uniform(0.0, 2.5);
  const double height = 3.0 * std::pow(100.0, uniform(0.0, 1.0));
  view.camera.position = {uniform(-1e3, 1e3), uniform(-1e3, 1e3), height};
  const double heading = uniform(-pi, pi), pitch = radiansFromDegrees(uniform(-60.0, 0.0));
  view.camera.worldFromCamera = attitude(heading, pitch, radiansFromDegrees(uniform(-10.0, 10.0)));
  view.camera.verticalFieldOfView = radiansFromDegrees(uniform(35.0, 75.0));
  view.camera.size = {1280, 720};
  return view;
}

}  // namespace seaway::render
