// Plays a trajectory on the robot without dynamics: where everything is, how fast, what torques and what
// ground that takes, and which rules it breaks.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/kinematic/findings.hpp"
#include "gaitway/kinematic/trajectory.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematic {

// Which rules are looked at, and by how much soles may be off before that is told.
struct Checks {
  bool joints = true, self_collision = true, soles = true, zmp = true;
  double collision_depth_m = 0.001;
  double sole_depth_m = 0.003;
  double sole_slide_m = 0.005;
  double touch_m = 0.003;  // below it a sole stands, where the source does not say
  double zmp_outside_m = 0.0;
};

// How far a joint goes, and when it goes furthest.
struct JointUse {
  double lowest_rad = 0.0, highest_rad = 0.0;
  double fastest_rad_per_s = 0.0, fastest_at_s = 0.0;
  double largest_torque_Nm = 0.0, largest_torque_at_s = 0.0;
  double torque_share = 0.0;  // of what the motor gives at that speed, at most
  int largest_step_counts = 0;
  double largest_step_at_s = 0.0;
};

// While a sole stood without a break.
struct Stand {
  urdf::Side side = urdf::Side::left;
  double from_s = 0.0, to_s = 0.0;
};

struct ZmpCourse {
  ZmpRows at_m;                  // empty: the source has none
  std::vector<double> margin_m;  // inside the support polygon; negative outside; NaN where nothing is known
  double least_margin_m = 0.0, least_at_s = 0.0;
  std::size_t least_row = 0;
  double mean_margin_m = 0.0;
  std::size_t rows = 0;  // for which the margin is known
  [[nodiscard]] bool known() const noexcept { return rows > 0; }
};

// Rows as the trajectory's.
struct Course {
  std::vector<double> speed_rad_per_s, torque_Nm;  // torque: NaN where nothing stands
  std::vector<Eigen::Isometry3d> base;
  std::vector<motion::Contact> contact;
  std::vector<Eigen::Vector3d> com_m;
  std::array<ZmpCourse, kZmpSources.size()> zmp;  // [ZmpSource]
  bool planned_is_computed = false;  // the source has no planned ZMP: the cart-table's of the CoM stands in
  std::vector<JointUse> joints;
  std::vector<Stand> stands;
  std::vector<Finding> findings;
  std::vector<std::string> notes;
  std::size_t collision_pairs = 0;  // that were looked at

  [[nodiscard]] const ZmpCourse& of(ZmpSource source) const noexcept { return zmp[index_of(source)]; }
};

using Progress = std::function<void(double share)>;

// Throws std::invalid_argument when the trajectory does not fit the robot, or has fewer than three rows.
[[nodiscard]] Course play(const urdf::RobotModel& robot, const Trajectory& trajectory, const Checks& checks,
                          const Progress& progress = {});

// How two trajectories differ, from the first row of each on, as long as both last.
struct JointDifference {
  double rms_rad = 0.0, largest_rad = 0.0, largest_at_s = 0.0;  // on the first one's clock
};
[[nodiscard]] std::vector<JointDifference> compare(const Trajectory& one, const Trajectory& other);

}  // namespace gaitway::kinematic
