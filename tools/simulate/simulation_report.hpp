// What is told of a played trajectory: lines for people, JSON for programs, one page that carries everything
// in itself.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/kinematic/play.hpp"

namespace gaitway::tools {

struct Played {
  kinematic::Trajectory trajectory;
  kinematic::Course course;
  double reading_s = 0.0, playing_s = 0.0;  // wall time

  [[nodiscard]] double duration_s() const noexcept {
    return static_cast<double>(trajectory.rows() - 1) * facts::kSlot_s;
  }
};

enum class Subject : std::uint8_t { trajectory, zmp };

// One or, side by side, two.
struct Simulation {
  const urdf::RobotModel& robot;
  Subject subject = Subject::trajectory;
  std::vector<Played> played;
};

[[nodiscard]] std::string simulation_text(const Simulation& simulation);
[[nodiscard]] nlohmann::ordered_json simulation_json(const Simulation& simulation);
// Throws std::runtime_error naming the file when it cannot be written.
void write_simulation_page(const std::filesystem::path& file, const Simulation& simulation);

// The page's own script and style, as they stand in page/.
[[nodiscard]] std::string_view page_script();
[[nodiscard]] std::string_view page_style();

}  // namespace gaitway::tools
