// The simulated robot for the tests of plug-ins: the co-simulation behind a small face.
#include "gaitway/simulator/simulated_robot.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "gaitway/input/complaint.hpp"
#include "gaitway/manager/plugin_exchange.hpp"
#include "gaitway/process/installation.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway {
namespace {

constexpr double kPushDuration_s = 0.1;

std::filesystem::path or_shipped(const std::filesystem::path& given, std::filesystem::path (*shipped)()) {
  return given.empty() ? shipped() : given;
}

simulator::CosimulationOptions options_of(const SimulationOptions& given, const urdf::RobotModel& robot) {
  const std::filesystem::path config = or_shipped(given.config, &process::default_config_file);
  const core::PluginExchange plugins =
      core::put_in(core::read_configuration(config), given.with,
                   {.robot_directory = robot.directory, .plugin_path = core::plugin_search_path({})});
  simulator::CosimulationOptions options;
  options.plant.seed = given.seed;
  options.plant.mismatch = given.mismatch;
  if (!given.world.empty()) {
    options.plant.world = world::load_world(
        {.name = given.world, .random_seed = {}, .written_in = "SimulationOptions", .line = 0});
  }
  options.main_controller.configuration = config;
  options.main_controller.plugins = plugins.configuration;
  return options;
}

double yaw_of(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

}  // namespace

struct SimulatedRobot::Implementation {
  explicit Implementation(const SimulationOptions& options)
      : robot(urdf::load_robot(or_shipped(options.robot, &process::default_robot_directory))),
        cosimulation(robot, options_of(options, robot)),
        start(cosimulation.plant().truth().base),
        last_yaw_rad(yaw_of(start)) {}

  void advance() {
    cosimulation.advance_millisecond();
    const double yaw_rad = yaw_of(cosimulation.plant().truth().base);
    heading_rad += std::remainder(yaw_rad - last_yaw_rad, 2.0 * std::numbers::pi);
    last_yaw_rad = yaw_rad;
  }

  [[nodiscard]] std::size_t joint(std::string_view name) const {
    std::vector<std::string> known;
    for (std::size_t i = 0; i < robot.joints.size(); ++i) {
      if (robot.joints[i].name == name) {
        return i;
      }
      known.push_back(robot.joints[i].name);
    }
    throw std::invalid_argument(
        fmt::format("no joint '{}'. {}", name, input::suggest(std::string(name), known)));
  }

  urdf::RobotModel robot;
  mutable simulator::Cosimulation cosimulation;  // reading a topic opens it
  Eigen::Isometry3d start;
  double last_yaw_rad;
  double heading_rad = 0.0;
};

SimulatedRobot::SimulatedRobot(const SimulationOptions& options)
    : implementation_(std::make_unique<Implementation>(options)) {}
SimulatedRobot::~SimulatedRobot() = default;
SimulatedRobot::SimulatedRobot(SimulatedRobot&&) noexcept = default;
SimulatedRobot& SimulatedRobot::operator=(SimulatedRobot&&) noexcept = default;

void SimulatedRobot::walk(double forward_m_per_s, double left_m_per_s, double turn_rad_per_s) {
  const simulator::WalkEvent event{.velocity_m_per_s = {forward_m_per_s, left_m_per_s},
                                   .turn_rate_rad_per_s = turn_rad_per_s};
  implementation_->cosimulation.apply({time_s(), event});
}

void SimulatedRobot::stand() {
  implementation_->cosimulation.apply({time_s(), simulator::WalkEvent{.walk = false}});
}

void SimulatedRobot::push(std::string_view link, const std::array<double, 3>& impulse_Ns) {
  const Eigen::Vector3d impulse(impulse_Ns[0], impulse_Ns[1], impulse_Ns[2]);
  implementation_->cosimulation.plant().push(link, impulse, impulse.norm(), kPushDuration_s);
}

void SimulatedRobot::run_for(double seconds) {
  for (auto remaining_ms = std::llround(seconds * 1e3); remaining_ms > 0 && is_upright(); --remaining_ms) {
    implementation_->advance();
  }
}

double SimulatedRobot::time_s() const {
  return static_cast<double>(implementation_->cosimulation.now_ns()) * 1e-9;
}

bool SimulatedRobot::is_upright() const {
  return !implementation_->cosimulation.plant().fallen();
}

Whereabouts SimulatedRobot::whereabouts() const {
  const Eigen::Isometry3d base = implementation_->cosimulation.plant().truth().base;
  const Eigen::Vector3d moved = base.translation() - implementation_->start.translation();
  return {moved.x(), moved.y(), base.translation().z(), implementation_->heading_rad};
}

double SimulatedRobot::joint_position(std::string_view joint) const {
  const std::size_t index = implementation_->joint(joint);
  return topic<JointStates>("joint_states").position[index];
}

double SimulatedRobot::joint_reference(std::string_view joint) const {
  const std::size_t index = implementation_->joint(joint);
  return topic<JointStates>("joint_states").reference_position[index];
}

void SimulatedRobot::read_topic(std::string_view name, std::string_view type_name, std::uint64_t type_hash,
                                std::size_t size, void* value) const {
  msgclient::UntypedReader reader =
      implementation_->cosimulation.client().read_untyped({.name = std::string(name),
                                                           .type_name = std::string(type_name),
                                                           .type_hash = type_hash,
                                                           .size = static_cast<std::uint32_t>(size)});
  if (reader.read(value).status == msgclient::ReadStatus::none) {
    throw std::runtime_error(fmt::format("topic '{}': nobody has written it yet", name));
  }
}

std::vector<std::string> SimulatedRobot::events() const {
  const core::EventLog& log = implementation_->cosimulation.main_controller().events();
  std::vector<std::string> lines;
  for (std::uint64_t i = log.first(); i < log.total(); ++i) {
    lines.push_back(fmt::format("{}: {}", log[i].source(), log[i].text()));
  }
  return lines;
}

std::uint64_t SimulatedRobot::faults(std::string_view plugin) const {
  for (const core::PluginTiming& timing :
       implementation_->cosimulation.main_controller().plugins().timings()) {
    if (timing.name == plugin) {
      return timing.faults;
    }
  }
  throw std::invalid_argument(fmt::format("no plug-in '{}' runs", plugin));
}

std::uint64_t SimulatedRobot::batches_accepted() const {
  return implementation_->cosimulation.main_controller().statistics().answers[0];
}

}  // namespace gaitway
