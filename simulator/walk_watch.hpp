// Sees where the simulated robot goes and whether it falls, for the summary and the log of the virtual_robot
// process.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "gaitway/simulator/plant.hpp"

namespace gaitway::simulator {

class WalkWatch {
 public:
  WalkWatch(const Plant& plant, bool log_wanted, std::int64_t start_ns);

  // To be called after each millisecond; the first fall is printed.
  void look(const Plant& plant, std::int64_t now_ns);

  [[nodiscard]] double time_s(std::int64_t now_ns) const noexcept {
    return static_cast<double>(now_ns - start_ns_) * 1e-9;
  }
  [[nodiscard]] const std::optional<double>& fell_at_s() const noexcept { return fell_at_s_; }
  [[nodiscard]] double distance_m(const Plant& plant) const;
  // Where the base was, every 10 ms (CSV). Throws what process::write_text_file() throws.
  void write_log(const std::filesystem::path& file) const;

 private:
  struct Row {
    double time_s;
    Eigen::Vector3d base_m;
    double trunk_tilt_rad;
  };
  bool log_wanted_;
  std::int64_t start_ns_;
  Eigen::Vector3d start_m_;
  std::optional<double> fell_at_s_;
  std::vector<Row> log_;
};

}  // namespace gaitway::simulator
