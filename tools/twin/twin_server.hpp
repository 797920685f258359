// A twin in a thread of its own, with a control channel of its own: a stop of the robot there waits for
// nothing that the simulation does.
#pragma once

#include <atomic>
#include <filesystem>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/simulation/control_server.hpp"
#include "tools/twin/twin.hpp"

namespace gaitway::tools {

class TwinServer {
 public:
  // Takes the twin's orders at `socket`. Throws process::SocketError.
  TwinServer(const TwinOptions& options, const urdf::RobotModel& robot, const std::filesystem::path& socket);
  // Ends what is sent, and the rest within some seconds.
  ~TwinServer();
  TwinServer(const TwinServer&) = delete;
  TwinServer& operator=(const TwinServer&) = delete;

  // How the simulation runs now.
  void set_pace(const SimulationPace& pace);
  // What there is to say for people since the last call.
  [[nodiscard]] std::vector<std::string> take_lines();

 private:
  void run();

  Twin twin_;  // of the thread alone, once that runs
  simulation::ControlServer server_;
  std::mutex mutex_;
  SimulationPace pace_;
  std::vector<std::string> lines_;
  std::atomic<bool> ending_ = false;
  std::thread thread_;  // the last: it uses the others
};

}  // namespace gaitway::tools
