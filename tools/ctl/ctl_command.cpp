// One request over the memory block, one answer.
#include "tools/ctl/ctl_command.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <optional>
#include <random>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/ctl/robot_ctl.hpp"
#include "tools/program.hpp"

namespace gaitway::tools {
namespace {

using core::PluginVerb;

struct Verb {
  const char* name;
  PluginVerb verb;
  const char* help;
};
constexpr std::array kVerbs{
    Verb{"reload", PluginVerb::reload, "Put a plug-in's new version in its place, with its state"},
    Verb{"load", PluginVerb::load, "Load a plug-in beside the others"},
    Verb{"unload", PluginVerb::unload, "Take a plug-in out"},
    Verb{"stop", PluginVerb::stop, "Take a plug-in out of service: fallbacks write its topics"},
    Verb{"start", PluginVerb::start, "Load a plug-in that was stopped or left out, afresh"},
    Verb{"set", PluginVerb::set, "Change a parameter that may change while the plug-in runs"},
    Verb{"parameters", PluginVerb::describe_parameter, "List a plug-in's parameters and their values"}};

template <std::size_t size>
void copy_text(const std::string& text, std::uint8_t (&field)[size], std::string_view what) {
  if (text.size() >= size) {
    throw std::invalid_argument(fmt::format("{} '{}' is longer than {} bytes", what, text, size - 1));
  }
  std::memcpy(field, text.data(), text.size());
}

PluginRequest request_of(PluginVerb verb, const CtlOptions& options) {
  PluginRequest request{};
  request.number = std::random_device{}();
  request.verb = static_cast<std::uint32_t>(verb);
  copy_text(options.plugin, request.plugin, "the plug-in's name");
  // The main controller has a working directory of its own.
  const bool is_path = options.library.find('/') != std::string::npos;
  copy_text(is_path ? std::filesystem::absolute(options.library).string() : options.library, request.library,
            "the library's path");
  copy_text(options.parameter, request.parameter, "the parameter's name");
  copy_text(options.value, request.value, "the value");
  return request;
}

PluginVerb parsed_verb(const CLI::App& command) {
  const auto verb = std::find_if(kVerbs.begin(), kVerbs.end(),
                                 [&](const Verb& one) { return command.got_subcommand(one.name); });
  return verb->verb;  // one is required
}

// Requests over the memory block, each with its answer. Complains where there is none.
class Conversation {
 public:
  explicit Conversation(const CtlOptions& options)
      : client_(msgclient::Client::connect(options.socket, "ctl")),
        answers_(client_.read_stream<PluginAnswer>("plugin_answer")),
        requests_(client_.write_queue<PluginRequest>("plugin_request")),
        timeout_s_(options.timeout_s) {}

  std::optional<PluginAnswer> ask(const PluginRequest& request) {
    if (!requests_.push(request, process::monotonic_ns())) {
      fmt::print(stderr, "gaitway ctl: too many requests are waiting. Is the main controller running?\n");
      return std::nullopt;
    }
    const auto end = std::chrono::steady_clock::now() + std::chrono::duration<double>(timeout_s_);
    PluginAnswer answer{};
    while (std::chrono::steady_clock::now() < end) {
      if (answers_.read(answer) && answer.number == request.number) {
        return answer;
      }
      std::this_thread::sleep_for(std::chrono::milliseconds(2));  // the memory block has no doorbell for us
    }
    fmt::print(stderr, "gaitway ctl: no answer within {} s. Is the main controller running?\n", timeout_s_);
    return std::nullopt;
  }

