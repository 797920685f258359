// The rows of the fault campaign: each one a fault, or a kind of faults that is drawn anew for each trial,
// and what is expected of a robot that meets it while it walks.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

// Something that happens, as a scenario has it: `fault: {...}`, `command: is_lost`.
struct FaultAction {
  double after_s = 0.0;  // the trial's instant
  std::string text;
};

enum class FaultExpectation {
  survives,  // no fall at any instant
  physics,   // a robot on two legs may fall; then it knows so before the impact, and does what it can
  not_yet,   // a better controller would survive it, and this one does not at every instant
  reported   // nothing is promised: the figures alone
};

struct FaultRow {
  std::string name;
  std::string what;  // for people
  FaultExpectation expected = FaultExpectation::survives;
  std::string why;  // where it falls
  // One of its faults; it depends on the stream alone.
  std::function<std::vector<FaultAction>(facts::RandomStream& random)> draw;
  bool is_told = true;  // where it may fall: the robot knows before the impact
};

// Of a robot with the joints and plug-ins that are shipped. A row about joints that this one has none of is
// left out.
[[nodiscard]] std::vector<FaultRow> fault_table(const urdf::RobotModel& robot);

// The rows of these names in the table's order, or all of them if there is none, without those of `except`.
// Throws std::invalid_argument for a name that no row has.
[[nodiscard]] std::vector<FaultRow> chosen_fault_rows(std::vector<FaultRow> table,
                                                      const std::vector<std::string>& names,
                                                      const std::vector<std::string>& except);

}  // namespace gaitway::tools
