#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <sstream>

#include "render/edge_smoothing.h"
#include "render/gl/frame_targets.h"
#include "render/gl/object_pass.h"
#include "render/gl/shading_pass.h"
#include "render/gl/sky_pass.h"
#include "render/gl/water_pass.h"
#include "render/headless_context.h"
#include "render/projector.h"
#include "render/render_technique.h"
#include "render/sea_grid.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

void check(const ProjectedGridOptions& options) {
  if (options.grid.x < 2 || options.grid.y < 2) {
    std::ostringstream message;
    message << "projected grid: " << options.grid.x << " x " << options.grid.y
            << " vertices are not allowed; there must be at least 2 each way";
    throw InputError(message.str());
  }
  if (!(options.projectorElevation > 0.0 && std::isfinite(options.projectorElevation))) {
    throw InputError("projected grid: projector elevation must be above 0 m and finite");
  }
}

glm::dvec3 towardsSun(const Light& light) {
  return {std::cos(light.sunElevation) * std::cos(light.sunDirection),
          std::cos(light.sunElevation) * std::sin(light.sunDirection),
          std::sin(light.sunElevation)};
}

/// Depth runs from 1 at the near plane to 0 at infinity, which spreads a float's precision evenly
/// over distances; nothing is cut off far away.
glm::mat4 reversedClipFromRelativeWorld(const Camera& camera) {
  glm::dmat4 clipFromEye = camera.clipFromEye();
  for (int column = 0; column < 4; ++column) clipFromEye[column][2] = 0.0;
  clipFromEye[3][2] = camera.nearDistance;
  return glm::mat4(clipFromEye * camera.eyeFromRelativeWorld());
}

/// Whether any ray of the picture goes above the horizontal: if one does, one at a corner does.
bool seesAboveHorizon(const Camera& camera) {
  const glm::dvec2 last = glm::dvec2(camera.size) - 0.5;
  for (const glm::dvec2 pixel : {glm::dvec2(-0.5, -0.5), glm::dvec2(last.x, -0.5),
                                 glm::dvec2(-0.5, last.y), last}) {
    if (camera.rayThrough(pixel).z > 0.0) return true;
  }
  return false;
}

class ProjectedGridTechnique final : public RenderTechnique {
 public:
  ProjectedGridTechnique(HeadlessContext& context, const ProjectedGridOptions& options)
      : context_(context), options_(options) {
    check(options_);
  }
  ~ProjectedGridTechnique() override { context_.makeCurrent(); }  // for the names it deletes

  std::string name() const override { return "projected_grid"; }
  Frame draw(const View& view) override;

 private:
  /// Runs one pass to its end and notes its time, charged to `effect` where one is given.
  template <typename Pass>
  void timed(const View& view, FrameStats& stats, const char* name, std::optional<Effect> effect,
             Pass pass) {
    const Clock::time_point start = Clock::now();
    pass();
    glFinish();
    const double milliseconds = millisecondsSince(start);
    stats.passesMs.emplace_back(name, milliseconds);
    if (effect) view.effects->charge(*effect, 1e3 * milliseconds);
  }
  void prepareTargets(const Camera& camera);
  bool fillGrid(const View& view, FrameStats& stats);
  struct Drawn {
    bool water = false, objects = false, underWater = false;
  };
  Drawn drawGeometry(const View& view, FrameStats& stats);
  ShadingInput decideLight(const View& view, const Drawn& drawn);
  void shade(const View& view, const Drawn& drawn, FrameStats& stats);
  void holdMemory(EffectLedger& effects) const;

  HeadlessContext& context_;
  ProjectedGridOptions options_;
  SeaGrid grid_;
  GlVertexArray noVertices_;
  std::optional<FrameTargets> targets_;
  std::optional<WaterPass> water_;
  std::optional<ObjectPass> objects_;
  std::optional<SkyPass> sky_;
  std::optional<ShadingPass> shading_;
};

void ProjectedGridTechnique::prepareTargets(const Camera& camera) {
  const int most = context_.maximumSize();
  if (camera.size.x > most || camera.size.y > most) {
    throw InputError("camera: image size " + std::to_string(camera.size.x) + "x" +
                     std::to_string(camera.size.y) +
                     " is not allowed; the graphics context takes " + std::to_string(most) +
                     " pixels at most");
  }
  if (!targets_ || targets_->size != camera.size) {
    targets_.reset();
    targets_.emplace(camera.size);
  }
  if (noVertices_ == 0) noVertices_ = makeVertexArray();
}

/// True if there is water to draw. Where a wave passes the bounds that placed the grid, the grid is
/// placed again with room for it.
bool ProjectedGridTechnique::fillGrid(const View& view, FrameStats& stats) {
  const ProjectorOptions options{.elevation = options_.projectorElevation};
  double bound = view.water->heightBound();
  for (int attempt = 0; attempt < 4; ++attempt) {
    const auto projector = Projector::aimedAt(view.camera, bound, options);
    const bool runs = view.effects->decide(
        Effect::water, projector.has_value(),
        projector ? "the waves' volume meets the camera's view" : "no water in the camera's view");
    if (!runs || !projector) return false;
    grid_.fill(*view.water, view.time, view.camera, *projector, options_.grid);
    if (grid_.largestHeight() <= bound) break;
    bound = 1.05 * grid_.largestHeight();
    ++stats.boundRedraws;
  }
  stats.vertices = grid_.vertices().size();
  stats.vertexEfficiency = static_cast<double>(grid_.verticesInFrustum()) / stats.vertices;
  return true;
}

