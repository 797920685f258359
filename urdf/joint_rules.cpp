// Limits, home posture, speed on the wire.
#include "robot_files.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::urdf {
namespace {

constexpr double kLargestOffset_m = 2.0;
using facts::kSlot_s;

double degrees(double angle_rad) {
  return angle_rad * 180.0 / std::numbers::pi;
}

}  // namespace

void check_geometry(const UrdfFile& urdf, const UrdfJoint& source) {
  const Joint& joint = source.joint;
  const auto complain = [&](const std::string& field, double value, const std::string& rule,
                            const std::string& remedy) {
    input::refuse({urdf.file, source.line, fmt::format("joint '{}' {}", joint.name, field),
                   fmt::format("{:g}", value), rule, remedy});
  };
  if (joint.origin.translation().norm() > kLargestOffset_m) {
    complain("origin", joint.origin.translation().norm(),
             fmt::format("must lie within {:g} m of the parent", kLargestOffset_m),
             "Write lengths in metres");
  }
  if (std::abs(joint.axis.norm() - 1.0) > 1e-3) {
    complain("axis length", joint.axis.norm(), "must be 1", "Write a unit vector, such as 0 1 0");
  }
  for (const double limit_rad : {joint.lower_rad, joint.upper_rad}) {
    if (std::abs(limit_rad) > std::numbers::pi) {
      complain(limit_rad == joint.lower_rad ? "limit lower" : "limit upper", limit_rad,
               "must lie within -pi..pi rad: feedback frames carry half a turn either way",
               "Write radians, not degrees");
    }
  }
  if (!(joint.lower_rad < joint.upper_rad)) {
    complain("limit lower", joint.lower_rad, fmt::format("must be below upper = {:g}", joint.upper_rad),
             "Exchange the two or correct one");
  }
  if (!(joint.velocity_limit_rad_per_s > 0.0)) {
    complain("limit velocity", joint.velocity_limit_rad_per_s, "must be above 0", "Write rad/s");
  }
  if (!(source.effort_limit_Nm > 0.0)) {
    complain("limit effort", source.effort_limit_Nm, "must be above 0", "Write N·m");
  }
}

void check_drive(const UrdfFile& urdf, const UrdfJoint& geometry, const NetworkFile& network,
                 const NetworkJoint& drive) {
  const Joint& joint = drive.joint;
  const auto field = [&joint](const char* name) { return fmt::format("joint '{}' {}", joint.name, name); };
  if (joint.home_rad < geometry.joint.lower_rad || joint.home_rad > geometry.joint.upper_rad) {
    input::refuse({network.file, drive.line, field("home_deg"), fmt::format("{:g}", degrees(joint.home_rad)),
                   fmt::format("must lie within the URDF's limits {:g}..{:g} deg",
                               degrees(geometry.joint.lower_rad), degrees(geometry.joint.upper_rad)),
                   "Change the posture or widen the limits"});
  }
  const double velocity = geometry.joint.velocity_limit_rad_per_s;
  const double wire_limit = facts::kLargestByte_counts * joint.count_rad / kSlot_s;
  if (velocity > wire_limit * (1.0 + 1e-9)) {
    input::refuse({urdf.file, geometry.line, field("limit velocity"), fmt::format("{:g} rad/s", velocity),
                   fmt::format("a signed byte of {:g} deg a count in 10 ms holds {:.4g} rad/s only",
                               degrees(joint.count_rad), wire_limit),
                   "Lower the limit, or raise count_deg in the network file"});
  }
  if (velocity > joint.motor.speed_limit_rad_per_s) {
    input::refuse({urdf.file, geometry.line, field("limit velocity"), fmt::format("{:g} rad/s", velocity),
                   fmt::format("the motor reaches {:g} rad/s", joint.motor.speed_limit_rad_per_s),
                   "Lower the limit, or raise speed_limit_rad_per_s in the network file"});
  }
  if (joint.motor.torque_limit_Nm > geometry.effort_limit_Nm) {
    input::refuse(
        {network.file, drive.line, field("torque_limit_Nm"), fmt::format("{:g}", joint.motor.torque_limit_Nm),
         fmt::format("the URDF's effort limit is {:g} N·m", geometry.effort_limit_Nm), "Make the two agree"});
  }
}

}  // namespace gaitway::urdf
