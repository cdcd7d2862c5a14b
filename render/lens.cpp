#include "render/lens.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <utility>

#include "render/edge_smoothing.h"
#include "render/shading/pixel_shader.h"

namespace seaway::render {
namespace {

bool sameLens(const Camera& a, const Camera& b) {
  const auto fields = [](const Camera& c) {
    const Intrinsics i = c.pinhole();
    const Distortion d = c.distortion.value_or(Distortion{});
    return std::array{
        double(c.size.x), double(c.size.y), i.fx, i.fy, i.cx, i.cy, d.k1, d.k2, d.k3, d.p1, d.p2};
  };
  return fields(a) == fields(b);
}

/// Linear radiance between the centres of pixels.
glm::vec3 between(const Frame& frame, glm::vec2 place) {
  const glm::ivec2 size = frame.colour.size;
  const glm::vec2 low = glm::clamp(glm::floor(place), glm::vec2(0.0f), glm::vec2(size - 2));
  const glm::vec2 part = glm::clamp(place - low, 0.0f, 1.0f);
  const glm::vec3* at =
      &frame.radiance[static_cast<std::size_t>(low.y) * size.x + static_cast<std::size_t>(low.x)];
  return glm::mix(glm::mix(at[0], at[1], part.x), glm::mix(at[size.x], at[size.x + 1], part.x),
                  part.y);
}

/// Copies all but colour and radiance of pixel `from` of `wide` to `to`.
void copyPixel(const Frame& wide, std::size_t from, Frame& frame, std::size_t to) {
  frame.depth.metres[to] = wide.depth.metres[from];
  frame.classes[to] = wide.classes[from];
  if (!frame.normals.empty()) frame.normals[to] = wide.normals[from];
  if (!frame.instances.empty()) frame.instances[to] = wide.instances[from];
  if (!frame.foam.empty()) frame.foam[to] = wide.foam[from];
}

class LensTechnique final : public RenderTechnique {
 public:
  explicit LensTechnique(std::unique_ptr<RenderTechnique> technique)
      : technique_(std::move(technique)) {}
  std::string name() const override { return technique_->name(); }
  void drawInto(const View& view, Frame& frame) override;

 private:
  struct KnownLens {
    Camera camera;
    int samples;
    LensMap map;
  };
  const LensMap& mapOf(const Camera& camera, int samples);
  void drawBent(const View& view, Frame& frame);
  void drawOften(const View& view, Frame& frame);
  template <typename Radiance>
  void colour(const View& view, Radiance radianceAt, Frame& frame);

  std::unique_ptr<RenderTechnique> technique_;
  std::vector<KnownLens> lenses_;  // of a few cameras that take turns
  Frame large_;
  std::vector<glm::vec3> row_;
};

const LensMap& LensTechnique::mapOf(const Camera& camera, int samples) {
  for (const KnownLens& lens : lenses_) {
    if (lens.samples == samples && sameLens(lens.camera, camera)) return lens.map;
  }
  if (lenses_.size() == 8) lenses_.erase(lenses_.begin());
  lenses_.push_back({camera, samples, lensMap(camera, samples)});
  return lenses_.back().map;
}

/// Colour, and radiance where it is asked for, of pixels whose samples have `radianceAt(x, y)`.
template <typename Radiance>
void LensTechnique::colour(const View& view, Radiance radianceAt, Frame& frame) {
  const glm::ivec2 size = view.camera.size;
  const int n = view.samplesPerSide;
  const float share = 1.0f / static_cast<float>(n * n);
  frame.exposure = large_.exposure;
  tbb::parallel_for(0, size.y, [&](int y) {
    std::vector<glm::vec3> row(static_cast<std::size_t>(size.x));
    for (int x = 0; x < size.x; ++x) {
      glm::vec3 sum(0.0f);
      for (int i = 0; i < n * n; ++i) sum += radianceAt(n * x + i % n, n * y + i / n);
      row[static_cast<std::size_t>(x)] = sum * share;
    }
    const std::size_t at = static_cast<std::size_t>(y) * size.x;
    mapTones(row, {frame.exposure, view.light.toneCurve, view.light.dithers}, {0, y},
             &frame.colour.rgb[3 * at]);
    if (!frame.radiance.empty()) std::copy(row.begin(), row.end(), frame.radiance.begin() + at);
  });
}

void LensTechnique::drawBent(const View& view, Frame& frame) {
  const LensMap& map = mapOf(view.camera, view.samplesPerSide);
  View wide = view;
  const Camera& camera = view.camera;
  wide.camera = map.wide;
  wide.camera.position = camera.position;
  wide.camera.worldFromCamera = camera.worldFromCamera;
  wide.samplesPerSide = 1;
  wide.wantsRadiance = true;
  technique_->drawInto(wide, large_);
  const auto begin = std::chrono::steady_clock::now();
  prepare(frame, camera.size, view.contents());
  frame.stats = large_.stats;
  colour(
      view,
      [&](int x, int y) {
        return between(large_, map.places[static_cast<std::size_t>(y) * map.size.x + x]);
      },
      frame);
  const int n = view.samplesPerSide;
  for (int y = 0; y < camera.size.y; ++y) {
    for (int x = 0; x < camera.size.x; ++x) {
      // Of an even number of samples none is the pixel's centre: the mean of the two beside it is.
      const auto place = [&](int i, int j) {
        return map.places[static_cast<std::size_t>(n * y + j) * map.size.x + n * x + i];
      };
      const glm::ivec2 nearest(
          glm::round(0.5f * (place((n - 1) / 2, (n - 1) / 2) + place(n / 2, n / 2))));
      copyPixel(large_, static_cast<std::size_t>(nearest.y) * map.wide.size.x + nearest.x, frame,
                static_cast<std::size_t>(y) * camera.size.x + x);
    }
  }
  if (n == 1) smoothEdges(frame.colour, frame.depth, frame.classes);
  frame.stats.passesMs.emplace_back(
      "lens",
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
}

void LensTechnique::drawOften(const View& view, Frame& frame) {
  const int n = view.samplesPerSide;
  validate(view.camera);
  validateSamples(view.camera.size, n);
  View once = view;
  once.samplesPerSide = 1;
  technique_->drawInto(once, frame);  // for all that lies at pixels' centres
  View often = once;
  often.camera.size *= n;
  if (view.camera.intrinsics) {
    often.camera.intrinsics = scaled(*view.camera.intrinsics, view.camera.size, often.camera.size);
  }
  often.wantsNormals = often.wantsLabels = false;
  often.wantsRadiance = true;
  technique_->drawInto(often, large_);
  const auto begin = std::chrono::steady_clock::now();
  frame.stats = large_.stats;
  colour(
      view,
      [&](int x, int y) {
        return large_.radiance[static_cast<std::size_t>(y) * large_.colour.size.x + x];
      },
      frame);
  frame.stats.passesMs.emplace_back(
      "lens",
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - begin).count());
}

void LensTechnique::drawInto(const View& view, Frame& frame) {
  const bool isBent = view.camera.distortion && !view.camera.distortion->isNone();
  if (isBent) {
    drawBent(view, frame);
  } else if (view.samplesPerSide != 1) {
    drawOften(view, frame);
  } else {
    technique_->drawInto(view, frame);
  }
}

}  // namespace

std::unique_ptr<RenderTechnique> makeLens(std::unique_ptr<RenderTechnique> technique) {
  return std::make_unique<LensTechnique>(std::move(technique));
}

}  // namespace seaway::render
