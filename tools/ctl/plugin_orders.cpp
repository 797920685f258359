// `gaitway ctl plugin`: what people order the plug-in manager, over the robot API or, with --socket, over the
// message controller's memory block: one request, one answer.
#include <fmt/format.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstring>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string_view>
#include <thread>

#include "gaitway/facts/parameter_line.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/manager/plugin_requests.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/process/real_time.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {
namespace {

using core::PluginVerb;

struct Verb {
  const char* name;
  PluginVerb verb;
  const char* help;
  const char* examples;
};
constexpr std::array kVerbs{
    Verb{"load", PluginVerb::load, "Load a plug-in beside the others",
         "  gaitway ctl plugin load sway --library build/libsway.so\n"},
    Verb{"unload", PluginVerb::unload, "Take a plug-in out", "  gaitway ctl plugin unload sway\n"},
    Verb{"reload", PluginVerb::reload, "Put a plug-in's new version in its place, with its state",
         "  gaitway ctl plugin reload trajectory\n  gaitway ctl plugin reload sway --library "
         "build/libsway.so\n"
         "A version that cannot take its place leaves the old one where it is.\n"},
    Verb{"start", PluginVerb::start, "Load a plug-in that is stopped, afresh",
         "  gaitway ctl plugin start stability --socket /run/gaitway.sock\n"},
    Verb{"stop", PluginVerb::stop, "Take a plug-in out of service: fallbacks write its topics",
         "  gaitway ctl plugin stop stability --socket /run/gaitway.sock\n"},
    Verb{"set", PluginVerb::set, "Change a parameter that may change while the plug-in runs",
         "  gaitway ctl plugin set sway amplitude \"0.03 m\"\n"},
    Verb{"parameters", PluginVerb::describe_parameter, "List a plug-in's parameters and their values",
         "  gaitway ctl plugin parameters stability\n"}};

struct PluginOrder {
  PluginVerb verb{};
  std::string plugin, library, parameter, value;
};

template <std::size_t size>
void copy_text(const std::string& text, std::uint8_t (&field)[size], std::string_view what) {
  if (text.size() >= size) {
    throw std::invalid_argument(fmt::format("{} '{}' is longer than {} bytes", what, text, size - 1));
  }
  std::memcpy(field, text.data(), text.size());
}

PluginRequest request_of(const PluginOrder& order) {
  PluginRequest request{};
  request.number = std::random_device{}();
  request.verb = static_cast<std::uint32_t>(order.verb);
  copy_text(order.plugin, request.plugin, "the plug-in's name");
  // The main controller has a working directory of its own.
  const bool is_path = order.library.find('/') != std::string::npos;
  copy_text(is_path ? std::filesystem::absolute(order.library).string() : order.library, request.library,
            "the library's path");
  copy_text(order.parameter, request.parameter, "the parameter's name");
  copy_text(order.value, request.value, "the value");
  return request;
}

// A message controller that was restarted is there again soon.
msgclient::Client connect_to_block(const CtlOptions& options) {
  ReturnWait wait(options.api.wait_s);
  while (true) {
    try {
      return msgclient::Client::connect(options.socket, "ctl");
    } catch (const msgclient::TopicError& error) {
      if (!wait.once_more(error.what())) {
        throw;
      }
    }
  }
}

// Requests over the memory block, each with its answer. Complains where there is none.
class Conversation {
 public:
  explicit Conversation(const CtlOptions& options)
      : client_(connect_to_block(options)),
        answers_(client_.read_stream<PluginAnswer>("plugin_answer")),
        requests_(client_.write_queue<PluginRequest>("plugin_request")),
        timeout_s_(options.api.timeout_s) {}

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

std::string text_of(const PluginAnswer& answer) {
  const auto* const text = reinterpret_cast<const char*>(answer.text);
  return {text, strnlen(text, sizeof answer.text)};
}

int change(Conversation& conversation, const PluginRequest& request, const std::string& plugin) {
  const std::optional<PluginAnswer> answer = conversation.ask(request);
  if (!answer) {
    return kExitNoAnswer;
  }
  const bool done = answer->done != 0;
  fmt::print(done ? stdout : stderr, "{}: {}\n", plugin, input::terminal_text(text_of(*answer)));
  return done ? kExitFine : kExitRefused;
}

void print_parameter(const std::string& line) {
  const auto parameter = facts::read_parameter_line(line);
  if (!parameter) {
    throw std::runtime_error("the main controller is of another version: it tells a parameter as '" +
                             input::terminal_text(line) + "'");
  }
  fmt::print("{}\n",
             input::terminal_text(fmt::format("{:<24} {:>12} {:<10} {:<5} {}", parameter->name,
                                              parameter->value, parameter->unit == "1" ? "" : parameter->unit,
                                              parameter->live ? "live" : "", parameter->doc)));
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
      fmt::print(stderr, "{}\n", input::terminal_text(text_of(*answer)));
      return kExitRefused;
    }
    print_parameter(text_of(*answer));
  }
}

