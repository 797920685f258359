// What the robot plays now: the newest motion plan is usually for a batch that has not started, so the ones
// before it are kept.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::stability {

// MotionPlan::motion of the posture of a fall, and of the way back from it.
inline constexpr std::uint32_t kFallPostureMotion = 2;

struct PlanMoment {
  std::uint32_t sequence = 0;  // of the batch that plays, or whose tail does
  double since_start_s = 0.0;  // of that batch
  std::size_t support = 2;     // 0 left, 1 right, 2 both feet, 3 neither: in the time slot that begins now
  double commanded_yaw_rad = 0.0;                                  // reached now, in the frame `plan`
  Eigen::Vector2d com_velocity_m_per_s = Eigen::Vector2d::Zero();  // forward and left of the base
  // The planned CoM at the tail's end, at rest, in each foot's frame [Side], and how that is turned against
  // the base.
  std::array<Eigen::Vector2d, 2> com_in_foot_m{Eigen::Vector2d::Zero(), Eigen::Vector2d::Zero()};
  std::array<double, 2> foot_from_base_rad{};
  std::array<double, 2> foot_turn_rad{};  // of each foot against the base, now
  bool walking = false;                   // the plan has footsteps to come
  bool motion = false;                    // a key-frame motion plays
  // Of the trunk, roll and pitch, as they are meant to be now; and their rates.
  Eigen::Vector2d trunk_attitude_rad = Eigen::Vector2d::Zero(),
                  trunk_rate_rad_per_s = Eigen::Vector2d::Zero();
  bool fall_posture = false;  // the joints go into the posture in which a falling robot meets the ground
  bool on_ground = false;     // neither foot is meant to carry: a motion of a robot that lies
};

class PlanTimeline {
 public:
  // Takes a plan, in the place of one of the same batch. A plan without sequence or with non-finite yaw is
  // not taken.
  void take(const MotionPlan& plan) noexcept;

  // Whether the trunk is to stay near upright through the newest plan and its tail: the message controller,
  // which knows one attitude reference alone, may then balance the tail.
  [[nodiscard]] bool newest_stays_upright() const noexcept { return upright_; }

  // accepted_sequence: newest batch that the message controller accepted, if that is known: a plan that it
  // has not accepted is not played. After its last point a plan stays at it. Nothing before the first plan
  // starts.
  [[nodiscard]] std::optional<PlanMoment> at(std::int64_t now_ns,
                                             std::optional<std::uint32_t> accepted_sequence) const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.kept_, self.newest_, self.upright_);
  }

 private:
  struct Excerpt {
    std::uint32_t sequence = 0;  // 0: none
    std::uint32_t count = 0;
    std::int64_t start_ns = 0;
    bool walking = false, motion = false, fall_posture = false;
    std::array<std::uint8_t, kMaxPoints> support{};
    std::array<double, kMaxPoints> commanded_yaw_rad{};
    std::array<std::array<double, 2>, kMaxPoints> com_velocity_m_per_s{}, foot_turn_rad{},
        trunk_attitude_rad{};
    // At the tail's end, by foot: m, m; and the foot's turn, rad.
    std::array<std::array<double, 3>, 2> com_in_foot{};
  };
  static constexpr std::size_t kKept = 4;  // a batch is planned less than three cycles ahead

  std::array<Excerpt, kKept> kept_{};
  std::size_t newest_ = 0;
  bool upright_ = true;
};

}  // namespace gaitway::stability
