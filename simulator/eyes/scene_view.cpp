// MuJoCo's renderer behind a pinhole.
#include "scene_view.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "plant_implementation.hpp"

namespace gaitway::simulator {
namespace {

constexpr int kMoreGeoms = 100;  // than the model has: what MuJoCo adds of its own
constexpr int kHiddenGroup = 5;  // of geoms
constexpr float kNearest_m = 0.02F, kFarthest_m = 100.0F;
constexpr double kSunAway_m = 4.0;
constexpr float kAmbient = 0.42F;  // light that comes from everywhere

// The plant's model as the camera's light has it: no lamp on the camera's head, another shadow map.
ModelPointer drawn_model(const mjModel& plants, int hidden_link, const SceneLook& look) {
  ModelPointer model(mj_copyModel(nullptr, &plants));
  if (!model) throw std::runtime_error("no pictures: no memory for a copy of the physics model");
  model->vis.quality.shadowsize = std::max(look.shadow_px, 1);
  model->vis.quality.offsamples = look.samples;
  model->vis.global.offwidth = look.widest_px;
  model->vis.global.offheight = look.highest_px;
  for (int i = 0; i < 3; ++i) {
    model->vis.headlight.ambient[i] = kAmbient;
    model->vis.headlight.diffuse[i] = model->vis.headlight.specular[i] = 0.0F;
  }
  for (mjtSize geom = 0; geom < model->ngeom; ++geom) {
    if (model->geom_bodyid[geom] == hidden_link + 1) model->geom_group[geom] = kHiddenGroup;
  }
  return model;
}

std::uint8_t luminance(const std::uint8_t* rgb) noexcept {  // ITU-R BT.601, in 1/256
  return static_cast<std::uint8_t>((77U * rgb[0] + 150U * rgb[1] + 29U * rgb[2] + 128U) >> 8U);
}

}  // namespace

SceneView::SceneView(const Plant& plant, int hidden_link, const SceneLook& look)
    : geometry_(plant.geometry()),
      plants_(plant.implementation().model.get()),
      model_(drawn_model(*plants_, hidden_link, look)),
      data_(mj_makeData(model_.get())) {
  const OffscreenContext::Current current(offscreen_);
  mjv_defaultScene(&scene_);
  mjv_defaultOption(&option_);
  mjv_defaultCamera(&camera_);
  mjr_defaultContext(&context_);
  mjv_makeScene(model_.get(), &scene_, kMoreGeoms + static_cast<int>(model_->ngeom));
  mjr_makeContext(model_.get(), &context_, mjFONTSCALE_50);
  mjr_setBuffer(mjFB_OFFSCREEN, &context_);
  option_.geomgroup[kHiddenGroup] = 0;
  camera_.type = mjCAMERA_USER;
  scene_.flags[mjRND_REFLECTION] = 0;
  scene_.flags[mjRND_SHADOW] = look.shadow_px > 0 ? 1 : 0;
}

SceneView::~SceneView() {
  try {
    const OffscreenContext::Current current(offscreen_);
    mjr_freeContext(&context_);
  } catch (const std::runtime_error&) {  // NOLINT(bugprone-empty-catch): its memory goes with the context
  }
  mjv_freeScene(&scene_);
}

bool SceneView::is_of(const Plant& plant) const noexcept {
  return plants_ == plant.implementation().model.get() && geometry_ == plant.geometry();
}

void SceneView::pose(std::span<const double> positions) {
  std::ranges::copy(positions, data_->qpos);
  std::copy_n(plants_->geom_pos, 3 * static_cast<std::ptrdiff_t>(model_->ngeom), model_->geom_pos);
  mj_kinematics(model_.get(), data_.get());
}

Eigen::Isometry3d SceneView::link_pose(std::span<const double> positions, int link) {
  pose(positions);
  const std::ptrdiff_t body = link + 1;
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  result.translation() = Eigen::Map<const Eigen::Vector3d>(data_->xpos + 3 * body);
  result.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data_->xmat + 9 * body);
  return result;
}

void SceneView::aim(const Eigen::Isometry3d& optical, const PinholeWindow& window,
                    const Eigen::Vector3d& sun_over) {
  mjvGLCamera& eye = scene_.camera[0];
  const Eigen::Vector3f position = optical.translation().cast<float>();
  const Eigen::Vector3f ahead = optical.linear().col(2).cast<float>();
  const Eigen::Vector3f up = -optical.linear().col(1).cast<float>();
  std::copy_n(position.data(), 3, eye.pos);
  std::copy_n(ahead.data(), 3, eye.forward);
  std::copy_n(up.data(), 3, eye.up);
  const auto at_near = [](double tangent) { return static_cast<float>(tangent) * kNearest_m; };
  eye.frustum_center = at_near(window.left + 0.5 * window.width_px / window.scale);
  eye.frustum_width = at_near(0.5 * window.width_px / window.scale);
  eye.frustum_top = at_near(-window.top);
  eye.frustum_bottom = at_near(-(window.top + window.height_px / window.scale));
  eye.frustum_near = kNearest_m;
  eye.frustum_far = kFarthest_m;
  eye.orthographic = 0;
  scene_.camera[1] = eye;
  mjv_updateScene(model_.get(), data_.get(), &option_, nullptr, &camera_, mjCAT_ALL, &scene_);
  for (int i = 0; i < scene_.nlight; ++i) {
    mjvLight& light = scene_.lights[i];
    const bool is_sun = light.type == mjLIGHT_DIRECTIONAL && light.headlight == 0;
    for (int axis = 0; is_sun && axis < 3; ++axis) {
      light.pos[axis] =
          static_cast<float>(sun_over[axis] - kSunAway_m * static_cast<double>(light.dir[axis]));
    }
  }
}

void SceneView::draw(std::span<const double> positions, const Eigen::Isometry3d& optical,
                     const PinholeWindow& window, const Eigen::Vector3d& sun_over, GreyPicture& picture) {
  const OffscreenContext::Current current(offscreen_);
  pose(positions);
  mj_comPos(model_.get(), data_.get());
  mj_camlight(model_.get(), data_.get());
  aim(optical, window, sun_over);
  const mjrRect viewport{0, 0, window.width_px, window.height_px};
  mjr_render(viewport, &scene_, &context_);
  const auto width = static_cast<std::size_t>(window.width_px),
             height = static_cast<std::size_t>(window.height_px);
  rgb_.resize(3 * width * height);
  mjr_readPixels(rgb_.data(), nullptr, viewport, &context_);
  picture.width_px = window.width_px;
  picture.height_px = window.height_px;
  picture.grey.resize(width * height);
  for (std::size_t row = 0; row < height; ++row) {
    const std::uint8_t* from = rgb_.data() + 3 * width * (height - 1 - row);
    for (std::size_t column = 0; column < width; ++column, from += 3) {
      picture.grey[row * width + column] = luminance(from);
    }
  }
}

}  // namespace gaitway::simulator
