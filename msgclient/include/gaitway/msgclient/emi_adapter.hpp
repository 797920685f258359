// The external memory interface between main controller (host) and message controller: a window of 32-bit
// words, two doorbells and what a transfer costs. The message controller owns the memory; only the host pays
// for its accesses.
//
// The window is two regions of the memory block, since each region has one writer: `emi.host_to_message`
// (mailboxes and the host's doorbell) and `emi.message_to_host` (answers, what has been taken, the message
// controller's doorbell). A mail that is posted at t is seen on the other side from t + its transfer time on,
// and not before its doorbell rang; one doorbell announces all mails that wait. In real time both sides look
// at the doorbell word once a tick (host 10 ms, message controller 1 ms), which costs nothing that a wake-up
// between ticks would save.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::msgclient {

// Cost of one 32-bit word on an asynchronous memory bus: set-up, strobe and hold cycles of its clock.
// The defaults make 50 ns a word (20 Mword/s).
struct EmiTiming {
  std::int64_t clock_hz = 100'000'000;
  std::int64_t setup_cycles = 1;
  std::int64_t strobe_cycles = 3;
  std::int64_t hold_cycles = 1;

  // Rounded up to whole nanoseconds.
  [[nodiscard]] constexpr std::int64_t transfer_ns(std::uint64_t words) const noexcept {
    const std::int64_t cycles =
        static_cast<std::int64_t>(words) * (setup_cycles + strobe_cycles + hold_cycles);
    return (cycles * 1'000'000'000 + clock_hz - 1) / clock_hz;
  }
};

inline constexpr std::size_t kAnswerSlots = 16;  // answers that may wait for the host

enum class PostStatus : std::uint8_t {
  posted,
  occupied,   // the mail before it has not been taken yet; nothing was written, the doorbell rang again
  bus_stuck,  // the bus doesn't answer; nothing was written
  invalid     // the mail's counts are out of range; nothing was written
};

struct PostResult {
  PostStatus status = PostStatus::posted;
  std::int64_t transfer_ns = 0;  // time on the bus, including the wait for transfers that were under way
  [[nodiscard]] explicit operator bool() const noexcept { return status == PostStatus::posted; }
};

struct EmiStatistics {
  std::uint64_t words = 0;   // read and written by the host
  std::int64_t busy_ns = 0;  // time that they took
  std::uint64_t posted = 0;
  std::uint64_t occupied = 0;
  std::uint64_t stuck = 0;  // accesses that the stuck bus refused
  std::uint64_t corrupt_answers = 0;
};

// What tests and drills do to the adapter.
struct EmiFaults {
  // The next mail of this kind has these bits of one word inverted on its way.
  struct Flip {
    MailKind mail = MailKind::hand_over;
    std::uint32_t word = 0;  // counted modulo the mail's length
    std::uint32_t mask = 0;
  };
  std::optional<Flip> flip_next;
  std::int64_t delay_next_ns = 0;    // the next hand-over is ready so much later
  std::uint32_t lose_doorbells = 0;  // how many of the next doorbells of this side don't ring
  bool bus_stuck = false;
};

enum class TakeStatus : std::uint8_t { none, mail, corrupt };

class EmiWindow;

// The main controller's side. For the cycle: no allocation, lock or system call.
class EmiHost {
 public:
  // Opens the window: set-up, throws TopicError.
  explicit EmiHost(Client& client, const EmiTiming& timing = {});
  ~EmiHost();
  EmiHost(EmiHost&&) noexcept;
  EmiHost& operator=(EmiHost&&) noexcept;

  // now_ns: the clock of the robot; may not run backwards.
  PostResult post(const HandOver& hand_over, std::int64_t now_ns) noexcept;
  PostResult post(const TrimUpdate& trim, std::int64_t now_ns) noexcept;
  PostResult post(const UserCommandMail& command, std::int64_t now_ns) noexcept;
  // The oldest answer that has not been taken; nothing before its doorbell rang, or while the bus is stuck.
  std::optional<Answer> take_answer(std::int64_t now_ns) noexcept;
  // Charges the bus for topics that are read across it (joint feedback, sensors). The time it takes, or
  // nothing while the bus is stuck.
  std::optional<std::int64_t> charge_read(std::size_t bytes, std::int64_t now_ns) noexcept;

  [[nodiscard]] std::int64_t transfer_ns(std::uint64_t words) const noexcept {
    return timing_.transfer_ns(words);
  }
  [[nodiscard]] const EmiStatistics& statistics() const noexcept { return statistics_; }
  [[nodiscard]] EmiFaults& faults() noexcept { return faults_; }

 private:
  PostResult post_words(MailKind mail, std::span<const std::uint32_t> words, std::int64_t now_ns) noexcept;
  std::int64_t charge(std::uint64_t words, std::int64_t now_ns) noexcept;

  EmiTiming timing_;
  std::unique_ptr<EmiWindow> window_;
  EmiStatistics statistics_;
  EmiFaults faults_;
  std::int64_t bus_free_ns_ = 0;
  std::uint64_t rings_seen_ = 0;
  std::uint64_t answers_announced_ = 0;
};

// The message controller's side. For the cycle, too.
class EmiMessage {
 public:
  explicit EmiMessage(Client& client);
  ~EmiMessage();
  EmiMessage(EmiMessage&&) noexcept;
  EmiMessage& operator=(EmiMessage&&) noexcept;

  // `corrupt`: the mail was damaged; it has been taken, counted and, if its kind is answered, answered as
  // corrupt already.
  TakeStatus take_hand_over(HandOver& hand_over, std::int64_t now_ns) noexcept;
  TakeStatus take_trim(TrimUpdate& trim, std::int64_t now_ns) noexcept;
  TakeStatus take_user_command(UserCommandMail& command, std::int64_t now_ns) noexcept;
  // False: the host has left kAnswerSlots answers lying; the answer was not taken, give it again later.
  [[nodiscard]] bool answer(const Answer& answer) noexcept;

  [[nodiscard]] std::uint64_t corrupt() const noexcept { return corrupt_; }
  [[nodiscard]] EmiFaults& faults() noexcept {
    return faults_;
  }  // only lose_doorbells has a meaning on this side

 private:
  // The words of the mail that waits, marked as taken; empty: none.
  std::span<const std::uint32_t> fetch(MailKind mail, std::int64_t now_ns) noexcept;
  TakeStatus damaged(MailKind mail, std::uint32_t sequence) noexcept;
  [[nodiscard]] bool answers_full() const noexcept;

  std::unique_ptr<EmiWindow> window_;
  EmiFaults faults_;
  std::uint64_t corrupt_ = 0;
  std::uint64_t rings_seen_ = 0;
  std::array<std::uint64_t, kMailKinds> announced_{};  // mails that a doorbell has announced
};

// Both sides in one process, for virtual time.
class EmiAdapter {
 public:
  explicit EmiAdapter(Client host_client, Client message_client, const EmiTiming& timing = {})
      : message_(message_client), host_(host_client, timing) {}
  explicit EmiAdapter(MemoryBlock& block, const EmiTiming& timing = {})
      : EmiAdapter(block.local_client("main_controller"), block.local_client("message_controller"), timing) {}
  [[nodiscard]] EmiHost& host() noexcept { return host_; }
  [[nodiscard]] EmiMessage& message() noexcept { return message_; }

 private:
  EmiMessage message_;
  EmiHost host_;
};

}  // namespace gaitway::msgclient
