#include "render/headless_context.h"

#include "render/osmesa_context.h"
#include "surface/input_error.h"

namespace seaway::render {
namespace {

struct Backend {
  const char* name;
  std::unique_ptr<HeadlessContext> (*make)();
};

constexpr Backend backends[] = {{"osmesa", &makeOsmesaContext}};

}  // namespace

std::unique_ptr<HeadlessContext> makeHeadlessContext(const std::string& backend) {
  std::string known;
  for (const Backend& candidate : backends) {
    if (backend == candidate.name) return candidate.make();
    known += known.empty() ? candidate.name : std::string(", ") + candidate.name;
  }
  throw InputError("graphics backend '" + backend + "' is not known; there is: " + known);
}

}  // namespace seaway::render
