// Keeps the user interface module running beside the simulated robot, as the robot's own computer does:
// started, and started again.
#pragma once

#include <sys/types.h>

#include <atomic>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::tools {

class ModuleKeeper {
 public:
  // Starts it, and returns when it serves. `arguments`: its command line, without the program. Throws
  // std::runtime_error when it ends before, having said why.
  explicit ModuleKeeper(std::vector<std::string> arguments);
  // Ends it.
  ~ModuleKeeper();
  ModuleKeeper(const ModuleKeeper&) = delete;
  ModuleKeeper& operator=(const ModuleKeeper&) = delete;

 private:
  void keep();
  [[nodiscard]] bool start();                 // false: it could not be started
  [[nodiscard]] bool comes_to_serve() const;  // false: it has ended before, or is to
  [[nodiscard]] int wait_for_end();           // its status
  void report(int status) const;

  std::vector<std::string> arguments_;
  process::FileDescriptor ending_;  // an eventfd
  process::FileDescriptor ready_;   // where the module says that it serves
  std::atomic<pid_t> process_ = 0;
  process::FileDescriptor pidfd_;
  std::atomic<int> first_state_ = 0;  // 0 not known yet, 1 serves, 2 ended
  std::thread thread_;                // which starts it, so that the kernel ends it with this process
};

}  // namespace gaitway::tools
