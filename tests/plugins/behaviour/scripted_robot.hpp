// A robot that obeys as tests have it, and a tree over it.
#pragma once

#include <cmath>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/behaviour/read.hpp"
#include "gaitway/behaviour/tree.hpp"
#include "gaitway/behaviour_leaves/leaves.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::behaviour_leaves {

inline std::string file_of(std::string_view nodes) {
  return "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">" + std::string(nodes) + "</BehaviorTree></root>";
}

// Topics that tests write as they like. It stands, navigation is at the origin, no motion plays.
class ScriptedRobot {
 public:
  ScriptedRobot() : robot(std::make_shared<Robot>()) {
    register_leaves(registry, robot);
    look();
  }

  // What the robot's other parts would say of the tick's orders.
  void look() {
    robot->situation = {.now_ns = now_ns,
                        .estimate = &estimate,
                        .footsteps = plans_footsteps ? &footsteps : nullptr,
                        .navigation = has_navigation ? &navigation : nullptr,
                        .motion = &motion,
                        .command = &command,
                        .targets = &targets,
                        .vision = &vision,
                        .network = &network};
  }

  void lie(double pitch_rad) {
    estimate.fall = estimate::fall::lies;
    estimate.attitude[1] = pitch_rad;
    footsteps.state = footstep_state::state::other;
  }
  void stand() {
    estimate.fall = estimate::fall::upright;
    estimate.attitude[1] = 0.0;
    footsteps.state = footstep_state::state::stands;
  }
  void answer_motion(std::uint32_t state) {
    motion.answered = robot->orders.motion_number();
    motion.refused = 0;
    motion.state = state;
  }
  void end_motion(std::uint32_t result) {
    motion.state = 0;
    motion.result = result;
    ++motion.ended;
  }
  void refuse_motion(const char* why) {
    motion.answered = robot->orders.motion_number();
    motion.refused = 1;
    std::strcpy(reinterpret_cast<char*>(motion.text), why);
  }
  void answer_way(std::uint32_t state, std::uint32_t result = 0) {
    navigation.answered = robot->orders.way_number();
    navigation.state = state;
    navigation.result = result;
  }
  void see_tag(std::uint32_t id, double x_m, double y_m) {
    targets.count = 1;
    targets.kind[0] = seen_targets::kind::tag;
    targets.id[0] = id;
    targets.seen_ns[0] = now_ns;
    targets.position[0][0] = x_m;
    targets.position[0][1] = y_m;
    targets.position[0][2] = 0.3;
  }

  std::shared_ptr<Robot> robot;
  behaviour::Registry registry;
  std::int64_t now_ns = 100 * facts::kCycle_ns;
  bool has_navigation = true, plans_footsteps = true;
  Estimate estimate{};
  FootstepState footsteps{};
  NavigationState navigation{};
  MotionState motion{};
  CommandState command{};
  SeenTargets targets{};
  VisionState vision{};
  NetworkState network{};
};

class ScriptedRun : public ScriptedRobot {
 public:
  explicit ScriptedRun(std::string_view nodes)
      : tree(behaviour::parse_tree(file_of(nodes), "test.xml", registry), registry) {}

  // One cycle later.
  behaviour::NodeStatus tick() {
    now_ns += facts::kCycle_ns;
    look();
    robot->begin();
    const behaviour::NodeStatus status = tree.tick(now_ns);
    note();
    return status;
  }
  bool halt() {
    now_ns += facts::kCycle_ns;
    look();
    robot->begin();
    const bool has_ended = tree.halt(now_ns);
    note();
    return has_ended;
  }
  behaviour::NodeStatus tick_for(double seconds) {
    behaviour::NodeStatus status = behaviour::NodeStatus::running;
    for (double s = 0.0; s < seconds && status == behaviour::NodeStatus::running; s += 0.08) status = tick();
    return status;
  }
  // The motions and sayings that have been ordered since the last call.
  std::vector<std::string> take_motions() { return std::exchange(motions, {}); }
  std::vector<std::string> take_sayings() { return std::exchange(sayings, {}); }

  behaviour::Tree tree;
  std::vector<std::string> motions, sayings;

 private:
  void note() {
    if (const auto& order = robot->orders.motion()) {
      const char* const name = reinterpret_cast<const char*>(order->name);
      motions.emplace_back(*name != '\0' ? name : "(leave)");
    }
    for (const Orders::Saying& saying : robot->orders.sayings()) sayings.emplace_back(saying.text.data());
  }
};

}  // namespace gaitway::behaviour_leaves
