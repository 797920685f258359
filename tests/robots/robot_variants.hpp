// humanoid22 with other legs, as folders that load: hips whose joints come in another order, and ankles.
// Names stay where they were, so that whoever goes by names or numbers goes wrong.
#pragma once

#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
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

 private:
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
