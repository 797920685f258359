// A whole run of the simulated robot for tests: scenario in, metrics out.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/world/world_file.hpp"
#include "tools/run/run_recorder.hpp"

namespace gaitway::scenarios {

// How many seeds a scenario is played with; the build says which share of the stated number.
constexpr int seeds(int stated) {
  return (stated * GAITWAY_SEED_PERCENT + 99) / 100;
}

inline const urdf::RobotModel& humanoid22() {
  static const urdf::RobotModel robot =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  return robot;
}

inline world::World shipped_world(const std::string& name) {
  return world::read_world(std::filesystem::path(GAITWAY_SOURCE_DIR) / "tools/worlds" / (name + ".yaml"));
}

class SimulatedRun {
 public:
  // `configuration`: plug-ins of the main controller, relative to the source tree.
  explicit SimulatedRun(std::uint64_t seed, const std::filesystem::path& bus_log = {},
                        const std::filesystem::path& configuration = "core/config/walk.yaml")
      : SimulatedRun(options(seed, source_tree() / configuration), bus_log) {}
  // With a message controller whose port keeps one frame, as a CAN interface of an operating system does.
  static SimulatedRun on_an_interface(std::uint64_t seed) {
    simulator::CosimulationOptions chosen = options(seed, source_tree() / "core/config/walk.yaml");
    chosen.message_port_takes_back = false;
    return SimulatedRun(chosen, {});
  }
  static SimulatedRun on_ground(std::uint64_t seed, const simulator::GroundConditions& ground) {
    simulator::CosimulationOptions chosen = options(seed, source_tree() / "core/config/walk.yaml");
    chosen.plant.conditions.ground = ground;
    return SimulatedRun(chosen, {});
  }
  static SimulatedRun in_world(std::uint64_t seed, const world::World& world) {
    simulator::CosimulationOptions chosen = options(seed, source_tree() / "core/config/walk.yaml");
    chosen.plant.world = world;
    return SimulatedRun(chosen, {});
  }
  // With the plug-in `navigation`, which has the world as its map, and something in the room that sees the
  // robot.
  static SimulatedRun on_its_way(std::uint64_t seed, const world::World& world, bool localization = true) {
    core::Configuration plugins = core::read_configuration(source_tree() / "core/config/walk.yaml");
    core::PluginEntry& navigation = plugins.plugins.emplace_back();
    navigation.name = "navigation";
    navigation.library = "libgaitway_plugin_navigation.so";
    navigation.parameters = {{"plans_in_step", "true", 0}, {"world", world.file.string(), 0}};
    simulator::CosimulationOptions chosen = options(seed, plugins.file, plugins);
    chosen.plant.world = world;
    chosen.localization.is_there = localization;
    return SimulatedRun(chosen, {});
  }
  static SimulatedRun of_robot(std::uint64_t seed, const urdf::RobotModel& robot) {
    return SimulatedRun(options(seed, source_tree() / "core/config/walk.yaml"), {}, robot);
  }
  SimulatedRun(std::uint64_t seed, const core::Configuration& plugins)
      : SimulatedRun(options(seed, plugins.file, plugins), {}) {}

  // Plays a scenario to its end, or until the robot has fallen.
  void play(const simulator::Scenario& scenario) {
    auto event = scenario.events.begin();
    while (time_s() < scenario.seconds && !recorder.metrics().fell) {
      for (; event != scenario.events.end() && event->at_s <= time_s() + 1e-9; ++event) {
        apply(*event);
      }
      cosimulation.advance_millisecond();
    }
    recorder.finish();
  }
  void apply(const simulator::ScenarioEvent& event) {
    recorder.on_event(event, cosimulation.now_ns());
    cosimulation.apply(event);
  }
  [[nodiscard]] double time_s() const { return static_cast<double>(cosimulation.now_ns()) * 1e-9; }
  [[nodiscard]] const tools::RunMetrics& metrics() const { return recorder.metrics(); }

  simulator::Cosimulation cosimulation;
  tools::RunRecorder recorder;

 private:
  static std::filesystem::path source_tree() { return GAITWAY_SOURCE_DIR; }
  SimulatedRun(const simulator::CosimulationOptions& options, const std::filesystem::path& bus_log,
               const urdf::RobotModel& robot = humanoid22())
      : cosimulation(robot, options), recorder(cosimulation, bus_log, false) {
    cosimulation.observe(&recorder);
  }
  static simulator::CosimulationOptions options(std::uint64_t seed,
                                                const std::filesystem::path& configuration,
                                                std::optional<core::Configuration> plugins = std::nullopt) {
    simulator::CosimulationOptions result;
    result.plant.seed = seed;
    result.main_controller.configuration = configuration;
    result.main_controller.plugins = std::move(plugins);
    result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    return result;
  }
};

inline simulator::ScenarioEvent walk_at(double at_s, double forward, double left = 0.0, double turn = 0.0) {
  return {at_s, simulator::WalkEvent{.velocity_m_per_s = {forward, left}, .turn_rate_rad_per_s = turn}};
}
inline simulator::ScenarioEvent walk_to_at(double at_s, double x_m, double y_m, double yaw_rad) {
  return {at_s, simulator::WalkToEvent{std::array{x_m, y_m, yaw_rad}}};
}
inline simulator::ScenarioEvent stand_at(double at_s) {
  return {at_s, simulator::WalkEvent{.walk = false}};
}

}  // namespace gaitway::scenarios
