// Draws the plant with MuJoCo's renderer.
#include "gaitway/simulator/camera.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <stdexcept>

#include "plant_implementation.hpp"

#define EGL_NO_PLATFORM_SPECIFIC_TYPES

namespace gaitway::simulator {

// libEGL is loaded at run time, so that a machine without it can do everything but take pictures. Several
// contexts may live at once and be used from any thread, by one thread at a time. Mesa's surfaceless display
// stays initialised until the process ends: EGL shares it between all contexts.
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

namespace {

[[noreturn]] void refuse(const std::string& cause) {
  throw std::runtime_error("no pictures: " + cause + " (Debian: install libegl1 and libgl1-mesa-dri)");
}

// Never closed: EGL drivers leave threads and exit handlers behind.
void* load_library(const char* name) {
  void* const library = dlopen(name, RTLD_NOW | RTLD_GLOBAL);
  if (library == nullptr) {
    refuse(dlerror());
  }
  return library;
}

template <typename Function>
Function load_function(void* library, const char* name) {
  void* const address = dlsym(library, name);
  if (address == nullptr) {
    refuse(std::string("libEGL lacks ") + name + ", it is older than EGL 1.5");
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
    refuse("EGL offers no surfaceless display");
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
    refuse("EGL gives no OpenGL context");
  }
}

OffscreenContext::~OffscreenContext() {
  egl_->destroy_context(egl_->display, egl_->context);
}

OffscreenContext::Current::Current(const OffscreenContext& context) : context_(context) {
  const Egl& egl = *context.egl_;
  if (egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, egl.context) == EGL_FALSE) {
    refuse("the OpenGL context cannot be used without a surface, or another thread uses it");
  }
}

OffscreenContext::Current::~Current() {
  const Egl& egl = *context_.egl_;
  egl.make_current(egl.display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

namespace {

constexpr int kMaxGeoms = 1000;
constexpr double kDistance_m = 1.5, kAzimuth_deg = -125.0, kElevation_deg = -11.0;
constexpr double kLookAtHeight_m = 0.40;
constexpr double kSunDistance_m = 2.0;

void check_size(int width_px, int height_px) {
  if (width_px < 1 || height_px < 1 || width_px > kLargestPictureWidth_px ||
      height_px > kLargestPictureHeight_px) {
    throw std::invalid_argument("a picture of " + std::to_string(width_px) + " x " +
                                std::to_string(height_px) + " pixels: the camera makes 1 x 1 to " +
                                std::to_string(kLargestPictureWidth_px) + " x " +
                                std::to_string(kLargestPictureHeight_px));
  }
}

}  // namespace

struct Camera::Implementation {
  Implementation(const mjModel* physics_model, double body_size, int width_px, int height_px)
      : size(body_size), model(physics_model), data(mj_makeData(model)), width(width_px), height(height_px) {
    const OffscreenContext::Current current(offscreen);
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjv_defaultCamera(&camera);
    mjr_defaultContext(&context);
    mjv_makeScene(model, &scene, kMaxGeoms);
    mjr_makeContext(model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    camera.type = mjCAMERA_FREE;
    camera.distance = size * kDistance_m;
    camera.azimuth = kAzimuth_deg;
    camera.elevation = kElevation_deg;
    scene.flags[mjRND_REFLECTION] = 0;
  }
  ~Implementation() {
    const OffscreenContext::Current current(offscreen);
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void aim(std::span<const double> positions);

  double size;                 // of the robot, against humanoid22
  OffscreenContext offscreen;  // first: everything below needs it
  const mjModel* model;
  DataPointer data;
  int width, height;
  mjvScene scene;
  mjvOption option;
  mjvCamera camera;
  mjrContext context;
};

// Camera and sun follow the robot: a shadow falls only within the sun's field of view.
void Camera::Implementation::aim(std::span<const double> positions) {
  camera.lookat[0] = positions[0];
  camera.lookat[1] = positions[1];
  camera.lookat[2] = size * kLookAtHeight_m;
  mjv_updateScene(model, data.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
  for (int i = 0; i < scene.nlight; ++i) {
    mjvLight& light = scene.lights[i];
    for (std::size_t axis = 0; light.castshadow != 0 && axis < 3; ++axis) {
      light.pos[axis] = static_cast<float>(camera.lookat[axis] - size * kSunDistance_m * kSunDirection[axis]);
    }
  }
}

Camera::Camera(const Plant& plant, int width_px, int height_px) {
  check_size(width_px, height_px);
  implementation_ = std::make_unique<Implementation>(plant.implementation().model.get(),
                                                     plant.implementation().robot.body_scale().factor("m"),
                                                     width_px, height_px);
}
Camera::~Camera() = default;

Image Camera::render(std::span<const double> positions) {
  Implementation& self = *implementation_;
  if (positions.size() != static_cast<std::size_t>(self.model->nq)) {
    throw std::invalid_argument("a pose of " + std::to_string(positions.size()) +
                                " numbers: this robot's has " + std::to_string(self.model->nq));
  }
  const OffscreenContext::Current current(self.offscreen);
  std::ranges::copy(positions, self.data->qpos);
  mj_kinematics(self.model, self.data.get());
  mj_comPos(self.model, self.data.get());
  mj_camlight(self.model, self.data.get());
  self.aim(positions);
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
