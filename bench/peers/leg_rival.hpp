// One way to find the six angles of a leg: ours, or a peer's.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::peers {

using LegAngles = std::array<double, 6>;

// All peers stop at this distance from the goal, in m and rad: KDL's and TRAC-IK's own default. Ours go on
// to 1e-11, and cannot be told otherwise.
inline constexpr double kTolerance = 1e-5;
inline constexpr int kMostIterations = 500;

class LegRival {
 public:
  explicit LegRival(std::string name) : name_(std::move(name)) {}
  LegRival(const LegRival&) = delete;
  LegRival& operator=(const LegRival&) = delete;
  virtual ~LegRival() = default;
  [[nodiscard]] const std::string& name() const noexcept { return name_; }

  // Of the sole in the base frame; brings them into the rival's own type, outside of what is timed.
  virtual void set_goals(const std::vector<Eigen::Isometry3d>& soles) = 0;
  // Whether it says that it has a solution, which then lies in `angle_rad`.
  [[nodiscard]] virtual bool solve(std::size_t goal, const LegAngles& start_rad, LegAngles& angle_rad) = 0;

 private:
  std::string name_;
};

// What the plug-in kinematics takes for this leg: the closed form, or Newton's iteration.
std::unique_ptr<LegRival> our_leg(const urdf::RobotModel& robot, urdf::Side side);
// KDL's own solvers: Levenberg-Marquardt, and Newton-Raphson within the joints' limits.
std::unique_ptr<LegRival> kdl_leg_lma(const urdf::RobotModel& robot, urdf::Side side);
std::unique_ptr<LegRival> kdl_leg_nr_jl(const urdf::RobotModel& robot, urdf::Side side);
// The closed-loop inverse kinematics of Pinocchio's manual. `step`: share of the way that an iteration goes.
std::unique_ptr<LegRival> pinocchio_leg(const urdf::RobotModel& robot, urdf::Side side, double step);

}  // namespace gaitway::peers
