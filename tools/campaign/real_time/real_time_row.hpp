// The rows of the campaign in real time: faults of processes, of the operating system, of whoever is at the
// interface.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tools/campaign/real_time/noise.hpp"
#include "tools/campaign/real_time/person.hpp"
#include "tools/campaign/real_time/walking_robot.hpp"

namespace gaitway::tools {

// What a fault may touch.
struct FaultPlace {
  WalkingRobot& robot;
  Person& person;
};

struct RealTimeRow {
  std::string name;
  std::string what;
  Equipment equipment = Equipment::none;
  double lasts_s = 0.0;  // from its beginning to its end
  // Called once shortly before the fault, which is to come at this instant; empty: nothing to prepare.
  std::function<void(FaultPlace&, std::int64_t at_ns)> prepare = {};
  // At the instant; what it leaves ends after lasts_s. Empty: it comes by itself.
  std::function<std::unique_ptr<Noise>(FaultPlace&)> begin = {};
};

[[nodiscard]] std::vector<RealTimeRow> real_time_table();
// Throws std::invalid_argument for a name that is none of them.
[[nodiscard]] std::vector<RealTimeRow> chosen_real_time_rows(const std::vector<RealTimeRow>& table,
                                                             const std::vector<std::string>& names,
                                                             const std::vector<std::string>& except);

}  // namespace gaitway::tools
