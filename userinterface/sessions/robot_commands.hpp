// All that clients may make the robot do, behind the authority: the one place that gives orders to the robot.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "gait_bounds.hpp"
#include "gaitway/api/authority.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api {

// Commands throw CommandDenied to who may not give them, and when the robot is not there. Orders give their
// number, or nothing when the way to the robot is full. Whoever drove the robot and has the command no more:
// the robot is told to stand.
inline constexpr const char* kEmergencyStopped =
    "the robot is in emergency stop and stays where it is: call /release to end that";

class RobotCommands {
 public:
  RobotCommands(RobotPort& robot, const Limits& limits)
      : robot_(robot), limits_(limits), authority_(limits.lease_ns) {}

  // What moves the robot is denied while an emergency stop holds. Throws Refused for a velocity that the
  // robot cannot walk.
  std::optional<std::uint32_t> walk(Claimant& claimant, const ros::Twist& twist, std::int64_t now_ns);
  void stand(Claimant& claimant, std::int64_t now_ns);
  std::optional<std::uint32_t> move_joint(Claimant& claimant, int joint, double position_rad,
                                          double duration_s, std::int64_t now_ns);
  std::optional<std::uint32_t> play_motion(Claimant& claimant, const std::string& name, std::int64_t now_ns);
  std::optional<std::uint32_t> walk_to(Claimant& claimant, const Goal& goal, std::int64_t now_ns);
  std::optional<std::uint32_t> leave_way(Claimant& claimant, std::int64_t now_ns);
  std::optional<std::uint32_t> look(Claimant& claimant, const Look& look, std::int64_t now_ns);
  // Of the robot, from its behaviour and back: nothing that people have ordered is in force afterwards.
  std::optional<std::uint32_t> take_command(Claimant& claimant, std::int64_t now_ns);
  std::optional<std::uint32_t> let_command_go(Claimant& claimant, std::int64_t now_ns);
  std::optional<std::uint32_t> mission(Claimant& claimant, MissionVerb verb, std::string_view mission,
                                       std::int64_t now_ns);
  std::optional<std::uint32_t> order(Claimant& claimant, const PluginOrder& order, std::int64_t now_ns);
  std::optional<std::uint32_t> end_emergency_stop(Claimant& claimant, std::int64_t now_ns);

  // For everybody: nobody else has the command afterwards, and nothing walks on.
  std::optional<std::uint32_t> stop(Claimant& by);
  std::optional<std::uint32_t> emergency_stop(Claimant& by, bool soft);

  [[nodiscard]] std::string acquire(Claimant& claimant, std::int64_t now_ns);
  void keep_alive(const Claimant& claimant, std::string_view lease, std::int64_t now_ns);
  void release(const Claimant& claimant, std::string_view lease, std::int64_t now_ns);

  // Nobody has the command afterwards.
  void robot_lost() noexcept;
  // Somebody who is no claimant has stopped the robot: nobody has the command, and nothing walks on.
  void stopped_by_datagram();
  // The connection has ended.
  void leave(const Claimant& claimant);
  // A lease that has run out ends.
  void step(std::int64_t now_ns);

  // What the gait walks now; nothing: it is not known, and the limits alone count.
  void keep_to(const std::optional<GaitBounds>& gait) noexcept { gait_ = gait; }

  // The velocity that the robot has been told to walk with, where it is another one than at the last call.
  [[nodiscard]] std::optional<Velocity> take_told_velocity() noexcept;

  // When the robot was told to move last, by its own clock; long ago, if never.
  [[nodiscard]] std::int64_t moved_ns() const noexcept { return moved_ns_; }

  [[nodiscard]] const Authority& authority() const noexcept { return authority_; }

 private:
  static constexpr std::int64_t kNever_ns = -1'000'000'000'000;

  static void demand_not_overtaken(const Claimant& claimant);
  [[noreturn]] static void deny(Claimant& claimant, std::int64_t now_ns, const std::string& why);
  static void demand_timely(Claimant& claimant, std::int64_t now_ns, std::int64_t validity_ns);
  void demand(Claimant& claimant, std::int64_t now_ns);
  // `validity_ns`: how old what it asks for may be.
  void demand_movement(Claimant& claimant, std::int64_t now_ns, std::int64_t validity_ns);
  void end_way(const Claimant& claimant);
  void end_walk();

  RobotPort& robot_;
  Limits limits_;
  Authority authority_;
  bool walks_ = false;                   // told to, and not told to stand since
  std::optional<std::uint64_t> way_of_;  // number of the claimant whose way it walks, as far as is known here
  std::int64_t moved_ns_ = kNever_ns;
  std::optional<GaitBounds> gait_;
  Velocity velocity_{}, told_velocity_{};
  std::int64_t velocity_until_ns_ = kNever_ns;  // then it holds no more, unless it is said again
};

}  // namespace gaitway::api
