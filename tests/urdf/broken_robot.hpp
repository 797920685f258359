// A copy of the shipped robot in a folder of its own, damaged in one place.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::urdf::test {

inline constexpr const char* kNetworkFile = "robot.yaml";

class BrokenRobot {
 public:
  BrokenRobot() {
    std::string pattern = (std::filesystem::temp_directory_path() / "gaitway-robot-XXXXXX").string();
    if (!mkdtemp(pattern.data())) {
      throw std::runtime_error("cannot make a folder like " + pattern);
    }
    folder_ = pattern;
    for (const char* file : {"robot.urdf", "robot.yaml"}) {
      std::filesystem::copy_file(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22" / file,
                                 folder_ / file);
    }
  }
  ~BrokenRobot() { std::filesystem::remove_all(folder_); }
  BrokenRobot(const BrokenRobot&) = delete;
  BrokenRobot& operator=(const BrokenRobot&) = delete;

  // Replaces the first `before` after the first `anchor`.
  BrokenRobot& replace(const std::string& file, const std::string& anchor, const std::string& before,
                       const std::string& after) {
    std::string text = read(file);
    const std::size_t start = text.find(anchor);
    const std::size_t place = start == std::string::npos ? start : text.find(before, start);
    if (place == std::string::npos) {
      ADD_FAILURE() << "'" << before << "' after '" << anchor << "' is not in " << file;
      return *this;
    }
    write(file, text.replace(place, before.size(), after));
    return *this;
  }
  BrokenRobot& replace(const std::string& file, const std::string& before, const std::string& after) {
    return replace(file, before, before, after);
  }

  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder_ / file) << text;
  }
  void remove(const std::string& file) const { std::filesystem::remove(folder_ / file); }

  // "robot.yaml:17: ", for the line in which `text` first stands.
  [[nodiscard]] std::string line_of(const std::string& file, const std::string& text) const {
    const std::string content = read(file);
    const std::size_t place = content.find(text);
    EXPECT_NE(place, std::string::npos) << "'" << text << "' is not in " << file;
    const auto end = content.begin() + static_cast<std::ptrdiff_t>(std::min(place, content.size()));
    return file + ":" + std::to_string(1 + std::count(content.begin(), end, '\n')) + ": ";
  }

  [[nodiscard]] const std::filesystem::path& folder() const { return folder_; }
  [[nodiscard]] RobotModel load() const { return load_robot(folder_); }

  // What load_robot() says; nothing may appear on the terminal meanwhile.
  [[nodiscard]] std::string complaint() const {
    testing::internal::CaptureStderr();
    std::string text = "(loaded without complaint)";
    try {
      (void)load_robot(folder_);
    } catch (const RobotError& error) {
      text = error.what();
    }
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
    return text;
  }

  void expect_complaint(const std::vector<std::string>& parts) const {
    const std::string text = complaint();
    for (const std::string& part : parts) {
      EXPECT_THAT(text, testing::HasSubstr(part));
    }
  }

 private:
  [[nodiscard]] std::string read(const std::string& file) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / file).rdbuf();
    return text.str();
  }

  std::filesystem::path folder_;
};

}  // namespace gaitway::urdf::test
