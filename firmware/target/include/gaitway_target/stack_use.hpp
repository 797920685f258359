// How deep the stack has been: the free part is painted at start-up and looked over later.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t bss_end[], stack_top[];
}

namespace gaitway::target {

inline constexpr std::uint32_t kUnusedStack = 0x5AC5'5AC5U;

// From the end of the static data to just below the caller's own frame.
[[gnu::noinline]] inline void paint_stack() {
  constexpr std::size_t kOwnWords = 32;
  const auto* const here = static_cast<std::uint32_t*>(__builtin_frame_address(0)) - kOwnWords;
  for (volatile std::uint32_t* word = bss_end; word < here; ++word) {
    *word = kUnusedStack;
  }
}

// The most that the stack has held since then, in bytes.
[[nodiscard]] inline std::size_t deepest_stack_bytes() {
  const volatile std::uint32_t* word = bss_end;
  while (word < stack_top && *word == kUnusedStack) {
    ++word;
  }
  return static_cast<std::size_t>(stack_top - word) * sizeof(std::uint32_t);
}

}  // namespace gaitway::target
