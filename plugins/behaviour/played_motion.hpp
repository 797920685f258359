// One key-frame motion from its order to its end, for the leaves that play motions.
#pragma once

#include <cstdint>
#include <string_view>

#include "leaf_base.hpp"

namespace gaitway::behaviour_leaves {

class PlayedMotion {
 public:
  enum class Stage : std::uint8_t { waits, plays, finished, broken_off, refused, not_answered, replaced };

  void order(std::string_view name, const Situation& now, Orders& orders) noexcept {
    number_ = orders.play(name);
    ordered_ns_ = now.now_ns;
    ended_before_ = now.motion != nullptr ? now.motion->ended : 0;
  }

  [[nodiscard]] Stage stage(const Situation& now, const Orders& orders) const noexcept {
    if (orders.motion_number() != number_) return Stage::replaced;
    const bool is_late = now.now_ns - ordered_ns_ >= kOrderIsAnswered_ns;
    if (now.motion == nullptr || now.motion->answered != number_) {
      return is_late ? Stage::not_answered : Stage::waits;
    }
    if (now.motion->refused != 0) return Stage::refused;
    if (now.motion->state != 0) return Stage::plays;
    if (now.motion->ended == ended_before_) return is_late ? Stage::broken_off : Stage::waits;
    constexpr std::uint32_t kToItsEnd = 1;
    return now.motion->result == kToItsEnd ? Stage::finished : Stage::broken_off;
  }

  // Has it left. The approach of a motion can't be, so the order is given anew until it is.
  void leave(const Situation& now, Orders& orders) noexcept {
    if (orders.motion_number() != number_) return;
    number_ = orders.leave_motion();
    ordered_ns_ = now.now_ns;
  }
  [[nodiscard]] bool has_left(const Situation& now, Orders& orders) noexcept {
    if (!now.commands_motions() || now.motion == nullptr || orders.motion_number() != number_) return true;
    const bool is_late = now.now_ns - ordered_ns_ >= kOrderShows_ns;
    if (now.motion->state == 0) return is_late;  // one that had just been ordered would show by then
    constexpr std::uint32_t kIsBeingLeft = 3;
    if (now.motion->state != kIsBeingLeft && is_late) leave(now, orders);
    return false;
  }

 private:
  std::uint32_t number_ = 0, ended_before_ = 0;
  std::int64_t ordered_ns_ = 0;
};

}  // namespace gaitway::behaviour_leaves
