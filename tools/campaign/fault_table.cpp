// What can happen to a robot that walks, room by room: bus, batches, controllers, plug-ins, joints, sensors,
// supply, commander; and two of them together.
#include "tools/campaign/fault_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string_view>
#include <utility>

#include "gaitway/input/complaint.hpp"

namespace gaitway::tools {
namespace {

using facts::RandomStream;
using Names = std::vector<std::string>;

// In whole steps of a tenth of a millisecond, so that its text is short.
double between(RandomStream& random, double lowest, double highest) {
  return std::round((lowest + (highest - lowest) * random.uniform()) * 1e4) * 1e-4;
}
const std::string& one_of(RandomStream& random, const Names& names) {
  return names[static_cast<std::size_t>(random.next() % names.size())];
}
std::string number(double value) {
  return fmt::format("{:.4g}", value);
}

class FaultTable {
 public:
  explicit FaultTable(const urdf::RobotModel& robot) {
    std::vector<bool> in_a_leg(robot.joints.size(), false);
    for (const urdf::Leg& leg : robot.legs) {
      for (const int joint : leg.joints) in_a_leg[static_cast<std::size_t>(joint)] = true;
    }
    for (std::size_t joint = 0; joint < robot.joints.size(); ++joint) {
      const std::string& name = robot.joints[joint].name;
      joints_.push_back(name);
      const bool bears = in_a_leg[joint] || name.find("waist") != std::string::npos;
      (bears ? bearing_ : others_).push_back(name);
    }
  }

  std::vector<FaultRow> rows() && {
    add_bus();
    add_stations();
    add_batches();
    add_controllers();
    add_plugins();
    add_joints();
    add_sensors();
    add_rest();
    add_pairs();
    return std::move(rows_);
  }

 private:
  // A row of one fault. `text`: what stands between the braces, made with the trial's stream.
  template <class Text>
  void add(const char* name, std::string what, Text text,
           FaultExpectation expected = FaultExpectation::survives, const char* why = "") {
    const auto draw = [text = std::move(text)](RandomStream& random) {
      return std::vector<FaultAction>{{0.0, "fault: {kind: " + text(random) + "}"}};
    };
    rows_.push_back({name, std::move(what), expected, why, draw});
  }
  // ... that is always the same.
  void add_plain(const char* name, const char* what, const char* text,
                 FaultExpectation expected = FaultExpectation::survives, const char* why = "") {
    add(
        name, what, [text](RandomStream&) { return std::string(text); }, expected, why);
  }

  void add_bus();
  void add_stations();
  void add_batches();
  void add_controllers();
  void add_plugins();
  void add_joints();
  void add_sensors();
  void add_rest();
  void add_pairs();
  void add_dead_joints(const char* name, const char* what, const char* part, FaultExpectation expected,
                       const char* why);
  // `not_yet`: which of the ways it does not survive so far, and why; the others it does.
  struct Weakness {
    std::string_view way;
    const char* why;
    FaultExpectation expected = FaultExpectation::not_yet;
  };
  void add_sensor(const std::string& name, const std::string& what, const Names& sensors,
                  const std::vector<Weakness>& weaknesses = {});

