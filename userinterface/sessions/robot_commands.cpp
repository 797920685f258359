#include "robot_commands.hpp"

#include <array>
#include <cmath>

#include "client_message.hpp"

namespace gaitway::api {
namespace {

struct Component {
  const char* name;
  double value;
  double least, most;       // of the limits; both 0: not supported
  double slowest, fastest;  // of the gait
  const char* unit;
};

// What the gait walks is told rounded, and asked for so.
constexpr double kRounding = 1.001;

std::string range(double least, double most, const char* unit) {
  return ", but must be from " + shown_json(nlohmann::json(least)) + " to " +
         shown_json(nlohmann::json(most)) + " " + unit;
}

void require_walkable(const Component& component) {
  const std::string shown_value =
      std::string(component.name) + " is " + shown_json(nlohmann::json(component.value));
  const double value = component.value;
  if (!(value >= component.least && value <= component.most)) {  // so for NaN, too
    throw Refused(shown_value + (component.most == 0.0
                                     ? ", but must be 0: the robot walks in the plane"
                                     : range(component.least, component.most, component.unit)));
  }
  if (!(value >= kRounding * component.slowest && value <= kRounding * component.fastest)) {
    throw Refused(shown_value + range(component.slowest, component.fastest, component.unit) +
                  ", which is what the gait walks now (/walk/limits)");
  }
}

Velocity velocity_of(const ros::Twist& twist, const Limits& limits, const std::optional<GaitBounds>& known) {
  const double most = limits.forward_m_per_s, turn = limits.turn_rad_per_s;
  const GaitBounds gait = known.value_or(GaitBounds{most, most, most, turn});
  const std::array components{
      Component{"linear.x", twist.linear.x, -most, most, -gait.backward_m_per_s, gait.forward_m_per_s, "m/s"},
      Component{"linear.y", twist.linear.y, -most, most, -gait.left_m_per_s, gait.left_m_per_s, "m/s"},
      Component{"linear.z", twist.linear.z, 0.0, 0.0, 0.0, 0.0, "m/s"},
      Component{"angular.x", twist.angular.x, 0.0, 0.0, 0.0, 0.0, "rad/s"},
      Component{"angular.y", twist.angular.y, 0.0, 0.0, 0.0, 0.0, "rad/s"},
      Component{"angular.z", twist.angular.z, -turn, turn, -gait.turn_rad_per_s, gait.turn_rad_per_s,
                "rad/s"},
  };
  for (const Component& component : components) {
    require_walkable(component);
  }
  return {twist.linear.x, twist.linear.y, twist.angular.z};
}

}  // namespace

std::optional<std::uint32_t> RobotCommands::walk(Claimant& claimant, const ros::Twist& twist,
                                                 std::int64_t now_ns) {
  const Velocity velocity = velocity_of(twist, limits_, gait_);
  demand_movement(claimant, now_ns, kVelocityValidity_ns);
  walks_ = true;
  way_of_.reset();
  moved_ns_ = robot_.now_ns();
  velocity_ = velocity;
  velocity_until_ns_ = now_ns + limits_.velocity_ns;
  return robot_.walk(velocity, limits_.velocity_ns, claimant.age_ns);
}

void RobotCommands::stand(Claimant& claimant, std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  walks_ = false;
  way_of_.reset();
  robot_.stand();
  static_cast<void>(robot_.play_motion("", claimant.age_ns));
}

std::optional<std::uint32_t> RobotCommands::play_motion(Claimant& claimant, const std::string& name,
                                                        std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  moved_ns_ = robot_.now_ns();
  return robot_.play_motion(name, claimant.age_ns);
}

// Whoever gives a way must stay, as with a velocity; but it goes on without the command being renewed.
std::optional<std::uint32_t> RobotCommands::walk_to(Claimant& claimant, const Goal& goal,
                                                    std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  end_walk();
  way_of_ = claimant.number;
  moved_ns_ = robot_.now_ns();
  return robot_.walk_to(goal, claimant.age_ns);
}

std::optional<std::uint32_t> RobotCommands::leave_way(Claimant& claimant, std::int64_t now_ns) {
  demand(claimant, now_ns);
  return robot_.leave_way(claimant.age_ns);
}

std::optional<std::uint32_t> RobotCommands::look(Claimant& claimant, const Look& look, std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  return robot_.look(look, claimant.age_ns);
}

std::optional<std::uint32_t> RobotCommands::take_command(Claimant& claimant, std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  return robot_.take_command(claimant.age_ns);
}

// The robot ends the walk itself. No stand is sent for it later: it would take the command anew.
std::optional<std::uint32_t> RobotCommands::let_command_go(Claimant& claimant, std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  const auto number = robot_.let_command_go(claimant.age_ns);
  if (number) {
    walks_ = false;
    way_of_.reset();
  }
  return number;
}

std::optional<std::uint32_t> RobotCommands::mission(Claimant& claimant, MissionVerb verb,
                                                    std::string_view mission, std::int64_t now_ns) {
  demand_not_overtaken(claimant);
  demand_timely(claimant, now_ns, kOrderValidity_ns);
  demand(claimant, now_ns);
  return robot_.mission(verb, mission, claimant.age_ns);
}

std::optional<std::uint32_t> RobotCommands::move_joint(Claimant& claimant, int joint, double position_rad,
                                                       double duration_s, std::int64_t now_ns) {
  demand_movement(claimant, now_ns, kOrderValidity_ns);
  moved_ns_ = robot_.now_ns();
  return robot_.move_joint(joint, position_rad, duration_s, claimant.age_ns);
}

std::optional<std::uint32_t> RobotCommands::order(Claimant& claimant, const PluginOrder& order,
                                                  std::int64_t now_ns) {
  demand(claimant, now_ns);
  return robot_.order(order);
}

std::optional<std::uint32_t> RobotCommands::end_emergency_stop(Claimant& claimant, std::int64_t now_ns) {
  demand_not_overtaken(claimant);
  demand_timely(claimant, now_ns, kOrderValidity_ns);
  demand(claimant, now_ns);
  moved_ns_ = robot_.now_ns();
  return robot_.release(claimant.age_ns);
}

void RobotCommands::demand_not_overtaken(const Claimant& claimant) {
  if (claimant.overtaken) {
    throw CommandDenied("a stop that this connection called later has been carried out before this");
  }
}

void RobotCommands::deny(Claimant& claimant, std::int64_t now_ns, const std::string& why) {
  claimant.tried_ns = now_ns;  // a stick that is held meanwhile is not let go
  throw CommandDenied(why);
}

void RobotCommands::demand_timely(Claimant& claimant, std::int64_t now_ns, std::int64_t validity_ns) {
  constexpr std::int64_t kMillisecond_ns = 1'000'000;
  if (claimant.age_ns > validity_ns) {
    deny(claimant, now_ns,
         "late: it may have been sent " + std::to_string(claimant.age_ns / kMillisecond_ns) +
             " ms ago, and is carried out for " + std::to_string(validity_ns / kMillisecond_ns) +
             " ms; the connection is slow, or its client does not answer pings");
  }
}

void RobotCommands::demand_movement(Claimant& claimant, std::int64_t now_ns, std::int64_t validity_ns) {
  demand_not_overtaken(claimant);
  demand_timely(claimant, now_ns, validity_ns);
  demand(claimant, now_ns);
  if (robot_.emergency_stopped()) {
    throw CommandDenied(kEmergencyStopped);
  }
}

void RobotCommands::demand(Claimant& claimant, std::int64_t now_ns) {
  step(now_ns);
  if (!robot_.connected()) {
    deny(claimant, now_ns,
         "the robot is not there: its " + std::string(robot_.silent_part()) + " does not answer");
  }
  authority_.use(claimant, now_ns);
}

std::optional<std::uint32_t> RobotCommands::stop(Claimant& by) {
  authority_.stop(by);
  const auto number = robot_.stop();
  walks_ = false;
  way_of_.reset();
  robot_.stand();
  return number;
}

std::optional<std::uint32_t> RobotCommands::emergency_stop(Claimant& by, bool soft) {
  authority_.stop(by);
  const auto number = robot_.emergency_stop(soft);
  walks_ = false;
  way_of_.reset();
  robot_.stand();
  return number;
}

std::string RobotCommands::acquire(Claimant& claimant, std::int64_t now_ns) {
  step(now_ns);
  return authority_.acquire(claimant, now_ns);
}

void RobotCommands::keep_alive(const Claimant& claimant, std::string_view lease, std::int64_t now_ns) {
  step(now_ns);
  authority_.keep_alive(claimant, lease, now_ns);
}

void RobotCommands::release(const Claimant& claimant, std::string_view lease, std::int64_t now_ns) {
  step(now_ns);
  authority_.release(claimant, lease, now_ns);
  end_way(claimant);
  end_walk();
}

void RobotCommands::robot_lost() noexcept {
  authority_.lose_all();
  walks_ = false;  // its own side sees to that it stands
  way_of_.reset();
}

void RobotCommands::stopped_by_datagram() {
  authority_.end_all();
  walks_ = false;
  way_of_.reset();
  robot_.stand();
}

void RobotCommands::leave(const Claimant& claimant) {
  end_way(claimant);
  if (authority_.leave(claimant)) {
    end_walk();
  }
}

void RobotCommands::step(std::int64_t now_ns) {
  if (authority_.lapse(now_ns)) {
    end_walk();
  }
  if (!walks_ || now_ns >= velocity_until_ns_) {
    velocity_ = {};
  }
}

std::optional<Velocity> RobotCommands::take_told_velocity() noexcept {
  if (velocity_ == told_velocity_) {
    return std::nullopt;
  }
  told_velocity_ = velocity_;
  return velocity_;
}

void RobotCommands::end_way(const Claimant& claimant) {
  if (way_of_ == claimant.number) {
    way_of_.reset();
    walks_ = false;
    robot_.stand();
  }
}

void RobotCommands::end_walk() {
  if (walks_) {
    walks_ = false;
    robot_.stand();
  }
}

}  // namespace gaitway::api
