#pragma once

#include <cstddef>
#include <glm/mat4x4.hpp>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "render/gl/frame_targets.h"
#include "render/grid_placement.h"
#include "render/render_technique.h"

namespace seaway::render {

/// How the sea's surface gets into the geometry framebuffer: the stage of the projected grid that
/// its variants differ in (Johanson 2004, "CPU-based vertex processing" and the GPU variants).
///
/// Makes what it needs when first used, in the context that is current; that context must be
/// current in every call and in the destructor. Not thread-safe.
class SeaGeometryPass {
 public:
  virtual ~SeaGeometryPass() = default;

  /// The variant's name, as in `gridVariantName`.
  virtual std::string_view variant() const = 0;

  /// Works out heights and slopes of a grid of `size` vertices. Called again with a wider
  /// projector where `largestHeight` passes the bound that the projector was aimed with.
  virtual SeaPlacement place(const View& view, const Projector& projector, glm::ivec2 size) = 0;

  /// Draws what was placed into `targets.geometry`: bound and cleared, reversed depth, depth test
  /// and stencil test on. Leaves for each pixel of water
  /// - `surface`: slope x, slope y of the waves carried; mean-square slope left out; height, m
  /// - `distance`: axial distance, m, > 0
  /// - depth: reversed, `clipFromRelativeWorld` (its z/w is near/axial distance)
  /// - stencil: stencilWater, or stencilUnderside where the camera is under water and sees the
  ///   surface from below
  virtual void draw(const FrameTargets& targets, const glm::mat4& clipFromRelativeWorld,
                    bool cameraIsUnderWater) = 0;

  /// Milliseconds that what `place` did since the last call took on the graphics card, by pass;
  /// empty in software, and where the processor alone places.
  virtual std::vector<std::pair<std::string, double>> gpuMs() { return {}; }

  virtual std::size_t memoryBytes() const = 0;
};

/// Stencil of the sea: a camera sees the side that it is on, whatever side a triangle at a crest's
/// rim turns to it.
void setWaterStencil(bool cameraIsUnderWater);

/// The stage for a variant that draws through GL. Throws InputError where the current context
/// cannot run it.
std::unique_ptr<SeaGeometryPass> makeSeaGeometryPass(GridVariant variant);

}  // namespace seaway::render
