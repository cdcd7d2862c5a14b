#include "tests/bench/accuracy.h"

#include "sim_bridge/cost/rivals/field_models.h"
#include "tests/bench/setups.h"

namespace seaway::bench {
namespace {

Accuracy of(const rivals::FieldModel& model) {
  return {rivals::heightError(model), model.spectralResidual, model.memoryBytes};
}

}  // namespace

std::map<std::string, Accuracy> measureAccuracy() {
  const FrequencySpectrum target = jonswap(benchSea);
  std::map<std::string, Accuracy> result;
  const Accuracy group = of(rivals::groupModel(target, benchOctaves));
  for (const char* name : {"group/12/64", "group/12/1024", "group/12/65536", "height/12/1024",
                           "lattice_lines/12/1024", "single/12", "group_samples/12/1024",
                           "group_orbital/12/1024", "group_avx2/12/1024", "two_threads/65536"}) {
    result[std::string("field/") + name] = group;
  }
  result["field/scalar/12/1024"] = {0.0, group.spectralResidual, group.memoryBytes};
  result["field/perlin/12/1024"] = result["field/perlin_avx2/12/1024"] =
      of(rivals::perlinModel(target, benchOctaves));
  result["field/regular/12/1024"] = of(rivals::regularModel(target, benchOctaves));
  for (const int count : {50, 200, 1000}) {
    result["field/sines/" + std::to_string(count) + "/1024"] = of(rivals::sineModel(target, count));
  }
  result["field/sines_avx2/200/1024"] = result["field/sines/200/1024"];
  for (const std::uint32_t size : {256u, 512u}) {
    const std::string name = "field/fft" + std::to_string(size);
    result[name + "_bilinear/1024"] = of(rivals::fftModel(benchSea, size, false));
    result[name + "_bicubic/1024"] = of(rivals::fftModel(benchSea, size, true));
  }
  result["field/cached_bilinear/1024"] = of(rivals::cachedModel(benchSea, false, 0.0));
  result["field/cached_trilinear/1024"] = of(rivals::cachedModel(benchSea, false, 0.5));
  result["field/cached_cubic/1024"] = of(rivals::cachedModel(benchSea, true, 0.0));
  return result;
}

}  // namespace seaway::bench
