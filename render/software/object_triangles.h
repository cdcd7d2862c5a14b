#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "render/pixel_box.h"
#include "render/render_technique.h"
#include "render/shading/pixel_shader.h"
#include "render/software/raster.h"

namespace seaway::render {

/// A part of an object, and where light by way of the water shows it.
enum class WaterSide {
  mirrored,  ///< what stands above the water, z → 2h − z
  below,     ///< what is under it, depths divided by the index of refraction
  depths,    ///< what is under it, z → 2h − z: as the underside mirrors it
};

/// The corners of a triangle on one side of a level, those above it for `upwards` 1, below for −1;
/// as many as four. Returns how many.
int cutAtLevel(const glm::vec3 (&corners)[3], float level, float upwards, glm::vec3 (&out)[4]);

/// Scene objects as triangles in the picture, and how each is shaded.
class ObjectTriangles {
 public:
  void fill(std::span<const SceneObject> objects, const Camera& camera);
  /// One side of the objects, cut at the water's height at each, m above still water. Those that
  /// are not finite stand ashore: nothing of them.
  void fill(std::span<const SceneObject> objects, const Camera& camera, WaterSide side,
            std::span<const double> levels);
  /// What stands above the water at each object's `levels`, as an eye `depth` m > 0 under still
  /// water sees it: each point in the direction of the ray to it that Snell's law bends there, at
  /// the length of that ray. Straight edges are followed to a third of a pixel.
  void fillWindow(std::span<const SceneObject> objects, const Camera& camera, double depth,
                  std::span<const double> levels);
  void clear();
  bool empty() const { return triangles_.empty(); }
  void raster(Strip& strip) const;
  std::span<const ScreenTriangle> triangles() const { return triangles_; }

  /// Least and largest axial distance, m.
  std::pair<float, float> axialRange() const { return axialRangeOf(triangles_); }

  /// Pixels of a picture that the triangles may touch.
  PixelBox boxIn(glm::ivec2 picture) const { return boxOf(triangles_, picture); }
  /// Pixels of the strip that they may touch.
  PixelBox boxIn(const Strip& strip) const;

  /// Makes those pixels of the span that show an object ones to be shaded so. `which` as
  /// Strip::object, `inverse` as Strip::inverse.
  void fillSpan(const std::uint32_t* which, const float* inverse, PixelSpan& span) const;

  /// SceneObject::instance of what Strip::object says; 0 of 0.
  std::uint16_t instanceOf(std::uint32_t which) const {
    return which == 0 ? std::uint16_t{0} : faces_[which - 1].instance;
  }

  std::size_t memoryBytes() const;

 private:
  struct Face {
    glm::vec3 normal, colour;
    std::uint16_t instance = 0;
    float level = 0.0f, scale = 1.0f;  // of PixelSpan's place
  };
  struct Window;
  struct Bent;
  struct Half {
    WaterSide side;
    float level;  // relative to the camera, m
  };
  void add(const SceneObject& object, const Camera& camera, const Half* half);
  void add(const glm::vec3 (&corners)[3], const Face& face, const ScreenProjection& projection,
           bool mirrored);
  void addBent(const Bent (&corners)[3], const Face& face, const Window& window, int splits);

  std::vector<ScreenTriangle> triangles_;
  std::vector<Face> faces_;  // of object number − 1
  bool isMoved_ = false;     // by way of the water: not where it is
};

}  // namespace seaway::render
