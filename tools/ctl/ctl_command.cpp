// `gaitway ctl`: orders to a robot that is running, to its plug-ins and its recordings.
#include <fmt/chrono.h>
#include <fmt/format.h>

#include <cstdio>
#include <ctime>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "gaitway/input/text.hpp"
#include "tools/ctl/api_client.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;

std::string shown_text(const json& text) {
  return input::terminal_text(text.get<std::string>());
}

void print_table(const json& values) {
  if (values.contains("plugins")) {
    fmt::print("{:<20} {:<16} {:>9} {:>7} {:>9} {:>9}\n", "plug-in", "state", "steps", "faults", "p50 us",
               "p99 us");
    for (const json& plugin : values["plugins"]) {
      fmt::print("{:<20} {:<16} {:>9} {:>7} {:>9.1f} {:>9.1f}\n", shown_text(plugin["name"]),
                 shown_text(plugin["state"]), plugin["steps"].get<std::uint64_t>(),
                 plugin["faults"].get<std::uint64_t>(), plugin["p50_step_us"].get<double>(),
                 plugin["p99_step_us"].get<double>());
    }
  }
  for (std::size_t i = 0; values.contains("live") && i < values["names"].size(); ++i) {
    fmt::print("{:<28} {:<16} {:<10} {:<5} {}\n", shown_text(values["names"][i]),
               shown_text(values["values"][i]), shown_text(values["units"][i]),
               values["live"][i].get<bool>() ? "live" : "", shown_text(values["docs"][i]));
  }
  for (std::size_t i = 0; values.contains("recordings") && i < values["recordings"].size(); ++i) {
    const json& recording = values["recordings"][i];
    fmt::print("{:%Y-%m-%d %H:%M:%S} {:>9.1f} MB  {}\n",
               fmt::localtime(recording["start"]["sec"].get<std::time_t>()),
               recording["bytes"].get<double>() / 1e6, shown_text(recording["file"]));
  }
}

}  // namespace

void add_address(const CommandLine& command, CtlOptions& options) {
  const Option port =
      command.option("--port", options.port, "Port of the robot API on this computer (default 9090)")
          .between(1, 65535);
  command.option("--url", options.url, "The robot API anywhere: ws://HOST:PORT or wss://HOST:PORT")
      .excludes(port);
  command.option("--token-file", options.api.token_file, "File with the API's token, in its first line");
  command.option("--ca", options.api.ca_file, "Certificates to trust (PEM), with wss://");
  command.option("--timeout", options.api.timeout_s, "Seconds to wait for an answer").between(0.1, 3600.0);
  command
      .option("--wait", options.api.wait_s,
              "Seconds to wait for a robot that is not there, as after a restart (default 3; 0: not at all)")
      .between(0.0, 3600.0);
}

CommandLine add_order(const CommandLine& parent, const SharedCtlOptions& options, const char* name,
                      const char* help, const char* examples) {
  const CommandLine order = parent.subcommand(name, help);
  add_address(order, *options);
  order.footer(fmt::format("Examples:\n{}", examples));
  return order;
}

ApiClient connect(const CtlOptions& options) {
  if (!options.socket.empty()) {
    throw std::invalid_argument(
        "--socket reaches the plug-in manager alone. This order goes through the robot API: --port or --url");
  }
  if (options.port && options.url) {
    throw std::invalid_argument("--port and --url name two robots: leave one of them out");
  }
  ApiAddress address = options.api;
  if (options.port) {
    address.url = fmt::format("ws://127.0.0.1:{}", *options.port);
  } else if (options.url) {
    address.url = *options.url;
  }
  return ApiClient(address);
}

int call_and_print(ApiClient& client, const std::string& service, const json& arguments) {
  json values;
  const ApiClient::ServiceAnswer answer = client.call(service, arguments, values);
  const bool done = answer.result && values.value("success", false);
  const std::string text = answer.result ? values.value("message", "") : answer.problem;
  if (done) {
    print_table(values);
  }
  if (!text.empty() || !done) {
    fmt::print(done ? stdout : stderr, "{}: {}\n", service, input::terminal_text(text));
  }
  return done ? kExitFine : kExitRefused;
}

int order(const CtlOptions& options, const std::string& service, const json& arguments) {
  ApiClient client = connect(options);
  return call_and_print(client, service, arguments);
}

void declare_program(const CommandLine& program) {
  const auto options = std::make_shared<CtlOptions>();
  const CommandLine ctl = add_command(program, "ctl");
  add_address(ctl, *options);
  ctl.needs_subcommand();
  add_robot_orders(ctl, options);
  add_command_orders(ctl, options);
  add_plugin_orders(ctl, options);
  ctl.renamed("halt", "ctl stop");
  ctl.renamed("record", "ctl recording start");
  ctl.renamed("record-stop", "ctl recording stop");
  ctl.renamed("plugins", "ctl plugin list");
  for (const char* const verb : {"reload", "load", "unload", "start", "set", "parameters"}) {
    ctl.renamed(verb, fmt::format("ctl plugin {}", verb));
  }
  ctl.footer(
      "Examples:\n"
      "  gaitway ctl walk 0.15 --seconds 5\n"
      "  gaitway ctl stop\n"
      "  gaitway ctl --port 9191 emergency-stop            the robot of 'gaitway serve --port 9191'\n"
      "  gaitway ctl look direction 0.5,0.1\n"
      "  gaitway ctl let-go\n"
      "  gaitway ctl plugin --help\n"
      "  gaitway ctl recording start walk1\n"
      "  gaitway ctl --url wss://robot:9090 --token-file token --ca ca.pem plugin list\n"
      "A robot that is not there is waited for, 3 s at most (--wait): it may be just coming back.\n"
      "Exit code: 0 done, 1 the input was bad or nobody is there, 2 refused, 3 no answer.");
}

}  // namespace gaitway::tools
