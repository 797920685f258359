// Draws the plant with MuJoCo's renderer.
#include "gaitway/simulator/camera.hpp"

#include <algorithm>
#include <stdexcept>

#include "camera_context.hpp"
#include "plant_implementation.hpp"

namespace gaitway::simulator {
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
  Implementation(const mjModel* physics_model, int width_px, int height_px)
      : model(physics_model), data(mj_makeData(model)), width(width_px), height(height_px) {
    const OffscreenContext::Current current(offscreen);
    mjv_defaultScene(&scene);
    mjv_defaultOption(&option);
    mjv_defaultCamera(&camera);
    mjr_defaultContext(&context);
    mjv_makeScene(model, &scene, kMaxGeoms);
    mjr_makeContext(model, &context, mjFONTSCALE_100);
    mjr_setBuffer(mjFB_OFFSCREEN, &context);
    camera.type = mjCAMERA_FREE;
    camera.distance = kDistance_m;
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
  camera.lookat[2] = kLookAtHeight_m;
  mjv_updateScene(model, data.get(), &option, nullptr, &camera, mjCAT_ALL, &scene);
  for (int i = 0; i < scene.nlight; ++i) {
    mjvLight& light = scene.lights[i];
    for (std::size_t axis = 0; light.castshadow != 0 && axis < 3; ++axis) {
      light.pos[axis] = static_cast<float>(camera.lookat[axis] - kSunDistance_m * kSunDirection[axis]);
    }
  }
}

Camera::Camera(const Plant& plant, int width_px, int height_px) {
  check_size(width_px, height_px);
  implementation_ = std::make_unique<Implementation>(plant.implementation().model.get(), width_px, height_px);
}
Camera::~Camera() = default;

Image Camera::render(std::span<const double> positions) {
  Implementation& self = *implementation_;
  if (positions.size() != static_cast<std::size_t>(self.model->nq)) {
    throw std::invalid_argument("a pose of " + std::to_string(positions.size()) +
                                " numbers: this robot's has " + std::to_string(self.model->nq));
  }
  const OffscreenContext::Current current(self.offscreen);
  std::copy(positions.begin(), positions.end(), self.data->qpos);
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
