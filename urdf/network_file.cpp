// Reads robot.yaml: defaults, joints, legs, feet, sensors, simulation.
#include "robot_files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "joint_claims.hpp"

namespace gaitway::urdf {
namespace {

using Keys = std::vector<std::string_view>;

using facts::kRadPerDegree;
constexpr input::Range kCount_deg{0.001, 0.5, "deg"};
constexpr input::Range kHalfTurn_deg{-180.0, 180.0, "deg"};
constexpr input::Range kPosition_m{-2.0, 2.0, "m"};
constexpr input::Range kLength_m{0.001, 1.0, "m"};

Eigen::Isometry3d pose_of(const std::array<double, 3>& position_m, const std::array<double, 3>& rpy_deg) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Vector3d(position_m.data());
  pose.linear() = (Eigen::AngleAxisd(rpy_deg[2] * kRadPerDegree, Eigen::Vector3d::UnitZ()) *
                   Eigen::AngleAxisd(rpy_deg[1] * kRadPerDegree, Eigen::Vector3d::UnitY()) *
                   Eigen::AngleAxisd(rpy_deg[0] * kRadPerDegree, Eigen::Vector3d::UnitX()))
                      .toRotationMatrix();
  return pose;
}

std::array<double, 3> rotation_or_zero(const input::YamlValue& value, std::string_view key) {
  const auto rotation = value.find(key);
  return rotation ? rotation->numbers<3>(kHalfTurn_deg) : std::array<double, 3>{};
}

// A number that may be left out where an earlier layer has set it already.
void read_number(const input::YamlValue& map, std::string_view key, const input::Range& range, bool required,
                 double& target, double factor = 1.0) {
  if (const auto value = required ? map.at(key) : map.find(key)) {
    target = value->number(range) * factor;
  }
}

void read_servo(const input::YamlValue& map, bool required, Servo& servo) {
  map.require_map(Keys{"stiffness_Nm_per_rad", "damping_Nms_per_rad"});
  read_number(map, "stiffness_Nm_per_rad", {0.1, 1e5, "N·m/rad"}, required, servo.stiffness_Nm_per_rad);
  read_number(map, "damping_Nms_per_rad", {0.0, 1e4, "N·m·s/rad"}, required, servo.damping_Nms_per_rad);
}

void read_motor(const input::YamlValue& map, bool required, Motor& motor) {
  map.require_map(Keys{"torque_limit_Nm", "speed_limit_rad_per_s", "armature_kg_m2", "damping_Nms_per_rad",
                       "friction_Nm"});
  read_number(map, "torque_limit_Nm", {0.01, 1000.0, "N·m"}, required, motor.torque_limit_Nm);
  read_number(map, "speed_limit_rad_per_s", {0.1, 100.0, "rad/s"}, required, motor.speed_limit_rad_per_s);
  read_number(map, "armature_kg_m2", {0.0, 1.0, "kg·m²"}, required, motor.armature_kg_m2);
  read_number(map, "damping_Nms_per_rad", {0.0, 100.0, "N·m·s/rad"}, required, motor.damping_Nms_per_rad);
  read_number(map, "friction_Nm", {0.0, 100.0, "N·m"}, required, motor.friction_Nm);
}

// What defaults and single joints have in common; `required` for the defaults.
void read_drive(const input::YamlValue& map, bool required, Joint& joint) {
  read_number(map, "count_deg", kCount_deg, required, joint.count_rad, kRadPerDegree);
  read_number(map, "home_deg", kHalfTurn_deg, required, joint.home_rad, kRadPerDegree);
  if (const auto counts =
          required ? map.at("encoder_counts_per_turn") : map.find("encoder_counts_per_turn")) {
    joint.encoder_count_rad = 2.0 * std::numbers::pi / counts->integer(256, 1 << 26);
  }
  if (const auto servo = required ? map.at("servo") : map.find("servo")) {
    read_servo(*servo, required, joint.servo);
  }
  if (const auto motor = required ? map.at("motor") : map.find("motor")) {
    read_motor(*motor, required, joint.motor);
  }
  if (joint.encoder_count_rad > joint.count_rad) {
    map.refuse(fmt::format("the encoder's step of {:g} deg must not be larger than a count of {:g} deg",
                           joint.encoder_count_rad / kRadPerDegree, joint.count_rad / kRadPerDegree),
               "Check encoder_counts_per_turn and count_deg");
  }
}

int read_trim_channel(const input::YamlValue& value) {
  const int channel = value.integer(0, 255);
  if (channel >= facts::kTrimChannels) {
    value.refuse(fmt::format("must be 0..{}: one trim frame holds the corrections of {} joints",
                             facts::kTrimChannels - 1, facts::kTrimChannels),
                 "Give channels to ankles first, then to the hips' roll and pitch; a joint without "
                 "trim_channel is not trimmed");
  }
  return channel;
}

NetworkJoint read_joint(const input::YamlValue& map, const Joint& defaults, const ChannelScales& scales) {
  map.require_map(Keys{"name", "node", "channels", "trim_channel", "count_deg", "encoder_counts_per_turn",
                       "servo", "motor", "home_deg"});
  NetworkJoint result{defaults, {}, map.line()};
  result.joint.name = map.at("name").text();
  result.joint.node = static_cast<std::uint8_t>(map.at("node").integer(1, 64));
  read_drive(map, false, result.joint);
  if (const auto trim = map.find("trim_channel")) {
    result.joint.trim_channel = read_trim_channel(*trim);
  }
  if (const auto channels = map.find("channels")) {
    const std::vector<input::YamlValue> pair = channels->items(result.channels.size());
    std::transform(pair.begin(), pair.end(), result.channels.begin(),
                   [&scales](const input::YamlValue& value) { return scales.channel(value); });
  }
  return result;
}

void read_joints(const input::YamlValue& top, NetworkFile& network) {
  const input::YamlValue defaults_map = top.at("defaults");
  defaults_map.require_map(Keys{"count_deg", "encoder_counts_per_turn", "servo", "motor", "home_deg"});
  Joint defaults;
  read_drive(defaults_map, true, defaults);
  const ChannelScales scales(top.at("channel_scale"));
  JointClaims claims;
  for (const input::YamlValue& map : top.at("joints").items()) {
    network.joints.push_back(read_joint(map, defaults, scales));
    claims.add(map, network.joints.back());
  }
  claims.require_channels(top.at("joints"), network.feet);
}

void read_foot_sensor(const input::YamlValue& map, Foot& foot) {
  static const std::vector<std::string> kKinds{"cells", "six_axis", "none"};  // as FootSensor
  if (const auto sensor = map.find("sensor")) {
    const auto kind = std::ranges::find(kKinds, sensor->text());
    if (kind == kKinds.end()) {
      sensor->refuse("must be cells, six_axis or none", input::suggest(sensor->text(), kKinds));
    }
    foot.sensor = static_cast<FootSensor>(kind - kKinds.begin());
  }
  const bool has_frame = foot.sensor == FootSensor::six_axis;
  for (const char* const key : {"sensor_position_m", "sensor_rotation_rpy_deg"}) {
    const auto value = map.find(key);
    if (value && !has_frame) {
      value->refuse("only a six-axis sensor has a frame of its own", "Write sensor: six_axis, or remove it");
    }
  }
  if (has_frame) {
    foot.sensor_pose = pose_of(map.at("sensor_position_m").numbers<3>(kPosition_m),
                               rotation_or_zero(map, "sensor_rotation_rpy_deg"));
  }
}

void read_foot(const input::YamlValue& map, std::size_t side, NetworkFile& network) {
  map.require_map(Keys{"link", "sole_position_m", "sole_rotation_rpy_deg", "size_m", "centre_m",
                       "cell_inset_m", "sensor", "sensor_position_m", "sensor_rotation_rpy_deg"});
  network.foot_link[side] = map.at("link").text();
  network.foot_line[side] = map.at("link").line();
  Foot& foot = network.feet[side];
  foot.sole = pose_of(map.at("sole_position_m").numbers<3>(kPosition_m),
                      rotation_or_zero(map, "sole_rotation_rpy_deg"));
  foot.size_m = Eigen::Vector2d(map.at("size_m").numbers<2>(kLength_m).data());
  foot.centre_m = Eigen::Vector2d(map.at("centre_m").numbers<2>(kPosition_m).data());
  const double largest_inset_m = 0.4 * foot.size_m.minCoeff();
  read_foot_sensor(map, foot);
  double inset_m = 0.0;
  read_number(map, "cell_inset_m", {0.0, largest_inset_m, "m"}, foot.sensor == FootSensor::cells, inset_m);
  const Eigen::Vector2d half_m = 0.5 * foot.size_m - Eigen::Vector2d::Constant(inset_m);
  foot.cell_m = {foot.centre_m + Eigen::Vector2d(half_m.x(), half_m.y()),
                 foot.centre_m + Eigen::Vector2d(half_m.x(), -half_m.y()),
                 foot.centre_m + Eigen::Vector2d(-half_m.x(), half_m.y()),
                 foot.centre_m + Eigen::Vector2d(-half_m.x(), -half_m.y())};
}

void read_legs_and_feet(const input::YamlValue& top, NetworkFile& network) {
  const Keys sides{"left", "right"};
  const input::YamlValue legs = top.at("legs");
  const input::YamlValue feet = top.at("feet");
  legs.require_map(sides);
  feet.require_map(sides);
  for (std::size_t side = 0; side < sides.size(); ++side) {
    const input::YamlValue leg = legs.at(sides[side]);
    const std::vector<input::YamlValue> names = leg.items();
    if (names.size() != 6) {
      leg.refuse("a leg has six joints: hip yaw, hip roll, hip pitch, knee, ankle pitch, ankle roll",
                 "List exactly these, from the base to the foot");
    }
    for (const input::YamlValue& name : names) {
      network.leg_joints[side].push_back(name.text());
    }
    network.leg_line[side] = leg.line();
    read_foot(feet.at(sides[side]), side, network);
  }
  if (network.feet[0].sensor != network.feet[1].sensor) {
    feet.refuse("both feet must have the same kind of sensor", "Write the same sensor for left and right");
  }
}

void read_imu(const input::YamlValue& map, NetworkFile& network) {
  map.require_map(Keys{"link", "position_m", "rotation_rpy_deg", "inclinometer"});
  network.imu_link = map.at("link").text();
  network.imu_line = map.at("link").line();
  network.imu.pose =
      pose_of(map.at("position_m").numbers<3>(kPosition_m), rotation_or_zero(map, "rotation_rpy_deg"));
  const auto inclinometer = map.find("inclinometer");
  if (!inclinometer) return;
  const std::string kind = inclinometer->text();
  if (kind != "fused" && kind != "pendulum") {
    inclinometer->refuse("must be fused or pendulum",
                         "Write fused for a module that fuses it with a gyro of its own, else pendulum");
  }
  network.imu.inclinometer = kind == "fused" ? Inclinometer::fused : Inclinometer::pendulum;
}

void read_trim(const input::YamlValue& map, TrimSettings& trim) {
  map.require_map(Keys{"count_deg", "slew_deg_per_s", "limit_deg"});
  const double count_deg = map.at("count_deg").number(kCount_deg);
  trim.count_rad = count_deg * kRadPerDegree;
  trim.slew_rad_per_s = map.at("slew_deg_per_s").number({1.0, 2000.0, "deg/s"}) * kRadPerDegree;
  const input::YamlValue limit = map.at("limit_deg");
  trim.limit_rad = limit.number({count_deg, 45.0, "deg"}) * kRadPerDegree;
  constexpr double kRounding_counts = 1e-4;
  if (trim.limit_rad > (facts::kLargestByte_counts + kRounding_counts) * trim.count_rad) {
    limit.refuse(fmt::format("a signed byte holds {} counts of {:g} deg = {:g} deg",
                             facts::kLargestByte_counts, count_deg, facts::kLargestByte_counts * count_deg),
                 "Lower limit_deg or raise trim.count_deg");
  }
}

void read_network(const input::YamlValue& map, NetworkSettings& network) {
  constexpr int kLargestId = 0x7FF;
  constexpr input::Range kMessage_ms{0.1, 10000.0, "ms"};
  map.require_map(Keys{"profile", "messages", "tail_parts"});
  network.line = map.line();
  if (const auto profile = map.find("profile")) {
    network.profile = profile->text();
    network.line = profile->line();
  }
  if (const auto parts = map.find("tail_parts")) {
    network.tail_parts = static_cast<int>(parts->integer(0, facts::kMostTailParts));
  }
  if (const auto messages = map.find("messages")) {
    for (const auto& [name, value] : messages->entries()) {
      value.require_map(Keys{"id", "period_ms", "deadline_ms"});
      MessageSetting setting{
          .message = name, .line = value.line(), .id = {}, .period_s = {}, .deadline_s = {}};
      if (const auto id = value.find("id")) {
        setting.id = id->integer(0, kLargestId);
      }
      if (const auto period = value.find("period_ms")) {
        setting.period_s = period->number(kMessage_ms) * 1e-3;
      }
      if (const auto deadline = value.find("deadline_ms")) {
        setting.deadline_s = deadline->number(kMessage_ms) * 1e-3;
      }
      network.messages.push_back(std::move(setting));
    }
  }
}

void read_simulation(const input::YamlValue& map, NetworkFile& network) {
  map.require_map(Keys{"noise", "contact", "physics_step_s", "parts"});
  read_number(map, "parts", {0.0, 5.0, ""}, false, network.parts_deviation);
  const input::YamlValue noise = map.at("noise");
  noise.require_map(
      Keys{"angular_velocity_rad_per_s", "acceleration_m_per_s2", "inclination_rad", "force_N", "torque_Nm"});
  network.noise.angular_velocity_rad_per_s =
      noise.at("angular_velocity_rad_per_s").number({0.0, 1.0, "rad/s"});
  network.noise.acceleration_m_per_s2 = noise.at("acceleration_m_per_s2").number({0.0, 10.0, "m/s²"});
  read_number(noise, "inclination_rad", {0.0, 0.2, "rad"}, false, network.noise.inclination_rad);
  read_number(noise, "force_N", {0.0, 50.0, "N"}, false, network.noise.force_N);
  read_number(noise, "torque_Nm", {0.0, 10.0, "N·m"}, false, network.noise.torque_Nm);
  const input::YamlValue contact = map.at("contact");
  contact.require_map(Keys{"friction"});
  network.contact.friction = contact.at("friction").number({0.01, 3.0, ""});
  network.physics_step_s = map.at("physics_step_s").number({1e-5, 0.001, "s"});
}

}  // namespace

NetworkFile read_network_file(const std::filesystem::path& file) {
  const input::YamlValue top = input::YamlValue::read(file);
  top.require_map(Keys{"defaults", "joints", "legs", "feet", "imu", "channel_scale", "trim", "standing",
                       "simulation", "network"});
  NetworkFile network;
  network.file = file;
  read_legs_and_feet(top, network);
  read_joints(top, network);
  read_imu(top.at("imu"), network);
  read_trim(top.at("trim"), network.trim);
  const input::YamlValue standing = top.at("standing");
  standing.require_map(Keys{"hip_height_m"});
  network.hip_height_m = standing.at("hip_height_m").number({0.02, 2.0, "m"});
  network.hip_height_line = standing.at("hip_height_m").line();
  read_simulation(top.at("simulation"), network);
  if (const auto settings = top.find("network")) {
    read_network(*settings, network.network);
  }
  return network;
}

}  // namespace gaitway::urdf
