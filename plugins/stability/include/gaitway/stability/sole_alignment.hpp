// Turns both soles flat against the ground: what wrong joint zeros incline them by is learned while the robot
// stands.
#pragma once

#include <array>
#include <cstddef>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/stability/balance_parameters.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::stability {

// A sole that is inclined against the ground by a tenth of a degree bears its load some 15 mm beside where it
// should, since the legs are stiff; and a foot that comes down so throws the body off its plan in every step.
// While the robot stands, each centre of pressure says how its sole is inclined:
// - roll: each foot's is brought to the line through its sole's origin;
// - pitch: both are brought to the same place. Where that is, the body's CoM decides and not the ankles.
// What is learned is added to the ankles' trims, also in the walk that follows.
class SoleAlignment {
 public:
  SoleAlignment(const urdf::RobotModel& model, const BalanceParameters& parameters);

  // To be called every 10 ms while the robot stands calmly on both feet: if it sways, the centres of pressure
  // say how the body is being caught. Learns nothing while one foot bears little.
  void learn(const Estimate& standing) noexcept;

  // The sums stay within the limit of the trims.
  void add_to(TrimCommand& trim) const noexcept;

  // By how much the sole of that side (0 left, 1 right) is turned in base axes, rad.
  [[nodiscard]] double roll_rad(std::size_t side) const noexcept { return roll_rad_[side]; }
  [[nodiscard]] double pitch_rad(std::size_t side) const noexcept {
    return side == 0 ? pitch_rad_ : -pitch_rad_;
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.roll_rad_, self.pitch_rad_);
  }

 private:
  struct Ankle {
    int pitch_channel = -1, roll_channel = -1;       // of the trims; -1: none
    double pitch_about_y = 0.0, roll_about_x = 0.0;  // of the joints' axes, in base axes at the home posture
  };

  const BalanceParameters& parameters_;
  double robot_limit_rad_;  // of its trims
  std::array<Ankle, 2> ankles_;
  std::array<double, 2> roll_rad_{};
  double pitch_rad_ = 0.0;  // of the left sole; the right one is turned the other way
};

}  // namespace gaitway::stability
