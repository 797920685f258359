// humanoid22 with another body, as folders that load: hips whose joints come in another order or whose axes
// have no common point, and ankles, where names stay so that whoever goes by names or numbers goes wrong;
// feet that tell their load otherwise or not at all; other sizes; other names; no arms. Motions and postures
// of a fall are not among its files.
#pragma once

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <iomanip>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gaitway::test {

class RobotVariant {
 public:
  RobotVariant() {
    std::string pattern = (std::filesystem::temp_directory_path() / "gaitway-robot-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("cannot make a folder like " + pattern);
    folder_ = pattern;
    urdf_ = read("robot.urdf");
    yaml_ = read("robot.yaml");
    write();
  }
  ~RobotVariant() { std::filesystem::remove_all(folder_); }
  RobotVariant(const RobotVariant&) = delete;
  RobotVariant& operator=(const RobotVariant&) = delete;

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }

  // All joints turn at most so fast.
  void limit_speed(double rad_per_s) {
    replace_numbers(urdf_, "velocity=\"", "\"", rad_per_s);
    replace_numbers(yaml_, "speed_limit_rad_per_s: ", ",", rad_per_s);
    write();
  }

  // The joint of both sides turns so far to either side; its name without the side.
  void narrow(const std::string& name, double rad) {
    const std::string number = std::to_string(rad), limit = "lower=\"-" + number + "\" upper=\"" + number;
    for (const std::string side : {"left_", "right_"})
      part(urdf_, "<joint name=\"" + side + name + "\"", "lower=\"", "\" effort", &limit);
    write();
  }

  // All motors have so much at most.
  void limit_torque(double torque_Nm) {
    replace_numbers(urdf_, "effort=\"", "\"", torque_Nm);
    replace_numbers(yaml_, "torque_limit_Nm: ", ",", torque_Nm);
    write();
  }

  // On both sides the joint names[i] turns as names[order[i]] did; names without their side.
  void reorder(const std::vector<std::string>& names, const std::vector<std::size_t>& order) {
    for (const std::string side : {"left_", "right_"}) {
      std::vector<std::string> turning, home;
      for (const std::string& name : names) {
        turning.push_back(part(urdf_, "<joint name=\"" + side + name + "\"", "<axis", "</joint>"));
        home.push_back(part(yaml_, "{name: " + side + name + ",", "]", "}"));
      }
      for (std::size_t i = 0; i < names.size(); ++i) {
        part(urdf_, "<joint name=\"" + side + names[i] + "\"", "<axis", "</joint>", &turning[order[i]]);
        part(yaml_, "{name: " + side + names[i] + ",", "]", "}", &home[order[i]]);
      }
    }
    write();
  }

  // On both sides the joint turns about an axis that lies so much beside; `name` without its side, y away
  // from the middle of the body. In the zero posture nothing else moves: neither the masses nor the other
  // joints.
  void move_axis(const std::string& name, const std::array<double, 3>& by_m) {
    for (const std::string side : {"left_", "right_"}) {
      std::array<double, 3> there_m = by_m;
      if (side == "right_") there_m[1] = -there_m[1];
      const std::array<double, 3> back_m{-there_m[0], -there_m[1], -there_m[2]};
      const std::string anchor = "<joint name=\"" + side + name + "\"", child = "<child link=\"";
      const std::string link = part(urdf_, anchor, child, "\"/>").substr(child.size());
      shift_origins(urdf_.find(anchor), "</joint>", there_m);
      shift_origins(urdf_.find("<link name=\"" + link + "\""), "</link>", back_m);
      shift_origins(urdf_.find("<parent link=\"" + link + "\""), "</joint>", back_m);
    }
    write();
  }

  // Joints and links are called otherwise: read backwards.
  void rename() {
    std::vector<std::string> names;
    for (const std::string element : {"<joint name=\"", "<link name=\""}) {
      for (std::size_t at = urdf_.find(element); at != std::string::npos; at = urdf_.find(element, at)) {
        at += element.size();
        names.push_back(urdf_.substr(at, urdf_.find('"', at) - at));
      }
    }
    for (std::string* const text : {&urdf_, &yaml_}) rename_words(*text, names);
    write();
  }
  static std::string renamed(std::string name) {
    std::reverse(name.begin(), name.end());
    return name;
  }

  void remove_arms() {
    for (const std::string side : {"left_", "right_"}) {
      for (const std::string joint : {"shoulder_pitch", "shoulder_roll", "elbow"}) {
        remove(urdf_, "  <joint name=\"" + side + joint + "\"", "</joint>");
        remove(yaml_, "  - {name: " + side + joint + ",", "\n");
      }
      for (const std::string link : {"shoulder", "upper_arm", "forearm"}) {
        remove(urdf_, "  <link name=\"" + side + link + "\"", "</link>");
      }
    }
    write();
  }

  // A body `larger` times as large that moves in the same way: lengths with it, masses with its cube, times
  // with its root.
  void scale(double larger) {
    const auto by = [larger](double power) { return std::pow(larger, power); };
    for (const char* length : {"size", "length", "radius"})
      multiply(urdf_, std::string(length) + "=\"", "\"", larger);
    multiply(urdf_, "<origin xyz=\"", "\"", larger);
    multiply(urdf_, "<mass value=\"", "\"", by(3));
    for (const char* moment : {"ixx", "ixy", "ixz", "iyy", "iyz", "izz"}) {
      multiply(urdf_, std::string(moment) + "=\"", "\"", by(5));
    }
    multiply(urdf_, "effort=\"", "\"", by(4));
    multiply(urdf_, "velocity=\"", "\"",
             by(-0.5) * (1.0 - 1e-9));  // never above the motor's, however it is rounded
    const std::vector<std::pair<const char*, double>> powers{{"stiffness_Nm_per_rad", 4},
                                                             {"damping_Nms_per_rad", 4.5},
                                                             {"torque_limit_Nm", 4},
                                                             {"speed_limit_rad_per_s", -0.5},
                                                             {"armature_kg_m2", 5},
                                                             {"friction_Nm", 4},
                                                             {"sole_position_m", 1},
                                                             {"size_m", 1},
                                                             {"centre_m", 1},
                                                             {"cell_inset_m", 1},
                                                             {"position_m", 1},
                                                             {"force_N", 3},
                                                             {"angular_velocity_rad_per_s", -0.5},
                                                             {"slew_deg_per_s", -0.5},
                                                             {"hip_height_m", 1}};
    for (const auto& [key, power] : powers) {
      for (const std::string before : {" ", "{"}) {
        multiply(yaml_, before + key + ": [", "]", by(power));
        multiply(yaml_, before + key + ": ", ",}\n", by(power));
      }
    }
    if (larger < 1.0)
      multiply(yaml_, "count_deg: ", " ,", 1.6);  // a byte of counts must hold the higher speed
    write();
  }

  // Force and torques at a sensor 20 mm above each sole in place of the four cells, in three channels.
  void give_six_axis_feet() {
    for (const std::string side : {"left", "right"}) {
      exchange(yaml_, side + "_cell_front_left, " + side + "_cell_front_right",
               side + "_foot_force_z, " + side + "_foot_torque_x");
      exchange(yaml_, side + "_cell_rear_left, " + side + "_cell_rear_right", side + "_foot_torque_y, none");
    }
    exchange(yaml_, "cell_inset_m: 0.005}", "sensor: six_axis, sensor_position_m: [0, 0, -0.02]}");
    exchange(yaml_, "channel_scale: {force_N: 0.01",
             "channel_scale: {foot_force_N: 0.01, foot_torque_Nm: 0.001");
    exchange(yaml_, "force_N: 0.2", "force_N: 0.4, torque_Nm: 0.01");
    write();
  }

  void take_foot_sensors() {
    for (const std::string side : {"left", "right"}) {
      exchange(yaml_, side + "_cell_front_left, " + side + "_cell_front_right", "none, none");
      exchange(yaml_, side + "_cell_rear_left, " + side + "_cell_rear_right", "none, none");
    }
    exchange(yaml_, "cell_inset_m: 0.005}", "sensor: none}");
    write();
  }

  void put_imu_into_base() {
    exchange(yaml_, "imu: {link: trunk, position_m: [0, 0, 0.10]",
             "imu: {link: pelvis, position_m: [0, 0, 0.02]");
    write();
  }

  void trim_ankles_alone() {
    for (const char* const hip : {"0", "1", "2", "3"})
      exchange(yaml_, std::string(", trim_channel: ") + hip, "");
    write();
  }

  // As no robot is built: its parts are as described, and its inclinometer knows accelerations from tilts.
  void build_of_ideal_parts() {
    exchange(yaml_, ", inclinometer: pendulum", "");
    exchange(yaml_, "  parts: 1\n", "");
    write();
  }

  void take_inclinometer() {
    exchange(yaml_, ", inclinometer: pendulum", "");
    for (const char* const tilt : {"inclination_roll", "inclination_pitch"}) exchange(yaml_, tilt, "none");
    exchange(yaml_, ", inclination_rad: 0.0001", "");
    write();
  }

  void take_foot_accelerometers() {
    for (const std::string side : {"left", "right"}) {
      for (const char* const axis : {"x", "y", "z"}) {
        exchange(yaml_, side + "_foot_acceleration_" + axis, "none");
      }
    }
    write();
  }

 private:
  // Everywhere.
  static void exchange(std::string& text, const std::string& before, const std::string& after) {
    std::size_t place = text.find(before);
    if (place == std::string::npos) throw std::runtime_error("humanoid22 has no " + before);
    for (; place != std::string::npos; place = text.find(before, place + after.size())) {
      text.replace(place, before.size(), after);
    }
  }
  // Every list of numbers between `from` and the first of the characters `to`.
  static void multiply(std::string& text, const std::string& from, const std::string& to, double factor) {
    for (std::size_t begin = text.find(from); begin != std::string::npos; begin = text.find(from, begin)) {
      begin += from.size();
      const std::size_t end = text.find_first_of(to, begin);
      if (text[begin] == '[') continue;  // a list, whose turn is another
      std::string numbers = text.substr(begin, end - begin), scaled;
      std::replace(numbers.begin(), numbers.end(), ',', ' ');
      std::istringstream words(numbers);
      const char* const between = to == "]" ? ", " : " ";
      for (double number = 0.0; words >> number;) {
        std::ostringstream word;
        word << std::setprecision(12) << number * factor;
        scaled += (scaled.empty() ? "" : between) + word.str();
      }
      text.replace(begin, end - begin, scaled);
    }
  }
  // Of all origins from `begin` to the first `end` of the URDF.
  void shift_origins(std::size_t begin, const std::string& end, const std::array<double, 3>& by_m) {
    const std::string origin = "<origin xyz=\"";
    for (std::size_t at = urdf_.find(origin, begin); at < urdf_.find(end, begin);
         at = urdf_.find(origin, at)) {
      at += origin.size();
      const std::size_t length = urdf_.find('"', at) - at;
      std::istringstream words(urdf_.substr(at, length));
      std::ostringstream shifted;
      for (const double by : by_m) {
        double number = 0.0;
        words >> number;
        shifted << number + by << ' ';
      }
      urdf_.replace(at, length, shifted.str().substr(0, shifted.str().size() - 1));
    }
  }
  // A word is what letters, digits and underscores make: a channel that begins with a link's name is another.
  static void rename_words(std::string& text, const std::vector<std::string>& names) {
    const auto is_of_word = [](char c) {
      return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
    };
    for (auto begin = text.begin(); begin != text.end();) {
      const auto end = std::find_if_not(begin, text.end(), is_of_word);
      if (std::find(names.begin(), names.end(), std::string(begin, end)) != names.end())
        std::reverse(begin, end);
      begin = end == text.end() ? end : end + 1;
    }
  }
  static void remove(std::string& text, const std::string& from, const std::string& to) {
    const std::size_t begin = text.find(from), end = text.find(to, begin);
    if (end == std::string::npos) throw std::runtime_error("humanoid22 has no " + from);
    text.erase(begin, end + to.size() - begin);
  }
  static void replace_numbers(std::string& text, const std::string& from, const std::string& to,
                              double number) {
    for (std::size_t begin = text.find(from); begin != std::string::npos; begin = text.find(from, begin)) {
      begin += from.size();
      text.replace(begin, text.find_first_of(to, begin) - begin, std::to_string(number));
    }
  }
  // What stands from `from` up to `to`, after `anchor`; replaced if there is something to put there.
  static std::string part(std::string& text, const std::string& anchor, const std::string& from,
                          const std::string& to, const std::string* replacement = nullptr) {
    const std::size_t begin = text.find(from, text.find(anchor)), end = text.find(to, begin);
    if (end == std::string::npos) throw std::runtime_error("humanoid22 has no " + anchor);
    std::string found = text.substr(begin, end - begin);
    if (replacement != nullptr) text.replace(begin, end - begin, *replacement);
    return found;
  }
  static std::string read(const std::string& name) {
    std::ifstream file(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22" / name);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  void write() const {
    std::ofstream(folder_ / "robot.urdf") << urdf_;
    std::ofstream(folder_ / "robot.yaml") << yaml_;
  }

  std::filesystem::path folder_;
  std::string urdf_, yaml_;
};

// Of hip yaw, roll and pitch: who comes first, second, third.
inline const std::vector<std::vector<std::size_t>> kHipOrders{{0, 1, 2}, {0, 2, 1}, {1, 0, 2},
                                                              {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
inline const std::vector<std::string> kHip{"hip_yaw", "hip_roll", "hip_pitch"};
inline const std::vector<std::string> kAnkle{"ankle_pitch", "ankle_roll"};

}  // namespace gaitway::test
