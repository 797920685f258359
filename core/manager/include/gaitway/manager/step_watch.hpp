// Which plug-in's code is running, in memory that outlives the process: so whoever watches it knows the
// culprit of a crash or a hang.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <string>
#include <string_view>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {

// A page of shared memory: one side makes it, the other opens it by its descriptor. enter() and leave() are
// for the cycle: one relaxed store each. Relaxed is enough: the watcher looks once the process has ended, or
// to see a number grow.
class StepWatch {
 public:
  static constexpr std::uint32_t kCapacity = 63;  // names of plug-ins since start

  static StepWatch make();               // throws std::system_error
  static StepWatch open(int inherited);  // throws std::system_error
  StepWatch(StepWatch&& other) noexcept;
  StepWatch& operator=(StepWatch&&) = delete;
  ~StepWatch();

  // The worker's side. add() is for set-up, and gives the same name the same number; 0: no room, that one is
  // not named.
  std::uint32_t add(std::string_view plugin) noexcept;
  void enter(std::uint32_t id) noexcept { page_->current.store(id, std::memory_order_relaxed); }
  void leave() noexcept { page_->current.store(0, std::memory_order_relaxed); }
  // Its last tick is done: what follows takes its time.
  void end() noexcept { page_->ending.store(1, std::memory_order_relaxed); }
  void count_tick() noexcept {
    page_->ticks.store(page_->ticks.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
  }

  // The watcher's side.
  [[nodiscard]] std::string current() const;  // name of the plug-in; empty: none
  [[nodiscard]] std::uint64_t ticks() const noexcept { return page_->ticks.load(std::memory_order_relaxed); }
  [[nodiscard]] bool is_ending() const noexcept { return page_->ending.load(std::memory_order_relaxed) != 0; }
  [[nodiscard]] int descriptor() const noexcept { return memory_.get(); }

 private:
  struct Page {
    std::atomic<std::uint32_t> current, count, ending;
    std::atomic<std::uint64_t> ticks;
    std::array<std::array<char, 48>, kCapacity + 1> names;
  };
  static_assert(std::atomic<std::uint64_t>::is_always_lock_free);

  explicit StepWatch(process::FileDescriptor memory);

  process::FileDescriptor memory_;
  Page* page_ = nullptr;
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
