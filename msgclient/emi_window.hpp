// Layout of the EMI's window, and the packing of the small mails. Each region is written by one side only.
//
// Memory orders. A mailbox and its `posted` count belong to the host, its `taken` count to the message
// controller:
//   host:    taken (acquire) == posted?  words (relaxed), posted (release), doorbell (release)
//   message: doorbell (acquire), posted (acquire), words (relaxed), taken (release)
// The acquire of `posted` sees all words of that mail; the acquire of `taken` keeps the next mail's words
// behind the message controller's last look at the old ones. So words are never read and written at once.
// Answers go the same way back.
#pragma once

#include <atomic>
#include <vector>

#include "gaitway/msgclient/emi_adapter.hpp"

namespace gaitway::msgclient {

using WindowWord = std::atomic<std::uint32_t>;
static_assert(WindowWord::is_always_lock_free && sizeof(WindowWord) == 4);

inline constexpr std::size_t kTrimWords = 2 + 1 + kTrimChannels + 1 + 1;
inline constexpr std::size_t kUserCommandWords = 6;
inline constexpr std::size_t kAnswerWords = 8;
inline constexpr std::array<std::size_t, kMailKinds> kMailboxWords = {kMaxHandOverWords, kTrimWords,
                                                                      kUserCommandWords};

// Written by the host.
struct HostRegion {
  struct Mailbox {
    SharedWord posted;    // mails posted so far
    SharedWord length;    // words of the newest
    SharedWord ready_ns;  // when its transfer is over
  };
  SharedWord rings;
  SharedWord answers_taken;
  std::array<Mailbox, kMailKinds> mailbox;
  std::array<WindowWord, kMaxHandOverWords> hand_over;
  std::array<WindowWord, kTrimWords> trim;
  std::array<WindowWord, kUserCommandWords> user_command;

  [[nodiscard]] WindowWord* words(MailKind mail) noexcept {
    return mail == MailKind::hand_over ? hand_over.data()
           : mail == MailKind::trim    ? trim.data()
                                       : user_command.data();
  }
};

// Written by the message controller.
struct MessageRegion {
  SharedWord rings;
  std::array<SharedWord, kMailKinds> taken;
  SharedWord answers_posted;
  std::array<std::array<WindowWord, kAnswerWords>, kAnswerSlots> answers;
};

// One side's view; the region of the other side is mapped for reading only, where the sides are different
// processes.
class EmiWindow {
 public:
  EmiWindow(Client& client, Role to_message, Role to_host)
      : host_grant_(client.open_window("emi.host_to_message", sizeof(HostRegion), to_message)),
        message_grant_(client.open_window("emi.message_to_host", sizeof(MessageRegion), to_host)),
        staging(kMaxHandOverWords) {}

  [[nodiscard]] HostRegion& host() const noexcept {
    return *static_cast<HostRegion*>(host_grant_.storage->data());
  }
  [[nodiscard]] MessageRegion& message() const noexcept {
    return *static_cast<MessageRegion*>(message_grant_.storage->data());
  }

 private:
  TopicGrant host_grant_;
  TopicGrant message_grant_;

 public:
  std::vector<std::uint32_t> staging;  // where a mail is packed or unpacked
};

// Adds one to a count that only this side writes.
inline void count_up(SharedWord& count) noexcept {
  count.store(count.load(std::memory_order_relaxed) + 1, std::memory_order_release);
}

// Rings this side's doorbell, unless a fault swallows it.
inline void ring_doorbell(SharedWord& rings, EmiFaults& faults) noexcept {
  if (faults.lose_doorbells > 0) {
    --faults.lose_doorbells;
    return;
  }
  count_up(rings);
}

std::array<std::uint32_t, kTrimWords> pack(const TrimUpdate& trim) noexcept;
std::array<std::uint32_t, kUserCommandWords> pack(const UserCommandMail& command) noexcept;
std::array<std::uint32_t, kAnswerWords> pack(const Answer& answer) noexcept;
// False: damaged. What could be read is in the destination all the same.
bool unpack(std::span<const std::uint32_t> words, TrimUpdate& trim) noexcept;
bool unpack(std::span<const std::uint32_t> words, UserCommandMail& command) noexcept;
bool unpack(std::span<const std::uint32_t> words, Answer& answer) noexcept;

}  // namespace gaitway::msgclient
