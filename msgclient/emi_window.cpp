// Packing of the small mails; each ends with its CRC-32.
#include "emi_window.hpp"

#include <bit>

#include "gaitway/msgclient/hand_over.hpp"

namespace gaitway::msgclient {
namespace {

template <std::size_t words>
void seal(std::array<std::uint32_t, words>& packed) noexcept {
  packed.back() = crc32(std::span(packed).first(words - 1));
}

bool whole(std::span<const std::uint32_t> words, std::size_t expected) noexcept {
  return words.size() == expected && crc32(words.first(expected - 1)) == words.back();
}

}  // namespace

std::array<std::uint32_t, kTrimWords> pack(const TrimUpdate& trim) noexcept {
  std::array<std::uint32_t, kTrimWords> words{};
  const auto stamp = static_cast<std::uint64_t>(trim.stamp_ns);
  words[0] = static_cast<std::uint32_t>(stamp);
  words[1] = static_cast<std::uint32_t>(stamp >> 32);
  words[2] = trim.channel_count;
  for (std::size_t i = 0; i < trim.angle.size(); ++i) {
    words[3 + i] = std::bit_cast<std::uint32_t>(trim.angle[i]);
  }
  words[3 + kTrimChannels] = std::bit_cast<std::uint32_t>(trim.softness);
  seal(words);
  return words;
}

bool unpack(std::span<const std::uint32_t> words, TrimUpdate& trim) noexcept {
  if (!whole(words, kTrimWords) || words[2] > kTrimChannels) {
    return false;
  }
  trim.stamp_ns = static_cast<std::int64_t>(words[0] | std::uint64_t{words[1]} << 32);
  trim.channel_count = words[2];
  for (std::size_t i = 0; i < trim.angle.size(); ++i) {
    trim.angle[i] = std::bit_cast<float>(words[3 + i]);
  }
  trim.softness = std::bit_cast<float>(words[3 + kTrimChannels]);
  return true;
}

std::array<std::uint32_t, kUserCommandWords> pack(const UserCommandMail& command) noexcept {
  std::array<std::uint32_t, kUserCommandWords> words = {
      command.sequence,       static_cast<std::uint32_t>(command.kind),
      command.joint,          std::bit_cast<std::uint32_t>(command.position),
      command.duration_slots, 0};
  seal(words);
  return words;
}

bool unpack(std::span<const std::uint32_t> words, UserCommandMail& command) noexcept {
  if (words.size() != kUserCommandWords) {
    return false;
  }
  command = {words[0], static_cast<UserCommandKind>(words[1]), words[2], std::bit_cast<float>(words[3]),
             words[4]};
  return whole(words, kUserCommandWords);
}

std::array<std::uint32_t, kAnswerWords> pack(const Answer& answer) noexcept {
  std::array<std::uint32_t, kAnswerWords> words = {
      static_cast<std::uint32_t>(answer.mail),    answer.sequence,
      static_cast<std::uint32_t>(answer.verdict), static_cast<std::uint32_t>(answer.reason),
      static_cast<std::uint32_t>(answer.joint),   static_cast<std::uint32_t>(answer.point),
      std::bit_cast<std::uint32_t>(answer.value), 0};
  seal(words);
  return words;
}

bool unpack(std::span<const std::uint32_t> words, Answer& answer) noexcept {
  if (!whole(words, kAnswerWords)) {
    return false;
  }
  answer = {static_cast<MailKind>(words[0]),     words[1],
            static_cast<Verdict>(words[2]),      static_cast<Reason>(words[3]),
            static_cast<std::int32_t>(words[4]), static_cast<std::int32_t>(words[5]),
            std::bit_cast<float>(words[6])};
  return true;
}

}  // namespace gaitway::msgclient
