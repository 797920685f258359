// Files with prepared motions (trajectory/motion_table_file.hpp). Whatever the bytes: they are
// refused with MotionTableError and nothing else, or are a motion that plays to its end, from every batch of
// which a safe tail leads out.
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>

#include "fuzz_input.hpp"
#include "gaitway/trajectory/motion_player.hpp"
#include "gaitway/trajectory/motion_table.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {

void motion_table(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  trajectory::MotionTable table;
  try {
    table = trajectory::read_motion_table(file.path());
  } catch (const trajectory::MotionTableError&) {
    return;
  }
  const std::size_t batches = table.batch_count();
  const auto plan = std::make_unique<MotionPlan>();
  const auto posture = std::make_unique<PosturePlan>();
  trajectory::MotionPlayer player({table});
  for (const bool leaves : {false, true}) {
    player.start(0, {}, {});
    std::size_t played = 0;
    constexpr std::size_t kMostOfApproachAndTail = 2 * kMaxTailPoints / kBatchPoints;
    for (; player.plays(); ++played) {
      require(played <= batches + kMostOfApproachAndTail, "a motion ends");
      player.plan(1, 0, *plan, *posture);
      require(plan->tail_count >= kBatchPoints && plan->tail_count <= kMaxTailPoints, "a tail is one");
      require(posture->joint_count <= kMaxJoints, "no more joints than a plan holds");
      if (leaves && played == batches / 2) player.leave();
    }
  }
}

}  // namespace gaitway::fuzz
