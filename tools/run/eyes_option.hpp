// What the robot's cameras see in a run, as files for people.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::tools {

class EyeFiles {
 public:
  // Without a folder: writes nothing. Throws std::invalid_argument where the robot has no camera; makes the
  // folder.
  EyeFiles(const std::optional<std::filesystem::path>& folder, const simulator::Cosimulation& cosimulation);

  // After each millisecond: writes each new pair as `000123.png`, by its number, the left picture left. One
  // that cannot be written is counted.
  void look(const simulator::Cosimulation& cosimulation);
  // Throws std::runtime_error, with the reason, where there were no pictures.
  void finish(const simulator::Cosimulation& cosimulation) const;
  // Throws std::runtime_error, with the reason, where some could not be written.
  void require_all() const;

 private:
  std::optional<std::filesystem::path> folder_;
  std::uint64_t written_ = 0;  // number of the newest
  std::uint64_t lost_ = 0;
  std::string failure_;
};

}  // namespace gaitway::tools
