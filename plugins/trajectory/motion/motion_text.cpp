// Writes a motion as its file has it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/written_text.hpp"
#include "gaitway/motion/motion_adaptation.hpp"

namespace gaitway::motion {
namespace {

// To a hundredth of a degree, a tenth of a millimetre, a millisecond.
std::string rounded(double value, double step) {
  const double whole = std::round(value / step) * step;
  return fmt::format("{:.6g}", whole == 0.0 ? 0.0 : whole);
}
std::string degrees(double angle_rad) {
  return rounded(angle_rad * facts::kDegreePerRad, 0.01);
}
std::string metres(double length_m) {
  return rounded(length_m, 1e-4);
}
std::string seconds(double time_s) {
  return rounded(time_s, 1e-3);
}

std::string quoted(const std::string& text) {
  return input::yaml_text(text, " _-.,");
}

std::string map_of(const std::vector<std::string>& fields) {
  return fmt::format("{{{}}}", fmt::join(fields, ", "));
}

std::string pelvis_text(const PelvisWish& wish) {
  constexpr std::array<std::string_view, 3> kAngles{"roll_deg", "pitch_deg", "yaw_deg"};
  constexpr std::array<std::string_view, 2> kOffsets{"forward_m", "left_m"};
  constexpr std::array<std::string_view, 3> kOver{"both", "left", "right"};
  std::vector<std::string> fields;
  if (wish.hip_height_m) fields.push_back("hip_height_m: " + metres(*wish.hip_height_m));
  for (std::size_t i = 0; i < kAngles.size(); ++i) {
    if (wish.attitude_rad[i])
      fields.push_back(fmt::format("{}: {}", kAngles[i], degrees(*wish.attitude_rad[i])));
  }
  if (wish.over) fields.push_back(fmt::format("over: {}", kOver[static_cast<std::size_t>(*wish.over)]));
  for (std::size_t i = 0; i < kOffsets.size(); ++i) {
    if (wish.com_offset_m[i])
      fields.push_back(fmt::format("{}: {}", kOffsets[i], metres(*wish.com_offset_m[i])));
  }
  return map_of(fields);
}

std::string foot_text(const FootWish& wish) {
  constexpr std::array<std::string_view, 3> kPlaces{"forward_m", "left_m", "up_m"};
  constexpr std::array<std::string_view, 3> kAngles{"roll_deg", "pitch_deg", "yaw_deg"};
  std::vector<std::string> fields;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (wish.position_m[axis] != 0.0)
      fields.push_back(fmt::format("{}: {}", kPlaces[i], metres(wish.position_m[axis])));
  }
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    if (wish.attitude_rad[axis] != 0.0)
      fields.push_back(fmt::format("{}: {}", kAngles[i], degrees(wish.attitude_rad[axis])));
  }
  return map_of(fields);
}

void add_key(const Key& key, const urdf::RobotModel& robot, std::string& text) {
  text += fmt::format("  - name: {}\n", quoted(key.name));
  if (key.from_home) text += "    from: home\n";
  if (key.contact != Contact::both) text += fmt::format("    contact: {}\n", name_of(key.contact));
  if (key.min_time_s > 0.0) text += fmt::format("    min_time_s: {}\n", seconds(key.min_time_s));
  if (key.hold_s > 0.0) text += fmt::format("    hold_s: {}\n", seconds(key.hold_s));
  if (key.pelvis) text += fmt::format("    pelvis: {}\n", pelvis_text(*key.pelvis));
  if (key.foot[0]) text += fmt::format("    left_foot: {}\n", foot_text(*key.foot[0]));
  if (key.foot[1]) text += fmt::format("    right_foot: {}\n", foot_text(*key.foot[1]));
  if (key.joints.empty()) return;
  text += "    joints:\n";
  for (const JointAngle& angle : key.joints) {
    text += fmt::format("      {}: {}\n", quoted(robot.joints[static_cast<std::size_t>(angle.joint)].name),
                        degrees(angle.angle_rad));
  }
}

}  // namespace

std::string motion_text(const Motion& motion, const urdf::RobotModel& robot,
                        const std::vector<std::string>& comments) {
  std::string text;
  for (const std::string& comment : comments) text += fmt::format("# {}\n", comment);
  text += fmt::format("name: {}\ndescription: {}\n", quoted(motion.name), quoted(motion.description));
  if (motion.starts_at_first_key) text += "start: first_key\n";
  if (motion.lies_on) text += fmt::format("lies_on: {}\n", trajectory::name_of(*motion.lies_on));
  if (motion.torque_share) text += fmt::format("torque_share: {}\n", rounded(*motion.torque_share, 1e-3));
  text += "keys:\n";
  for (const Key& key : motion.keys) add_key(key, robot, text);
  return text;
}

}  // namespace gaitway::motion
