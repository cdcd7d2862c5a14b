#pragma once

#include "render/gl/loader.h"
#include "render/headless_context.h"

namespace seaway::render {

/// What all backends share: which context a thread draws with, and whose OpenGL is loaded.
///
/// A backend's constructor calls `load` last, its destructor `release` first.
class LoadedContext : public HeadlessContext {
 public:
  void makeCurrent() final;
  std::string renderer() const final { return description_.renderer; }
  std::string version() const final { return description_.version; }
  int maximumSize() const final { return description_.maximumSize; }
  bool isSoftware() const final { return description_.isSoftware; }

 protected:
  explicit LoadedContext(GlGetProcedure getProcedure) : getProcedure_(getProcedure) {}

  /// Makes the context current and asks it what it is. Throws std::runtime_error where it offers
  /// less than OpenGL 4.5.
  void load();
  /// Lets go of the context if it is current on this thread.
  void release() noexcept;

 private:
  /// Makes the backend's context current while none of another backend is.
  virtual void bind() = 0;
  virtual void unbind() noexcept = 0;

  GlGetProcedure getProcedure_;
  GlDescription description_;
};

}  // namespace seaway::render
