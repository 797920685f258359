// One subcommand, one conversation.
#include "tools/ctl/robot_ctl.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>

#include "gaitway/process/real_time.hpp"
#include "tools/ctl/ctl_command.hpp"
#include "tools/program.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

// A service without arguments that one of our words stands for.
struct Word {
  const char* name;
  const char* service;
  const char* help;
};
constexpr std::array kWords{
    Word{"stand", "/stand", "End the walk by the next steps, and stand"},
    Word{"halt", "/stop", "Stop now: the message controller plays the safe tail, and the robot stands"},
    Word{"record-stop", "/recording/stop", "End the recording"},
    Word{"plugins", "/plugins/list", "List the plug-ins, their states and costs"}};

// While it walks, the command is renewed so often.
constexpr std::int64_t kRenew_ns = 100'000'000;

json twist(const std::vector<double>& velocity) {
  const auto at = [&velocity](std::size_t i) { return i < velocity.size() ? velocity[i] : 0.0; };
  return {{"linear", {{"x", at(0)}, {"y", at(1)}, {"z", 0.0}}},
          {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", at(2)}}}};
}

// Walks for so long, or until it is told to end, and stands.
int walk(ApiClient& client, const RobotCtlOptions& options) {
  process::stop_on_signals();
  json values;
  const ApiClient::ServiceAnswer lease = client.call("/command/acquire", {{"name", "gaitway ctl"}}, values);
  if (!lease.result || !values.value("success", false)) {
    fmt::print(stderr, "gaitway ctl: {}\n", lease.result ? values.value("message", "") : lease.problem);
    return kExitRefused;
  }
  const json renewal = {{"lease", values.value("lease", "")}};
  client.advertise("/cmd_vel", "geometry_msgs/msg/Twist");
  const std::int64_t end_ns = process::monotonic_ns() + static_cast<std::int64_t>(options.seconds * 1e9);
  while (!process::stop_requested() && process::monotonic_ns() < end_ns) {
    const std::int64_t next_ns = process::monotonic_ns() + kRenew_ns;
    client.publish("/cmd_vel", twist(options.velocity));
    static_cast<void>(client.call("/command/keep_alive", renewal, values));
    client.throw_reported_errors();
    while (!process::stop_requested() && process::monotonic_ns() < std::min(next_ns, end_ns)) {
      process::wait_until(std::min(next_ns, end_ns), {});
    }
  }
  return call_and_print(client, "/stand", json::object());
}

int echo(ApiClient& client, const RobotCtlOptions& options) {
  client.subscribe(options.topic);
  for (int shown = 0; options.count == 0 || shown < options.count; ++shown) {
    const auto message = client.next_message();
    if (!message) {
      fmt::print(stderr, "gaitway ctl: {}: no message within {:g} s\n", options.topic, options.api.timeout_s);
      return kExitNoAnswer;
    }
    fmt::print("{}\n", message->value("msg", json()).dump());
    std::fflush(stdout);
  }
  return kExitFine;
}

int list_topics(ApiClient& client) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call("/rosapi/topics", json::object(), values);
  if (!answer.result) {
    fmt::print(stderr, "gaitway ctl: {}\n", answer.problem);
    return kExitRefused;
  }
  for (std::size_t i = 0; i < values["topics"].size(); ++i) {
    fmt::print("{:<22} {}\n", values["topics"][i].get<std::string>(), values["types"][i].get<std::string>());
  }
  return kExitFine;
}

void print_table(const json& values) {
  if (values.contains("plugins")) {
    fmt::print("{:<20} {:<16} {:>9} {:>7} {:>9} {:>9}\n", "plug-in", "state", "steps", "faults", "p50 us",
               "p99 us");
    for (const json& plugin : values["plugins"]) {
      fmt::print("{:<20} {:<16} {:>9} {:>7} {:>9.1f} {:>9.1f}\n", plugin["name"].get<std::string>(),
                 plugin["state"].get<std::string>(), plugin["steps"].get<std::uint64_t>(),
                 plugin["faults"].get<std::uint64_t>(), plugin["p50_step_us"].get<double>(),
                 plugin["p99_step_us"].get<double>());
    }
  }
  for (std::size_t i = 0; values.contains("live") && i < values["names"].size(); ++i) {
    fmt::print("{:<28} {:<16} {:<10} {:<5} {}\n", values["names"][i].get<std::string>(),
               values["values"][i].get<std::string>(), values["units"][i].get<std::string>(),
               values["live"][i].get<bool>() ? "live" : "", values["docs"][i].get<std::string>());
  }
}

}  // namespace

