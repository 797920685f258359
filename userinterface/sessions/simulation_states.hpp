// The simulator's states as they came: the newest one, and how fast things moved between the last two.
#pragma once

#include <optional>
#include <string>

#include "gaitway/api/ros_messages.hpp"
#include "simulator_answers.hpp"

namespace gaitway::api {

class SimulationStates {
 public:
  // A velocity is the mean over no more simulated time than this.
  static constexpr double kLongestMean_s = 0.25;

  void take(StateAnswer state);
  // Something was put elsewhere: from there to here nothing has moved.
  void forget_motion() noexcept { before_.reset(); }
  [[nodiscard]] const std::optional<StateAnswer>& newest() const noexcept { return newest_; }

  // Of the robot's base and of a thing, in the simulator's world, as the mean since the state before. NaN: it
  // is not known, since the robot has been put back to another instant, or too much time lies between.
  [[nodiscard]] ros::Twist twist_of_base() const;
  [[nodiscard]] ros::Twist twist_of_thing(const std::string& name) const;

 private:
  [[nodiscard]] ros::Twist twist(const PoseNumbers* before, const PoseNumbers* now) const;

  std::optional<StateAnswer> newest_, before_;  // of two instants
};

}  // namespace gaitway::api
