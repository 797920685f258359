// The thread beside the ticks that loads and destroys plug-ins when somebody asks for a change. For binaries.
#pragma once

#include <thread>

#include "gaitway/manager/plugin_requests.hpp"

namespace gaitway::core {

// Works at ordinary priority, from construction to destruction.
class PluginWorkshop {
 public:
  // `requests` outlives it, and is stepped by another thread.
  explicit PluginWorkshop(PluginRequests& requests)
      : requests_(requests), thread_([&requests] {
          while (requests.wait_for_work()) {
            requests.work();
          }
        }) {}
  PluginWorkshop(const PluginWorkshop&) = delete;
  PluginWorkshop& operator=(const PluginWorkshop&) = delete;
  ~PluginWorkshop() { requests_.end_work(); }

 private:
  PluginRequests& requests_;
  std::jthread thread_;  // joined after end_work()
};

}  // namespace gaitway::core
