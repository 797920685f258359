// Words of the command line, understood and made.
#include "tools/simulator/twin_choice.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "gaitway/process/installation.hpp"

namespace gaitway::tools {
namespace {

bool is_address(const std::string& text) {
  return text.starts_with("ws://") || text.starts_with("wss://");
}

// "http://robot:9090" or "robot:9090".
bool looks_like_address(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  const bool has_port = colon != std::string::npos && colon + 1 < text.size() &&
                        text.find_first_not_of("0123456789", colon + 1) == std::string::npos;
  return (text.find("://") != std::string::npos || has_port) && !std::filesystem::exists(text);
}

}  // namespace

TwinChoice twin_choice(const std::vector<std::string>& robots, const std::filesystem::path& token_file,
                       const std::filesystem::path& ca_file) {
  TwinChoice choice;
  for (const std::string& one : robots) {
    const bool again = is_address(one) ? choice.there.has_value() : !choice.folder.empty();
    if (!is_address(one) && looks_like_address(one)) {
      throw std::invalid_argument(fmt::format(
          "--robot {}: the address of a robot's API begins with ws:// or wss://, for example ws://robot:9090",
          one));
    }
    if (again) {
      throw std::invalid_argument(
          fmt::format("--robot {}: there is one already: give one folder and one address at most", one));
    }
    if (is_address(one)) {
      choice.there = ApiAddress{.url = one, .token_file = token_file, .ca_file = ca_file};
    } else {
      choice.folder = one;
    }
  }
  if (!choice.there && !(token_file.empty() && ca_file.empty())) {
    throw std::invalid_argument(
        "--robot-token-file and --robot-ca are of a real robot: give its address, --robot ws://HOST:PORT");
  }
  if (choice.folder.empty()) choice.folder = process::default_robot_directory();
  return choice;
}

RobotNow ask_real_robot(const ApiAddress& there, const urdf::RobotModel& robot) {
  ApiClient client(there);
  return ask_where(client, robot);
}

ApiAddress own_api(const ModuleOptions& module) {
  if (module.port == 0) {
    throw std::invalid_argument("--port 0: a twin talks to its own robot API, too: give a port");
  }
  const bool everywhere = module.address == "0.0.0.0" || module.address == "::";
  const std::string host = everywhere ? "127.0.0.1" : module.address;
  const bool is_six = host.find(':') != std::string::npos;
  return {.url = fmt::format("{}://{}:{}", module.certificate_file.empty() ? "ws" : "wss",
                             is_six ? "[" + host + "]" : host, module.port),
          .token_file = module.token_file,
          .ca_file = module.certificate_file,
          .any_name = true};  // the certificate is for those who come from elsewhere
}

std::vector<std::string> flight_arguments(const ApiAddress& there, const std::filesystem::path& robot,
                                          const std::filesystem::path& config, const world::World& world,
                                          int robots) {
  std::vector<std::string> words{"--from=" + there.url, "--robot=" + robot.string(),
                                 "--config=" + config.string(), "--world=" + world.file.string(),
                                 fmt::format("--robots={}", robots)};
  if (world.random_seed) words.push_back(fmt::format("--world-seed={}", *world.random_seed));
  if (!there.token_file.empty()) words.push_back("--token-file=" + there.token_file.string());
  if (!there.ca_file.empty()) words.push_back("--ca=" + there.ca_file.string());
  return words;
}

}  // namespace gaitway::tools
