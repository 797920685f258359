// MuJoCo's model of the robot and the ground, built from the RobotModel alone: one truth for planner and
// physics.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <array>
#include <memory>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/conditions.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

inline constexpr int kLargestPictureWidth_px = 1920, kLargestPictureHeight_px = 1080;
inline constexpr std::array<double, 3> kSunDirection{-0.35, -0.45,
                                                     -1.0};  // the way its light goes, in the world

// How the simulated robot differs from its description.
struct ModelMismatch {
  std::vector<double> mass_factor;  // each link's; inertia likewise
  Eigen::Vector3d trunk_com_offset_m = Eigen::Vector3d::Zero();
};

struct ModelDeleter {
  void operator()(mjModel* model) const noexcept { mj_deleteModel(model); }
};
struct DataDeleter {
  void operator()(mjData* data) const noexcept { mj_deleteData(data); }
};
using ModelPointer = std::unique_ptr<mjModel, ModelDeleter>;
using DataPointer = std::unique_ptr<mjData, DataDeleter>;

// Body i + 1 of the model is link i; a hinge has its joint's name. Throws std::runtime_error with the
// compiler's words.
ModelPointer build_physics_model(const urdf::RobotModel& robot, const ModelMismatch& mismatch,
                                 const Conditions& conditions);

}  // namespace gaitway::simulator
