// A simulation with a time line, in processes of its own.
#pragma once

#include <gmock/gmock.h>

#include <filesystem>
#include <memory>
#include <string>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/timeline/live_simulation.hpp"
#include "gaitway/timeline/simulation_copy.hpp"
#include "gaitway/world/world_file.hpp"

namespace gaitway::timeline {

inline const std::filesystem::path& source_tree() {
  static const std::filesystem::path tree = GAITWAY_SOURCE_DIR;
  return tree;
}

inline const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot = urdf::load_robot(source_tree() / "urdf/humanoid22");
  return robot;
}

class SimulationTest : public testing::Test {
 protected:
  static constexpr std::int64_t kSecond_ns = 1'000'000'000;

  [[nodiscard]] simulator::CosimulationOptions options() const {
    simulator::CosimulationOptions options;
    options.plant.seed = 3;
    options.plant.world = world::read_world(source_tree() / "tools/worlds/empty.yaml");
    options.main_controller.configuration = source_tree() / "core/config/walk.yaml";
    options.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    options.main_controller.memory_socket = folder_.path() / "memory.sock";
    options.main_controller.isolation.lock_step = false;
    return options;
  }
  [[nodiscard]] std::unique_ptr<ReplayedRun> run() const {
    return std::make_unique<ReplayedRun>(humanoid22(), options());
  }
  [[nodiscard]] CopyHandle start() {
    live_.memory_socket = folder_.path() / "memory.sock";
    live_.digest_every_ns = 10 * kSecond_ns;
    live_.quiet = true;
    live_.api = core::read_configuration(source_tree() / "core/config/serve.yaml").plugins.back();
    live_.api.parameters = {{"link", "unix:" + (folder_.path() / "link.sock").string(), 0}};
    return start_simulation([this] { return run(); },
                            [this](ReplayedRun& copy, const CopyChannel& channel,
                                   const nlohmann::json& told) { live(live_, copy, channel, told); });
  }
  // The same events played in this process.
  [[nodiscard]] std::uint64_t digest_of(std::span<const TimedEvent> events, std::int64_t at_ns) const {
    const auto alone = run();
    alone->expect(events);
    alone->advance_to(at_ns);
    return alone->digest();
  }

  process::PrivateFolder folder_{"gaitway_timeline"};
  LiveOptions live_{.memory_socket = {}, .api = {}, .digest_every_ns = 0, .quiet = true};
};

}  // namespace gaitway::timeline
