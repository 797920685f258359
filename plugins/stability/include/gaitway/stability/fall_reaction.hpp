// How soft the joints are in a fall, and until the robot gets up.
#pragma once

#include <cstdint>

namespace gaitway::stability {

class FallReaction {
 public:
  // softness: 0 (the joints stay as stiff as ever) to 1 (no torque).
  explicit FallReaction(double softness) noexcept : softness_(softness) {}

  // One tick of 10 ms. fall: as in the estimate. on_ground: the plan that plays is a motion on the ground,
  // which was asked for. Returns the joints' softness: none while the robot is upright; from the recognition
  // of a fall on the full one, whatever plays; none again once a robot that lies is moved on purpose, until
  // it stands or that has failed: three seconds after the motion's last point on the ground it lies still.
  double update(std::uint32_t fall, bool on_ground) noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.rising_ticks_);
  }

 private:
  double softness_;
  int rising_ticks_ = 0;  // left to stand up
};

}  // namespace gaitway::stability