ProjectedGridTechnique::Drawn ProjectedGridTechnique::drawGeometry(const View& view,
                                                                   FrameStats& stats) {
  Drawn drawn;
  const Clock::time_point start = Clock::now();
  if (view.water) drawn.water = fillGrid(view, stats);
  const double fillMs = millisecondsSince(start);
  stats.passesMs.emplace_back("vertices", fillMs);
  const glm::dvec3 eye = view.camera.position;
  drawn.underWater = drawn.water && eye.z < view.water->sample(glm::dvec2(eye), view.time).height;
  if (drawn.water) view.effects->charge(Effect::water, 1e3 * fillMs);

  glBindFramebuffer(GL_FRAMEBUFFER, targets_->geometry);
  glViewport(0, 0, targets_->size.x, targets_->size.y);
  glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  const float none[4] = {0.0f, 0.0f, 0.0f, 0.0f};
  for (int attachment = 0; attachment < 3; ++attachment) {
    glClearBufferfv(GL_COLOR, attachment, none);
  }
  glClearBufferfi(GL_DEPTH_STENCIL, 0, 0.0f, stencilSky);
  glEnable(GL_STENCIL_TEST);
  glStencilOp(GL_KEEP, GL_KEEP, GL_REPLACE);

  const glm::mat4 clipFromRelativeWorld = reversedClipFromRelativeWorld(view.camera);
  if (drawn.water) {
    timed(view, stats, "water", Effect::water, [&] {
      if (!water_) water_.emplace();
      water_->draw(grid_, clipFromRelativeWorld, drawn.underWater);
    });
  }
  const bool anyInView = std::any_of(view.objects.begin(), view.objects.end(),
                                     [&](const auto& o) { return inView(o, view.camera); });
  drawn.objects =
      view.effects->decide(Effect::vesselMeshes, anyInView,
                           anyInView ? "a vessel is in the camera's view" : "no vessel in view") &&
      anyInView;
  if (drawn.objects) {
    timed(view, stats, "objects", Effect::vesselMeshes, [&] {
      if (!objects_) objects_.emplace();
      objects_->draw(view.objects, view.camera, clipFromRelativeWorld);
    });
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  return drawn;
}

ShadingInput ProjectedGridTechnique::decideLight(const View& view, const Drawn& drawn) {
  ShadingInput input;
  input.view = &view;
  input.sunDirection = glm::vec3(towardsSun(view.light));
  const bool sunIsUp = input.sunDirection.z > -0.01f;  // its disc is half a degree wide
  const bool skyIsSeen = drawn.water || seesAboveHorizon(view.camera);
  const bool sunIsSeen = sunIsUp && (skyIsSeen || drawn.objects);
  input.sunIsOn = view.effects->decide(Effect::sun, sunIsSeen,
                                       sunIsSeen ? "the sun is up"
                                       : sunIsUp ? "nothing that it lights is in view"
                                                 : "the sun is below the horizon");
  const char* sky = drawn.water ? "water reflects it"
                    : skyIsSeen ? "the camera sees above the horizon"
                                : "nothing shows or reflects it";
  if (view.effects->decide(Effect::sky, skyIsSeen, sky)) {
    if (!sky_) sky_.emplace();
    input.skyDome = sky_->dome();
  }
  return input;
}

void ProjectedGridTechnique::shade(const View& view, const Drawn& drawn, FrameStats& stats) {
  glBindVertexArray(noVertices_);
  ShadingInput input = decideLight(view, drawn);
  if (input.skyDome != 0) {
    timed(view, stats, "sky", Effect::sky, [&] { sky_->draw(input.sunDirection); });
  }
  input.waterIsOn = drawn.water;
  input.objectsAreOn = drawn.objects;
  input.cameraIsUnderWater = drawn.underWater;
  // What is shaded pays: nobody, where neither water nor sky is drawn.
  const auto payer = drawn.water            ? std::optional(Effect::water)
                     : input.skyDome != 0 ? std::optional(Effect::sky)
                                          : std::nullopt;
  if (input.sunIsOn && payer) view.effects->chargeInside(Effect::sun, *payer);
  timed(view, stats, "shading", payer, [&] {
    if (!shading_) shading_.emplace();
    shading_->shade(*targets_, input);
  });
  timed(view, stats, "tone_map", std::nullopt, [&] { shading_->mapTones(*targets_, input); });
}

void ProjectedGridTechnique::holdMemory(EffectLedger& effects) const {
  const std::size_t water = grid_.memoryBytes() + (water_ ? water_->memoryBytes() : 0) +
                            (shading_ ? shading_->waterMemoryBytes() : 0);
  if (water > 0) effects.holdMemory(Effect::water, water);
  if (sky_) effects.holdMemory(Effect::sky, sky_->memoryBytes());
  if (objects_) effects.holdMemory(Effect::vesselMeshes, objects_->memoryBytes());
}

Frame ProjectedGridTechnique::draw(const View& view) {
  validate(view.camera);
  context_.makeCurrent();
  prepareTargets(view.camera);

  Frame frame;
  frame.stats.technique = name();
  frame.stats.backend = context_.backend();
  frame.stats.renderer = context_.renderer();
  const Drawn drawn = drawGeometry(view, frame.stats);
  shade(view, drawn, frame.stats);
  timed(view, frame.stats, "readback", std::nullopt, [&] { readBack(*targets_, frame); });
  timed(view, frame.stats, "smoothing", std::nullopt,
        [&] { smoothEdges(frame.colour, frame.depth, frame.classes); });
  holdMemory(*view.effects);
  checkGl("projected grid");
  return frame;
}

}  // namespace

std::unique_ptr<RenderTechnique> makeProjectedGrid(HeadlessContext& context,
                                                   const ProjectedGridOptions& options) {
  return std::make_unique<ProjectedGridTechnique>(context, options);
}

}  // namespace seaway::render
