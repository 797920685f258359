// Who commands the robot, where its head looks, and what its behaviour does: orders through its API.
#include <fmt/format.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

void add_word(const CommandLine& parent, const SharedCtlOptions& options, const char* name,
              const std::string& service, const char* help, const char* examples) {
  add_order(parent, options, name, help, examples).runs([options, service] {
    return order(*options, service, json::object());
  });
}

struct LookNumbers {
  std::vector<double> numbers;
  double extent_rad = 0.5;
  double period_s = 0.0, speed_rad_per_s = 0.0;
};

void require_count(const std::string& mode, const std::vector<double>& numbers, std::size_t count,
                   const char* which) {
  if (numbers.size() != count) {
    throw std::invalid_argument(
        fmt::format("'ctl look {}' takes {}: {} numbers, not {}", mode, which, count, numbers.size()));
  }
}

json look_arguments(const std::string& mode, const LookNumbers& asked) {
  json arguments = {{"mode", mode}, {"speed", asked.speed_rad_per_s}};
  if (mode == "point") {
    require_count(mode, asked.numbers, 3, "X,Y,Z [m, in odom]");
    arguments.update({{"x", asked.numbers[0]}, {"y", asked.numbers[1]}, {"z", asked.numbers[2]}});
  } else if (mode == "direction" || (mode == "scan" && !asked.numbers.empty())) {
    require_count(mode, asked.numbers, 2, "YAW,PITCH [rad, to the left and down]");
    arguments.update({{"yaw", asked.numbers[0]}, {"pitch", asked.numbers[1]}});
  } else {
    require_count(mode, asked.numbers, 0, "nothing more");
  }
  if (mode == "scan") arguments.update({{"extent", asked.extent_rad}, {"period", asked.period_s}});
  return arguments;
}

void add_look(const CommandLine& ctl, const SharedCtlOptions& options) {
  struct Look {
    std::string mode;
    LookNumbers numbers;
  };
  const auto asked = std::make_shared<Look>();
  const CommandLine look =
      add_order(ctl, options, "look", "Where the head is to look, while it stands or walks",
                "  gaitway ctl look direction 0.5,0.1\n"
                "  gaitway ctl look point 1.5,0,0.3 --speed 1\n"
                "  gaitway ctl look scan --extent 0.8 --period 4\n"
                "  gaitway ctl look direction -- -0.5,0\n"
                "  gaitway ctl look hold && gaitway ctl look ahead\n");
  look.option("mode", asked->mode, "ahead, direction, point, scan or hold").required();
  look.option(
      "numbers", asked->numbers.numbers,
      "direction and scan: YAW,PITCH [rad] of the neck, to the left and down; point: X,Y,Z [m, odom]");
  look.option("--extent", asked->numbers.extent_rad, "Of scan: as far to either side [rad]")
      .between(0.0, 3.2);
  look.option("--period", asked->numbers.period_s,
              "Of scan: from one side to the other and back [s]; 0: as the robot has it")
      .between(0.0, 600.0);
  look.option("--speed", asked->numbers.speed_rad_per_s, "At most [rad/s]; 0: as the robot has it")
      .between(0.0, 100.0);
  look.runs([options, asked] {
    return order(*options, "/head/look", look_arguments(asked->mode, asked->numbers));
  });
}

void add_behaviour(const CommandLine& ctl, const SharedCtlOptions& options) {
  const CommandLine behaviour =
      ctl.subcommand("behaviour", "What the robot does by itself: start, end or change its mission");
  behaviour.needs_subcommand();
  behaviour.footer(
      "Examples:\n"
      "  gaitway ctl behaviour start find_and_walk_to_tag && gaitway ctl let-go\n"
      "  gaitway ctl behaviour change\n"
      "  gaitway ctl behaviour end");
  const auto mission = std::make_shared<std::string>();
  const CommandLine start =
      add_order(behaviour, options, "start", "Begin a mission anew; it waits while a person commands",
                "  gaitway ctl behaviour start find_and_walk_to_tag\n"
                "  gaitway ctl behaviour start /home/robot/my_mission.xml\n"
                "  gaitway ctl let-go\n");
  start.option("mission", *mission,
               "Name of a shipped one, or a file's path on the robot; without it, the one that is loaded");
  start.runs([options, mission] { return order(*options, "/behaviour/start", {{"mission", *mission}}); });
  add_word(behaviour, options, "end", "/behaviour/end", "End the mission", "  gaitway ctl behaviour end\n");
  add_word(behaviour, options, "change", "/behaviour/change",
           "Exchange the running tree for what its file says now, or say why not",
           "  gaitway ctl behaviour change\n");
}

}  // namespace

void add_command_orders(const CommandLine& ctl, const SharedCtlOptions& options) {
  add_word(ctl, options, "take", "/command/take",
           "Take the command from the robot's behaviour, without an order",
           "  gaitway ctl take\n  gaitway ctl let-go\n");
  add_word(ctl, options, "let-go", "/command/let_go",
           "Let the command go: what people have ordered ends, and the robot's behaviour may command",
           "  gaitway ctl stop\n  gaitway ctl let-go\n  gaitway ctl echo /command/state\n");
  add_look(ctl, options);
  add_behaviour(ctl, options);
}

}  // namespace gaitway::tools
