// How soft the joints are in a fall, and until the robot gets up.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::stability {

struct FallSoftness {
  double lying = 1.0;     // 0: the joints stay as stiff as ever, to 1: no torque
  double posture = 0.43;  // while they go into the posture of a fall, and hold it
  double wait_s = 0.1;    // from the recognition on, for such a posture to begin: a cycle and its hand-over
};

class FallReaction {
 public:
  explicit FallReaction(const FallSoftness& softness) noexcept : softness_(softness) {}

  // What plays, as the plan has it.
  struct Plays {
    bool on_ground = false;  // a motion on the ground, which was asked for
    bool fall_posture = false;
  };

  // One tick of 10 ms. fall: as in the estimate. Returns the joints' softness: none while the robot is
  // upright. While it falls, that of the posture if one plays or may still come, and else, whatever plays,
  // that of a robot that lies; so it is from the impact on. None again once a robot that lies is moved on
  // purpose, until it stands or that has failed: three seconds after the motion's last point on the ground it
  // lies still.
  double update(std::uint32_t fall, const Plays& plays) noexcept {
    if (fall != estimate::fall::falls) falling_ticks_ = 0;
    if (fall == estimate::fall::upright) {
      rising_ticks_ = 0;
      return 0.0;
    }
    if (fall == estimate::fall::falls) {
      // What is played in the moment of the fall, be it on the ground, does not keep the joints stiff.
      rising_ticks_ = 0;
      falling_ticks_ = std::min(falling_ticks_ + 1, kMostTicks);
      const bool waits = falling_ticks_ <= std::lround(softness_.wait_s / facts::kSlot_s);
      return plays.fall_posture || waits ? std::min(softness_.posture, softness_.lying) : softness_.lying;
    }
    rising_ticks_ = plays.on_ground ? kRisingTicks : std::max(rising_ticks_ - 1, 0);
    return rising_ticks_ > 0 ? 0.0 : softness_.lying;
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.rising_ticks_, self.falling_ticks_);
  }

 private:
  static constexpr int kRisingTicks = 300, kMostTicks = 1000;

  const FallSoftness& softness_;
  int rising_ticks_ = 0;   // left to stand up
  int falling_ticks_ = 0;  // since the recognition, up to the longest wait
};

}  // namespace gaitway::stability