int carry_out(const CtlOptions& options, const PluginOrder& order) {
  const PluginRequest request = request_of(order);
  Conversation conversation(options);
  return order.verb == PluginVerb::describe_parameter ? list_parameters(conversation, request)
                                                      : change(conversation, request, order.plugin);
}

// The same by the robot API's services.
int carry_out_over_api(const CtlOptions& options, const PluginOrder& order) {
  if (order.verb == PluginVerb::stop || order.verb == PluginVerb::start) {
    throw std::invalid_argument(
        "stop and start of a plug-in need --socket SOCKET: the robot API has no such service");
  }
  ApiClient client = connect(options);
  if (order.verb == PluginVerb::set) {
    return call_and_print(client, "/plugins/set_parameter",
                          {{"plugin", order.plugin}, {"parameter", order.parameter}, {"value", order.value}});
  }
  if (order.verb == PluginVerb::describe_parameter) {
    return call_and_print(client, "/plugins/get_parameters", {{"plugin", order.plugin}});
  }
  const char* const service = order.verb == PluginVerb::reload ? "/plugins/reload"
                              : order.verb == PluginVerb::load ? "/plugins/load"
                                                               : "/plugins/unload";
  return call_and_print(client, service, {{"name", order.plugin}, {"library", order.library}});
}

void add_verb(const CommandLine& plugin, const SharedCtlOptions& options, const Verb& verb) {
  const auto order = std::make_shared<PluginOrder>();
  order->verb = verb.verb;
  const CommandLine command = add_order(plugin, options, verb.name, verb.help, verb.examples);
  command.option("--socket", options->socket,
                 "Over the memory block of this message controller, without the robot API");
  command.option("plugin", order->plugin, "Its name in the configuration").required();
  if (verb.verb == PluginVerb::set) {
    command.option("parameter", order->parameter, "Name of the parameter").required();
    command.option("value", order->value, "New value, with its unit").required();
  } else if (verb.verb == PluginVerb::reload || verb.verb == PluginVerb::load) {
    command.option("--library", order->library,
                   verb.verb == PluginVerb::reload
                       ? "File, or name on the plug-in path; default: as before"
                       : "File, or name on the plug-in path; default: libgaitway_plugin_NAME.so");
  }
  command.runs([options, order] {
    return options->socket.empty() ? carry_out_over_api(*options, *order) : carry_out(*options, *order);
  });
}

}  // namespace

void add_plugin_orders(const CommandLine& ctl, const SharedCtlOptions& options) {
  ctl.option("--socket", options->socket,
             "For orders to plug-ins: over this memory block, without the robot API");
  const CommandLine plugin = ctl.subcommand(
      "plugin", "Orders to plug-ins: list, load, unload, reload, start, stop, set, parameters");
  plugin.needs_subcommand();
  plugin.footer(
      "Examples:\n"
      "  gaitway ctl plugin list\n"
      "  gaitway ctl plugin reload trajectory\n"
      "  gaitway ctl plugin set sway amplitude \"0.03 m\"\n"
      "  gaitway ctl plugin stop stability --socket /run/gaitway.sock");
  add_order(plugin, options, "list", "List the plug-ins, their states and costs",
            "  gaitway ctl plugin list\n")
      .runs([options] {
        ApiClient client = connect(*options);
        return call_and_print(client, "/plugins/list", nlohmann::json::object());
      });
  for (const Verb& verb : kVerbs) {
    add_verb(plugin, options, verb);
  }
}

}  // namespace gaitway::tools
