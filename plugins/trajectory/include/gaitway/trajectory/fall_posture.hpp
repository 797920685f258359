// The posture in which a falling robot meets the ground, the way back from it, and where such ways begin.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/fall_posture_file.hpp"
#include "gaitway/trajectory/motion_player.hpp"
#include "gaitway/trajectory/quintic.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// Value of MotionPlan::motion while it plays.
inline constexpr std::uint32_t kFallPostureMotion = 2;

// Each joint goes on from the angle and speed of its reference by a polynomial of its own, as fast as it may.
// No allocation, no exception after construction.
class FallPosture {
 public:
  // The references at the last two points before the next batch, in the joints' order.
  struct References {
    std::span<const double> before_rad, at_rad;
  };

  // With the postures of its folder, or those that its body allows; a robot with neither has none: see
  // exists().
  explicit FallPosture(const urdf::RobotModel& robot) : FallPosture(robot, fall_postures_of(robot)) {}
  FallPosture(const urdf::RobotModel& robot, std::optional<FallPostures> postures);
  [[nodiscard]] bool exists() const noexcept { return postures_rad_.has_value(); }

  // The next batch begins the way into the posture. direction_rad: as Estimate::fall_direction. 30 us.
  void fall(double direction_rad, const References& references) noexcept;
  // The next batch begins the way to the home angles, where plans of a stand go on.
  void go_home(const References& references) noexcept;

  // It is over: somebody else moves the joints.
  void end() noexcept { state_.stage = Stage::none; }

  [[nodiscard]] bool plays() const noexcept { return state_.stage != Stage::none; }
  [[nodiscard]] bool falls() const noexcept { return state_.stage == Stage::falls; }

  // The next batch and its tail, which ends the way and stays there. Only while it plays; a way home ends by
  // itself. stand: where the feet were meant to be when the fall began.
  void plan(std::uint32_t sequence, std::int64_t start_ns, const Stand& stand, MotionPlan& plan,
            PosturePlan& posture) noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_);
  }

 private:
  enum class Stage : std::uint32_t { none = 0, falls = 1, goes_home = 2 };
  struct Way {
    double from_rad = 0.0, speed_rad_per_s = 0.0, to_rad = 0.0, time_s = 0.0;

    // From speed to rest, from no acceleration to none.
    [[nodiscard]] Quintic path() const noexcept { return {{from_rad, speed_rad_per_s}, {to_rad}, time_s}; }
    [[nodiscard]] double at(double since_start_s) const noexcept;
    [[nodiscard]] double fastest_rad_per_s() const noexcept;
  };
  struct State {
    Stage stage = Stage::none;
    std::uint32_t points = 0;  // that are played
    std::array<Way, kMaxJoints> ways{};
  };
  struct Limits {
    double lower_rad, upper_rad, speed_rad_per_s, home_rad;
  };

  void begin(Stage stage, const References& references, std::span<const double> to_rad,
             double most_rad_per_s) noexcept;

  std::vector<Limits> joints_;
  PostureAngles home_rad_;
  std::optional<FallPostures> postures_rad_;
  State state_;
};

// Where the joints' references are when the next batch begins: on the batch that was accepted last, or on its
// safe tail.
class AcceptedReferences {
 public:
  // Once a batch, with the newest joint plan: it is kept if it is the one that was accepted. 5 us.
  void take(const JointPlan& newest, std::uint32_t accepted_sequence) noexcept {
    if (newest.sequence != 0 && newest.sequence == accepted_sequence) accepted_ = newest;
  }
  // At the two points before the batch of that sequence; nothing: the accepted plan is not known. Valid until
  // the next call.
  [[nodiscard]] std::optional<FallPosture::References> before(std::uint32_t sequence) noexcept;

 private:
  JointPlan accepted_{};
  std::array<double, kMaxJoints> before_rad_{}, at_rad_{};
};

}  // namespace gaitway::trajectory
