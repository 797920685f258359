// Reads what `gaitway run` reads, with the same defaults.
#include "robot_setup.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <stdexcept>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/process/shipped_files.hpp"
#include "gaitway/world/world_choice.hpp"

namespace gaitway::python {
namespace {

constexpr std::string_view kNavigation = "navigation";

std::filesystem::path robot_folder(const std::string& given) {
  const std::filesystem::path shipped = process::default_robot_directory().parent_path();
  if (given.empty()) return process::default_robot_directory();
  if (std::filesystem::is_directory(given) || given.find('/') != std::string::npos) return given;
  if (std::filesystem::is_regular_file(shipped / given / "robot.yaml")) return shipped / given;
  std::vector<std::string> known;
  for (const auto& entry : std::filesystem::directory_iterator(shipped)) {
    if (std::filesystem::is_regular_file(entry.path() / "robot.yaml"))
      known.push_back(entry.path().filename());
  }
  std::ranges::sort(known);
  input::refuse({"robot", 0, "name", "'" + given + "'",
                 "there is no such folder, and no robot of that name is shipped",
                 input::suggest(given, known)});
}

std::filesystem::path configuration_file(const std::string& given) {
  if (given.empty()) return process::default_config_file();
  if (process::is_file(given) || given.find('/') != std::string::npos) return given;
  const std::filesystem::path folder = process::config_directory();
  if (const auto shipped = process::find_shipped(folder, given, ".yaml")) return *shipped;
  input::refuse({"config", 0, "name", "'" + given + "'",
                 "there is no such file, and none of that name is shipped",
                 input::suggest(given, process::shipped_names(folder, ".yaml"))});
}

std::optional<world::World> world_of(const RobotChoice& choice) {
  if (!choice.world) {
    if (choice.world_seed) throw std::invalid_argument("world_seed: needs a world. Give world=NAME, too");
    return std::nullopt;
  }
  return world::load_world(
      {.name = *choice.world, .random_seed = choice.world_seed, .written_in = "world", .line = 0});
}

urdf::RobotModel load(const RobotChoice& choice) {
  const std::scoped_lock lock(loading_lock());
  urdf::RobotModel robot = msgcontroller::load_robot(robot_folder(choice.robot), choice.profile);
  msgcontroller::require_proven_network(robot, choice.accept_unproven);
  return robot;
}

core::PluginEntry* entry_of(core::Configuration& configuration, std::string_view name) {
  const auto entry = std::ranges::find(configuration.plugins, name, &core::PluginEntry::name);
  return entry == configuration.plugins.end() ? nullptr : &*entry;
}

std::vector<std::string> names_of(const core::Configuration& configuration) {
  std::vector<std::string> names;
  std::ranges::transform(configuration.plugins, std::back_inserter(names), &core::PluginEntry::name);
  return names;
}

void set(core::PluginEntry& plugin, const std::string& name, const std::string& text) {
  std::erase_if(plugin.parameters, [&name](const core::ParameterEntry& given) { return given.name == name; });
  plugin.parameters.push_back({.name = name, .text = text});
}

}  // namespace

// A process that is copied while another thread loads would have a lock that nobody opens: the copy is made
// when nobody else loads, and begins with a lock of its own. Recursive, since who loads may itself fork.
std::recursive_mutex& loading_lock() {
  static std::recursive_mutex lock;
  static const int kept_over_forks =
      pthread_atfork([] { lock.lock(); }, [] { lock.unlock(); }, [] { new (&lock) std::recursive_mutex; });
  static_cast<void>(kept_over_forks);
  return lock;
}

RobotSetup::RobotSetup(const RobotChoice& choice)
    : robot_(load(choice)),
      configuration_(core::read_configuration(configuration_file(choice.configuration))),
      writes_(choice.writes) {
  const std::filesystem::path file = configuration_.file;
  options_.plant.world = world_of(choice);
  if (!choice.conditions.empty()) {
    options_.plant.conditions =
        simulator::read_conditions(input::YamlValue::parse(choice.conditions, "conditions"));
  }
  if (!(choice.mismatch >= 0.0 && choice.mismatch <= 10.0)) {
    throw std::invalid_argument(
        fmt::format("mismatch = {:g}: must be 0..10; 1 is what the description says", choice.mismatch));
  }
  options_.plant.mismatch = choice.mismatch;
  if (choice.navigation || entry_of(configuration_, "behaviour") != nullptr) add_navigation();
  options_.localization.is_there = choice.localization && choice.navigation;
  if (!choice.libraries.empty()) {
    const std::vector<std::filesystem::path> libraries(choice.libraries.begin(), choice.libraries.end());
    configuration_ =
        core::put_in(configuration_, libraries,
                     {.robot_directory = robot_.directory, .plugin_path = core::plugin_search_path({})})
            .configuration;
    options_.main_controller.try_at_start = true;  // somebody's own, which may crash
  }
  take_out_writers();
  set_parameters(choice.parameters);
  options_.main_controller.configuration = file;
  options_.main_controller.plugins = configuration_;
}

simulator::CosimulationOptions RobotSetup::options(std::uint64_t seed, msgclient::MemoryBlock& block) const {
  simulator::CosimulationOptions options = options_;
  options.plant.seed = seed;
  options.memory_block = &block;
  return options;
}

// As the option --to of `gaitway run` has it.
void RobotSetup::add_navigation() {
  if (entry_of(configuration_, kNavigation) != nullptr) return;
  core::PluginEntry entry;
  entry.name = kNavigation;
  entry.library = "libgaitway_plugin_navigation.so";
  set(entry, "plans_in_step", "true");
  if (const auto& world = options_.plant.world; world && entry_of(configuration_, "vision") == nullptr) {
    set(entry, "world", world->file.string());
    if (world->random_seed) set(entry, "world_seed", std::to_string(*world->random_seed));
  }
  configuration_.plugins.push_back(std::move(entry));
}

// A topic has one writer: the schema names the plug-in that goes.
void RobotSetup::take_out_writers() {
  for (const std::string& name : writes_) {
    const auto topic = std::ranges::find(kStandardTopics, name, &StandardTopic::name);
    if (topic == kStandardTopics.end()) {
      std::vector<std::string> known;
      for (const StandardTopic& one : kStandardTopics) known.emplace_back(one.name);
      throw std::invalid_argument(
          fmt::format("writes: there is no topic '{}'. {}", name, input::suggest(name, known)));
    }
    if (entry_of(configuration_, topic->writer) == nullptr) continue;
    std::erase_if(configuration_.plugins,
                  [&topic](const core::PluginEntry& entry) { return entry.name == topic->writer; });
    taken_out_.emplace_back(topic->writer);
  }
}

void RobotSetup::set_parameters(const std::vector<ParameterChoice>& parameters) {
  for (const ParameterChoice& parameter : parameters) {
    core::PluginEntry* const entry = entry_of(configuration_, parameter.plugin);
    if (entry == nullptr) {
      throw std::invalid_argument(fmt::format("parameters: the configuration {} has no plug-in '{}'. {}",
                                              configuration_.file.string(), parameter.plugin,
                                              input::suggest(parameter.plugin, names_of(configuration_))));
    }
    set(*entry, parameter.name, parameter.text);
  }
}

}  // namespace gaitway::python
