// Reads motions strictly: what isn't understood is refused with file, line, field, value and rule.
#include "gaitway/motion/motion.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"

namespace gaitway::motion {
namespace {

using input::YamlValue;

using facts::kRadPerDegree;
constexpr input::Range kTilt{-60.0, 60.0, "deg"};
constexpr input::Range kShift{-1.0, 1.0, "m"};
constexpr input::Range kHipHeight{0.02, 2.0, "m"};
constexpr input::Range kShare{0.05, 1.0, "1"};
constexpr input::Range kTime{0.0, 60.0, "s"};

// The place of the value's text among the names.
std::size_t choice(const YamlValue& value, std::span<const std::string_view> names) {
  const std::string text = value.text();
  const auto found = std::ranges::find(names, text);
  if (found == names.end()) {
    value.refuse(fmt::format("must be {}", fmt::join(names, ", ")), "Choose one of them.");
  }
  return static_cast<std::size_t>(found - names.begin());
}

std::optional<double> number_in(const YamlValue& map, std::string_view key, const input::Range& range) {
  const auto value = map.find(key);
  return value ? std::optional(value->number(range)) : std::nullopt;
}

std::optional<double> angle_in(const YamlValue& map, std::string_view key) {
  const std::optional<double> angle_deg = number_in(map, key, kTilt);
  return angle_deg ? std::optional(*angle_deg * kRadPerDegree) : std::nullopt;
}

PelvisWish read_pelvis(const YamlValue& value) {
  constexpr std::array<std::string_view, 7> kKeys{"hip_height_m", "roll_deg",  "pitch_deg", "yaw_deg",
                                                  "over",         "forward_m", "left_m"};
  value.require_map(kKeys);
  PelvisWish wish;
  wish.hip_height_m = number_in(value, "hip_height_m", kHipHeight);
  wish.attitude_rad = {angle_in(value, "roll_deg"), angle_in(value, "pitch_deg"), angle_in(value, "yaw_deg")};
  if (const auto over = value.find("over")) {
    constexpr std::array<std::string_view, 3> kOver{"both", "left", "right"};
    wish.over = static_cast<Over>(choice(*over, kOver));
  }
  wish.com_offset_m = {number_in(value, "forward_m", kShift), number_in(value, "left_m", kShift)};
  return wish;
}

FootWish read_foot(const YamlValue& value) {
  constexpr std::array<std::string_view, 6> kKeys{"forward_m", "left_m",    "up_m",
                                                  "roll_deg",  "pitch_deg", "yaw_deg"};
  value.require_map(kKeys);
  FootWish wish;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    wish.position_m[axis] = number_in(value, kKeys[i], kShift).value_or(0.0);
    wish.attitude_rad[axis] = angle_in(value, kKeys[i + 3]).value_or(0.0);
  }
  if (wish.position_m.z() < 0.0) {
    value.at("up_m").refuse("the foot would be in the ground", "Choose 0 or more.");
  }
  return wish;
}

bool moves_legs(const Key& key, const urdf::RobotModel& robot) {
  return std::ranges::any_of(key.joints, [&](const JointAngle& angle) {
    return std::ranges::any_of(robot.legs, [&](const urdf::Leg& leg) {
      return std::ranges::find(leg.joints, angle.joint) != leg.joints.end();
    });
  });
}

void read_stance(const YamlValue& value, const urdf::RobotModel& robot, Key& key) {
  const bool legs_given = moves_legs(key, robot);
  const auto refuse_double = [&](const YamlValue& field) {
    if (legs_given || key.contact == Contact::none) {
      field.refuse(legs_given ? "the key gives angles of leg joints, which say this already"
                              : "with contact none nothing says where the ground is",
                   "Give one or the other.");
    }
  };
  if (const auto pelvis = value.find("pelvis")) {
    refuse_double(*pelvis);
    key.pelvis = read_pelvis(*pelvis);
  }
  for (const urdf::Side side : urdf::kSides) {
    const auto foot = value.find(side == urdf::Side::left ? "left_foot" : "right_foot");
    if (!foot) continue;
    refuse_double(*foot);
    if (stands_on(key.contact, side)) {
      foot->refuse(fmt::format("the robot stands on this foot: contact is {}", name_of(key.contact)),
                   "Only a lifted foot can be moved.");
    }
    key.foot[static_cast<std::size_t>(side)] = read_foot(*foot);
  }
}

Key read_key(const YamlValue& value, const urdf::RobotModel& robot, trajectory::PostureReader& postures) {
  constexpr std::array<std::string_view, 10> kKeys{"name",       "from",      "contact",   "hold_s",
                                                   "min_time_s", "joints",    "symmetric", "pelvis",
                                                   "left_foot",  "right_foot"};
  value.require_map(kKeys);
  Key key;
  key.name = value.at("name").text();
  key.where = fmt::format("{}:{}: key '{}'", value.file().string(), value.line(), key.name);
  if (const auto from = value.find("from")) {
    constexpr std::array<std::string_view, 2> kFrom{"previous", "home"};
    key.from_home = choice(*from, kFrom) == 1;
  }
  if (const auto contact = value.find("contact")) {
    key.contact = static_cast<Contact>(choice(*contact, kContactNames));
  }
  key.hold_s = number_in(value, "hold_s", kTime).value_or(0.0);
  key.min_time_s = number_in(value, "min_time_s", kTime).value_or(0.0);
  key.joints = postures.read(value);
  read_stance(value, robot, key);
  return key;
}

// Files are called after it.
std::string read_name(const YamlValue& value) {
  const std::string name = value.text();
  const auto is_allowed = [](unsigned char c) { return std::isalnum(c) != 0 || c == '_' || c == '-'; };
  if (name.empty() || !std::ranges::all_of(name, is_allowed))
    value.refuse("a motion's name must be letters, digits, '_' and '-'", "Give it another name.");
  return name;
}

Motion read(const YamlValue& file, const urdf::RobotModel& robot) {
  constexpr std::array<std::string_view, 6> kKeys{"name",    "description",  "start",
                                                  "lies_on", "torque_share", "keys"};
  file.require_map(kKeys);
  Motion motion{.name = read_name(file.at("name")),
                .description = file.at("description").text(),
                .torque_share = number_in(file, "torque_share", kShare),
                .lies_on = {},
                .keys = {}};
  if (const auto start = file.find("start")) {
    constexpr std::array<std::string_view, 2> kStarts{"home", "first_key"};
    motion.starts_at_first_key = choice(*start, kStarts) == 1;
  }
  if (const auto side = file.find("lies_on")) {
    if (!motion.starts_at_first_key) {
      side->refuse("the motion starts in the standing posture",
                   "Say start: first_key, too, or leave this out.");
    }
    motion.lies_on = static_cast<trajectory::LyingSide>(choice(*side, trajectory::kLyingSideNames));
  }
  const YamlValue keys = file.at("keys");
  trajectory::PostureReader postures(robot);
  for (const YamlValue& key : keys.items()) {
    motion.keys.push_back(read_key(key, robot, postures));
  }
  if (motion.keys.size() < (motion.starts_at_first_key ? 2U : 1U)) {
    keys.refuse("a motion goes to at least one key", "Add one.");
  }
  return motion;
}

}  // namespace

Motion read_motion(const std::filesystem::path& file, const urdf::RobotModel& robot) {
  return read(YamlValue::read(file), robot);
}

Motion parse_motion(const std::string& text, const std::filesystem::path& file,
                    const urdf::RobotModel& robot) {
  return read(YamlValue::parse(text, file), robot);
}

std::vector<std::filesystem::path> motion_files(const std::filesystem::path& folder) {
  if (!std::filesystem::is_directory(folder)) {
    throw urdf::RobotError(fmt::format(
        "{}: is no folder. Name the one that holds the motions' files, or make one with `gaitway motion "
        "adapt`",
        folder.string()));
  }
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".yaml") files.push_back(entry.path());
  }
  std::ranges::sort(files);
  return files;
}

}  // namespace gaitway::motion
