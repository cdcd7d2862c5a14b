#include "render/technique_choice.h"

#include <algorithm>
#include <array>
#include <utility>

#include "render/headless_context.h"
#include "render/lens.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

constexpr std::array<std::string_view, 5> techniques = {"projected_grid", "radial_grid",
                                                        "post_process", "naive_grid", "reference"};
constexpr GridVariant variants[] = {GridVariant::software, GridVariant::cpuVertices,
                                    GridVariant::gpu, GridVariant::cpuVerticesGpuNormals,
                                    GridVariant::marched};

/// A technique and the context that it draws through.
class WithContext final : public RenderTechnique {
 public:
  WithContext(std::unique_ptr<HeadlessContext> context, const ProjectedGridOptions& options)
      : context_(std::move(context)), technique_(makeProjectedGrid(*context_, options)) {}
  std::string name() const override { return technique_->name(); }
  void drawInto(const View& view, Frame& frame) override { technique_->drawInto(view, frame); }

 private:
  std::unique_ptr<HeadlessContext> context_;
  std::unique_ptr<RenderTechnique> technique_;  // goes first
};

void requireKnown(const char* what, const std::string& name,
                  std::span<const std::string_view> known) {
  if (std::find(known.begin(), known.end(), name) != known.end()) return;
  std::string all;
  for (const std::string_view other : known) all += (all.empty() ? "" : ", ") + std::string(other);
  throw InputError(std::string(what) + " '" + name + "' is not known; there is: " + all);
}

std::unique_ptr<RenderTechnique> automaticGrid(const TechniqueChoice& choice) {
  ProjectedGridOptions options{.grid = choice.grid};
  if (choice.backend == "osmesa") return makeSoftwareGrid(options);
  auto context = makeHeadlessContext(choice.backend);
  if (context->isSoftware()) return makeSoftwareGrid(options);
  options.variant = GridVariant::marched;
  return std::make_unique<WithContext>(std::move(context), options);
}

}  // namespace

std::span<const std::string_view> techniqueNames() { return techniques; }

std::span<const std::string_view> variantNames() {
  static const auto names = [] {
    std::array<std::string_view, std::size(variants) + 1> all{"automatic"};
    for (std::size_t i = 0; i < std::size(variants); ++i) {
      all[i + 1] = gridVariantName(variants[i]);
    }
    return all;
  }();
  return names;
}

namespace {

std::unique_ptr<RenderTechnique> makePinhole(const TechniqueChoice& choice) {
  requireKnown("technique", choice.technique, techniqueNames());
  requireKnown("variant", choice.variant, variantNames());
  if (choice.technique != "projected_grid" && choice.variant != "automatic") {
    throw InputError("variant '" + choice.variant + "' is not allowed: technique '" +
                     choice.technique + "' has none");
  }
  ProjectedGridOptions options{.grid = choice.grid};
  if (choice.technique == "reference") return makeReference(options);
  if (choice.technique == "radial_grid") return makeRadialGrid({.grid = choice.grid});
  if (choice.technique == "post_process") return makePostProcess({.grid = choice.grid});
  if (choice.technique == "naive_grid") return makeNaiveGrid({.grid = choice.grid});
  if (choice.variant == "automatic") return automaticGrid(choice);
  options.variant = *std::find_if(std::begin(variants), std::end(variants), [&](GridVariant v) {
    return gridVariantName(v) == choice.variant;
  });
  if (options.variant == GridVariant::software) return makeSoftwareGrid(options);
  return std::make_unique<WithContext>(makeHeadlessContext(choice.backend), options);
}

}  // namespace

std::unique_ptr<RenderTechnique> makeTechnique(const TechniqueChoice& choice) {
  return makeLens(makePinhole(choice));
}

}  // namespace seaway::render
