// Hours of walking in which one fault after the other comes at random: whether the robot stays up, whether
// every loss is found and put right, and whether memory stays as it was.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <string>
#include <vector>

#include "tools/campaign/fault_table.hpp"
#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {

struct EnduranceOptions {
  double hours = 8.0;  // of each robot, in virtual time
  int robots = 4;      // seeds 1, 2, ...
  int jobs = 1;        // processes side by side
  double speed_m_per_s = 0.2;
  double mean_pause_s = 10.0;                  // between two faults; they come as memoryless events do
  std::function<void(double share)> progress;  // empty: none
};

struct EnduranceFall {
  double at_s = 0.0;
  std::vector<std::string> rows;  // of the faults of the ten seconds before, the newest first
  std::uint64_t seed = 0;         // of the robot that fell
  std::string scenario;           // from its start to its fall, for `gaitway run --scenario FILE --seed SEED`
};

// Of one robot. After a fall another one with the next deviations walks on in its stead.
struct EnduranceRun {
  int robot = 0;
  double played_s = 0.0, walked_m = 0.0;
  std::map<std::string, std::uint64_t> faults;  // of each row
  std::vector<EnduranceFall> falls;
  std::uint64_t looks = 0;         // at the joints, when the last fault was some seconds ago
  std::uint64_t wrong_joints = 0;  // found there: their references were not what they ought to be
  double longest_stand_s = 0.0;    // without having walked on
  std::uint64_t memory_first_KiB = 0,
                memory_last_KiB = 0;  // resident, after a tenth of the time and at the end

  [[nodiscard]] std::uint64_t fault_count() const;
};

// Those rows whose faults a robot survives and that pass by themselves, as of this draw.
[[nodiscard]] std::vector<FaultRow> passing_rows(const std::vector<FaultRow>& table,
                                                 const urdf::RobotModel& robot);

// Outcomes depend on rows, robot and options alone, but for the memory. Call it where there is a single
// thread.
[[nodiscard]] std::vector<EnduranceRun> run_endurance(const TrialRobot& robot,
                                                      const std::vector<FaultRow>& rows,
                                                      const EnduranceOptions& options);

// Without the falls' scenarios.
[[nodiscard]] nlohmann::ordered_json endurance_json(const std::vector<EnduranceRun>& runs);
// Name of the file that a robot's fall is written to, among the results; counted from 0.
[[nodiscard]] std::string fall_file(const EnduranceRun& run, std::size_t fall);
[[nodiscard]] std::string endurance_markdown(const EnduranceOptions& options,
                                             const std::vector<EnduranceRun>& runs);

}  // namespace gaitway::tools
