// What the robot plays now: the newest motion plan is usually for a batch that has not started, so the ones
// before it are kept.
#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::stability {

struct PlanMoment {
  std::size_t support = 2;    // 0 left, 1 right, 2 both feet: in the time slot that begins now
  double base_yaw_rad = 0.0;  // reached now, in the frame `plan`
  bool walking = false;       // the plan has footsteps to come
};

class PlanTimeline {
 public:
  // Takes a plan, or a revision of one. A plan without sequence or with non-finite yaw is not taken.
  void take(const MotionPlan& plan) noexcept;

  // accepted_sequence: newest batch that the message controller accepted, if that is known: a plan that it
  // has not accepted is not played. After its last point a plan stays at it. Nothing before the first plan
  // starts.
  [[nodiscard]] std::optional<PlanMoment> at(std::int64_t now_ns,
                                             std::optional<std::uint32_t> accepted_sequence) const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.kept_, self.newest_);
  }

 private:
  struct Excerpt {
    std::uint32_t sequence = 0;  // 0: none
    std::uint32_t count = 0;
    std::int64_t start_ns = 0;
    bool walking = false;
    std::array<std::uint8_t, kMaxPoints> support{};
    std::array<double, kMaxPoints> base_yaw_rad{};
  };
  static constexpr std::size_t kKept = 4;  // a batch is planned less than three cycles ahead

  std::array<Excerpt, kKept> kept_{};
  std::size_t newest_ = 0;
};

}  // namespace gaitway::stability
