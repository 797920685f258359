// Each rule in its own function; what is within it keeps the joint's extremes.
#include "rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::kinematic {
namespace {

constexpr double kSums = 1e-9;  // of rounding: of what is equal to its limit

// The robot's own limits, nothing kept from them.
motion::MotionLimits whole_limits() {
  motion::MotionLimits limits;
  limits.joint_margin_rad = 0.0;
  limits.speed_share = limits.torque_share = 1.0;
  return limits;
}

std::string_view sole_name(urdf::Side side) {
  return side == urdf::Side::left ? "left sole" : "right sole";
}

}  // namespace

RuleBook::RuleBook(const urdf::RobotModel& robot, const Trajectory& trajectory, const Checks& checks,
                   Course& course)
    : robot_(robot),
      trajectory_(trajectory),
      checks_(checks),
      course_(course),
      limits_(robot, whole_limits()) {
  course_.joints.resize(robot.joints.size());
  const std::span<const double> first = trajectory.row(0);
  for (std::size_t j = 0; j < first.size(); ++j)
    course_.joints[j].lowest_rad = course_.joints[j].highest_rad = first[j];
}

void RuleBook::check_joints(std::size_t row) {
  for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
    const double angle = trajectory_.row(row)[joint], reference = trajectory_.reference(row)[joint];
    JointUse& use = course_.joints[joint];
    use.lowest_rad = std::min(use.lowest_rad, angle);
    use.highest_rad = std::max(use.highest_rad, angle);
    const auto beyond = [&](double at) {
      return std::max(at - robot_.joints[joint].upper_rad, robot_.joints[joint].lower_rad - at);
    };
    check_position(row, joint, beyond(reference) > beyond(angle) ? reference : angle);
    if (row == 0) continue;
    check_speed(row, joint);
    if (trajectory_.points_of_wire) check_count_step(row, joint);
  }
}

void RuleBook::check_position(std::size_t row, std::size_t joint, double angle_rad) {
  const urdf::Joint& description = robot_.joints[joint];
  const double above = angle_rad - description.upper_rad, below = description.lower_rad - angle_rad;
  const double excess = std::max(above, below) - kSums - trajectory_.rounding_counts * description.count_rad;
  if (excess > 0.0) {
    found_.note(Rule::position, description.name, row, trajectory_.time_s(row), angle_rad,
                above > below ? description.upper_rad : description.lower_rad, excess, "rad");
  }
}

// From row to row, so that a jump is as fast as it is. What is measured has the motor's limit alone.
void RuleBook::check_speed(std::size_t row, std::size_t joint) {
  const urdf::Joint& description = robot_.joints[joint];
  const double motor = description.motor.speed_limit_rad_per_s;
  const double limit = trajectory_.measured ? motor : std::min(motor, description.velocity_limit_rad_per_s);
  const double way = trajectory_.row(row)[joint] - trajectory_.row(row - 1)[joint];
  const double speed = std::abs(way) / facts::kSlot_s;
  JointUse& use = course_.joints[joint];
  if (speed > use.fastest_rad_per_s) {
    use.fastest_rad_per_s = speed;
    use.fastest_at_s = trajectory_.time_s(row);
  }
  // Two angles that were rounded can be a whole count further apart than they were.
  const double rounding = 2.0 * trajectory_.rounding_counts * description.count_rad / facts::kSlot_s;
  if (const double excess = speed - limit - kSums - rounding; excess > 0.0)
    found_.note(Rule::speed, description.name, row, trajectory_.time_s(row), speed, limit, excess, "rad/s");
}

// As the wire has it: the difference of absolute counts.
void RuleBook::check_count_step(std::size_t row, std::size_t joint) {
  const urdf::Joint& description = robot_.joints[joint];
  const auto counts = [&](std::size_t at) {
    return std::llround(trajectory_.reference(at)[joint] / description.count_rad);
  };
  const auto step = static_cast<int>(std::abs(counts(row) - counts(row - 1)));
  JointUse& use = course_.joints[joint];
  if (step > use.largest_step_counts) {
    use.largest_step_counts = step;
    use.largest_step_at_s = trajectory_.time_s(row);
  }
  if (step > facts::kLargestByte_counts) {
    found_.note(Rule::count_step, description.name, row, trajectory_.time_s(row), step,
                facts::kLargestByte_counts, step - facts::kLargestByte_counts, "counts");
  }
}

