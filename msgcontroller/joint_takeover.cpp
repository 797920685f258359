// From what a joint feels to where it wants to be: its servo's torque tells how far its reference is from
// where it stands, to less than the sixteen counts that the low bits leave open.
#include "gaitway/msgcontroller/joint_takeover.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::msgcontroller {
namespace {

// Of a feedback frame. The torque is a measured one, and the servo's stiffness is not quite the described:
// with 20 % of stiffness, 5 % of the sensor's gain and 0.3 N·m of its zero at their worst together, the
// counts are right up to 4.5 N·m, and a robot that stands needs half of that. (humanoid22: a count is 0.26
// N·m of stretch.)
constexpr double kTorqueCount_Nm = 0.125;
constexpr int kUnheardSlots = 3;  // from then on a joint is not waited for
// Damping is part of the torque, so only a joint at rest tells its reference. One that goes on moving,
// because it swings, or is pushed, is taken at its word after a while.
constexpr double kRest_counts = 2.0;  // of movement in a slot
constexpr int kPatience_slots = 100;
// One that never comes to rest, because it does not hear SYNC, say, keeps nobody waiting for longer.
constexpr int kLongestPatience_slots = 300;

}  // namespace

std::int32_t nearest_with_low_bits(std::int32_t estimate, std::uint8_t low_bits) noexcept {
  const std::int32_t off = (low_bits - estimate) & 0xF;
  return estimate + (off < 8 ? off : off - 16);
}

JointTakeover::JointTakeover(const urdf::RobotModel& robot, std::span<const can::NodeId> nodes,
                             std::span<const std::int32_t> assumed_count)
    : joints_(robot.joints.size()), count_(assumed_count.begin(), assumed_count.end()) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    joints_[j].on_bus = nodes[j] != 0;
    count_rad_.push_back(robot.joints[j].count_rad);
    stiffness_Nm_per_rad_.push_back(robot.joints[j].servo.stiffness_Nm_per_rad);
  }
}

void JointTakeover::take(int joint, const can::Feedback& feedback, double position_rad) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  Joint& known = joints_[j];
  const bool first = !heard_ || known.silent_slots > 0 || slots_ == 0;
  const double torque_Nm = kTorqueCount_Nm * feedback.current;
  const double stretch_rad = stiffness_Nm_per_rad_[j] > 0.0 ? torque_Nm / stiffness_Nm_per_rad_[j] : 0.0;
  const auto estimate = static_cast<std::int32_t>(std::lround((position_rad + stretch_rad) / count_rad_[j]));
  const std::int32_t count = nearest_with_low_bits(estimate, feedback.reference_low);
  const bool moved = std::abs(position_rad - known.position_rad) > kRest_counts * count_rad_[j];
  // One that stands where it is assumed to needs no second look.
  known.rests = feedback.state != can::JointState::running &&
                (count == count_[j] || (!first && !moved) || slots_ >= kPatience_slots);
  if (known.rests) {
    count_[j] = count;
  }
  known.position_rad = position_rad;
  known.answered = known.heard = true;
  known.silent_slots = 0;
  heard_ = true;
}

void JointTakeover::give_up() noexcept {
  complete_ = true;
  for (Joint& joint : joints_) {
    joint.rests = true;
  }
}

bool JointTakeover::end_slot() noexcept {
  if (complete_ || !heard_) {
    return complete_;
  }
  if (std::ranges::none_of(joints_, &Joint::answered)) {
    slots_ = 0;  // the bus is away: what they tell then is new
    return false;
  }
  ++slots_;
  bool all_rest = true;
  for (Joint& joint : joints_) {
    joint.silent_slots += joint.answered ? 0 : 1;
    // Who has been heard is there, and not where it is assumed to be.
    const bool waited_for =
        joint.on_bus && (joint.silent_slots < kUnheardSlots || (joint.heard && !joint.rests));
    all_rest = all_rest && (!waited_for || (joint.answered && joint.rests));
    joint.answered = false;
  }
  complete_ = all_rest || slots_ >= kLongestPatience_slots;
  return complete_;
}

}  // namespace gaitway::msgcontroller
