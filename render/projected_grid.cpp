#include <chrono>
#include <glm/common.hpp>
#include <optional>

#include "render/edge_smoothing.h"
#include "render/gl/boundary_passes.h"
#include "render/gl/compute_shading.h"
#include "render/gl/frame_targets.h"
#include "render/gl/gpu_clock.h"
#include "render/gl/object_pass.h"
#include "render/gl/sea_geometry_pass.h"
#include "render/gl/shading_pass.h"
#include "render/grid_placement.h"
#include "render/headless_context.h"
#include "render/hollows.h"
#include "render/lighting_decision.h"
#include "render/render_technique.h"
#include "render/shore.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

using Clock = std::chrono::steady_clock;

double millisecondsSince(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

class ProjectedGridTechnique final : public RenderTechnique {
 public:
  ProjectedGridTechnique(HeadlessContext& context, const ProjectedGridOptions& options)
      : context_(context), options_(options), gpuClock_(!context.isSoftware()) {
    validate(options_);
  }
  ~ProjectedGridTechnique() override { context_.makeCurrent(); }  // for the names it deletes

  std::string name() const override { return "projected_grid"; }
  void drawInto(const View& view, Frame& frame) override;

 private:
  /// Runs one pass to its end and notes its time, charged to `effect` where one is given.
  template <typename Pass>
  void timed(const View& view, FrameStats& stats, const char* name, std::optional<Effect> effect,
             Pass pass) {
    const Clock::time_point start = Clock::now();
    gpuClock_.start(name);
    pass();
    gpuClock_.stop();
    if (options_.readBack) glFinish();
    const double milliseconds = millisecondsSince(start);
    stats.passesMs.emplace_back(name, milliseconds);
    if (effect) view.effects->charge(*effect, 1e3 * milliseconds);
  }
  void prepareTargets(const Camera& camera);
  Shown drawGeometry(const View& view, FrameStats& stats);
  void keepTo(const WaterOutline& outline, const View& view) const;
  void drawBoundaries(const View& view, const Shown& shown, FrameStats& stats);
  void shade(const View& view, const Shown& shown, FrameStats& stats);
  void read(const View& view, Frame& frame);
  void holdMemory(EffectLedger& effects) const;
  /// Hardware shades in compute: see ComputeShading.
  bool shadesInCompute() const {
    return !context_.isSoftware() || options_.variant == GridVariant::marched;
  }

  HeadlessContext& context_;
  ProjectedGridOptions options_;
  GlVertexArray noVertices_;
  std::optional<FrameTargets> targets_;
  std::unique_ptr<SeaGeometryPass> sea_;
  std::optional<ObjectPass> objects_;
  std::optional<GroundPass> ground_;
  std::optional<HullMaskPass> hullMask_;
  bool groundIsShown_ = false;
  std::optional<SkyDome> sky_;
  LocalLight local_;
  ShadingConstants constants_;  // of this frame
  std::optional<ShadingPass> shading_;
  std::optional<ComputeShading> computeShading_;
  GpuClock gpuClock_;
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

Shown ProjectedGridTechnique::drawGeometry(const View& view, FrameStats& stats) {
  Shown shown;
  const Clock::time_point start = Clock::now();
  const auto place = [&](const Projector& projector) {
    if (!sea_) sea_ = makeSeaGeometryPass(options_.variant);
    return sea_->place(view, projector, options_.grid);
  };
  shown.water = placeSea(view, options_.projectorElevation, place, stats).has_value();
  const double fillMs = millisecondsSince(start);
  stats.passesMs.emplace_back("vertices", fillMs);
  shown.cameraIsUnderWater = shown.water && cameraIsUnderWater(view);
  if (shown.water) view.effects->charge(Effect::water, 1e3 * fillMs);

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

  const glm::mat4 clipFromRelativeWorld(reversedClipFromRelativeWorld(view.camera));
  if (shown.water) {
    timed(view, stats, "water", Effect::water, [&] {
      if (const WaterOutline* outline = view.water->outline()) keepTo(*outline, view);
      sea_->draw(*targets_, clipFromRelativeWorld, shown.cameraIsUnderWater);
      glDisable(GL_SCISSOR_TEST);
    });
  }
  drawBoundaries(view, shown, stats);
  shown.objects = decideObjects(view);
  if (shown.objects) {
    timed(view, stats, "objects", Effect::vesselMeshes, [&] {
      if (!objects_) objects_.emplace();
      objects_->draw(view.objects, view.camera, clipFromRelativeWorld);
    });
  }
  glDisable(GL_DEPTH_TEST);
  glDisable(GL_STENCIL_TEST);
  return shown;
}

void ProjectedGridTechnique::keepTo(const WaterOutline& outline, const View& view) const {
  const PixelBox box = pixelsOf(outline, view.camera, view.water->heightBound(view.time));
  const glm::ivec2 size = glm::max(box.end - box.least, 0);
  glScissor(box.least.x, targets_->size.y - box.end.y, size.x, size.y);
  glEnable(GL_SCISSOR_TEST);
}

void ProjectedGridTechnique::drawBoundaries(const View& view, const Shown& shown,
                                            FrameStats& stats) {
  groundIsShown_ = decideOutline(view, shown.water) != nullptr;
  const std::vector<PlacedHollow> hollows = decideHollows(view, shown.water);
  if (groundIsShown_ || !hollows.empty()) glBindVertexArray(noVertices_);
  if (groundIsShown_) {
    timed(view, stats, "ground", Effect::outline, [&] {
      if (!ground_) ground_.emplace();
      ground_->draw(*targets_, view);
    });
  }
  if (!hollows.empty()) {
    timed(view, stats, "hull_mask", Effect::hullMask, [&] {
      if (!hullMask_) hullMask_.emplace();
      hullMask_->draw(*targets_, view.camera, hollows);
    });
  }
}

void ProjectedGridTechnique::shade(const View& view, const Shown& shown, FrameStats& stats) {
  glBindVertexArray(noVertices_);
  Lighting lighting;
  timed(view, stats, "sky", std::nullopt, [&] { lighting = decideLighting(view, shown, sky_); });
  if (lighting.sky) view.effects->charge(Effect::sky, 1e3 * stats.passesMs.back().second);
  if (!lighting.sky) stats.passesMs.pop_back();
  ShadingInput input;
  input.constants = shadingConstants(view, lighting);
  input.sky = lighting.sky;
  input.local = &local_;
  local_.fill(view, shown, input.constants, lighting.sky ? lighting.sky->texels().data() : nullptr);
  local_.setConstants(input.constants);
  constants_ = input.constants;
  input.waterIsOn = shown.water;
  input.objectsAreOn = shown.objects || groundIsShown_;
  // What is shaded pays: nobody, where neither water nor sky is drawn.
  std::optional<Effect> payer;
  if (shown.water || lighting.sky) payer = shown.water ? Effect::water : Effect::sky;
  if (lighting.sunIsOn && payer) view.effects->chargeInside(Effect::sun, *payer);
  if (shadesInCompute()) {
    timed(view, stats, "shading", payer, [&] {
      if (!computeShading_) computeShading_.emplace();
      computeShading_->shade(*targets_, input, view.wantsRadiance);
    });
    return;
  }
  timed(view, stats, "shading", payer, [&] {
    if (!shading_) shading_.emplace();
    shading_->shade(*targets_, input);
  });
  timed(view, stats, "tone_map", std::nullopt, [&] { shading_->mapTones(*targets_, input); });
}

void ProjectedGridTechnique::holdMemory(EffectLedger& effects) const {
  std::size_t water = sea_ ? sea_->memoryBytes() : 0, sky = sky_ ? sky_->memoryBytes() : 0;
  const auto addTextures = [&](const auto& shading) {
    if (!shading) return;
    water += shading->waterMemoryBytes();
    sky += shading->skyMemoryBytes();
  };
  addTextures(shading_);
  addTextures(computeShading_);
  if (water > 0) effects.holdMemory(Effect::water, water);
  if (sky > 0) effects.holdMemory(Effect::sky, sky);
  if (ground_) effects.holdMemory(Effect::outline, ground_->memoryBytes());
  if (objects_) effects.holdMemory(Effect::vesselMeshes, objects_->memoryBytes());
}

void ProjectedGridTechnique::read(const View& view, Frame& frame) {
  if (!options_.readBack) {
    glFinish();
    return;
  }
  timed(view, frame.stats, "readback", std::nullopt, [&] {
    readBack(*targets_, groundIsShown_, frame);
    readContents(*targets_, view.objects, constants_, frame);
  });
  frame.exposure = constants_.exposure;
  timed(view, frame.stats, "smoothing", std::nullopt,
        [&] { smoothEdges(frame.colour, frame.depth, frame.classes); });
}

void ProjectedGridTechnique::drawInto(const View& view, Frame& frame) {
  validatePlain(view);
  context_.makeCurrent();
  prepareTargets(view.camera);
  prepare(frame, options_.readBack ? view.camera.size : glm::ivec2(0), view.contents());
  frame.stats.technique = name();
  frame.stats.variant = gridVariantName(options_.variant);
  frame.stats.backend = context_.backend();
  frame.stats.renderer = context_.renderer();
  const Shown shown = drawGeometry(view, frame.stats);
  shade(view, shown, frame.stats);
  read(view, frame);
  holdMemory(*view.effects);
  if (sea_) frame.stats.gpuMs = sea_->gpuMs();
  for (auto& pass : gpuClock_.collect()) frame.stats.gpuMs.push_back(std::move(pass));
  checkGl("projected grid");
}

}  // namespace

std::string_view gridVariantName(GridVariant variant) {
  switch (variant) {
    case GridVariant::cpuVertices:
      return "cpu_vertices";
    case GridVariant::gpu:
      return "gpu";
    case GridVariant::cpuVerticesGpuNormals:
      return "cpu_vertices_gpu_normals";
    case GridVariant::marched:
      return "marched";
    case GridVariant::software:
      return "software";
  }
  return "";
}

std::unique_ptr<RenderTechnique> makeProjectedGrid(HeadlessContext& context,
                                                   const ProjectedGridOptions& options) {
  return std::make_unique<ProjectedGridTechnique>(context, options);
}

}  // namespace seaway::render
