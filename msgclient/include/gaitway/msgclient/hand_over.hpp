// The trajectory mail: what the main controller hands over for one cycle, and how it is packed into words.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgclient/trim_law.hpp"

namespace gaitway::msgclient {

// A batch, its safe tail and the trim gains that hold during both. Fixed storage: 53 kB, so not one for small
// stacks.
struct HandOver {
  std::uint32_t sequence = 0;     // cycle in which the batch plays; 0: none
  std::uint32_t joint_count = 0;  // order of RobotModel::joints
  std::uint32_t point_count = 0;  // kBatchPoints and the tail's
  TrimGains trim;
  std::array<std::uint8_t, kMaxPoints> support{};  // 0 left, 1 right, 2 both feet, for each point
  std::array<float, std::size_t{kMaxPoints} * kMaxJoints>
      position{};  // [point][joint], packed: use position_at [rad]

  // Reference of `joint` at the end of time slot `point`. 0 <= point < point_count, 0 <= joint < joint_count.
  [[nodiscard]] float position_at(int point, int joint) const noexcept {
    return position[index(point, joint)];
  }
  // `joint_count` must be set before.
  void set_position(int point, int joint, float angle) noexcept { position[index(point, joint)] = angle; }

 private:
  [[nodiscard]] std::size_t index(int point, int joint) const noexcept {
    return static_cast<std::size_t>(point) * joint_count + static_cast<std::size_t>(joint);
  }
};

// Fills `hand_over` from the topics `joint_plan` and `trim`. False: a count is out of range, hand_over is not
// usable.
[[nodiscard]] bool make_hand_over(const JointPlan& plan, const TrimCommand& trim,
                                  HandOver& hand_over) noexcept;

// CRC-32 (IEEE 802.3, as zlib's) over the words' bytes, least significant byte first. For the cycle: no
// allocation.
[[nodiscard]] std::uint32_t crc32(std::span<const std::uint32_t> words) noexcept;

// Words, 32 bits each, of the packed form; only what is used travels:
//   0 format | 1 sequence | 2 joint count, channel count << 8, point count << 16 | 3.. attitude reference
//   (2), gains (3 x channels x 4) | supports, 2 bits a point, 16 a word | positions [point][joint] | CRC-32
//   of all the words before it
// Floats as their IEEE 754 bits.
inline constexpr std::uint32_t kHandOverFormat = 0x47570001;  // "GW", version 1
constexpr std::size_t hand_over_words(std::size_t joints, std::size_t points, std::size_t channels) noexcept {
  return 3 + 2 + kSupports * channels * 4 + (points + 15) / 16 + points * joints + 1;
}
inline constexpr std::size_t kMaxHandOverWords = hand_over_words(kMaxJoints, kMaxPoints, kTrimChannels);

// Packs into the front of `words`; returns how many were used, or 0 if a count is out of range
// (joints 1..kMaxJoints, points kBatchPoints..kMaxPoints, channels 0..kTrimChannels, supports 0..2) or
// `words` is too small.
[[nodiscard]] std::size_t encode(const HandOver& hand_over, std::span<std::uint32_t> words) noexcept;

enum class DecodeStatus : std::uint8_t {
  whole,    // unpacked
  corrupt,  // the CRC-32 is wrong, the length doesn't fit the counts, or a support is none: hand_over is
            // untouched but for its sequence
};
// Unpacks; checks the CRC-32 first. What a damaged mail claims as its sequence is put into hand_over.sequence
// for the answer.
[[nodiscard]] DecodeStatus decode(std::span<const std::uint32_t> words, HandOver& hand_over) noexcept;

}  // namespace gaitway::msgclient
