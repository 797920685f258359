// Draws the plant with MuJoCo's renderer in a surfaceless EGL context.
#include "gaitway/simulator/camera.hpp"

#define EGL_EGLEXT_PROTOTYPES
#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <algorithm>
#include <stdexcept>

#include "plant_implementation.hpp"

namespace gaitway::simulator {
namespace {

// An OpenGL context without a window, current on this thread as long as it lives.
class OffscreenContext {
 public:
  OffscreenContext() : display_(eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr)) {
    if (display_ == EGL_NO_DISPLAY || eglInitialize(display_, nullptr, nullptr) == EGL_FALSE) {
      throw std::runtime_error("EGL offers no surfaceless display (Debian: install libegl1 and libgl1-mesa-dri)");
    }
    constexpr EGLint kConfig[] = {EGL_SURFACE_TYPE, EGL_PBUFFER_BIT, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT,
                                  EGL_DEPTH_SIZE,   24,              EGL_NONE};
    EGLConfig config = nullptr;
    EGLint found = 0;
    eglBindAPI(EGL_OPENGL_API);
    eglChooseConfig(display_, kConfig, &config, 1, &found);
    context_ = eglCreateContext(display_, found > 0 ? config : EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, nullptr);
    if (context_ == EGL_NO_CONTEXT || eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_) == EGL_FALSE) {
      eglTerminate(display_);
      throw std::runtime_error("EGL gives no OpenGL context (Debian: install libgl1-mesa-dri)");
    }
  }
  ~OffscreenContext() {
    eglMakeCurrent(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
    eglDestroyContext(display_, context_);
    eglTerminate(display_);
  }
  OffscreenContext(const OffscreenContext&) = delete;
  OffscreenContext& operator=(const OffscreenContext&) = delete;

 private:
  EGLDisplay display_;
  EGLContext context_ = EGL_NO_CONTEXT;
};

constexpr int kMaxGeoms = 1000;

}  // namespace

struct Camera::Implementation {
  Implementation(const mjModel* physics_model, int width_px, int height_px)
      : model(physics_model), data(mj_makeData(model)), width(width_px), height(height_px) {
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjv_defaultCamera(&camera);
    mjr_defaultContext(&context);
    mjv_makeScene(model, &scene, kMaxGeoms);
    mjr_makeContext(model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    camera.type = mjCAMERA_FREE;
    camera.distance = 1.55;
    camera.azimuth = -125.0;
    camera.elevation = -12.0;
    scene.flags[mjRND_REFLECTION] = 0;
  }
  ~Implementation() {
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  OffscreenContext offscreen;  // first: everything below needs it
  const mjModel* model;
  DataPointer data;
  int width, height;
  mjvScene scene;
  mjvOption option;
  mjvCamera camera;
  mjrContext context;
};

Camera::Camera(const Plant& plant, int width_px, int height_px)
    : implementation_(std::make_unique<Implementation>(plant.implementation().model.get(), width_px, height_px)) {}
Camera::~Camera() = default;

Image Camera::render(std::span<const double> positions) {
  Implementation& self = *implementation_;
  std::copy(positions.begin(), positions.end(), self.data->qpos);
  mj_forward(self.model, self.data.get());
  for (int axis = 0; axis < 2; ++axis) {
    self.camera.lookat[axis] = positions[static_cast<std::size_t>(axis)];
  }
  self.camera.lookat[2] = 0.40;
  mjv_updateScene(self.model, self.data.get(), &self.option, nullptr, &self.camera, mjCAT_ALL, &self.scene);
  const mjrRect viewport{0, 0, self.width, self.height};
  mjr_render(viewport, &self.scene, &self.context);
  const std::size_t row = static_cast<std::size_t>(self.width) * 3;
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(self.height));
  mjr_readPixels(upside_down.data(), nullptr, viewport, &self.context);
  Image image{.width_px = self.width, .height_px = self.height, .rgb = {}};
  image.rgb.reserve(upside_down.size());
  for (auto end = upside_down.end(); end != upside_down.begin(); end -= static_cast<std::ptrdiff_t>(row)) {
    image.rgb.insert(image.rgb.end(), end - static_cast<std::ptrdiff_t>(row), end);
  }
  return image;
}

}  // namespace gaitway::simulator
