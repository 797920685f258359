// Walks by velocities: for a while, or until the robot faces where it is to.
#include <algorithm>
#include <cmath>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;

class Walk final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    if (!now().is_upright()) return fail("Walk", not_upright());
    begun_ns_ = call.now_ns();
    ends_ = false;
    return on_running(call);
  }

  Outcome on_running(Call& call) noexcept override {
    if (!now().is_upright()) return fail("Walk", not_upright());
    if (ends_) return end_.is_reached(now()) ? Outcome::success : Outcome::running;
    const std::int64_t lasts_ns = call.get<std::int64_t>(3).value_or(0);
    if (lasts_ns > 0 && call.now_ns() - begun_ns_ >= lasts_ns) {
      ends_ = true;
      end_.begin(call.now_ns());
      return Outcome::running;
    }
    orders().walk({.forward_m_per_s = call.get<double>(0).value_or(0.0),
                   .left_m_per_s = call.get<double>(1).value_or(0.0),
                   .turn_rad_per_s = call.get<double>(2).value_or(0.0)});
    return Outcome::running;
  }

  Halt on_halt(Call& call) noexcept override {
    if (!ends_) end_.begin(call.now_ns());
    return on_halting(call);
  }
  Halt on_halting(Call&) noexcept override { return end_.is_reached(now()) ? Halt::ended : Halt::ending; }

 private:
  std::int64_t begun_ns_ = 0;
  bool ends_ = false;
  WalkEnd end_;
};

// Walks in place and turns the slower the nearer it is, stands, and looks whether it is there.
class TurnTo final : public RobotAction {
 public:
  using RobotAction::RobotAction;

  Outcome on_start(Call& call) noexcept override {
    if (!now().is_upright()) return fail("TurnTo", not_upright());
    const auto to_rad = call.get<double>(0);
    if (!to_rad) return fail("TurnTo", "its port 'to' has no value");
    double goal_rad = *to_rad;
    if (call.get<std::int64_t>(1).value_or(0) == kWorld) {
      const auto odometry = now().odometry();
      if (!odometry) return fail("TurnTo", "there is no navigation that knows the world");
      goal_rad -= odometry->yaw_rad;
    } else {
      goal_rad += now().base().yaw_rad;
    }
    goal_rad_ = goal_rad;
    ends_ = false;
    return on_running(call);
  }

  Outcome on_running(Call& call) noexcept override {
    if (!now().is_upright()) return fail("TurnTo", not_upright());
    const double off_rad = wrapped_rad(goal_rad_ - now().base().yaw_rad);
    const double within_rad = call.get<double>(2).value_or(0.0);
    if (ends_) {
      if (!end_.is_reached(now())) return Outcome::running;
      if (std::abs(off_rad) <= within_rad) return Outcome::success;
      ends_ = false;
    }
    if (std::abs(off_rad) <= 0.5 * within_rad) {
      ends_ = true;
      end_.begin(call.now_ns());
      return Outcome::running;
    }
    const double most = call.get<double>(3).value_or(0.0);
    const double least = std::min(kLeastRate_rad_per_s, most);
    orders().walk(
        {.turn_rad_per_s = std::copysign(std::clamp(std::abs(off_rad) * kRate_per_s, least, most), off_rad)});
    return Outcome::running;
  }

  Halt on_halt(Call& call) noexcept override {
    if (!ends_) end_.begin(call.now_ns());
    return on_halting(call);
  }
  Halt on_halting(Call&) noexcept override { return end_.is_reached(now()) ? Halt::ended : Halt::ending; }

  static constexpr std::int64_t kWorld = 1;

 private:
  static constexpr double kRate_per_s = 1.0, kLeastRate_rad_per_s = 0.15;

  double goal_rad_ = 0.0;  // odometry
  bool ends_ = false;
  WalkEnd end_;
};

}  // namespace

void register_walking(behaviour::Registry& registry, const std::shared_ptr<Robot>& robot) {
  registry.add_action(
      {.id = "Walk",
       .ports = {number_port("forward", "m/s", -1.5, 1.5, "0 m/s", "robot's heading"),
                 number_port("left", "m/s", -1.5, 1.5, "0 m/s", "robot's heading"),
                 number_port("turn", "rad/s", -3.0, 3.0, "0 rad/s", "counter-clockwise"),
                 duration_port("for", "0 s", "then it stands, and succeeds; 0: until it is halted")},
       .meaning = "Walks with a velocity; its end is a stand. Fails in a fall"},
      [robot] { return std::make_unique<Walk>(robot); });
  registry.add_action(
      {.id = "TurnTo",
       .ports = {number_port("to", "rad", -10.0, 10.0, std::nullopt,
                             "heading in world, or bearing from the robot"),
                 choice_port("from", {"robot", "world"}, "robot", "what `to` is told from"),
                 number_port("within", "rad", 0.01, 3.2, "5 deg", "deviation of the stand at the end"),
                 number_port("rate", "rad/s", 0.05, 3.0, "0.5 rad/s", "at most")},
       .meaning = "Turns in place until it faces there, and stands. Fails in a fall"},
      [robot] { return std::make_unique<TurnTo>(robot); });
}

}  // namespace gaitway::behaviour_leaves
