#include "render/loaded_context.h"

#include <utility>

namespace seaway::render {
namespace {

thread_local LoadedContext* current = nullptr;

/// Whose functions the loader's global pointers are.
GlGetProcedure loaded = nullptr;

}  // namespace

void LoadedContext::makeCurrent() {
  // Mesa's backends share a library that holds the current context: one that does not know that
  // another took its place would take a later call to bind it for a repetition.
  if (current != this) {
    if (current) current->unbind();
    current = nullptr;
    bind();
    current = this;
  }
  if (loaded != getProcedure_) {
    loadGl(getProcedure_);
    loaded = getProcedure_;
  }
}

void LoadedContext::load() {
  makeCurrent();
  description_ = describeGl();
}

void LoadedContext::release() noexcept {
  if (current != this) return;
  current = nullptr;
  unbind();
}

}  // namespace seaway::render
