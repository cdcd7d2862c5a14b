#pragma once

#include <cstdint>

#include "render/lighting_decision.h"
#include "render/local_image.h"
#include "render/software/object_triangles.h"
#include "render/terrain/terrain_in_view.h"

namespace seaway::render {

/// What of the scene's objects the water around them mirrors, and what of them shows through it, as
/// pictures for the camera's own view.
///
/// Mirrored: what stands above the water, z → 2h − z. Below: what is under it, depths divided by
/// the index of refraction as they appear from straight above. h is the water's height at each
/// object, with waves shorter than the object left out; triangles are clipped there, so that
/// nothing from the other side leaks in. Lit as objects are, without haze and without the water
/// between.
///
/// From under water: `window`, what stands above it as Snell's window shows it through still water,
/// and `depths`, what is under it as the underside mirrors it, z → 2h − z.
class LocalLight {
 public:
  /// Decides on them with the view's ledger, and draws what is called for; else holds nothing.
  /// `sources` are the frame's, without what this makes. Needs no OpenGL.
  void fill(const View& view, const Shown& shown, const ShadingSources& sources,
            const TerrainInView& terrain);

  const LocalImage& mirrored() const { return mirrored_; }
  const LocalImage& below() const { return below_; }
  const LocalImage& window() const { return window_; }
  const LocalImage& depths() const { return depths_; }
  /// Tells shading what is there.
  void setConstants(ShadingConstants& constants) const;

 private:
  /// One picture: what is in it, and from which side.
  struct Drawn {
    const Camera& camera;
    const TerrainInView& terrain;
    WaterSide side;
  };
  void fillAbove(const View& view, const Shown& shown, const ShadingSources& sources,
                 const TerrainInView& terrain);
  void fillUnder(const View& view, const Shown& shown, const ShadingSources& sources,
                 const TerrainInView& terrain);
  void draw(const Drawn& drawn, const ShadingSources& sources, LocalImage& image) const;
  void fillSpan(const Drawn& drawn, const Strip& objects, const Strip& ground, int line, int first,
                const ShadingConstants& constants, PixelSpan& span) const;

  ObjectTriangles triangles_;
  TerrainInView::Triangles ground_;
  float shoreHardness_ = 0.0f;  // 1/m; 0: no bed is shown
  float mirrorBend_ = 0.0f;
  LocalImage mirrored_, below_, window_, depths_;
  float nearest_ = 0.0f, farthest_ = 0.0f;  // axial distances of what is mirrored, m
};

}  // namespace seaway::render
