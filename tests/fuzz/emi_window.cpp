// The EMI's window of shared words when the other side has gone mad (msgclient/emi_adapter.hpp): each side
// reads what the fuzzer has written into the region of the other. Whatever stands there: the message
// controller takes at most one mail of a kind for each announcement, with counts in range, and counts every
// damaged one; the host takes no more answers than the window holds for each announcement.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "msgclient/emi_window.hpp"

namespace gaitway::fuzz {
namespace {

using namespace msgclient;

constexpr std::int64_t kLate_ns = std::int64_t{1} << 62;

// Writes up to `room` words; the last of them is their checksum if the fuzzer wants it. Returns how many.
std::size_t write_words(Input& input, WindowWord* target, std::size_t room) {
  const bool sealed = input.flag();
  const std::size_t length = std::min(room, std::size_t{input.take<std::uint16_t>()});
  std::vector<std::uint32_t> words(length);
  for (std::size_t i = 0; i < length && !input.empty(); ++i) {
    words[i] = input.take<std::uint32_t>();
  }
  if (sealed && length > 0) {
    words.back() = crc32(std::span(words).first(length - 1));
  }
  for (std::size_t i = 0; i < length; ++i) {
    target[i].store(words[i], std::memory_order_relaxed);
  }
  return length;
}

void post(Input& input, HostRegion& host) {
  const auto kind = input.choose(kMailKinds);
  HostRegion::Mailbox& box = host.mailbox[kind];
  const std::size_t length = write_words(input, host.words(static_cast<MailKind>(kind)), kMailboxWords[kind]);
  // Mostly what a sane host would say beside them.
  const bool sane = !input.flag();
  box.length.store(sane ? length : input.take<std::uint64_t>());
  box.ready_ns.store(sane ? 0 : input.take<std::uint64_t>());
  box.posted.store(sane ? box.posted.load() + 1 : input.take<std::uint64_t>());
  host.answers_taken.store(sane ? host.answers_taken.load() : input.take<std::uint64_t>());
  host.rings.store(host.rings.load() + 1);
}

void take_mails(EmiMessage& message, HandOver& hand_over) {
  const std::uint64_t corrupt = message.corrupt();
  std::uint64_t damaged = 0;
  const auto count = [&damaged](TakeStatus status) {
    damaged += status == TakeStatus::corrupt ? 1U : 0U;
    return status == TakeStatus::mail;
  };
  if (count(message.take_hand_over(hand_over, kLate_ns))) {
    require(hand_over.joint_count <= kMaxJoints && hand_over.point_count <= kMaxPoints,
            "a hand-over that is taken has its counts in range");
  }
  TrimUpdate trim;
  if (count(message.take_trim(trim, kLate_ns))) {
    require(trim.channel_count <= kTrimChannels, "a trim that is taken has its count in range");
  }
  UserCommandMail command;
  (void)count(message.take_user_command(command, kLate_ns));
  require(message.corrupt() == corrupt + damaged, "every damaged mail is counted");
  require(message.take_trim(trim, kLate_ns) == TakeStatus::none &&
              message.take_user_command(command, kLate_ns) == TakeStatus::none,
          "a mail that was taken does not come again");
}

void mad_host(Input& input) {
  MemoryBlock block;
  Client message_client = block.local_client("message_controller"), host_client = block.local_client("host");
  EmiMessage message(message_client);
  const EmiWindow window(host_client, Role::writer, Role::reader);
  const auto hand_over = std::make_unique<HandOver>();
  while (!input.empty()) {
    post(input, window.host());
    take_mails(message, *hand_over);
  }
}

void mad_message_controller(Input& input) {
  MemoryBlock block;
  Client message_client = block.local_client("message_controller"), host_client = block.local_client("host");
  const EmiWindow window(message_client, Role::reader, Role::writer);
  EmiHost host(host_client);
  MessageRegion& region = window.message();
  while (!input.empty()) {
    const std::size_t first = input.choose(kAnswerSlots);
    write_words(input, region.answers[first].data(), kAnswerWords);
    if (input.flag()) {
      for (auto& slot : region.answers) {
        for (std::size_t i = 0; i < kAnswerWords; ++i) {
          slot[i].store(region.answers[first][i].load());
        }
      }
    }
    region.answers_posted.store(input.flag() ? input.take<std::uint64_t>()
                                             : region.answers_posted.load() + input.choose(kAnswerSlots));
    region.rings.store(region.rings.load() + 1);
    std::size_t answers = 0;
    while (answers <= kAnswerSlots && host.take_answer(kLate_ns)) {
      ++answers;
    }
    require(answers <= kAnswerSlots, "no more answers come than the window holds");
  }
}

}  // namespace

void emi_window(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  if (input.flag()) {
    mad_message_controller(input);
  } else {
    mad_host(input);
  }
}

}  // namespace gaitway::fuzz
