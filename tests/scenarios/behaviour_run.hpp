// A simulated robot with the plug-in `behaviour`, and in the arbiter's place something as simple as can be.
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

// Orders of the behaviour become those of people, which are obeyed, but for when it does not command.
class CommandStandIn {
 public:
  explicit CommandStandIn(msgclient::MemoryBlock& block)
      : client_(block.local_client("api")),
        arbiter_(block.local_client("arbiter")),
        walk_(client_, "behaviour_walk", "walk_request"),
        way_(client_, "behaviour_walk_to", "walk_to_request"),
        motion_(client_, "behaviour_motion", "motion_request"),
        state_(arbiter_.write<CommandState>("command_state")) {}

  void set(std::uint32_t commander, bool may_get_up, std::int64_t now_ns) {
    value_.commander = commander;
    value_.may_get_up = may_get_up ? 1 : 0;
    value_.stamp_ns = value_.since_ns = now_ns;
    ++value_.changes;
    state_.publish(value_, now_ns);
  }
  [[nodiscard]] const CommandState& state() const { return value_; }

  void step(std::int64_t now_ns) {
    const bool obeys = value_.commander == command_state::commander::nobody ||
                       value_.commander == command_state::commander::behaviour;
    walk_.pass(obeys, now_ns);
    way_.pass(obeys, now_ns);
    motion_.pass((obeys || value_.may_get_up != 0) && !blocks_motions, now_ns);
  }
  // Every motion that has been asked for, with the time at which it was.
  struct AskedMotion {
    double at_s;
    std::string name;
  };
  [[nodiscard]] const std::vector<AskedMotion>& motions() const { return motion_.seen(); }
  [[nodiscard]] const WalkCommand& walk() const { return walk_.newest(); }
  [[nodiscard]] const WalkToRequest& way() const { return way_.newest(); }

  bool blocks_motions = false;  // they get lost

 private:
  template <class T>
  class Channel {
   public:
    Channel(msgclient::Client& client, const char* from, const char* to)
        : reader_(client.read<T>(from)), writer_(client.write<T>(to)) {}
    void pass(bool obeys, std::int64_t now_ns) {
      if (reader_.newest_sequence() == sequence_) return;
      const auto read = reader_.read(newest_);
      if (!read) return;
      sequence_ = read.sequence;
      if constexpr (std::is_same_v<T, MotionRequest>) {
        const auto* const name = reinterpret_cast<const char*>(newest_.name);
        seen_.push_back({static_cast<double>(now_ns) * 1e-9, name});
      }
      if (obeys) writer_.publish(newest_, now_ns);
    }
    [[nodiscard]] const T& newest() const { return newest_; }
    [[nodiscard]] const std::vector<AskedMotion>& seen() const { return seen_; }

   private:
    msgclient::Reader<T> reader_;
    msgclient::Writer<T> writer_;
    std::uint64_t sequence_ = 0;
    T newest_{};
    std::vector<AskedMotion> seen_;
  };

  msgclient::Client client_, arbiter_;
  Channel<WalkCommand> walk_;
  Channel<WalkToRequest> way_;
  Channel<MotionRequest> motion_;
  msgclient::Writer<CommandState> state_;
  CommandState value_{};
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
        commands(block),
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
  CommandStandIn commands;

 private:
  template <class T>
  static T newest(msgclient::Reader<T>& reader) {
    T value{};
    static_cast<void>(reader.read(value));
    return value;
  }
  static std::size_t trunk() { return static_cast<std::size_t>(robot().imu.link); }
  void advance() {
    commands.step(cosimulation.now_ns());
    cosimulation.advance_millisecond();
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
    result.obey_walk_requests = true;
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
