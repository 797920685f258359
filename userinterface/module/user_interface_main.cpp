// The `user_interface` process: the robot's user interface module. Between the network, where its users are,
// and the main controller, which it reaches over a narrow link.
#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <exception>
#include <optional>
#include <sstream>
#include <string>
#include <thread>

#include "gaitway/api/descriptor_bound.hpp"
#include "gaitway/api/door.hpp"
#include "gaitway/api/limits_file.hpp"
#include "gaitway/api/line_teller.hpp"
#include "gaitway/api/recording_folder.hpp"
#include "gaitway/api/simulator_port.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/process/installation.hpp"

namespace {

using namespace gaitway;

struct Options {
  std::filesystem::path robot = process::default_robot_directory();
  std::string profile;
  std::string link = "unix:/run/gaitway/link.sock";
  std::string simulation;  // empty: the robot is none
  std::string twin;        // empty: it is the twin of no robot
  std::string address = "127.0.0.1";
  std::uint16_t port = 9090;
  std::optional<std::uint16_t> stop_port;
  std::string origins;
  std::filesystem::path token_file, certificate_file, key_file, recordings, limits;
  int ready_descriptor = -1;  // gets a byte when clients can connect
  std::uint64_t recording_bytes = api::kRecordingLimit_bytes;
};

std::vector<std::string> split(const std::string& text) {
  std::vector<std::string> parts;
  std::istringstream stream(text);
  for (std::string part; std::getline(stream, part, ',');) {
    const auto begin = part.find_first_not_of(' ');
    if (begin != std::string::npos) {
      parts.push_back(part.substr(begin, part.find_last_not_of(' ') - begin + 1));
    }
  }
  return parts;
}

api::DoorOptions door_options(const Options& options) {
  api::DoorOptions door;
  door.robot = options.robot;
  door.profile = options.profile;
  door.link = link::parse_link_address(options.link);
  if (!options.simulation.empty()) {
    door.simulation = api::simulator_socket(options.simulation);
  }
  if (!options.twin.empty()) {
    door.twin = api::simulator_socket(options.twin);
  }
  door.server.address = options.address;
  door.server.port = options.port;
  door.stop_port = options.stop_port;
  door.server.origins = split(options.origins);
  door.server.token_file = options.token_file;
  door.server.certificate_file = options.certificate_file;
  door.server.key_file = options.key_file;
  door.recordings = options.recordings;
  door.recording_bytes = options.recording_bytes;
  if (!options.limits.empty()) {
    door.server.limits = api::read_limits(options.limits);
  }
  return door;
}

// More than all limits add up to is a mistake of this program's: it ends then, and nobody else of the
// computer suffers.
void bound_memory(const api::Limits& limits) {
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)  // their shadow memory is far larger
  rlimit bound{};
  getrlimit(RLIMIT_DATA, &bound);
  bound.rlim_cur = std::min<rlim_t>(bound.rlim_max, api::most_memory_bytes(limits));
  setrlimit(RLIMIT_DATA, &bound);
#else
  static_cast<void>(limits);
#endif
}

void tell(const std::string& line) {
  static api::LineTeller teller(STDERR_FILENO, "user_interface");
  teller.tell(line);
}

int serve(const Options& options) {
  sigset_t ends;
  sigemptyset(&ends);
  sigaddset(&ends, SIGINT);
  sigaddset(&ends, SIGTERM);
  pthread_sigmask(SIG_BLOCK, &ends, nullptr);  // inherited by all threads: one of them waits for it
  signal(SIGPIPE, SIG_IGN);
  signal(SIGXFSZ, SIG_IGN);  // a recording that may not grow ends by itself, and this process goes on
  const api::DoorOptions door_settings = door_options(options);
  api::provide_descriptors(door_settings.server.limits);
  bound_memory(door_settings.server.limits);
  api::Door door(door_settings, tell);
  if (options.ready_descriptor >= 0) {
    static_cast<void>(!write(options.ready_descriptor, "\n", 1));
    close(options.ready_descriptor);
  }
  std::thread waits([&door, &ends] {
    int which = 0;
    sigwait(&ends, &which);
    door.stop();
  });
  door.run();
  waits.join();
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  constexpr int kExitBadInput = 1;
  Options options;
  CLI::App app{
      "The robot's user interface module: the robot API (rosbridge v2 over WebSocket) and the page, on one "
      "side; on the other the narrow "
      "link to the main controller, whose plug-in `api` must be loaded."};
  app.option_defaults()->always_capture_default();
  app.add_option("--robot", options.robot,
                 "Folder with robot.urdf and robot.yaml: the same as the main controller's");
  app.add_option("--profile", options.profile,
                 "Messages of its bus: full or paper, as the message controller's. Without it, what the "
                 "robot's network file says");
  app.add_option("--link", options.link, "The main controller: unix:PATH, or serial:DEVICE:BAUD");
  app.add_option(
      "--simulation", options.simulation,
      "The robot is a simulation whose simulator listens there: unix:PATH, as `gaitway simulator` and "
      "`gaitway "
      "serve` give it. Then clients may push the robot, and, with the former, have its time and its world");
  app.add_option(
         "--twin", options.twin,
         "And is the twin of a real robot, about which one may ask there: unix:PATH, as `gaitway simulator "
         "--robot ws://HOST:PORT` gives it")
      ->needs("--simulation");
  app.add_option("--port", options.port, "TCP port of the robot API; 0: any free one");
  app.add_option(
      "--stop-port", options.stop_port,
      "UDP port of stops by datagram (`gaitway stop`), at the same address; 0: none; without it one "
      "more than the TCP port");
  app.add_option(
      "--address", options.address,
      "Address to listen on. Any but a loopback one needs --token-file, --certificate-file and --key-file");
  app.add_option("--origins", options.origins,
                 "Web origins that may connect besides this computer's, with commas between them; null: "
                 "pages from files");
  app.add_option("--token-file", options.token_file, "File with the token that clients must know");
  app.add_option("--certificate-file", options.certificate_file, "Certificate chain (PEM)");
  app.add_option("--key-file", options.key_file, "Its private key (PEM)");
  app.add_option("--recordings", options.recordings, "Folder for recordings; without it nothing is recorded");
  app.add_option("--recording-bytes", options.recording_bytes, "A recording's size, at most")
      ->check(CLI::Range(std::uint64_t{1'000'000}, std::uint64_t{1'000'000'000'000}));
  app.add_option(
      "--limits", options.limits,
      "Limits of clients (YAML: name: value) in place of the shipped ones; docs/api.md lists them");
  app.add_option("--ready-descriptor", options.ready_descriptor,
                 "Gets a byte when clients can connect: for who starts this program")
      ->capture_default_str()
      ->group("");
  app.footer(
      "Examples:\n"
      "  user_interface --link unix:/run/gaitway/link.sock            clients of this computer; the page at "
      "http://127.0.0.1:9090\n"
      "  user_interface --link serial:/dev/ttyS1:1000000 --address 0.0.0.0 --token-file token "
      "--certificate-file cert.pem \\\n"
      "                 --key-file key.pem --recordings /var/lib/gaitway/recordings\n"
      "Ends with SIGINT or SIGTERM. Exit code: 0 it was told to end; 1 the input was bad, or the port is "
      "taken.");
  try {
    app.parse(argc, argv);
    return serve(options);
  } catch (const CLI::ParseError& help_or_error) {
    return app.exit(help_or_error) == 0 ? 0 : kExitBadInput;
  } catch (const std::exception& error) {
    tell(error.what());
    return kExitBadInput;
  }
}
