// The least that hosts a plug-in: a table of functions and a buffer for each topic. No checks, no
// containment, no memory block: what a step costs without a manager.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "gaitway/plugin/abi.h"

namespace gaitway::core {

// The topics of all plug-ins that are to hear each other.
struct DirectTopic {
  std::vector<std::byte> value;
  std::uint64_t sequence = 0;
  std::int64_t stamp_ns = 0;
};
using DirectTopics = std::map<std::string, DirectTopic, std::less<>>;

// An instance of a plug-in, called straight through its function table. Stays where it is.
class DirectPlugin {
 public:
  // Parameters that are not in `texts` keep their defaults. Throws std::runtime_error with the plug-in's
  // words.
  DirectPlugin(const gaitway_plugin& plugin, DirectTopics& topics, std::string robot_directory,
               std::map<std::string, std::string> texts = {});
  ~DirectPlugin();
  DirectPlugin(const DirectPlugin&) = delete;
  DirectPlugin& operator=(const DirectPlugin&) = delete;

  void activate();
  gaitway_status step(const gaitway_tick& tick) noexcept {
    return instance_.step(instance_.context, &tick, &error_);
  }

 private:
  static gaitway_status open_topic(void* context, const gaitway_topic* topic, gaitway_access access,
                                   gaitway_port** port, const gaitway_text* error) noexcept;
  static gaitway_status parameter(void* context, const gaitway_parameter* parameter, gaitway_value* value,
                                  const gaitway_text* error) noexcept;
  static gaitway_status read(void* context, gaitway_port* port, void* value, gaitway_sample* sample) noexcept;
  static gaitway_status publish(void* context, gaitway_port* port, const void* value) noexcept;
  void require(gaitway_status status) const;

  DirectTopics& topics_;
  std::string robot_directory_;
  std::map<std::string, std::string> texts_;
  char error_bytes_[1024]{};
  gaitway_text error_{error_bytes_, sizeof error_bytes_, 0};
  gaitway_host host_{};
  gaitway_instance instance_{};
};

}  // namespace gaitway::core
