// An OpenGL context without a display.
#pragma once

#include <memory>

namespace gaitway::simulator {

// libEGL is loaded at run time, so that a machine without it can do everything but take pictures. Several
// contexts may live at once and be used from any thread, by one thread at a time. Mesa's surfaceless display
// stays initialised until the process ends: EGL shares it between all contexts. Drawing has no threads of its
// own, so that a copy of the process that fork() made draws on with the contexts that it finds in its memory.
class OffscreenContext {
 public:
  OffscreenContext();  // throws std::runtime_error naming what is missing and the package that brings it
  ~OffscreenContext();
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

  // Makes the context current on this thread as long as it lives. Throws std::runtime_error.
  class Current {
   public:
    explicit Current(const OffscreenContext& context);
    ~Current();
    Current(const Current&) = delete;
    Current& operator=(const Current&) = delete;

   private:
    const OffscreenContext& context_;
  };

 private:
  struct Egl;
  std::unique_ptr<Egl> egl_;
};

}  // namespace gaitway::simulator