void RuleBook::check_torques(std::size_t row) {
  for (std::size_t joint = 0; joint < robot_.joints.size(); ++joint) {
    const std::size_t at = row * robot_.joints.size() + joint;
    const double torque = course_.torque_Nm[at], size = std::abs(torque);
    if (std::isnan(torque)) continue;
    const double limit =
        limits_.torque_Nm(static_cast<Eigen::Index>(joint), course_.speed_rad_per_s[at], torque);
    JointUse& use = course_.joints[joint];
    if (size > use.largest_torque_Nm) {
      use.largest_torque_Nm = size;
      use.largest_torque_at_s = trajectory_.time_s(row);
    }
    if (limit > 0.0) use.torque_share = std::max(use.torque_share, size / limit);
    if (const double excess = size - limit - kSums; excess > 0.0) {
      found_.note(Rule::torque, robot_.joints[joint].name, row, trajectory_.time_s(row), size, limit, excess,
                  "N·m");
    }
  }
}

void RuleBook::check_collisions(std::size_t row, const std::vector<LinkContact>& contacts) {
  for (const LinkContact& contact : contacts) {
    if (contact.depth_m <= checks_.collision_depth_m) continue;
    const std::string both = fmt::format("{} in {}", robot_.links[static_cast<std::size_t>(contact.one)].name,
                                         robot_.links[static_cast<std::size_t>(contact.other)].name);
    found_.note(Rule::self_collision, both, row, trajectory_.time_s(row), 1e3 * contact.depth_m,
                1e3 * checks_.collision_depth_m, contact.depth_m, "mm");
  }
}

void RuleBook::check_soles(std::size_t row, const Standing& standing, const SolePoses& sole_in_base) {
  // A robot that lies has its feet anywhere.
  if (trajectory_.leads_joints || standing.contact[row] == motion::Contact::none) return;
  const double most_deep_m = checks_.sole_depth_m + trajectory_.place_error_m;
  const double most_way_m = checks_.sole_slide_m + trajectory_.place_error_m;
  for (const urdf::Side side : urdf::kSides) {
    const auto s = urdf::index_of(side);
    const Eigen::Isometry3d sole = standing.sole(sole_in_base, side, row);
    const double deep_m = -lowest_m(robot_.feet[s], sole);
    if (deep_m > most_deep_m) {
      found_.note(Rule::sole_in_floor, sole_name(side), row, trajectory_.time_s(row), 1e3 * deep_m,
                  1e3 * most_deep_m, deep_m, "mm");
    }
    if (!motion::stands_on(standing.contact[row], side)) continue;
    if (row == 0 || standing.since[s][row] == 0) stood_[s] = sole;
    const double way_m = (sole.translation() - stood_[s].translation()).head<2>().norm();
    if (way_m > most_way_m) {
      found_.note(Rule::sole_slides, sole_name(side), row, trajectory_.time_s(row), 1e3 * way_m,
                  1e3 * most_way_m, way_m, "mm");
    }
  }
}

void RuleBook::check_zmp(std::size_t row) {
  const double most_outside_m = checks_.zmp_outside_m + trajectory_.place_error_m;
  for (const ZmpSource source : kZmpSources) {
    const ZmpCourse& zmp = course_.of(source);
    const bool made_of_joints =
        source == ZmpSource::all_masses || (source == ZmpSource::planned && course_.planned_is_computed);
    if (made_of_joints && trajectory_.leads_joints) continue;
    if (zmp.at_m.empty() || !(zmp.margin_m[row] < -most_outside_m)) continue;
    found_.note(Rule::zmp, fmt::format("ZMP ({})", name_of(source)), row, trajectory_.time_s(row),
                1e3 * zmp.margin_m[row], 0.0 - 1e3 * most_outside_m, -zmp.margin_m[row], "mm");
  }
}

}  // namespace gaitway::kinematic
