// What the configuration says about the process of a plug-in with `isolation: process`.
#pragma once

#include <cstdint>
#include <filesystem>

#include "gaitway/core/isolation_options.hpp"

namespace gaitway::urdf {
class YamlValue;
}

namespace gaitway::core {

// Under a plug-in's entry:
//   network: serve          # it may open sockets while it is constructed, and accept connections ever after
//   writes: recordings      # the only folder in which it may create files; from the configuration's folder
//   descriptors: 512        # open files, 16..4096
//   memory: 1 GiB           # address space, 64 MiB..64 GiB
struct HostSettings {
  bool serves_network = false;
  std::filesystem::path writes;          // absolute; empty: none
  std::uint32_t descriptor_limit = 0;    // 0: that of IsolationOptions
  std::uint64_t memory_limit_bytes = 0;  // 0: the same
};

// The manager's options as these settings have them.
[[nodiscard]] IsolationOptions options_for(const HostSettings& settings, IsolationOptions options) noexcept;

// Reads these keys of a plug-in's entry. Throws urdf::RobotError.
HostSettings read_host_settings(const urdf::YamlValue& plugin, bool isolated);

}  // namespace gaitway::core
