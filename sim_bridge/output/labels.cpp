#include "sim_bridge/output/labels.h"

#include <algorithm>
#include <map>

namespace seaway::bridge {

std::vector<std::uint16_t> labelsOf(const render::Frame& frame) {
  using render::PixelClass;
  std::vector<std::uint16_t> labels(frame.classes.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    switch (frame.classes[i]) {
      case PixelClass::sky:
        labels[i] = label::sky;
        break;
      case PixelClass::water:
        labels[i] = frame.foam[i] >= label::foamFrom ? label::foam : label::water;
        break;
      case PixelClass::ground:
        labels[i] = label::ground;
        break;
      case PixelClass::object:
        labels[i] =
            frame.instances[i] == 0 ? label::otherObject : labelOfInstance(frame.instances[i]);
        break;
    }
  }
  return labels;
}

std::vector<std::pair<std::uint16_t, std::string>> commonLabels() {
  return {{label::sky, "sky"},
          {label::water, "water"},
          {label::foam, "foam"},
          {label::ground, "ground"},
          {label::otherObject, "object"}};
}

std::vector<InstanceBox> instanceBoxes(const render::Frame& frame) {
  std::map<std::uint16_t, InstanceBox> boxes;
  const glm::ivec2 size = frame.colour.size;
  for (std::size_t i = 0; i < frame.instances.size(); ++i) {
    const std::uint16_t instance = frame.instances[i];
    if (instance == 0) continue;
    const int x = static_cast<int>(i % static_cast<std::size_t>(size.x));
    const int y = static_cast<int>(i / static_cast<std::size_t>(size.x));
    const auto [at, isNew] =
        boxes.try_emplace(instance, InstanceBox{instance, x, y, x + 1, y + 1, 0});
    InstanceBox& box = at->second;
    box.left = std::min(box.left, x);
    box.right = std::max(box.right, x + 1);
    box.bottom = y + 1;
    ++box.pixels;
  }
  std::vector<InstanceBox> result;
  for (const auto& [instance, box] : boxes) result.push_back(box);
  return result;
}

}  // namespace seaway::bridge
