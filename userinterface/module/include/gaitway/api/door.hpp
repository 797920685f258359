// Everything between the link and the sockets: what the process user_interface consists of.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "gaitway/api/server_setup.hpp"
#include "gaitway/link/link_address.hpp"

namespace gaitway::api {

struct DoorOptions {
  std::filesystem::path robot;  // folder with robot.urdf and robot.yaml
  std::string profile;          // of the bus; empty: what its network file says
  link::LinkAddress link;
  ServerOptions server;
  // UDP, at the server's address; 0: no stops by datagram; without it one more than the port that the server
  // got.
  std::optional<std::uint16_t> stop_port;
  // Socket of the simulator's control channel; empty: the robot is no simulation.
  std::filesystem::path simulation;
  // Likewise of the twin of a real robot that the simulation is; empty: of none.
  std::filesystem::path twin;
  std::filesystem::path recordings;   // folder; empty: nothing is recorded
  std::uint64_t recording_bytes = 0;  // a recording's size, at most
};

class Door {
 public:
  // Opens all that it needs. `tell`: lines for people, from any of its threads. Throws what std::exception
  // says.
  Door(const DoorOptions& options, std::function<void(const std::string&)> tell);
  ~Door();
  Door(const Door&) = delete;
  Door& operator=(const Door&) = delete;

  // Serves until stop(), which any thread may call.
  void run();
  void stop();
  [[nodiscard]] const std::string& url() const noexcept;

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace gaitway::api
