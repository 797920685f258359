// Packs a hand-over (batch, tail, trim gains) into the words that cross the EMI, and reads it back.
#include "gaitway/msgclient/hand_over.hpp"

#include <algorithm>
#include <bit>

#include "gaitway/facts/facts.hpp"
#include "gaitway/process/crc32.hpp"

namespace gaitway::msgclient {
namespace {

static_assert(kBatchPoints == facts::kSlotsPerCycle,
              "topics.toml gives a batch one point for each time slot");
static_assert(kTrimChannels == facts::kTrimChannels, "topics.toml has the trim frame's channels");

constexpr std::size_t kSupportsPerWord = 16;

struct Counts {
  std::size_t joints = 0;
  std::size_t points = 0;
  std::size_t channels = 0;

  [[nodiscard]] bool valid() const noexcept {
    return joints >= 1 && joints <= kMaxJoints && points >= kBatchPoints && points <= kMaxPoints &&
           channels <= kTrimChannels;
  }
  [[nodiscard]] std::size_t words() const noexcept { return hand_over_words(joints, points, channels); }
};

// Walks over the packed words in their order; `visit_float` and `visit_support` read or write one.
template <class HandOverType, class VisitFloat>
void visit_floats_of_trim(HandOverType& hand_over, std::size_t channels, VisitFloat visit_float) noexcept {
  for (auto& reference : hand_over.trim.attitude_reference) {
    visit_float(reference);
  }
  for (auto& support : hand_over.trim.gain) {
    for (std::size_t c = 0; c < channels; ++c) {
      for (auto& gain : support[c]) {
        visit_float(gain);
      }
    }
  }
}

// Each of the points' supports is one that there is, and the bits behind the last one are zero.
bool supports_are_defined(std::span<const std::uint32_t> packed, std::size_t points) noexcept {
  for (std::size_t i = 0; i < packed.size() * kSupportsPerWord; ++i) {
    const std::uint32_t support = packed[i / kSupportsPerWord] >> (2 * (i % kSupportsPerWord)) & 3U;
    if (i < points ? support >= kSupports : support != 0) {
      return false;
    }
  }
  return true;
}

}  // namespace

bool make_hand_over(const JointPlan& plan, const TrimCommand& trim, HandOver& hand_over) noexcept {
  if (plan.joint_count == 0 || plan.joint_count > kMaxJoints || plan.tail_count > kMaxTailPoints) {
    return false;
  }
  hand_over.sequence = plan.sequence;
  hand_over.joint_count = plan.joint_count;
  hand_over.point_count = kBatchPoints + plan.tail_count;
  hand_over.trim = trim_gains(trim);
  std::copy_n(plan.support, hand_over.point_count, hand_over.support.begin());
  for (std::size_t point = 0; point < hand_over.point_count; ++point) {
    std::copy_n(plan.position[point], plan.joint_count,
                hand_over.position.begin() + static_cast<std::ptrdiff_t>(point * plan.joint_count));
  }
  return true;
}

std::uint32_t crc32(std::span<const std::uint32_t> words) noexcept {
  static_assert(std::endian::native == std::endian::little,
                "the checksum takes the bytes as they lie in memory");
  return process::crc32(std::as_bytes(words));
}

std::size_t encode(const HandOver& hand_over, std::span<std::uint32_t> words) noexcept {
  const Counts counts{hand_over.joint_count, hand_over.point_count, hand_over.trim.channel_count};
  if (!counts.valid() || counts.words() > words.size()) {
    return 0;
  }
  std::size_t next = 0;
  words[next++] = kHandOverFormat;
  words[next++] = hand_over.sequence;
  words[next++] = static_cast<std::uint32_t>(counts.joints | counts.channels << 8 | counts.points << 16);
  visit_floats_of_trim(hand_over, counts.channels,
                       [&](float value) { words[next++] = std::bit_cast<std::uint32_t>(value); });
  for (std::size_t first = 0; first < counts.points; first += kSupportsPerWord) {
    std::uint32_t packed = 0;
    for (std::size_t i = 0; i < kSupportsPerWord && first + i < counts.points; ++i) {
      const std::uint32_t support = hand_over.support[first + i];
      if (support >= kSupports) {
        return 0;
      }
      packed |= support << (2 * i);
    }
    words[next++] = packed;
  }
  for (std::size_t i = 0; i < counts.points * counts.joints; ++i) {
    words[next++] = std::bit_cast<std::uint32_t>(hand_over.position[i]);
  }
  words[next] = crc32(words.first(next));
  return next + 1;
}

DecodeStatus decode(std::span<const std::uint32_t> words, HandOver& hand_over) noexcept {
  hand_over.sequence = words.size() > 1 ? words[1] : 0;
  if (words.size() < hand_over_words(1, kBatchPoints, 0) || words[0] != kHandOverFormat ||
      crc32(words.first(words.size() - 1)) != words.back()) {
    return DecodeStatus::corrupt;
  }
  const Counts counts{words[2] & 0xff, words[2] >> 16, (words[2] >> 8) & 0xff};
  const std::size_t support_words = (counts.points + kSupportsPerWord - 1) / kSupportsPerWord;
  const std::size_t first_support = 3 + 2 + kSupports * counts.channels * 4;
  if (!counts.valid() || counts.words() != words.size() ||
      !supports_are_defined(words.subspan(first_support, support_words), counts.points)) {
    return DecodeStatus::corrupt;
  }
  hand_over.joint_count = static_cast<std::uint32_t>(counts.joints);
  hand_over.point_count = static_cast<std::uint32_t>(counts.points);
  hand_over.trim = {};
  hand_over.trim.channel_count = static_cast<std::uint32_t>(counts.channels);
  std::size_t next = 3;
  visit_floats_of_trim(hand_over, counts.channels,
                       [&](float& value) { value = std::bit_cast<float>(words[next++]); });
  for (std::size_t point = 0; point < counts.points; ++point) {
    const std::uint32_t packed = words[next + point / kSupportsPerWord];
    hand_over.support[point] = static_cast<std::uint8_t>(packed >> (2 * (point % kSupportsPerWord)) & 3);
  }
  next += support_words;
  for (std::size_t i = 0; i < counts.points * counts.joints; ++i) {
    hand_over.position[i] = std::bit_cast<float>(words[next + i]);
  }
  return DecodeStatus::whole;
}

}  // namespace gaitway::msgclient
