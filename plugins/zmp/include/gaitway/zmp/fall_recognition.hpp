// Tells a fall before the impact, by a pendulum over the edge of the feet, and when the robot stands again.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/plugin/number_parameter.hpp"

namespace gaitway::zmp {

// Where the body is over its feet, in one level frame (z against gravity).
struct BodyOverFeet {
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d com_velocity_m_per_s = Eigen::Vector3d::Zero();
  std::array<std::array<Eigen::Vector3d, 4>, 2> sole_corner_m{};  // of both feet, in any order
};

// What the pendulum does not know of the body.
struct TippingModel {
  double impact_tilt_rad = 1.0;  // of the line from the edge to the CoM when the first link hits the ground
  double inertia_factor = 1.25;  // the body's inertia about the edge, over that of all its mass in the CoM
  double lowest_com_m = 0.05;    // above the edge: below, the pendulum says nothing
  double longest_fall_s = 2.0;   // until the impact: a slower one is none
};

struct Tipping {
  // 2 sin(tilt / 2) + rate / ω about the edge: the capture point of the nonlinear pendulum. Above 0 the body
  // passes over the edge, however slowly, unless a foot is put down beyond it. One is some 0.38 m of the DCM.
  double state = 0.0;
  double time_to_impact_s = 0.0;                         // kNoImpact_s if it does not tip
  Eigen::Vector2d direction = Eigen::Vector2d::UnitX();  // outwards, square to the edge
};

inline constexpr double kNoImpact_s = 10.0;  // and more

// About the edge of the soles' convex hull over which it tips most. Feet in the air count as well: they come
// down before the body does. 0.3 us, 2 us while it tips; no allocation.
Tipping tipping_of(const BodyOverFeet& body, const TippingModel& model) noexcept;

enum class Fall : std::uint32_t {
  upright = estimate::fall::upright,
  falls = estimate::fall::falls,
  lies = estimate::fall::lies
};

struct FallParameters {
  double margin = 0.30;     // of the tipping state: beyond it no foot can be put down in time
  double confirm_s = 0.02;  // for so long, without a break
  TippingModel model;
  double carried_s = 0.2;       // without load on the feet: somebody holds the robot
  double stands_after_s = 0.5;  // straight on its feet
  double lies_after_s = 0.5;    // tilted far, without its weight on the feet
  double impact_past_s = 0.2;   // after the predicted impact

  // As the configuration has them.
  [[nodiscard]] std::array<NumberParameter, 10> numbers();

  // Throws std::invalid_argument naming parameter, value, rule and remedy.
  void validate() const;
};

struct FallInputs {
  BodyOverFeet body;
  double heading_rad = 0.0;     // of the trunk, in the body's frame
  double trunk_tilt_rad = 0.0;  // against the vertical
  double load_share = 0.0;      // of the body's weight, on both feet
};

// To be updated every 10 ms while the sensors are heard; without them it stays as it is. Not thread-safe.
class FallRecognition {
 public:
  // Throws std::invalid_argument (see FallParameters::validate).
  explicit FallRecognition(const FallParameters& parameters);

  // Upright → falls: the body tips beyond the margin over feet that stood on something just now (a robot that
  // is carried does not fall). Falls → lies: the predicted impact is past. Lies → upright: it has stood
  // straight on its feet for half a second. A robot that is found lying at the start lies. 0.3 us,
  // 2 us while it tips; no allocation.
  void update(const FallInputs& inputs) noexcept;

  [[nodiscard]] Fall fall() const noexcept { return fall_; }
  // Where to it falls, or fell: against the trunk's heading, 0 ahead, π/2 to the left.
  [[nodiscard]] double direction_rad() const noexcept { return direction_rad_; }
  [[nodiscard]] double time_to_impact_s() const noexcept { return time_to_impact_s_; }  // while it falls

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.fall_, self.direction_rad_, self.time_to_impact_s_, self.beyond_ticks_, self.airborne_ticks_,
            self.straight_ticks_, self.lying_ticks_, self.overdue_ticks_);
  }

 private:
  void watch_upright(const FallInputs& inputs) noexcept;
  void watch_falling(const FallInputs& inputs) noexcept;
  void begin_fall(const FallInputs& inputs) noexcept;
  [[nodiscard]] bool stands_again(const FallInputs& inputs) noexcept;

  FallParameters parameters_;
  int confirm_ticks_, carried_ticks_, stands_after_ticks_, lies_after_ticks_, impact_past_ticks_;
  Tipping tipping_;
  Fall fall_ = Fall::upright;
  double direction_rad_ = 0.0;
  double time_to_impact_s_ = 0.0;
  int beyond_ticks_ = 0;    // the margin, in a row
  int airborne_ticks_ = 0;  // without load on the feet, in a row
  int straight_ticks_ = 0;  // on its feet, in a row
  int lying_ticks_ = 0;     // tilted far without load on the feet, in a row
  int overdue_ticks_ = 0;   // that the predicted impact is past
};

}  // namespace gaitway::zmp
