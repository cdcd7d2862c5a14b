#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "render/cover_tiles.h"
#include "render/lighting_decision.h"
#include "render/software/raster.h"

namespace seaway::render {

/// What keeps the sun off: heights towards the sun of the scene's objects, in up to three
/// orthographic maps as seen from the sun, of which the first that covers a place counts
/// (shading/shadows.glsl.h). They are fitted to the objects whose shadows may fall into the view,
/// the first ones to those near the camera.
///
/// A shadow's rim lies where geometry puts it within 1.5 texels of the map; a face is looked at
/// from at most 2.13 texels off its plane, so a shadow begins no farther from what casts it. What
/// is under water is moved to where the sun's ray would have reached it straight on, so that its
/// shadows bend as the light does at still water. What is thinner than a texel may cast none.
class ShadowMaps {
 public:
  static constexpr int most = ShadingConstants::mostShadowMaps;
  static constexpr int side = 1024;  ///< texels at the most, without a margin

  /// Decides with the view's ledger and draws the maps where they are called for; else holds
  /// nothing. Needs no OpenGL.
  void fill(const View& view, const Shown& shown, const Lighting& lighting, int mostTexels = side);
  /// Tells shading what is there.
  void setConstants(ShadingConstants& constants) const;

  /// Map below map, row by row: metres towards the sun from `shadowBase`, 0 where nothing is.
  std::span<const float> texels() const { return texels_; }
  glm::ivec2 size() const { return size_; }  ///< of all; (0, 0): no maps
  /// Of each map.
  const CoverTiles* tiles() const { return tiles_.data(); }

 private:
  struct Caster {
    const SceneObject* object;
    glm::dvec3 centre;
    double level;  // of still water there
    double away;   // of the nearest of its shadow from the camera, m
  };
  struct Box {
    glm::dvec2 least{1e30}, most{-1e30};
  };
  struct Map {
    glm::dvec2 least;  // of texel (0, 0), in texels from the camera
    double texel;      // m
    glm::ivec2 size;
    int row;  // in texels_
  };
  /// Corner in the sun's view: across, up, towards the sun; m.
  struct Triangle {
    glm::dvec3 corner[3];
  };
  void aim(const View& view, const Lighting& lighting);
  std::vector<Caster> castersOf(const View& view) const;
  void place(std::span<const Caster> casters, double pixelAngle, int mostTexels);
  void trim(Box& box, double texel) const;
  void gather(std::span<const Caster> casters);
  void add(const glm::dvec3* corners, int count, double level);
  void draw();
  glm::dvec2 across(const glm::dvec3& p) const { return {dot(p, right_), dot(p, up_)}; }

  glm::dvec3 sun_{0.0}, right_{0.0}, up_{0.0}, bend_{0.0};
  double base_ = 0.0, stillWater_ = 0.0;
  std::vector<Map> maps_;
  std::vector<Triangle> triangles_;
  std::vector<float> texels_;
  std::array<CoverTiles, most> tiles_;
  glm::ivec2 size_{0};
};

}  // namespace seaway::render
