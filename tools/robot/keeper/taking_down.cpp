// The reverse of the start: who plans ends first, the safe tail brings the robot to a stand, then who plays
// it ends.
#include <fmt/format.h>
#include <signal.h>

#include <algorithm>

#include "gaitway/process/real_time.hpp"
#include "tools/robot/keeper/robot_keeper.hpp"

namespace gaitway::tools {
namespace {

constexpr std::int64_t kStandPatience_ns = 5'000'000'000;  // a safe tail lasts two seconds at most
constexpr std::int64_t kAfterKill_ns = 2'000'000'000;
constexpr std::int64_t kBetweenStandLooks_ns = 20'000'000;

// Nothing: it has not ended by then.
std::optional<std::string> wait_for_end(PartProcess& process, std::int64_t until_ns) {
  while (true) {
    if (auto how = process.take_end()) return how;
    if (process::monotonic_ns() >= until_ns) return std::nullopt;
    pollfd ended{process.ended_fd(), POLLIN, 0};
    process::wait_until(until_ns, {&ended, 1});
  }
}

// False: it had to be killed.
bool end_part(const PartPlan& plan, PartProcess& process, const Tell& tell) {
  if (process.pid() == 0) return true;
  process.send(SIGTERM);
  process.send(SIGCONT);  // should it have been stopped
  if (wait_for_end(process, process::monotonic_ns() + plan.end_ns)) {
    tell(fmt::format("{}: ended", plan.name));
    return true;
  }
  process.end_group();
  const bool gone = wait_for_end(process, process::monotonic_ns() + kAfterKill_ns).has_value();
  tell(fmt::format("{}: did not end within {:g} s when it was told to and was killed{}", plan.name,
                   static_cast<double>(plan.end_ns) * 1e-9, gone ? "" : "; it has not gone even so"));
  return false;
}

void wait_for_stand(RobotView& view, const Tell& tell) {
  const std::int64_t begin_ns = process::monotonic_ns();
  while (view.look() && process::monotonic_ns() - begin_ns < kStandPatience_ns) {
    if (view.holds(process::monotonic_ns())) {
      tell("the robot stands");
      return;
    }
    process::wait_until(process::monotonic_ns() + kBetweenStandLooks_ns, {});
  }
  tell("whether the robot stands is not known: its message controller does not say so");
}

}  // namespace

bool end_parts(const std::vector<PartPlan>& plans, std::vector<PartProcess>& processes, RobotView& view,
               const Tell& tell) {
  bool well = true;
  for (std::size_t i = plans.size(); i-- > 0;) {
    const bool was_there = processes[i].pid() != 0;
    // The robot stands before its message controller ends, whether it was the main controller that ended.
    if (was_there && plans[i].progress == Progress::block) wait_for_stand(view, tell);
    well = end_part(plans[i], processes[i], tell) && well;
  }
  return well;
}

}  // namespace gaitway::tools
