// MuJoCo's model of the robot and the ground, built from the RobotModel alone: one truth for planner and physics.
#pragma once

#include <mujoco/mujoco.h>

#include <Eigen/Core>
#include <memory>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

// How the simulated robot differs from its description.
struct ModelMismatch {
  std::vector<double> mass_factor;                             // each link's; inertia likewise
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

// Body i + 1 of the model is link i, hinge i is joint i (after the base's free joint). Throws std::runtime_error with
// the compiler's words.
ModelPointer build_physics_model(const urdf::RobotModel& robot, const ModelMismatch& mismatch);

}  // namespace gaitway::simulator
