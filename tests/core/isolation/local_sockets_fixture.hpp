// A plug-in that serves a Unix socket: the tests tell it over that what to do, and when.
#pragma once

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "plugin_fixture.hpp"

namespace gaitway::core {

class LocalSockets : public PluginFixture {
 protected:
  LocalSockets() {
    std::string name = (std::filesystem::path(testing::TempDir()) / "gaitway_sockets_XXXXXX").string();
    EXPECT_NE(mkdtemp(name.data()), nullptr);
    folder = name;
  }
  ~LocalSockets() override {
    manager.reset();
    std::filesystem::remove_all(folder);
  }
  // `parameters`: beside its door.
  [[nodiscard]] std::string server(const std::string& keys = "", const std::string& parameters = "") const {
    return entry(", isolation: process, sockets: local" + keys, parameters);
  }
  [[nodiscard]] std::string entry(const std::string& keys, const std::string& parameters = "") const {
    return "  - {name: server, library: local_sockets.so" + keys +
           ", parameters: {door: " + (folder / "door").string() + parameters + "}}\n";
  }

  // The newest line of the server that contains `part`.
  [[nodiscard]] std::string newest(const std::string& part) const {
    const EventLog& events = manager->events();
    for (std::uint64_t i = events.total(); i > events.first(); --i) {
      if (events[i - 1].source() == "server" && events[i - 1].text().find(part) != std::string_view::npos) {
        return std::string(events[i - 1].text());
      }
    }
    return {};
  }
  // The server's answer; -2: it closed the connection without one.
  [[nodiscard]] int ask(const std::string& what) const {
    const process::FileDescriptor connection(socket(AF_UNIX, SOCK_STREAM, 0));
    const sockaddr_un to = process::socket_address(folder / "door");
    EXPECT_EQ(connect(connection.get(), reinterpret_cast<const sockaddr*>(&to), sizeof to), 0);
    EXPECT_EQ(send(connection.get(), what.data(), what.size(), MSG_NOSIGNAL),
              static_cast<ssize_t>(what.size()));
    std::array<char, 32> answer{};
    return recv(connection.get(), answer.data(), answer.size() - 1, 0) > 0 ? std::atoi(answer.data()) : -2;
  }
  // What the setting of its parameter is refused with; empty: it is set.
  [[nodiscard]] std::string parameter_refusal() const {
    try {
      manager->changes().set_parameter("server", "level", "1");
    } catch (const PluginError& error) {
      return error.what();
    }
    return {};
  }
  int step() {
    const int failed = manager->step(tick(++number));
    manager->maintain(tick(number).now_ns);
    return failed;
  }
  [[nodiscard]] std::string fault() const {
    for (std::size_t i = 0; i < manager->size(); ++i) {
      if (manager->plugin(i).name() == "server") {
        return std::string(manager->plugin(i).fault());
      }
    }
    return {};
  }
  // Of the last of two relays that work beside it.
  double relayed() {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>("b").read(correction));
    return correction.com_offset[0];
  }
  static std::string relays() {
    return relay("first", "to: a") + relay("second", "from: a, add: 100, to: b");
  }
  [[nodiscard]] ServiceState service() const {
    for (const PluginTiming& timing : manager->timings()) {
      if (timing.name == "server") {
        return timing.state;
      }
    }
    return ServiceState::stopped;
  }
  // Ends its process and gives the line with which it comes back.
  std::string end_and_wait() {
    EXPECT_EQ(ask("die"), -2);
    int failed = 0;
    for (int i = 0; i == 0 || (failed > 0 && i < 100); ++i) {
      failed = step();
      EXPECT_EQ(failed, i == 0 ? 1 : std::min(failed, 1)) << "nobody else fails";
      EXPECT_EQ(relayed(), 100.0 + number);
      EXPECT_EQ(manager->fault_behind("b"), nullptr);
    }
    EXPECT_EQ(failed, 0);
    return newest("runs in a new process");
  }

  std::filesystem::path folder;
  std::unique_ptr<PluginManager> manager;
  std::uint32_t number = 0;
};

}  // namespace gaitway::core
