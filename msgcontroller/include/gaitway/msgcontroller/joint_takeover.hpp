// What a message controller that starts has to find out before it may move anything: where the joints' own
// references stand, which may have been left in the middle of a walk by the one before it. Joints that still
// play their batch or its tail are waited for.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/can/messages.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

// The count nearest to `estimate` that has these low four bits, of which a joint tells.
[[nodiscard]] std::int32_t nearest_with_low_bits(std::int32_t estimate, std::uint8_t low_bits) noexcept;

class JointTakeover {
 public:
  // `nodes`: of each joint, 0 for those that are not on the bus. `assumed_count`: where joints stand that do
  // not answer.
  JointTakeover(const urdf::RobotModel& robot, std::span<const can::NodeId> nodes,
                std::span<const std::int32_t> assumed_count);

  // A joint's answer. `position_rad`: its angle, as it told.
  void take(int joint, const can::Feedback& feedback, double position_rad) noexcept;
  // The answers of a slot have come, or their time is over. True from the slot on in which every joint that
  // answers has come to rest, or has been waited for in vain: then counts() are the references of all that
  // knows() names.
  bool end_slot() noexcept;
  [[nodiscard]] bool complete() const noexcept { return complete_; }
  // A joint that had not answered by then tells of itself when it does.
  [[nodiscard]] bool knows(int joint) const noexcept {
    return joints_[static_cast<std::size_t>(joint)].rests;
  }
  // Whoever stopped the joints finds out himself where they stand.
  void give_up() noexcept;
  [[nodiscard]] bool anything_heard() const noexcept { return heard_; }
  [[nodiscard]] std::span<const std::int32_t> counts() const noexcept { return count_; }

 private:
  struct Joint {
    bool on_bus = false;
    bool answered = false;  // in this slot
    bool heard = false;     // ever
    bool rests = false;
    int silent_slots = 0;
    double position_rad = 0.0;
  };
  std::vector<Joint> joints_;
  std::vector<std::int32_t> count_;
  std::vector<double> count_rad_, stiffness_Nm_per_rad_;
  int slots_ = 0;  // since the first answer
  bool heard_ = false;
  bool complete_ = false;
};

}  // namespace gaitway::msgcontroller
