#pragma once

#include <string>
#include <vector>

#include "render/frame.h"
#include "render/render_technique.h"
#include "sim_bridge/gallery/gallery_list.h"

namespace seaway::bridge {

/// A picture of a gallery as it was drawn.
struct DrawnPicture {
  render::Frame frame;
  double milliseconds = 0.0;          ///< of a frame, median of `repeats` after a first one
  std::vector<EffectReport> effects;  ///< those on in the last of them
  std::string seen;  ///< "camera 'chase', 45° high, at 28.878°, -78.467°, 6.5 m"
};

/// Draws a picture at `size`; `repeats` ≥ 0 times more after the first, which sets up what stays.
/// The bits of the picture are those of any machine with the same vector instructions. Throws
/// InputError for what the scene or the picture gets wrong.
DrawnPicture drawPicture(const Gallery& gallery, const GalleryPicture& picture, glm::ivec2 size,
                         const std::string& backend, int repeats);

/// Pictures of one size side by side, `columns` a row, in reading order.
render::ColourImage contactSheet(const std::vector<render::ColourImage>& pictures, int columns);

/// What golden pictures are drawn at.
inline constexpr glm::ivec2 goldenSize{240, 135};

/// How two pictures of one size differ.
struct PictureDifference {
  double meanAbsolute = 0.0;  ///< of a channel, in 255ths
  double farShare = 0.0;      ///< part of the pixels with a channel more than `far` apart
  int largest = 0;            ///< of any channel
};
PictureDifference differenceOf(const render::ColourImage& a, const render::ColourImage& b, int far);

/// Differences times eight on grey: what `a` has more of is brighter.
render::ColourImage differencePicture(const render::ColourImage& a, const render::ColourImage& b);

}  // namespace seaway::bridge
