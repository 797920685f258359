// What a step may not do, caught in the act: functions that allocate, lock or throw are interposed, and
// system calls are trapped by the kernel. On while a CallGuard lives, for its thread alone.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace gaitway::plugin_check {

struct CaughtCall {
  static constexpr int kFrames = 24;
  const char* function = nullptr;  // name of an interposed function; nullptr: a system call
  int system_call = -1;
  std::array<void*, kFrames> frames{};  // innermost first
  int frame_count = 0;
};

// Whether functions are interposed in this build (not under a sanitizer, which does that itself).
[[nodiscard]] bool functions_are_watched() noexcept;
// Whether this kernel and this machine can trap system calls. Tries it once.
[[nodiscard]] bool system_calls_are_watched() noexcept;
// Loads what the guard itself needs. Throws nothing; to be called once before the first guard.
void prepare_call_guard() noexcept;
// Exceptions thrown in this thread so far.
[[nodiscard]] std::uint64_t exceptions_thrown() noexcept;

class CallGuard {
 public:
  // `calls`: the first of them are kept.
  CallGuard() noexcept;
  ~CallGuard();
  CallGuard(const CallGuard&) = delete;
  CallGuard& operator=(const CallGuard&) = delete;
};

// Of the guards since clear_caught_calls().
[[nodiscard]] int caught_call_count() noexcept;
[[nodiscard]] const CaughtCall& caught_call(int index) noexcept;
void clear_caught_calls() noexcept;

// Bytes that were allocated and not freed since start_counting_memory(), exactly; 0 where functions are not
// watched.
void start_counting_memory() noexcept;
[[nodiscard]] std::int64_t live_memory_bytes() noexcept;

// What memory is filled with when it is allocated, so that what nobody initialises is seen; 0: nothing.
void set_allocation_fill(int fill) noexcept;

// For the interposed functions: `bytes` were allocated at `memory`, or it is about to be freed.
void fill_allocated(void* memory, std::size_t bytes) noexcept;
void count_allocated(void* memory) noexcept;
void count_freed(void* memory) noexcept;
// For the interposed functions: notes the call if a guard is on.
void note_call(const char* function) noexcept;
void note_exception() noexcept;

}  // namespace gaitway::plugin_check
