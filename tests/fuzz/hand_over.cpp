// The trajectory mail (msgclient/hand_over.hpp). Whatever the words: they are refused as corrupt, or they are
// exactly what the hand-over is packed into again, with counts in range. With a checksum of the fuzzer's own
// making, or the right one.
#include "gaitway/msgclient/hand_over.hpp"

#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fuzz_input.hpp"

namespace gaitway::fuzz {

void hand_over(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const bool sealed = input.flag();
  std::vector<std::uint32_t> words;
  while (!input.empty() && words.size() < msgclient::kMaxHandOverWords) {
    words.push_back(input.take<std::uint32_t>());
  }
  if (sealed && !words.empty()) {
    words.back() = msgclient::crc32(std::span(words).first(words.size() - 1));
  }
  const auto mail = std::make_unique<msgclient::HandOver>();
  if (msgclient::decode(words, *mail) != msgclient::DecodeStatus::whole) {
    require(mail->joint_count == 0 && mail->point_count == 0, "a corrupt mail leaves the hand-over alone");
    return;
  }
  require(mail->joint_count >= 1 && mail->joint_count <= kMaxJoints, "joints are in range");
  require(mail->point_count >= kBatchPoints && mail->point_count <= kMaxPoints, "points are in range");
  require(mail->trim.channel_count <= kTrimChannels, "channels are in range");
  std::vector<std::uint32_t> again(msgclient::kMaxHandOverWords);
  again.resize(msgclient::encode(*mail, again));
  require(again == words, "what is accepted packs into the same words");
}

}  // namespace gaitway::fuzz
