// The table.
#include "tools/campaign/real_time/real_time_row.hpp"

#include <fmt/format.h>
#include <signal.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "tools/campaign/real_time/sabotage_order.hpp"

namespace gaitway::tools {
namespace {

constexpr double kLong_s = 5.0;
constexpr std::int64_t kHour_ns = 3'600'000'000'000, kSlowWrite_ns = 200'000'000;

// Whom a row ends or stops.
using ProcessOf = std::function<pid_t(const WalkingRobot&)>;

class Stopped final : public Noise {
 public:
  explicit Stopped(pid_t process) : process_(process) { kill(process_, SIGSTOP); }
  // Somebody may have ended it meanwhile, which goes on nobody's account.
  ~Stopped() override { kill(process_, SIGCONT); }

 private:
  pid_t process_;
};

// A clock that is off, or a slow disk; sound again at the end.
class Disturbed final : public Noise {
 public:
  Disturbed(WalkingRobot& robot, std::int64_t shift_ns, std::int64_t write_ns) : robot_(robot) {
    robot_.disturb(shift_ns, write_ns);
  }
  ~Disturbed() override {
    try {
      robot_.disturb(0, 0);
    } catch (const std::exception&) {  // its folder is gone, and so is the robot
    }
  }

 private:
  WalkingRobot& robot_;
};

RealTimeRow killed(const std::string& part, const char* words, Equipment equipment,
                   const ProcessOf& process) {
  return {.name = part + "_killed",
          .what = fmt::format("{} is killed (SIGKILL)", words),
          .equipment = equipment,
          .begin = [process](FaultPlace& place) -> std::unique_ptr<Noise> {
            kill(process(place.robot), SIGKILL);
            return nullptr;
          }};
}

RealTimeRow stopped(const std::string& part, const char* words, Equipment equipment,
                    const ProcessOf& process) {
  return {.name = part + "_stopped_5s",
          .what = fmt::format("{} is stopped for 5 s (SIGSTOP)", words),
          .equipment = equipment,
          .lasts_s = kLong_s,
          .begin = [process](FaultPlace& place) -> std::unique_ptr<Noise> {
            return std::make_unique<Stopped>(process(place.robot));
          }};
}

void add_processes(std::vector<RealTimeRow>& table) {
  const auto part = [](const char* name) {
    return [name](const WalkingRobot& robot) { return robot.worker(name); };
  };
  const auto add = [&table](const char* name, const char* words, Equipment equipment,
                            const ProcessOf& process) {
    table.push_back(killed(name, words, equipment, process));
    table.push_back(stopped(name, words, equipment, process));
  };
  add("message_controller", "the message controller", Equipment::none, part("message_controller"));
  add("main_controller", "the main controller", Equipment::none, part("main_controller"));
  add("user_interface", "the user interface, over which the walk is ordered,", Equipment::none,
      part("user_interface"));
  add("plugin_host", "the process of the plug-in that balances", Equipment::for_faults,
      [](const WalkingRobot& robot) { return robot.plugin_host(); });
}

void add_plugins(std::vector<RealTimeRow>& table) {
  struct Way {
    const char *name, *sabotage, *what;
  };
  constexpr std::array<Way, 9> kWays{{{"segv", "segfault", "writes to where nothing is (SIGSEGV)"},
                                      {"abort", "abort", "aborts"},
                                      {"exit", "exit", "calls exit()"},
                                      {"throw", "throw", "throws"},
                                      {"loop", "loop", "loops without end"},
                                      {"leak", "memory", "takes all memory that it gets"},
                                      {"descriptors", "descriptors", "opens files until there are no more"},
                                      {"fork", "fork", "forks"},
                                      {"garbage", "garbage", "writes over the memory that it shares"}}};
  for (const Way& way : kWays) {
    table.push_back({.name = fmt::format("plugin_{}", way.name),
                     .what = fmt::format("the plug-in that balances, in a process of its own, {}", way.what),
                     .equipment = Equipment::for_faults,
                     .prepare = [sabotage = way.sabotage](FaultPlace& place, std::int64_t at_ns) {
                       place.robot.set_parameter("sabotage_order",
                                                 std::to_string(sabotage_order(sabotage, at_ns)));
                     }});
  }
}

void add_system(std::vector<RealTimeRow>& table) {
  const auto add = [&table](const char* name, const char* what, double lasts_s, auto begin) {
    table.push_back({.name = name,
                     .what = what,
                     .equipment = Equipment::for_faults,
                     .lasts_s = lasts_s,
                     .begin = [begin](FaultPlace& place) -> std::unique_ptr<Noise> { return begin(place); }});
  };
  add("disk_full_5s", "the disk of the logs is full for 5 s", kLong_s,
      [](FaultPlace& place) { return std::make_unique<FullDisk>(place.robot.logs()); });
  add("disk_full_restart", "the disk of the logs is full for 5 s, and the main controller is killed", kLong_s,
      [](FaultPlace& place) {
        auto full = std::make_unique<FullDisk>(place.robot.logs());
        kill(place.robot.worker("main_controller"), SIGKILL);
        return full;
      });
  add("disk_slow_5s", "each writing to a file takes 0.2 s more, for 5 s, and the main controller is killed",
      kLong_s, [](FaultPlace& place) {
        auto slow = std::make_unique<Disturbed>(place.robot, 0, kSlowWrite_ns);
        kill(place.robot.worker("main_controller"), SIGKILL);
        return slow;
      });
  add("clock_forward_1h", "the clock of the day jumps ahead by an hour, and after 3 s back", 3.0,
      [](FaultPlace& place) { return std::make_unique<Disturbed>(place.robot, kHour_ns, 0); });
  add("clock_back_1h", "the clock of the day jumps back by an hour, and after 3 s ahead", 3.0,
      [](FaultPlace& place) { return std::make_unique<Disturbed>(place.robot, -kHour_ns, 0); });
  table.push_back({.name = "processors_busy_5s",
                   .what = "on each processor a process spins, and two write to the disk, for 5 s",
                   .lasts_s = kLong_s,
                   .begin = [](FaultPlace& place) -> std::unique_ptr<Noise> {
                     return std::make_unique<BusyComputer>(place.robot.folder());
                   }});
}

void add_interface(std::vector<RealTimeRow>& table) {
  table.push_back({.name = "interface_flooded_5s",
                   .what = "eight clients ask for pages and order, as fast as they are answered, for 5 s",
                   .lasts_s = kLong_s,
                   .begin = [](FaultPlace& place) -> std::unique_ptr<Noise> {
                     return std::make_unique<Crowd>(place.robot.port());
                   }});
  table.push_back({.name = "interface_cut_off",
                   .what = "who commands falls silent, and the connection stays open",
                   .begin = [](FaultPlace& place) -> std::unique_ptr<Noise> {
                     place.person.fall_silent();
                     return nullptr;
                   }});
}

}  // namespace

std::vector<RealTimeRow> real_time_table() {
  std::vector<RealTimeRow> table;
  add_processes(table);
  add_plugins(table);
  add_system(table);
  add_interface(table);
  return table;
}

std::vector<RealTimeRow> chosen_real_time_rows(const std::vector<RealTimeRow>& table,
                                               const std::vector<std::string>& names,
                                               const std::vector<std::string>& except) {
  const auto require = [&table](const std::vector<std::string>& words, const char* option) {
    for (const std::string& name : words) {
      if (std::ranges::find(table, name, &RealTimeRow::name) != table.end()) continue;
      throw std::invalid_argument(fmt::format(
          "{} {}: there is no such row of real time; 'gaitway campaign --real-time --list' shows them",
          option, name));
    }
  };
  require(names, "--rows");
  require(except, "--except");
  std::vector<RealTimeRow> rows;
  for (const RealTimeRow& row : table) {
    const bool wanted = names.empty() || std::ranges::find(names, row.name) != names.end();
    if (wanted && std::ranges::find(except, row.name) == except.end()) rows.push_back(row);
  }
  if (rows.empty()) throw std::invalid_argument("--except: leaves no row");
  return rows;
}

}  // namespace gaitway::tools
