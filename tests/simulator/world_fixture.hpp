// A robot in a world of the test's own.
#pragma once

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "gaitway/world/world_file.hpp"
#include "home_servo.hpp"

namespace gaitway::simulator {

class WorldTest : public ::testing::Test {
 protected:
  ~WorldTest() override { std::filesystem::remove(file_); }

  [[nodiscard]] world::World world(const std::string& text) const {
    std::ofstream(file_) << text;
    return world::read_world(file_);
  }
  [[nodiscard]] PlantOptions options(const std::string& text) const {
    PlantOptions options{.mismatch = 0.0, .sensor_noise = false};
    options.world = world(text);
    return options;
  }
  [[nodiscard]] Plant plant(const std::string& text) const { return {model_, options(text)}; }
  void hold(Plant& robot, int ms) { HomeServo(model_).hold(robot, ms); }
  [[nodiscard]] int link(const std::string& name) const { return model_.link_index(name); }

  urdf::RobotModel model_ = humanoid22();
  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("gaitway_world_" + std::to_string(getpid()) + ".yaml");
};

}  // namespace gaitway::simulator