int call_and_print(ApiClient& client, const std::string& service, const json& arguments) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call(service, arguments, values);
  const bool done = answer.result && values.value("success", false);
  const std::string text = answer.result ? values.value("message", "") : answer.problem;
  if (done) {
    print_table(values);
  }
  if (!text.empty() || !done) {
    fmt::print(done ? stdout : stderr, "{}: {}\n", service, text);
  }
  return done ? kExitFine : kExitRefused;
}

void add_robot_ctl(CLI::App& ctl, RobotCtlOptions& options) {
  ctl.add_option("--url", options.api.url, "The robot API")->capture_default_str();
  ctl.add_option("--token-file", options.api.token_file, "File with the API's token, in its first line");
  ctl.add_option("--ca", options.api.ca_file, "Certificates to trust (PEM), with wss://");
  for (const Word& word : kWords) {
    ctl.add_subcommand(word.name, word.help);
  }
  CLI::App* const walk = ctl.add_subcommand("walk", "Walk for a while, then stand; Ctrl-C ends it early");
  walk->add_option("velocity", options.velocity, "VX[,VY[,WZ]]: forward m/s, left m/s, turn rad/s")
      ->delimiter(',')
      ->required();
  walk->add_option("--seconds", options.seconds, "How long")
      ->check(CLI::Range(0.1, 86400.0))
      ->capture_default_str();
  ctl.add_subcommand("emergency-stop", "Hold all joints at once, wherever they are: the robot may fall")
      ->add_flag("--soft", options.soft, "Let go instead");
  CLI::App* const move = ctl.add_subcommand("move-joint", "Move one joint, while the robot stands");
  move->add_option("joint", options.joint, "Its name")->required();
  move->add_option("position", options.position_rad, "Where to [rad]")->required();
  move->add_option("--duration", options.duration_s, "How long it takes [s]")->capture_default_str();
  ctl.add_subcommand("play", "Play a motion")->add_option("motion", options.motion, "Its name")->required();
  ctl.add_subcommand("record", "Start a recording (MCAP)")
      ->add_option("name", options.recording, "Of the file, without folder and ending")
      ->required();
  ctl.add_subcommand("topics", "List the API's topics and their types");
  CLI::App* const show = ctl.add_subcommand("echo", "Show a topic's messages, one in a line (JSON)");
  show->add_option("topic", options.topic, "Its name, for example /joint_states")->required();
  show->add_option("--count", options.count, "So many; 0: without end")->capture_default_str();
}

bool is_robot_ctl(const CLI::App& ctl) {
  constexpr std::array kOthers{"walk", "emergency-stop", "move-joint", "play", "record", "topics", "echo"};
  const auto got = [&ctl](const char* name) { return ctl.got_subcommand(name); };
  return std::any_of(kWords.begin(), kWords.end(), [&got](const Word& word) { return got(word.name); }) ||
         std::any_of(kOthers.begin(), kOthers.end(), got);
}

int robot_ctl(const CLI::App& ctl, const RobotCtlOptions& options) {
  ApiClient client(options.api);
  for (const Word& word : kWords) {
    if (ctl.got_subcommand(word.name)) {
      return call_and_print(client, word.service, json::object());
    }
  }
  if (ctl.got_subcommand("walk")) {
    return walk(client, options);
  }
  if (ctl.got_subcommand("emergency-stop")) {
    return call_and_print(client, "/emergency_stop", {{"data", options.soft}});
  }
  if (ctl.got_subcommand("move-joint")) {
    return call_and_print(
        client, "/move_joint",
        {{"joint", options.joint}, {"position", options.position_rad}, {"duration", options.duration_s}});
  }
  if (ctl.got_subcommand("play")) {
    return call_and_print(client, "/play_motion", {{"motion", options.motion}});
  }
  if (ctl.got_subcommand("record")) {
    return call_and_print(client, "/recording/start", {{"name", options.recording}});
  }
  return ctl.got_subcommand("topics") ? list_topics(client) : echo(client, options);
}

}  // namespace gaitway::tools