 private:
  msgclient::Client client_;
  msgclient::StreamReader<PluginAnswer> answers_;
  msgclient::QueueWriter<PluginRequest> requests_;
  double timeout_s_;
};

std::string_view text_of(const PluginAnswer& answer) {
  const auto* const text = reinterpret_cast<const char*>(answer.text);
  return {text, strnlen(text, sizeof answer.text)};
}

int change(Conversation& conversation, const PluginRequest& request, const std::string& plugin) {
  const std::optional<PluginAnswer> answer = conversation.ask(request);
  if (!answer) {
    return kExitNoAnswer;
  }
  const bool done = answer->done != 0;
  fmt::print(done ? stdout : stderr, "{}: {}\n", plugin, text_of(*answer));
  return done ? kExitFine : kExitRefused;
}

void print_parameter(const nlohmann::json& parameter) {
  const std::string unit = parameter.at("unit");
  fmt::print("{:<24} {:>12} {:<10} {:<5} {}\n", parameter.at("name").get<std::string>(),
             parameter.at("value").get<std::string>(), unit == "1" ? "" : unit,
             parameter.at("live").get<bool>() ? "live" : "", parameter.at("doc").get<std::string>());
}

// One after the other, until there is none of the next number.
int list_parameters(Conversation& conversation, PluginRequest request) {
  for (request.index = 0;; ++request.index, ++request.number) {
    const std::optional<PluginAnswer> answer = conversation.ask(request);
    if (!answer) {
      return kExitNoAnswer;
    }
    if (answer->done == 0) {
      if (request.index > 0) {
        return kExitFine;
      }
      fmt::print(stderr, "{}\n", text_of(*answer));
      return kExitRefused;
    }
    print_parameter(nlohmann::json::parse(text_of(*answer)));
  }
}

// The same by the robot API's services.
int change_over_api(PluginVerb verb, const CtlOptions& options) {
  if (verb == PluginVerb::stop || verb == PluginVerb::start) {
    throw std::invalid_argument(
        "stop and start of a plug-in need --socket SOCKET: the robot API has no such service");
  }
  ApiClient client(options.robot.api);
  if (verb == PluginVerb::set) {
    return call_and_print(
        client, "/plugins/set_parameter",
        {{"plugin", options.plugin}, {"parameter", options.parameter}, {"value", options.value}});
  }
  if (verb == PluginVerb::describe_parameter) {
    return call_and_print(client, "/plugins/get_parameters", {{"plugin", options.plugin}});
  }
  const char* const service = verb == PluginVerb::reload ? "/plugins/reload"
                              : verb == PluginVerb::load ? "/plugins/load"
                                                         : "/plugins/unload";
  return call_and_print(client, service, {{"name", options.plugin}, {"library", options.library}});
}

}  // namespace

CLI::App* add_ctl_command(CLI::App& app, CtlOptions& options) {
  CLI::App* const command = add_command(app, "ctl");
  command->add_option("--socket", options.socket,
                      "Change plug-ins over the message controller's memory block, without the robot API");
  add_robot_ctl(*command, options.robot);
  command->add_option("--timeout", options.timeout_s, "Seconds to wait for the answer")
      ->check(CLI::Range(0.1, 3600.0))
      ->capture_default_str();
  command->require_subcommand(1);
  for (const Verb& verb : kVerbs) {
    CLI::App* const sub = command->add_subcommand(verb.name, verb.help);
    sub->add_option("plugin", options.plugin, "Its name in the configuration")->required();
    if (verb.verb == PluginVerb::set) {
      sub->add_option("parameter", options.parameter, "Name of the parameter")->required();
      sub->add_option("value", options.value, "New value, with its unit")->required();
    } else if (verb.verb == PluginVerb::reload || verb.verb == PluginVerb::load) {
      sub->add_option("--library", options.library,
                      verb.verb == PluginVerb::reload
                          ? "File, or name on the plug-in path; default: as before"
                          : "File, or name on the plug-in path; default: libgaitway_plugin_NAME.so");
    }
  }
  command->footer(
      "Examples:\n"
      "  gaitway ctl walk 0.15 --seconds 5\n"
      "  gaitway ctl emergency-stop\n"
      "  gaitway ctl echo /joint_states --count 3\n"
      "  gaitway ctl --url wss://robot:9090 --token-file token --ca ca.pem plugins\n"
      "  gaitway ctl set stability gain \"1.1\"\n"
      "  gaitway ctl --socket /run/gaitway.sock reload trajectory\n"
      "  gaitway ctl --socket /run/gaitway.sock reload sway --library build/libsway.so\n"
      "  gaitway ctl --socket /run/gaitway.sock stop stability\n"
      "  gaitway ctl --socket /run/gaitway.sock parameters sway\n"
      "  gaitway ctl --socket /run/gaitway.sock set sway amplitude \"0.03 m\"\n"
      "A plug-in that cannot take its place leaves the old one where it is. Exit code: 0 done, 1 the input "
      "was\n"
      "bad or nobody serves the socket, 2 refused, 3 no answer.");
  return command;
}

int ctl(const CLI::App& command, const CtlOptions& options) {
  if (is_robot_ctl(command)) {
    return robot_ctl(command, options.robot);
  }
  if (options.socket.empty()) {
    return change_over_api(parsed_verb(command), options);
  }
  const PluginVerb verb = parsed_verb(command);
  const PluginRequest request = request_of(verb, options);
  Conversation conversation(options);
  return verb == PluginVerb::describe_parameter ? list_parameters(conversation, request)
                                                : change(conversation, request, options.plugin);
}

}  // namespace gaitway::tools

int main(int argc, char** argv) {
  gaitway::tools::CtlOptions options;
  return gaitway::tools::run_program(argc, argv, [&options](CLI::App& app) -> std::function<int()> {
    CLI::App* const command = gaitway::tools::add_ctl_command(app, options);
    return [command, &options] { return gaitway::tools::ctl(*command, options); };
  });
}
