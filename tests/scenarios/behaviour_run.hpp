// A simulated robot with the plug-in `behaviour`, whom people may take the command from.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/scenario.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::scenarios {

// What the behaviour has ordered.
class OrderLog {
 public:
  explicit OrderLog(msgclient::Client& client)
      : walk_(client.read<WalkCommand>("behaviour_walk")),
        way_(client.read<WalkToRequest>("behaviour_walk_to")),
        motion_(client.read<MotionRequest>("behaviour_motion")) {}

  void look(std::int64_t now_ns) {
    static_cast<void>(walk_.read(newest_walk_));
    static_cast<void>(way_.read(newest_way_));
    MotionRequest motion{};
    if (motion_.read(motion) && motion.number != number_) {
      number_ = motion.number;
      motions_.push_back({static_cast<double>(now_ns) * 1e-9, reinterpret_cast<const char*>(motion.name)});
    }
  }
  struct OrderedMotion {
    double at_s;
    std::string name;
  };
  [[nodiscard]] const std::vector<OrderedMotion>& motions() const { return motions_; }
  [[nodiscard]] const WalkCommand& walk() const { return newest_walk_; }
  [[nodiscard]] const WalkToRequest& way() const { return newest_way_; }

 private:
  msgclient::Reader<WalkCommand> walk_;
  msgclient::Reader<WalkToRequest> way_;
  msgclient::Reader<MotionRequest> motion_;
  WalkCommand newest_walk_{};
  WalkToRequest newest_way_{};
  std::uint32_t number_ = 0;
  std::vector<OrderedMotion> motions_;
};

struct BehaviourRunOptions {
  std::uint64_t seed = 1;
  std::string mission{};           // name or file
  std::string isolation = "none";  // of the plug-in `behaviour`
  std::string library{};           // of it; empty: the shipped one
  std::string parameters{};        // of it, further ones: ", enabled: false"
};

class BehaviourRun {
 public:
  explicit BehaviourRun(const BehaviourRunOptions& options)
      : cosimulation(robot(), cosimulation_options(options)),
        orders(cosimulation.client()),
        requests_client_(block.local_client("people")),
        state_(cosimulation.client().read<BehaviourState>("behaviour_state")),
        motion_(cosimulation.client().read<MotionState>("motion_state")),
        navigation_(cosimulation.client().read<NavigationState>("navigation_state")),
        estimate_(cosimulation.client().read<Estimate>("estimate")),
        footsteps_(cosimulation.client().read<FootstepState>("footstep_state")),
        requests_(requests_client_.write<BehaviourRequest>("behaviour_request")) {}

  void advance_until(double end_s) {
    while (time_s() < end_s) advance();
  }
  // False: it did not happen within `most_s`.
  bool advance_until(const std::function<bool()>& happens, double most_s) {
    const double end_s = time_s() + most_s;
    while (!happens()) {
      if (time_s() >= end_s) return false;
      advance();
    }
    return true;
  }
  void push(const Eigen::Vector3d& direction, double impulse_Ns = 8.0) {
    cosimulation.apply({time_s(), simulator::PushEvent{.body = robot().links[trunk()].name,
                                                       .direction = direction,
                                                       .impulse_Ns = impulse_Ns}});
  }
  void person_takes() {
    cosimulation.apply({time_s(), simulator::CommandEvent{msgcontroller::CommandVerb::take}});
  }
  void person_lets_go() { cosimulation.apply({time_s(), simulator::CommandEvent{}}); }
  std::uint32_t ask(std::uint32_t verb, std::string_view mission = {}) {
    BehaviourRequest request{};
    request.stamp_ns = cosimulation.now_ns();
    request.number = ++asked_;
    request.verb = verb;
    std::memcpy(request.mission, mission.data(), mission.size());
    requests_.publish(request, cosimulation.now_ns());
    return request.number;
  }

  [[nodiscard]] double time_s() const { return static_cast<double>(cosimulation.now_ns()) * 1e-9; }
  BehaviourState state() { return newest(state_); }
  std::string said() {
    const BehaviourState now = state();
    return reinterpret_cast<const char*>(now.text);
  }
  MotionState motion() { return newest(motion_); }
  NavigationState navigation() { return newest(navigation_); }
  std::uint32_t fall() { return newest(estimate_).fall; }
  double head_yaw_rad() { return newest(estimate_).head[0]; }
  bool stands() {
    return fall() == estimate::fall::upright && motion().state == 0 &&
           newest(footsteps_).state == footstep_state::state::stands &&
           cosimulation.plant().truth().trunk_tilt_rad < 0.2;
  }
  std::vector<std::string> lines() {
    std::vector<std::string> found;
    const core::EventLog& events = cosimulation.main_controller().events();
    for (std::uint64_t i = events.first(); i < events.total(); ++i) {
      if (events[i].source() == "behaviour") found.emplace_back(events[i].text());
    }
    return found;
  }

  static const urdf::RobotModel& robot() {
    static const urdf::RobotModel robot =
        urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
    return robot;
  }

  msgclient::MemoryBlock block;
  simulator::Cosimulation cosimulation;
  OrderLog orders;

 private:
  template <class T>
  static T newest(msgclient::Reader<T>& reader) {
    T value{};
    static_cast<void>(reader.read(value));
    return value;
  }
  static std::size_t trunk() { return static_cast<std::size_t>(robot().imu.link); }
  void advance() {
    cosimulation.advance_millisecond();
    orders.look(cosimulation.now_ns());
  }
  simulator::CosimulationOptions cosimulation_options(const BehaviourRunOptions& options) {
    simulator::CosimulationOptions result;
    const std::filesystem::path source = GAITWAY_SOURCE_DIR;
    std::string text = "plugins:\n";
    for (const std::string name : {"zmp", "trajectory", "stability", "kinematics"}) {
      text += "  - name: " + name + "\n    library: libgaitway_plugin_" + name + ".so\n";
    }
    text +=
        "  - name: navigation\n    library: libgaitway_plugin_navigation.so\n"
        "    parameters: {plans_in_step: true}\n";
    text += "  - name: behaviour\n    library: " +
            (options.library.empty() ? "libgaitway_plugin_behaviour.so" : options.library) + "\n";
    if (options.isolation != "none") text += "    isolation: " + options.isolation + "\n";
    text += "    parameters: {loads_in_step: true, mission: \"" + options.mission + "\"" +
            options.parameters + "}\n";
    result.plant.seed = options.seed;
    result.memory_block = &block;
    result.main_controller.plugins =
        core::parse_configuration(text, source / "core/config/behaviour_run.yaml");
    result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    return result;
  }

  msgclient::Client requests_client_;
  msgclient::Reader<BehaviourState> state_;
  msgclient::Reader<MotionState> motion_;
  msgclient::Reader<NavigationState> navigation_;
  msgclient::Reader<Estimate> estimate_;
  msgclient::Reader<FootstepState> footsteps_;
  msgclient::Writer<BehaviourRequest> requests_;
  std::uint32_t asked_ = 0;
};

}  // namespace gaitway::scenarios
