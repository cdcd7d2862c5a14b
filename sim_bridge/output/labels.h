#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "render/frame.h"

namespace seaway::bridge {

/// What the pixels of a label picture stand for; an instance i ≥ 1 (SceneObject::instance) has the
/// value `firstInstance` + i − 1.
namespace label {
inline constexpr std::uint16_t sky = 0, water = 1, foam = 2, ground = 3, otherObject = 4;
inline constexpr std::uint16_t firstInstance = 16;
/// A water pixel is foam where at least this much of it, of 255, is white.
inline constexpr std::uint8_t foamFrom = 128;
}  // namespace label

inline std::uint16_t labelOfInstance(std::uint16_t instance) {
  return static_cast<std::uint16_t>(label::firstInstance + instance - 1);
}

/// One label a pixel, row by row from the top left, of a frame drawn with `wantsLabels`.
std::vector<std::uint16_t> labelsOf(const render::Frame& frame);

/// The labels that are no instances, with their names, in order.
std::vector<std::pair<std::uint16_t, std::string>> commonLabels();

/// Pixels [left, right) x [top, bottom) in which an instance is visible, and how many show it.
struct InstanceBox {
  std::uint16_t instance = 0;
  int left = 0, top = 0, right = 0, bottom = 0;
  std::size_t pixels = 0;
};

/// Of each instance that a frame drawn with `wantsLabels` shows, by instance.
std::vector<InstanceBox> instanceBoxes(const render::Frame& frame);

}  // namespace seaway::bridge