  std::vector<FaultRow> rows_;
  Names joints_;
  Names bearing_, others_;  // of legs and waist: what is above falls with them; and the rest
};

void FaultTable::add_bus() {
  add("bit_errors", "1 to 5 % of all frames corrupted, for 2 s", [](RandomStream& random) {
    return fmt::format("disturb_bus, corruption: {}, duration_s: 2", number(between(random, 0.01, 0.05)));
  });
  add("error_burst", "half of all frames corrupted, for 5 to 20 ms", [](RandomStream& random) {
    return fmt::format("disturb_bus, corruption: 0.5, duration_s: {}", number(between(random, 0.005, 0.02)));
  });
  add("omissions", "2 % of all frames missed by some receivers, for 2 s",
      [](RandomStream&) { return std::string("disturb_bus, omission: 0.02, duration_s: 2"); });
  add("duplicates", "5 % of all frames come twice to some receivers, for 2 s",
      [](RandomStream&) { return std::string("disturb_bus, duplicate: 0.05, duration_s: 2"); });
  add("one_misses", "one joint hears nothing for 10 to 20 ms, and nobody notices",
      [joints = joints_](RandomStream& random) {
        const std::string& joint = one_of(random, joints);
        return fmt::format("misses_frames, node: {}, duration_s: {}", joint,
                           number(between(random, 0.01, 0.02)));
      });
  add("jam", "noise jams the bus for 2 to 20 ms", [](RandomStream& random) {
    return fmt::format("jam, duration_s: {}", number(between(random, 0.002, 0.02)));
  });
  add("stuck_dominant", "the line is dominant for 2 to 20 ms", [](RandomStream& random) {
    return fmt::format("jam, duration_s: {}, stuck: true", number(between(random, 0.002, 0.02)));
  });
  add_plain("bus_gone_5s", "the bus is unusable for 5 s", "jam, duration_s: 5");
}

void FaultTable::add_stations() {
  add("babbler_urgent", "a stranger sends the most urgent frame without end, for 5 to 80 ms",
      [](RandomStream& random) {
        return fmt::format("babbles, id: 0, data: [], duration_s: {}", number(between(random, 0.005, 0.08)));
      });
  add("babbler_joint", "a joint sends a frame of no meaning without end, for 5 to 80 ms",
      [joints = joints_](RandomStream& random) {
        const std::string& joint = one_of(random, joints);
        return fmt::format("babbles, node: {}, id: 7, data: [0, 0, 0, 0, 0, 0, 0, 0], duration_s: {}", joint,
                           number(between(random, 0.005, 0.08)));
      });
  add_plain("babbler_idle", "a stranger sends the least urgent frame without end, for 2 s",
            "babbles, id: 2047, data: [0, 0, 0, 0, 0, 0, 0, 0], duration_s: 2");
  add_plain("message_controller_bus_off", "the message controller's station goes bus-off",
            "bus_off, node: message_controller");
  add("joint_bus_off", "the station of any one joint goes bus-off",
      [joints = joints_](RandomStream& random) { return "bus_off, node: " + one_of(random, joints); });
}

void FaultTable::add_batches() {
  add("batch_late", "a batch is handed over 1 to 79 ms late", [](RandomStream& random) {
    return fmt::format("batch_fails, how: late, late_s: {}", number(between(random, 0.001, 0.079)));
  });
  add_plain("batch_damaged", "a batch is damaged on its way", "batch_fails, how: damaged");
  add_plain("batch_old", "the newest plan is handed over for the running cycle", "batch_fails, how: old");
  add_plain("batch_early", "... for the cycle after the next", "batch_fails, how: early");
  add_plain("batch_stale", "... for the next cycle, which has other points", "batch_fails, how: stale");
  add_plain("batch_garbage", "a batch of random points is handed over", "batch_fails, how: garbage");
  add("batch_lost_for_joint", "one joint of leg or waist gets no batch for 80 to 160 ms",
      [bearing = bearing_](RandomStream& random) {
        const std::string& joint = one_of(random, bearing);
        return fmt::format("lose_frames, probability: 1, duration_s: {}, batch_of: {}",
                           number(between(random, 0.08, 0.16)), joint);
      });
}

void FaultTable::add_controllers() {
  add_plain("main_controller_dead", "the main controller dies for good", "main_controller_silent");
  add_plain("main_controller_silent_5s", "... is silent for 5 s", "main_controller_silent, duration_s: 5");
  add("main_controller_returns", "... is away for 0.12 to 0.5 s", [](RandomStream& random) {
    return fmt::format("main_controller_silent, duration_s: {}", number(between(random, 0.12, 0.5)));
  });
  add("main_controller_overrun", "... misses its ticks for 10 to 100 ms", [](RandomStream& random) {
    return fmt::format("main_controller_silent, duration_s: {}", number(between(random, 0.01, 0.1)));
  });
  add_plain("message_controller_dead", "the message controller dies for good", "message_controller_silent");
  add_plain("message_controller_silent_5s", "... is stopped for 5 s, and goes on where it was",
            "message_controller_silent, duration_s: 5");
  add_plain("message_controller_restarts", "... dies, and starts again after 0.5 s",
            "message_controller_silent, duration_s: 0.5, restarts: true");
  add("message_controller_returns", "... is stopped for 0.02 to 0.5 s", [](RandomStream& random) {
    return fmt::format("message_controller_silent, duration_s: {}", number(between(random, 0.02, 0.5)));
  });
}

void FaultTable::add_plugins() {
  const Names plugins{"zmp", "trajectory", "stability", "kinematics"};
  const auto fails = [plugins](const char* how) {
    return [plugins, how](RandomStream& random) {
      return fmt::format("plugin_fails, plugin: {}, how: {}", one_of(random, plugins), how);
    };
  };
  add("plugin_throws", "a plug-in throws, for ever", fails("throws"));
  add("plugin_nan", "... tells what is not a number, for ever", fails("not_a_number"));
  add("plugin_garbage", "... tells numbers that are far off, for ever", fails("jumps"));
  add("plugin_overruns", "... takes 6 ms for each step, for ever", fails("overruns, cost_s: 0.006"));
  add("plugin_hangs", "... hangs in one step for 2 s", fails("overruns, cost_s: 2, duration_s: 0.01"));
}

void FaultTable::add_dead_joints(const char* name, const char* what, const char* part,
                                 FaultExpectation expected, const char* why) {
  Names these;
  std::ranges::copy_if(joints_, std::back_inserter(these),
                       [part](const std::string& joint) { return joint.find(part) != std::string::npos; });
  if (these.empty()) return;
  add(
      name, what, [these](RandomStream& random) { return "joint_dies, joint: " + one_of(random, these); },
      expected, why);
}

void FaultTable::add_joints() {
  constexpr auto kPhysics = FaultExpectation::physics;
  add("joint_restarts_20ms", "any one joint is without power for 20 ms",
      [joints = joints_](RandomStream& random) {
        return fmt::format("joint_restarts, joint: {}, duration_s: 0.02", one_of(random, joints));
      });
  add("arm_restarts_300ms", "a joint of arm or neck is without power for 0.3 s",
      [others = others_](RandomStream& random) {
        return fmt::format("joint_restarts, joint: {}, duration_s: 0.3", one_of(random, others));
      });
  add(
      "leg_restarts_300ms", "a joint of leg or waist is without power for 0.3 s",
      [bearing = bearing_](RandomStream& random) {
        return fmt::format("joint_restarts, joint: {}, duration_s: 0.3", one_of(random, bearing));
      },
      kPhysics, "a leg that bears the robot folds within 0.3 s");
  const char* const folds = "the leg that bears the robot, or is to do so next, folds";
  add_dead_joints("dead_hip_yaw", "a hip's yaw joint dies", "hip_yaw", kPhysics,
                  "the foot turns freely under the robot");
  add_dead_joints("dead_hip_roll", "a hip's roll joint dies", "hip_roll", kPhysics,
                  "that leg folds; no fall is told, since the IMU hangs on such a joint");
  rows_.back().is_told = false;
  add_dead_joints("dead_hip_pitch", "a hip's pitch joint dies", "hip_pitch", kPhysics, folds);
  add_dead_joints("dead_knee", "a knee dies", "knee", kPhysics, folds);
  add_dead_joints("dead_ankle_pitch", "an ankle's pitch joint dies", "ankle_pitch", kPhysics,
                  "nothing holds the robot above that foot");
  add_dead_joints("dead_ankle_roll", "an ankle's roll joint dies", "ankle_roll", kPhysics,
                  "nothing holds the robot above that foot");
  add_dead_joints("dead_waist", "a joint of the waist dies", "waist", kPhysics, "the trunk folds");
  add_dead_joints("dead_neck", "a joint of the neck dies", "neck", FaultExpectation::survives, "");
  add_dead_joints("dead_shoulder", "a joint of a shoulder dies", "shoulder", FaultExpectation::survives, "");
  add_dead_joints("dead_elbow", "an elbow dies", "elbow", FaultExpectation::survives, "");
}

void FaultTable::add_sensor(const std::string& name, const std::string& what, const Names& sensors,
                            const std::vector<Weakness>& weaknesses) {
  if (sensors.empty()) return;
  constexpr std::array<std::array<const char*, 3>, 5> kWays{{{"zero", "reads_zero", "reads zero"},
                                                             {"stuck", "freezes", "is stuck"},
                                                             {"noisy", "noisy", "has thirty times its noise"},
                                                             {"biased", "biased", "is off by a constant"},
                                                             {"exchanged", "exchanged", "is exchanged"}}};
  for (const auto& [suffix, how, words] : kWays) {
    Names these = sensors;
    if (std::string_view(how) == "exchanged") {
      std::erase_if(these, [](const std::string& sensor) {
        return sensor != "imu" && !sensor.starts_with("left_") && !sensor.starts_with("right_");
      });
    }
    if (these.empty()) continue;
    const auto weak = std::ranges::find(weaknesses, std::string_view(suffix), &Weakness::way);
    const bool survives = weak == weaknesses.end();
    add((name + "_" + suffix).c_str(), what + " " + words + ", for ever",
        [these, how](RandomStream& random) {
          return fmt::format("sensor_fails, sensor: {}, how: {}", one_of(random, these), how);
        },
        survives ? FaultExpectation::survives : weak->expected, survives ? "" : weak->why);
  }
}

void FaultTable::add_sensors() {
  constexpr auto kPhysics = FaultExpectation::physics;
  add_sensor("imu", "the IMU", {"imu"},
             {{"exchanged", "nobody compares it with the soles; the trims tip the robot over"}});
  add_sensor("foot", "a foot's force sensor", {"left_foot", "right_foot"},
             {{"zero", "a load that is there is not believed"},
              {"stuck", "a load that is none is believed"},
              {"exchanged", "the load is taken for the other foot's"}});
  const char* const turns = "its servo turns a joint that bears the robot by what the encoder says";
  add_sensor("leg_encoder", "the encoder of a joint of leg or waist", bearing_,
             {{"zero", turns, kPhysics}, {"stuck", turns, kPhysics}, {"exchanged", turns, kPhysics}});
  add_sensor("arm_encoder", "the encoder of a joint of arm or neck", others_);
}

void FaultTable::add_rest() {
  add_plain("supply_sags", "all motors have half of their torque for 0.5 s",
            "supply_sags, torque_factor: 0.5, duration_s: 0.5");
  rows_.push_back({"interface_dead", "the person who commands is lost", FaultExpectation::survives, "",
                   [](RandomStream&) {
                     return std::vector<FaultAction>{{0.0, "command: is_lost"}};
                   }});
}

// Of those that it survives one by one.
void FaultTable::add_pairs() {
  std::vector<FaultRow> single;
  std::ranges::copy_if(rows_, std::back_inserter(single),
                       [](const FaultRow& row) { return row.expected == FaultExpectation::survives; });
  rows_.push_back({"pairs", "any two of these that it survives one by one, within 100 ms",
                   FaultExpectation::reported, "", [single](RandomStream& random) {
                     const std::size_t first = random.next() % single.size();
                     std::size_t second = random.next() % (single.size() - 1);
                     second += second >= first ? 1 : 0;
                     std::vector<FaultAction> both = single[first].draw(random);
                     const double later_s = std::round(100.0 * random.uniform()) * 1e-3;
                     for (FaultAction action : single[second].draw(random)) {
                       action.after_s += later_s;
                       both.push_back(std::move(action));
                     }
                     return both;
                   }});
}

}  // namespace

std::vector<FaultRow> fault_table(const urdf::RobotModel& robot) {
  return FaultTable(robot).rows();
}

std::vector<FaultRow> chosen_fault_rows(std::vector<FaultRow> table, const std::vector<std::string>& names,
                                        const std::vector<std::string>& except) {
  std::vector<std::string> known;
  std::ranges::transform(table, std::back_inserter(known), &FaultRow::name);
  for (const auto* const list : {&names, &except}) {
    for (const std::string& name : *list) {
      if (std::ranges::find(known, name) == known.end()) {
        throw std::invalid_argument(fmt::format("no row of the fault campaign is called '{}'. {}", name,
                                                input::suggest(name, known)));
      }
    }
  }
  std::erase_if(table, [&](const FaultRow& row) {
    const bool wanted = names.empty() || std::ranges::find(names, row.name) != names.end();
    return !wanted || std::ranges::find(except, row.name) != except.end();
  });
  return table;
}

}  // namespace gaitway::tools
