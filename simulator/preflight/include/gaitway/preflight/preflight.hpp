// Before something is sent to a robot it is tried on as many simulated ones, each of which differs from its
// description in another way, from where the robot is: the verdict is whether all of them stayed up.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario_event.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::preflight {

struct Flight {
  std::vector<simulator::ScenarioEvent> events;  // in order of time
  double seconds = 20.0;
};

struct PreflightOptions {
  simulator::CosimulationOptions robot;  // of each: plug-ins, world, the posture that it begins in
  int robots = 20;                       // with the seeds 1 to so many
  int processes = 0;                     // at once; 0: one for each processor
};

// What became of one robot.
struct Trial {
  std::uint64_t seed = 0;
  bool fell = false;
  double ended_s = 0.0;             // when it fell, or the flight's end
  double largest_tilt_rad = 0.0;    // of the trunk against the vertical
  std::uint64_t body_contacts = 0;  // milliseconds in which something but a sole touched something
  std::string first_contact;        // link and solid, or two links; empty: none
  std::uint64_t refused_batches = 0;
  // Why the robot did not do what it was asked, in its own words: a motion that was refused, a way that there
  // is not; or what the simulation threw. Empty: it did.
  std::string refusal;

  [[nodiscard]] bool passed() const noexcept { return !fell && refusal.empty(); }
};

struct Verdict {
  std::vector<Trial> trials;  // by seed
  double wall_s = 0.0;

  [[nodiscard]] int passed() const noexcept;
  [[nodiscard]] bool all_passed() const noexcept { return passed() == static_cast<int>(trials.size()); }
  // That fell first; when none did, that was not obeyed; otherwise that leaned most. Only with trials.
  [[nodiscard]] const Trial& worst() const;
};

// Done so many of so many.
using Progress = std::function<void(std::size_t done, std::size_t all)>;

// In copies of this process, which has a single thread. The same flight has the same verdict, on however many
// processors. Throws std::invalid_argument for no robots or a flight of no length; what cannot be simulated
// at all (a world without room, a plug-in that cannot be loaded) is thrown as std::runtime_error.
[[nodiscard]] Verdict fly(const urdf::RobotModel& robot, const Flight& flight,
                          const PreflightOptions& options, const Progress& progress = {});

// Eight pictures of that trial, in a row, its end in the last one. Throws std::runtime_error where no
// pictures can be drawn or written.
void draw_trial(const std::filesystem::path& file, const urdf::RobotModel& robot, const Flight& flight,
                const PreflightOptions& options, const Trial& trial);

[[nodiscard]] nlohmann::ordered_json verdict_json(const Verdict& verdict);
// A few lines for people.
[[nodiscard]] std::string verdict_text(const Verdict& verdict);

}  // namespace gaitway::preflight
