#pragma once

#include <span>

#include "render/gl/frame_targets.h"
#include "render/gl/outline_buffers.h"
#include "render/hollows.h"
#include "render/render_technique.h"

/// Where the sea ends: full-screen passes over the geometry framebuffer, which must be bound, after
/// the sea and before objects.
namespace seaway::render {

/// Ground outside the sea's outline: see shore.h. Needs an empty vertex array to be bound.
class GroundPass {
 public:
  GroundPass();
  void draw(const FrameTargets& targets, const View& view);
  std::size_t memoryBytes() const { return outline_.memoryBytes(); }

 private:
  GlProgram program_;
  OutlineBuffers outline_;
};

/// No sea in open hulls: see hollows.h. Needs an empty vertex array to be bound.
class HullMaskPass {
 public:
  HullMaskPass();
  void draw(const FrameTargets& targets, const Camera& camera,
            std::span<const PlacedHollow> hollows);

 private:
  GlProgram program_;
};

}  // namespace seaway::render
