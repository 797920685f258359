// When a head that has been told where to look has come to rest.
#pragma once

#include <cmath>
#include <cstdint>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {

class HeadWatch {
 public:
  void begin(std::int64_t now_ns) noexcept {
    since_ns_ = still_since_ns_ = now_ns;
    moved_ = false;
    for (double& angle : at_rad_) angle = 0.0;
  }
  // Once a tick. A head that a walking robot carries along is still.
  void look(const Situation& now) noexcept {
    if (now.estimate == nullptr) return;
    constexpr double kStill_rad = 0.02;
    const double(&head)[2] = now.estimate->head;
    if (std::hypot(head[0] - at_rad_[0], head[1] - at_rad_[1]) <= kStill_rad) return;
    moved_ = now.now_ns != since_ns_ || moved_;
    at_rad_[0] = head[0];
    at_rad_[1] = head[1];
    still_since_ns_ = now.now_ns;
  }
  [[nodiscard]] bool is_still(std::int64_t now_ns) const noexcept {
    return now_ns - since_ns_ >= 2 * kOrderShows_ns && now_ns - still_since_ns_ >= kOrderShows_ns;
  }
  [[nodiscard]] bool has_moved() const noexcept { return moved_; }

 private:
  std::int64_t since_ns_ = 0, still_since_ns_ = 0;
  bool moved_ = false;
  double at_rad_[2] = {};
};

}  // namespace gaitway::behaviour_leaves
