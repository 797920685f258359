// A memory block and managers of the test plug-ins in it.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <memory>
#include <string>

#include "gaitway/manager/plugin_manager.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/plugin/cycle.hpp"

namespace gaitway::core {

class PluginFixture : public testing::Test {
 protected:
  // `plugins`: the list under `plugins:`, in YAML.
  std::unique_ptr<PluginManager> load(const std::string& plugins) {
    PluginManagerOptions options;
    options.robot_directory = GAITWAY_TEST_ROBOT;
    options.plugin_path = {GAITWAY_TEST_PLUGINS};
    options.isolation = isolation;
    options.try_at_start = try_at_start;
    options.memory_socket = memory_socket;
    options.stopped = stopped;
    return std::make_unique<PluginManager>(parse_configuration("plugins:\n" + plugins, "test.yaml"), options,
                                           client);
  }
  // What the loading complains about; empty if it does not.
  std::string refusal(const std::string& plugins) {
    try {
      load(plugins);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return {};
  }
  static Tick tick(std::uint32_t number) {
    return tick_at(std::int64_t{number} * facts::kSlot_ns + kTickPhase_ns);
  }

  IsolationOptions isolation;
  bool try_at_start = false;
  std::filesystem::path memory_socket;
  std::vector<std::string> stopped;
  msgclient::MemoryBlock block;
  msgclient::Client client = block.local_client("main_controller");
  msgclient::Client other = block.local_client("other_process");
};

// An entry of the configuration for the plug-in `relay`.
inline std::string relay(const std::string& name, const std::string& parameters) {
  return "  - {name: " + name + ", library: relay.so, parameters: {" + parameters + "}}\n";
}

// The only child of this process.
inline pid_t child_process() {
  for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
    std::ifstream status(entry.path() / "stat");
    std::string pid, name, state;
    pid_t parent = 0;
    if (status >> pid >> name >> state >> parent && parent == getpid()) {
      return std::stoi(pid);
    }
  }
  return 0;
}

// Until that child's thread that steps has nothing to do: its answer is there.
inline void wait_until_idle(pid_t child) {
  const std::string path = "/proc/" + std::to_string(child) + "/stat";
  std::string pid, name, state;
  do {
    std::ifstream(path) >> pid >> name >> state;
  } while (state == "R" || state == "D");
}

// Until it has ended; it stays to be waited for.
inline void wait_until_ended(pid_t child) {
  siginfo_t info{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &info, WEXITED | WNOWAIT), 0);
}

}  // namespace gaitway::core
