// A simulated robot that `gaitway robot up` has brought up, in a folder, a mount namespace and at a port of
// its own, and what faults need to know of it: its processes, its disk, its clock.
#pragma once

#include <sys/types.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/process/private_folder.hpp"
#include "tools/robot/keeper/robot_status.hpp"

namespace gaitway::tools {

// What a robot of the campaign has beside what is shipped.
enum class Equipment {
  none,
  for_faults,  // balance feedback that can be made to fail, a small disk for its logs, a clock that can be
               // shifted
};

class WalkingRobot {
 public:
  struct Options {
    std::filesystem::path robot;
    std::uint64_t seed = 1;
    Equipment equipment = Equipment::none;
  };
  // Returns when it may be commanded. Throws std::runtime_error with what it said.
  explicit WalkingRobot(const Options& options);
  // Takes it down.
  ~WalkingRobot();
  WalkingRobot(const WalkingRobot&) = delete;
  WalkingRobot& operator=(const WalkingRobot&) = delete;

  [[nodiscard]] std::uint64_t seed() const noexcept { return options_.seed; }
  [[nodiscard]] int port() const noexcept { return port_; }
  [[nodiscard]] std::string url() const;  // of its API
  [[nodiscard]] const std::filesystem::path& folder() const noexcept { return folder_.path(); }
  // Its logs, as its own processes see them: also where they are on a disk of its own.
  [[nodiscard]] std::filesystem::path logs() const;
  // That of the part which does the work. Throws std::runtime_error when there is none.
  [[nodiscard]] pid_t worker(const std::string& part) const;
  // Of the plug-in 'stability', with Equipment::for_faults. Throws as worker().
  [[nodiscard]] pid_t plugin_host() const;
  // The simulated body has said that it fell.
  [[nodiscard]] bool told_fall() const;
  // `gaitway ctl plugin set stability NAME VALUE`. Throws std::runtime_error.
  void set_parameter(const std::string& name, const std::string& value) const;
  // With Equipment::for_faults: what CLOCK_REALTIME is off by in its processes, and how long each of their
  // writings to a file takes.
  void disturb(std::int64_t clock_shift_ns, std::int64_t write_ns) const;

 private:
  void take_down() const;
  [[nodiscard]] std::vector<std::string> words() const;
  void write_configuration() const;
  void become(const std::vector<std::string>& words) const;
  [[nodiscard]] int run(const std::vector<std::string>& words, bool on_own_disk) const;

  Options options_;
  process::PrivateFolder folder_;
  int port_ = 0;
};

// The program beside this one, or in its installation. Throws std::runtime_error.
[[nodiscard]] std::filesystem::path campaign_program(const std::string& name);
// What only the campaign loads. Throws likewise.
[[nodiscard]] std::filesystem::path campaign_library(const std::string& name);

}  // namespace gaitway::tools
