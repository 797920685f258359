// What a person orders a robot through its API: to walk, stand, stop, play, move a joint; its recordings and
// topics.
#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "gaitway/input/text.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

// A service without arguments that a word stands for.
struct Word {
  const char* name;
  const char* service;
  const char* help;
  const char* examples;
};
constexpr std::array kRobotWords{
    Word{"release", "/release", "After an emergency stop: hold the joints where they are, and obey again",
         "  gaitway ctl release && gaitway ctl stand\n"}};
constexpr std::array kRecordingWords{
    Word{"stop", "/recording/stop", "End the recording", "  gaitway ctl recording stop\n"},
    Word{"list", "/recording/list", "List the recordings: start, size and file, newest first",
         "  gaitway ctl recording list\n"}};

// While it walks, the command is renewed so often.
constexpr double kRenew_s = 0.1;

// One subcommand without arguments for each word.
template <std::size_t size>
void add_words(const CommandLine& parent, const SharedCtlOptions& options,
               const std::array<Word, size>& words) {
  for (const Word& word : words) {
    add_order(parent, options, word.name, word.help, word.examples).runs([options, service = word.service] {
      return order(*options, service, json::object());
    });
  }
}

json twist(const std::vector<double>& velocity) {
  const auto at = [&velocity](std::size_t i) { return i < velocity.size() ? velocity[i] : 0.0; };
  return {{"linear", {{"x", at(0)}, {"y", at(1)}, {"z", 0.0}}},
          {"angular", {{"x", 0.0}, {"y", 0.0}, {"z", at(2)}}}};
}

// Its renewal: what keeps the command. Nothing, and it is told why: the command is not to be had.
std::optional<json> take_command(ApiClient& client) {
  json values;
  const ApiClient::ServiceAnswer lease = client.call("/command/acquire", {{"name", "gaitway ctl"}}, values);
  if (!lease.result || !values.value("success", false)) {
    fmt::print(stderr, "gaitway ctl: {}\n",
               input::terminal_text(lease.result ? values.value("message", "") : lease.problem));
    return std::nullopt;
  }
  client.advertise("/cmd_vel", "geometry_msgs/msg/Twist");
  return json{{"lease", values.value("lease", "")}};
}

// Walks for so long, or until it is told to end, and ends when the robot stands, so that what is ordered next
// finds it standing. A robot that is not there is waited for before it walks, and never once it has.
int walk(ApiClient& client, const std::vector<double>& velocity, double seconds) {
  std::optional<json> renewal = take_command(client);
  if (!renewal) return kExitRefused;
  json values;
  const auto renew = [&] {
    client.publish("/cmd_vel", twist(velocity));
    static_cast<void>(client.call("/command/keep_alive", *renewal, values));
    client.throw_reported_errors();
  };
  for (bool begun = false, over = false; !over;) {
    try {
      client.repeat(
          [&] {
            renew();
            begun = true;
          },
          kRenew_s, seconds);
      over = true;
    } catch (const ApiError& error) {
      if (begun || !client.await_return("/cmd_vel", error.what())) throw;
      renewal = take_command(client);
      if (!renewal) return kExitRefused;
    }
  }
  return call_and_print(client, "/stand", json::object());
}

int echo(ApiClient& client, const std::string& topic, int count, double timeout_s) {
  client.subscribe(topic);
  for (int shown = 0; count == 0 || shown < count; ++shown) {
    const auto message = client.next_message();
    if (!message) {
      fmt::print(stderr, "gaitway ctl: {}: no message within {:g} s\n", topic, timeout_s);
      return kExitNoAnswer;
    }
    fmt::print("{}\n", input::terminal_text(message->value("msg", json()).dump()));
    std::fflush(stdout);
  }
  return kExitFine;
}

int list_topics(ApiClient& client) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call("/rosapi/topics", json::object(), values);
  if (!answer.result) {
    fmt::print(stderr, "gaitway ctl: {}\n", input::terminal_text(answer.problem));
    return kExitRefused;
  }
  for (std::size_t i = 0; i < values["topics"].size(); ++i) {
    fmt::print("{:<22} {}\n", input::terminal_text(values["topics"][i].get<std::string>()),
               input::terminal_text(values["types"][i].get<std::string>()));
  }
  return kExitFine;
}

