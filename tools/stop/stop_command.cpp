// `gaitway stop`: stops a robot by datagram.

#include <fmt/format.h>
#include <poll.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/process/real_time.hpp"
#include "gaitway/stopgram/stop_sender.hpp"
#include "gaitway/stopgram/stop_socket.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;
using stopgram::StopState;

constexpr int kExitNotObeyed = 2;
constexpr int kExitNoAnswer = 3;
constexpr std::uint16_t kUsualPort = 9091;

struct StopOptions {
  std::string host;
  std::string kind = "stop";
  std::filesystem::path token_file;  // empty: the robot has none
  double seconds = 2.0;
};

struct Place {
  std::string host;
  std::uint16_t port = kUsualPort;
};

// HOST, HOST:PORT, an IPv6 address, or one in brackets with or without :PORT.
Place place_of(const std::string& text) {
  const bool in_brackets = text.starts_with('[');
  const std::size_t end = in_brackets ? text.find(']') : std::min(text.find(':'), text.size());
  Place place{.host = text.substr(in_brackets ? 1 : 0, end - (in_brackets ? 1 : 0))};
  std::string_view rest = std::string_view(text).substr(std::min(end + (in_brackets ? 1 : 0), text.size()));
  if (!in_brackets && rest.find(':', 1) != std::string_view::npos) {
    return {.host = text};  // a bare IPv6 address
  }
  if (!rest.empty()) {
    const char* const last = rest.data() + rest.size();
    const auto [read, error] = std::from_chars(rest.data() + 1, last, place.port);
    if (rest.front() != ':' || error != std::errc() || read != last || place.port == 0) {
      rest = {};
      place.host.clear();
    }
  }
  if (place.host.empty() || end == std::string::npos) {
    throw std::invalid_argument(fmt::format(
        "'{}': must be HOST or HOST:PORT, with a port from 1 to 65535 and an IPv6 address in brackets",
        text));
  }
  return place;
}

link::StopKind kind_of(const std::string& word) {
  return word == "stop"   ? link::StopKind::stop
         : word == "hold" ? link::StopKind::emergency_hold
                          : link::StopKind::emergency_soft;
}

double seconds_since(std::int64_t began_ns) {
  return static_cast<double>(process::monotonic_ns() - began_ns) * 1e-9;
}

void wait(const stopgram::StopSocket& socket, std::int64_t until_ns) {
  const std::int64_t wait_ns =
      std::clamp<std::int64_t>(until_ns - process::monotonic_ns(), 0, facts::kSecond_ns);
  pollfd wakes{socket.wake_fd(), POLLIN, 0};
  poll(&wakes, 1, static_cast<int>((wait_ns + kMillisecond_ns - 1) / kMillisecond_ns));
}

int stop(const StopOptions& options) {
  const link::StopKind kind = kind_of(options.kind);
  const Place place = place_of(options.host);
  stopgram::StopKey key =
      options.token_file.empty() ? stopgram::StopKey() : stopgram::StopKey::read(options.token_file);
  const stopgram::Peer robot = stopgram::find_peer(place.host, place.port);
  stopgram::StopSocket socket(robot);
  stopgram::StopSender sender(std::move(key), stopgram::random_identity());
  sender.stop(kind);
  const std::int64_t began_ns = process::monotonic_ns();
  const std::int64_t end_ns = began_ns + std::llround(options.seconds * 1e9);
  while (sender.state(kind) != StopState::obeyed && process::monotonic_ns() < end_ns) {
    const std::int64_t now_ns = process::monotonic_ns();
    for (link::Bytes datagram; !(datagram = sender.next(now_ns)).empty();) {
      socket.send(datagram, robot);
    }
    wait(socket, std::min(sender.next_due_ns(), end_ns));
    while (const auto received = socket.receive()) {
      sender.on_datagram(received->datagram, process::monotonic_ns());
    }
  }
  const std::string who = stopgram::text_of(robot);
  switch (sender.state(kind)) {
    case StopState::obeyed:
      fmt::print("the robot at {} has obeyed after {:.0f} ms\n", who, seconds_since(began_ns) * 1e3);
      return kExitFine;
    case StopState::heard:
      fmt::print(stderr,
                 "gaitway stop: {} has heard the stop, but the robot has not obeyed it within {:g} s: is its "
                 "main controller there? It obeys once it is\n",
                 who, options.seconds);
      return kExitNotObeyed;
    default:
      fmt::print(stderr,
                 "gaitway stop: nobody has answered at {} (UDP) for {:g} s: look at address and port, at the "
                 "token ({}), and at what the user interface module tells\n",
                 who, options.seconds,
                 options.token_file.empty() ? "none is given" : options.token_file.string());
      return kExitNoAnswer;
  }
}

}  // namespace

void declare_program(const CommandLine& app) {
  const CommandLine command = add_command(app, "stop");
  StopOptions& options = command.runs(stop);
  command
      .option(
          "host", options.host,
          "HOST or HOST:PORT of the user interface module: a name or an address; UDP port 9091 if none is "
          "given")
      .required();
  command
      .option(
          "--kind", options.kind,
          "stop: end the walk and stand; hold: emergency stop, the joints hold; soft: emergency stop, the "
          "joints let go")
      .one_of({"stop", "hold", "soft"});
  command.option("--token-file", options.token_file,
                 "File with the robot's token; without it for a robot that has none");
  command.option("--seconds", options.seconds, "Says it so long until it is obeyed").between(0.05, 3600.0);
  command.footer(
      "Examples:\n"
      "  gaitway stop localhost                                      the robot of `gaitway serve`\n"
      "  gaitway stop robot.local --token-file token\n"
      "  gaitway stop 192.168.1.7:9191 --kind soft --token-file token --seconds 10\n"
      "The stop goes by UDP, beside whatever connections there are, and is said every 10 ms. Whoever "
      "commands "
      "the robot must\n"
      "take the command again.\n"
      "Exit code: 0 the robot has obeyed, 1 the input was bad and nothing was sent, 2 it was heard but not "
      "obeyed in time, 3\n"
      "nobody answered: there is no such robot, or its token is another.");
}

}  // namespace gaitway::tools
