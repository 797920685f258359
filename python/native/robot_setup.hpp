// What a robot is made of, read and checked once; any number of runs begin from it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::python {

// One parameter of a plug-in, in place of what the configuration says.
struct ParameterChoice {
  std::string plugin, name, text;
};

// As people write it: robot, configuration and world are paths or names of shipped ones.
struct RobotChoice {
  std::string robot;  // empty: the default of `gaitway run`; so with the configuration
  std::string configuration;
  std::string profile;
  bool accept_unproven = false;
  std::vector<std::string> libraries;  // plug-ins put into the configuration
  std::vector<ParameterChoice> parameters;
  std::optional<std::string> world;
  std::optional<std::uint64_t> world_seed;
  std::string conditions;  // YAML, as a scenario's; empty: none
  bool navigation = false;
  bool localization = true;
  double mismatch = 1.0;
  // Topics that are written from outside in place of the plug-ins that otherwise do.
  std::vector<std::string> writes;
};

// What is global to the process (the log of the URDF reader, for one) is used by one robot at a time: whoever
// reads a description or loads plug-ins holds this lock.
[[nodiscard]] std::recursive_mutex& loading_lock();

class RobotSetup {
 public:
  // Throws input::InputError, core::ConfigurationError, core::PluginError, std::invalid_argument.
  explicit RobotSetup(const RobotChoice& choice);

  [[nodiscard]] const urdf::RobotModel& robot() const noexcept { return robot_; }
  [[nodiscard]] const std::vector<std::string>& writes() const noexcept { return writes_; }
  [[nodiscard]] const std::vector<std::string>& plugins_taken_out() const noexcept { return taken_out_; }
  [[nodiscard]] simulator::CosimulationOptions options(std::uint64_t seed,
                                                       msgclient::MemoryBlock& block) const;

 private:
  void add_navigation();
  void take_out_writers();
  void set_parameters(const std::vector<ParameterChoice>& parameters);

  urdf::RobotModel robot_;
  core::Configuration configuration_;
  simulator::CosimulationOptions options_;
  std::vector<std::string> writes_, taken_out_;
};

}  // namespace gaitway::python