void add_stops(const CommandLine& ctl, const SharedCtlOptions& options) {
  const CommandLine stop =
      add_order(ctl, options, "stop",
                "Stop now: the message controller ends the step by the safe tail, and the robot stands",
                "  gaitway ctl stop\n");
  const auto name = std::make_shared<std::string>();
  stop.option("plugin", *name, "").hidden();
  stop.runs([options, name] {
    if (!name->empty()) {
      throw std::invalid_argument(
          fmt::format("'ctl stop' stops the robot and takes no name. A plug-in is stopped by 'gaitway ctl "
                      "plugin stop {}'",
                      *name));
    }
    return order(*options, "/stop", json::object());
  });
  const CommandLine emergency_stop = add_order(
      ctl, options, "emergency-stop", "Hold all joints at once, wherever they are: the robot may fall",
      "  gaitway ctl emergency-stop\n  gaitway ctl emergency-stop --soft\n  gaitway ctl release\n");
  const auto soft = std::make_shared<bool>(false);
  emergency_stop.option("--soft", *soft, "Let go instead");
  emergency_stop.runs([options, soft] { return order(*options, "/emergency_stop", {{"data", *soft}}); });
}

void add_walk(const CommandLine& ctl, const SharedCtlOptions& options) {
  struct Walk {
    std::vector<double> velocity;
    double seconds = 1.0;
  };
  const auto asked = std::make_shared<Walk>();
  const CommandLine order =
      add_order(ctl, options, "walk", "Walk for a while, then stand; Ctrl-C ends it early",
                "  gaitway ctl walk 0.15 --seconds 5\n  gaitway ctl walk 0.1,0,0.2 --port 9191\n");
  order.option("velocity", asked->velocity, "VX[,VY[,WZ]]: forward m/s, left m/s, turn rad/s").required();
  order.option("--seconds", asked->seconds, "How long").between(0.1, 86400.0);
  order.runs([options, asked] {
    ApiClient client = connect(*options);
    return walk(client, asked->velocity, asked->seconds);
  });
}

void add_motions(const CommandLine& ctl, const SharedCtlOptions& options) {
  const auto motion = std::make_shared<std::string>();
  const CommandLine play = add_order(ctl, options, "play", "Play a motion; 'gaitway motion list' names them",
                                     "  gaitway ctl play wave\n");
  play.option("motion", *motion, "Its name").required();
  play.runs([options, motion] { return order(*options, "/play_motion", {{"motion", *motion}}); });
  struct Move {
    std::string joint;
    double position_rad = 0.0, duration_s = 1.0;
  };
  const auto asked = std::make_shared<Move>();
  const CommandLine move = add_order(ctl, options, "move-joint", "Move one joint, while the robot stands",
                                     "  gaitway ctl move-joint left_elbow -- -0.3\n");
  move.option("joint", asked->joint, "Its name").required();
  move.option("position", asked->position_rad, "Where to [rad]").required();
  move.option("--duration", asked->duration_s, "How long it takes [s]");
  move.runs([options, asked] {
    return order(
        *options, "/move_joint",
        {{"joint", asked->joint}, {"position", asked->position_rad}, {"duration", asked->duration_s}});
  });
}

void add_recordings(const CommandLine& ctl, const SharedCtlOptions& options) {
  const CommandLine recording =
      ctl.subcommand("recording", "Record the topics into MCAP files: start, stop, list");
  recording.needs_subcommand();
  recording.footer(
      "Examples:\n"
      "  gaitway ctl recording start walk1\n"
      "  gaitway ctl recording stop\n"
      "  gaitway ctl recording list");
  const auto name = std::make_shared<std::string>();
  const CommandLine start = add_order(recording, options, "start", "Start a recording (MCAP)",
                                      "  gaitway ctl recording start walk1\n");
  start.option("name", *name, "Of the file, without folder and ending; named by the time without it");
  start.runs([options, name] { return order(*options, "/recording/start", {{"name", *name}}); });
  add_words(recording, options, kRecordingWords);
}

void add_topics(const CommandLine& ctl, const SharedCtlOptions& options) {
  add_order(ctl, options, "topics", "List the API's topics and their types", "  gaitway ctl topics\n")
      .runs([options] {
        ApiClient client = connect(*options);
        return list_topics(client);
      });
  struct Echo {
    std::string topic;
    int count = 1;
  };
  const auto asked = std::make_shared<Echo>();
  const CommandLine order = add_order(ctl, options, "echo", "Show a topic's messages, one in a line (JSON)",
                                      "  gaitway ctl echo /joint_states --count 3\n");
  order.option("topic", asked->topic, "Its name, for example /joint_states").required();
  order.option("--count", asked->count, "So many; 0: without end");
  order.runs([options, asked] {
    ApiClient client = connect(*options);
    return echo(client, asked->topic, asked->count, options->api.timeout_s);
  });
}

}  // namespace

void add_robot_orders(const CommandLine& ctl, const SharedCtlOptions& options) {
  add_stops(ctl, options);
  add_words(ctl, options, kRobotWords);
  add_order(ctl, options, "stand", "End the walk or the motion by its next steps, and stand",
            "  gaitway ctl stand && gaitway ctl play wave\n")
      .runs([options] { return order(*options, "/stand", json::object()); });
  add_walk(ctl, options);
  add_motions(ctl, options);
  add_recordings(ctl, options);
  add_topics(ctl, options);
}

}  // namespace gaitway::tools
