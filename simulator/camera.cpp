// Draws the plant with MuJoCo's renderer.
#include "gaitway/simulator/camera.hpp"

#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <dlfcn.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "gaitway/facts/facts.hpp"
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
constexpr double kSunDistance_m = 2.3;
constexpr double kShadowsWithin_m = 4.0;  // further away the sun sees only a part of the picture

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
  Implementation(const Plant::Implementation& plant, int width_px, int height_px)
      : size(plant.robot.body_scale().factor("m")),
        links(static_cast<int>(plant.robot.links.size())),
        in_world(plant.world.has_value()),
        model(plant.model.get()),
        data(mj_makeData(model)),
        width(width_px),
        height(height_px) {
    const OffscreenContext::Current current(offscreen);
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjv_defaultCamera(&camera);
    mjr_defaultContext(&context);
    mjv_makeScene(model, &scene, kMaxGeoms + static_cast<int>(model->ngeom));
    mjr_makeContext(model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    camera.type = mjCAMERA_FREE;
    scene.flags[mjRND_REFLECTION] = 0;
  }
  ~Implementation() {
    const OffscreenContext::Current current(offscreen);
    mjr_freeContext(&context);
    mjv_freeScene(&scene);
  }
  Implementation(const Implementation&) = delete;
  Implementation& operator=(const Implementation&) = delete;

  void pose(std::span<const double> positions);
  [[nodiscard]] View beside_robot() const;
  [[nodiscard]] bool sees(const View& view) const;
  void aim(const View& view);
  [[nodiscard]] Image draw();

  double size;  // of the robot, against humanoid22
  int links;
  bool in_world;
  OffscreenContext offscreen;  // first: everything below needs it
  const mjModel* model;
  DataPointer data;
  int width, height;
  mjvScene scene;
  mjvOption option;
  mjvCamera camera;
  mjrContext context;
};

void Camera::Implementation::pose(std::span<const double> positions) {
  if (positions.size() != static_cast<std::size_t>(model->nq)) {
    throw std::invalid_argument("a pose of " + std::to_string(positions.size()) +
                                " numbers: this robot's has " + std::to_string(model->nq));
  }
  std::ranges::copy(positions, data->qpos);
  mj_kinematics(model, data.get());
  mj_comPos(model, data.get());
  mj_camlight(model, data.get());
}

// Whether the line of sight meets the robot first, or nothing.
bool Camera::Implementation::sees(const View& view) const {
  const double azimuth = view.azimuth_deg * facts::kRadPerDegree;
  const double elevation = view.elevation_deg * facts::kRadPerDegree;
  const Eigen::Vector3d ahead(std::cos(elevation) * std::cos(azimuth),
                              std::cos(elevation) * std::sin(azimuth), std::sin(elevation));
  const Eigen::Vector3d from = view.look_at_m - view.distance_m * ahead;
  int geom = -1;
  const double distance_m =
      mj_ray(model, data.get(), from.data(), ahead.data(), nullptr, 1, -1, &geom, nullptr);
  if (geom < 0 || distance_m > view.distance_m) return true;
  return model->geom_bodyid[geom] >= 1 && model->geom_bodyid[geom] <= links;
}

View Camera::Implementation::beside_robot() const {
  const View usual{.look_at_m = {data->qpos[0], data->qpos[1], size * kLookAtHeight_m},
                   .distance_m = size * kDistance_m,
                   .azimuth_deg = kAzimuth_deg,
                   .elevation_deg = kElevation_deg};
  if (!in_world) return usual;
  for (const double aside_deg : {0.0, 25.0, -25.0, 50.0, -50.0, 80.0, -80.0, 120.0, -120.0, 180.0}) {
    View view = usual;
    view.azimuth_deg += aside_deg;
    if (sees(view)) return view;
  }
  return usual;
}

// The sun follows the camera: a shadow falls only within the sun's field of view.
void Camera::Implementation::aim(const View& view) {
  std::copy_n(view.look_at_m.data(), 3, camera.lookat);
  camera.distance = view.distance_m;
  camera.azimuth = view.azimuth_deg;
  camera.elevation = view.elevation_deg;
  mjv_updateScene(model, data.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
  for (int i = 0; i < scene.nlight; ++i) {
    mjvLight& light = scene.lights[i];
    const bool is_sun = light.type == mjLIGHT_DIRECTIONAL && light.headlight == 0;
    for (std::size_t axis = 0; is_sun && axis < 3; ++axis) {
      light.pos[axis] = static_cast<float>(camera.lookat[axis] -
                                           size * kSunDistance_m * static_cast<double>(light.dir[axis]));
    }
  }
}

Image Camera::Implementation::draw() {
  const mjrRect viewport{0, 0, width, height};
  mjr_render(viewport, &scene, &context);
  const std::size_t row = static_cast<std::size_t>(width) * 3;
  std::vector<std::uint8_t> upside_down(row * static_cast<std::size_t>(height));
  mjr_readPixels(upside_down.data(), nullptr, viewport, &context);
  Image image{.width_px = width, .height_px = height, .rgb = {}};
  image.rgb.reserve(upside_down.size());
  for (auto end = upside_down.end(); end != upside_down.begin(); end -= static_cast<std::ptrdiff_t>(row)) {
    image.rgb.insert(image.rgb.end(), end - static_cast<std::ptrdiff_t>(row), end);
  }
  return image;
}

Camera::Camera(const Plant& plant, int width_px, int height_px) {
  check_size(width_px, height_px);
  implementation_ = std::make_unique<Implementation>(plant.implementation(), width_px, height_px);
}
Camera::~Camera() = default;

Image Camera::render(std::span<const double> positions) {
  Implementation& self = *implementation_;
  const OffscreenContext::Current current(self.offscreen);
  self.pose(positions);
  self.aim(self.beside_robot());
  return self.draw();
}

Image Camera::render(std::span<const double> positions, const View& view) {
  Implementation& self = *implementation_;
  const OffscreenContext::Current current(self.offscreen);
  self.pose(positions);
  self.aim(view);
  for (int i = 0; i < self.scene.nlight; ++i) {  // the sun is enough for one who looks straight down
    mjvLight& light = self.scene.lights[i];
    if (light.headlight != 0) std::fill_n(light.diffuse, 3, 0.0F);
  }
  self.scene.flags[mjRND_SHADOW] = view.distance_m < kShadowsWithin_m ? 1 : 0;
  Image image = self.draw();
  self.scene.flags[mjRND_SHADOW] = 1;
  return image;
}

}  // namespace gaitway::simulator
