// Writes the samples of a run as CSV with units in the column names.
#include <fmt/format.h>

#include <iterator>
#include <string>

#include "tools/run/run_logs.hpp"

namespace gaitway::tools {
namespace {

std::string header(const urdf::RobotModel& robot) {
  std::string line =
      "time_s,mode,base_x_m,base_y_m,base_z_m,base_roll_rad,base_pitch_rad,base_yaw_rad,com_x_m,com_y_m,com_"
      "z_m,"
      "reference_com_x_m,reference_com_y_m,cop_x_m,cop_y_m,measured_zmp_x_m,measured_zmp_y_m,reference_zmp_x_"
      "m,"
      "reference_zmp_y_m,gyro_x_rad_s,gyro_y_rad_s,gyro_z_rad_s,acceleration_x_m_s2,acceleration_y_m_s2,"
      "acceleration_z_m_s2,inclination_roll_rad,inclination_pitch_rad";
  for (const char* const side : {"left", "right"}) {
    for (const char* const quantity : {"x_m", "y_m", "z_m", "yaw_rad"}) {
      line += fmt::format(",{}_foot_{}", side, quantity);
    }
    for (const char* const cell : {"front_left", "front_right", "rear_left", "rear_right"}) {
      line += fmt::format(",{}_foot_force_{}_N", side, cell);
    }
  }
  for (int channel = 0; channel < 8; ++channel) {
    line += fmt::format(",trim_{}_rad", channel);
  }
  for (const urdf::Joint& joint : robot.joints) {
    line += fmt::format(",{0}_position_rad,{0}_reference_rad,{0}_velocity_rad_s,{0}_torque_Nm", joint.name);
  }
  return line + "\n";
}

template <class Range>
void append(std::string& line, const Range& values) {
  for (const double value : values) {
    fmt::format_to(std::back_inserter(line), ",{:.6g}", value);
  }
}

void append_sample(std::string& line, const RunSample& s) {
  fmt::format_to(std::back_inserter(line), "{:.3f},{}", s.time_s, s.mode);
  append(line, s.base_m);
  append(line, s.base_rpy_rad);
  append(line, s.com_m);
  append(line, s.reference_com_m);
  append(line, s.cop_m);
  append(line, s.measured_zmp_m);
  append(line, s.reference_zmp_m);
  append(line, s.angular_velocity_rad_per_s);
  append(line, s.acceleration_m_per_s2);
  append(line, s.inclination_rad);
  for (std::size_t side = 0; side < 2; ++side) {
    append(line, s.foot[side]);
    append(line, s.force_N[side]);
  }
  append(line, s.trim_rad);
  for (std::size_t joint = 0; joint < s.joint_position_rad.size(); ++joint) {
    append(line, std::array<double, 4>{s.joint_position_rad[joint], s.joint_reference_rad[joint],
                                       s.joint_velocity_rad_per_s[joint], s.joint_torque_Nm[joint]});
  }
  line += '\n';
}

}  // namespace

StatesCsv::StatesCsv(const std::filesystem::path& file, const urdf::RobotModel& robot)
    : log_(file, {.head = header(robot)}) {}

void StatesCsv::follow(std::span<const RunSample> samples) {
  constexpr std::size_t kBlock_bytes = std::size_t{1} << 16U;
  for (; taken_ < samples.size(); ++taken_) append_sample(waiting_, samples[taken_]);
  if (waiting_.size() >= kBlock_bytes) flush();
}

void StatesCsv::flush() {
  if (!waiting_.empty()) log_.append(waiting_);
  waiting_.clear();
}

}  // namespace gaitway::tools
