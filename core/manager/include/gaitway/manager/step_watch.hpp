// Which plug-in's code is running, in memory that outlives the process: so whoever watches it knows the
// culprit of a crash or a hang.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "gaitway/msgclient/segment.hpp"

namespace gaitway::core {

// A page of shared memory: one side makes it, the other opens it by its descriptor. enter() and leave() are
// for the cycle: one relaxed store each. Relaxed is enough: the watcher looks once the process has ended, or
// to see a number grow.
class StepWatch {
 public:
  static constexpr std::uint32_t kCapacity = 63;  // names of plug-ins since start

  static StepWatch make();               // throws std::system_error
  static StepWatch open(int inherited);  // throws std::system_error or msgclient::TopicError

  // The worker's side. add() is for set-up, and gives the same name the same number; 0: no room, that one is
  // not named.
  std::uint32_t add(std::string_view plugin) noexcept;
  void enter(std::uint32_t id) noexcept { page_->current.store(id, std::memory_order_relaxed); }
  void leave() noexcept { page_->current.store(0, std::memory_order_relaxed); }
  // Beside the ticks: a plug-in is loaded, constructed or destroyed.
  void begin_change(std::string_view plugin) noexcept;
  void end_change() noexcept { page_->changes.store(0, std::memory_order_relaxed); }
  // Its last tick is done: what follows takes its time.
  void end() noexcept { page_->ending.store(1, std::memory_order_relaxed); }
  void count_tick() noexcept {
    page_->ticks.store(page_->ticks.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  // The watcher's side. Names of plug-ins; empty: none.
  [[nodiscard]] std::string current() const;
  [[nodiscard]] std::string changed() const;
  [[nodiscard]] std::uint64_t ticks() const noexcept { return page_->ticks.load(std::memory_order_relaxed); }
  [[nodiscard]] bool is_ending() const noexcept { return page_->ending.load(std::memory_order_relaxed) != 0; }
  [[nodiscard]] int descriptor() const noexcept { return memory_.fd(); }

 private:
  using Name = std::array<char, 48>;
  struct Page {
    std::atomic<std::uint32_t> current, changes, count, ending;
    std::atomic<std::uint64_t> ticks;
    std::array<Name, kCapacity + 1> names;  // [0]: of the one that is being changed
  };
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

  // All zero in a new one: what its members begin with.
  explicit StepWatch(msgclient::Segment memory)
      : memory_(std::move(memory)), page_(static_cast<Page*>(memory_.data())) {}

  msgclient::Segment memory_;
  Page* page_;
};

// While it lives, a plug-in's code runs.
class WatchedCall {
 public:
  // `watch` may be nullptr: nobody watches.
  WatchedCall(StepWatch* watch, std::uint32_t id) noexcept : watch_(watch) {
    if (watch_ != nullptr) {
      watch_->enter(id);
    }
  }
  WatchedCall(const WatchedCall&) = delete;
  WatchedCall& operator=(const WatchedCall&) = delete;
  ~WatchedCall() {
    if (watch_ != nullptr) {
      watch_->leave();
    }
  }

 private:
  StepWatch* watch_;
};

}  // namespace gaitway::core
