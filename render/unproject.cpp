#include "render/unproject.h"

#include <glm/geometric.hpp>

#include "surface/curvature.h"

namespace seaway::render {

SeaPoint unproject(const Camera& camera, glm::dvec2 pixel, double axialDepth) {
  const glm::dvec3 ray = camera.rayThrough(pixel);
  const glm::dvec3 offset = ray * (axialDepth / glm::dot(ray, camera.forward()));
  const glm::dvec2 level(offset);
  return {glm::dvec2(camera.position) + level,
          camera.position.z + offset.z + seaDrop(glm::length(level))};
}

}  // namespace seaway::render
