// libEGL and Mesa.
#include "offscreen_context.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <cstdlib>
#include <stdexcept>
#include <string>

#define EGL_NO_PLATFORM_SPECIFIC_TYPES

namespace gaitway::simulator {
namespace {

[[noreturn]] void refuse_pictures(const std::string& cause) {
  throw std::runtime_error("no pictures: " + cause + " (Debian: install libegl1 and libgl1-mesa-dri)");
}

// Never closed: EGL drivers leave threads and exit handlers behind. Mesa looks at these when it is loaded: no
// threads that rasterise, and none that keeps compiled shaders on the disk. Who has set them otherwise wants
// so.
void* load_library(const char* name) {
  constexpr int kKeep = 0;
  setenv("LP_NUM_THREADS", "0", kKeep);
  setenv("MESA_SHADER_CACHE_DISABLE", "true", kKeep);
  void* const library = dlopen(name, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) {
    refuse_pictures(dlerror());
  }
  return library;
}

template <typename Function>
Function load_function(void* library, const char* name) {
  void* const address = dlsym(library, name);
  if (address == nullptr) {
    refuse_pictures(std::string("libEGL lacks ") + name + ", it is older than EGL 1.5");
  }
  return reinterpret_cast<Function>(address);
}

}  // namespace

struct OffscreenContext::Egl {
  explicit Egl(void* library)
      : get_platform_display(load_function<PFNEGLGETPLATFORMDISPLAYPROC>(library, "eglGetPlatformDisplay")),
        initialize(load_function<PFNEGLINITIALIZEPROC>(library, "eglInitialize")),
        bind_api(load_function<PFNEGLBINDAPIPROC>(library, "eglBindAPI")),
        choose_config(load_function<PFNEGLCHOOSECONFIGPROC>(library, "eglChooseConfig")),
        create_context(load_function<PFNEGLCREATECONTEXTPROC>(library, "eglCreateContext")),
        destroy_context(load_function<PFNEGLDESTROYCONTEXTPROC>(library, "eglDestroyContext")),
        make_current(load_function<PFNEGLMAKECURRENTPROC>(library, "eglMakeCurrent")) {}

  PFNEGLGETPLATFORMDISPLAYPROC get_platform_display;
  PFNEGLINITIALIZEPROC initialize;
  PFNEGLBINDAPIPROC bind_api;
  PFNEGLCHOOSECONFIGPROC choose_config;
  PFNEGLCREATECONTEXTPROC create_context;
  PFNEGLDESTROYCONTEXTPROC destroy_context;
  PFNEGLMAKECURRENTPROC make_current;
  EGLDisplay display = EGL_NO_DISPLAY;
  EGLContext context = EGL_NO_CONTEXT;
};

OffscreenContext::OffscreenContext() : egl_(std::make_unique<Egl>(load_library("libEGL.so.1"))) {
  Egl& egl = *egl_;
  egl.display = egl.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (egl.display == EGL_NO_DISPLAY || egl.initialize(egl.display, nullptr, nullptr) == EGL_FALSE) {
    refuse_pictures("EGL offers no surfaceless display");
  }
  constexpr EGLint kConfig[] = {
      EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_DEPTH_SIZE, 24, EGL_NONE};
  EGLConfig config = EGL_NO_CONFIG_KHR;
  EGLint found = 0;
  egl.bind_api(EGL_OPENGL_API);
  if (egl.choose_config(egl.display, kConfig, &config, 1, &found) == EGL_FALSE || found == 0) {
    config = EGL_NO_CONFIG_KHR;
  }
  egl.context = egl.create_context(egl.display, config, EGL_NO_CONTEXT, nullptr);
  if (egl.context == EGL_NO_CONTEXT) {
    refuse_pictures("EGL gives no OpenGL context");
  }
}

OffscreenContext::~OffscreenContext() {
  egl_->destroy_context(egl_->display, egl_->context);
}

OffscreenContext::Current::Current(const OffscreenContext& context) : context_(context) {
  const Egl& egl = *context.egl_;
  if (egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl.context) == EGL_FALSE) {
    refuse_pictures("the OpenGL context cannot be used without a surface, or another thread uses it");
  }
}

OffscreenContext::Current::~Current() {
  const Egl& egl = *context_.egl_;
  egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

}  // namespace gaitway::simulator
