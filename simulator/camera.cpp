// Draws the plant with MuJoCo's renderer.
#include "gaitway/simulator/camera.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "gaitway/facts/facts.hpp"
#include "offscreen_context.hpp"
#include "plant_implementation.hpp"

namespace gaitway::simulator {

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
