// A way: planned footsteps with their numbers, and how much of it is left.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/planning/planner.hpp"

namespace gaitway::navigation {

class Way {
 public:
  // Steps that follow those of the number `after`; what the way had from there on is gone.
  void go_on(std::uint32_t after, std::span<const planning::Footstep> steps);
  void clear() noexcept { steps_.clear(); }

  [[nodiscard]] bool empty() const noexcept { return steps_.empty(); }
  // Number of its last step; of an empty one, 0.
  [[nodiscard]] std::uint32_t last() const noexcept {
    return steps_.empty() ? 0 : first_ + static_cast<std::uint32_t>(steps_.size()) - 1;
  }
  // Null: the way has no step of that number.
  [[nodiscard]] const planning::Footstep* find(std::uint32_t number) const noexcept;
  // From that number on.
  [[nodiscard]] std::span<const planning::Footstep> from(std::uint32_t number) const noexcept;

  // What the walk is to follow from the step `number` on; `odometry`: that frame in the world.
  void tell(std::uint32_t number, const planning::Pose& odometry, FootstepPlan& to) const noexcept;
  // What is still to come after the step `landed`.
  void tell_rest(std::uint32_t landed, NavigationWay& to) const noexcept;
  // What a successor goes on from: the way's next steps, as far as there is room.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    auto count = static_cast<std::uint32_t>(std::min<std::size_t>(self.steps_.size(), kMaxWaySteps));
    archive(self.first_, count);
    if constexpr (!std::is_const_v<Self>) self.steps_.resize(std::min<std::size_t>(count, kMaxWaySteps));
    for (std::uint32_t i = 0; i < count && i < self.steps_.size(); ++i) archive(self.steps_[i]);
  }
  // Along it, by the feet's middle; `from`: where that is.
  [[nodiscard]] double distance_left_m(std::uint32_t landed, const planning::Pose& from) const noexcept;

 private:
  std::uint32_t first_ = 1;  // number of the first step
  std::vector<planning::Footstep> steps_;
};

}  // namespace gaitway::navigation
