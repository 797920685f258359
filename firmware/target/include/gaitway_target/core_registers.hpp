// The Cortex-M4 itself: the few of its registers that the programs use (Armv7-M Architecture Reference
// Manual, B3), and how deep its stack has been.
#pragma once

#include <cstddef>
#include <cstdint>

extern "C" {
extern std::uint32_t bss_end[], stack_top[];
}

namespace gaitway::target {

inline volatile std::uint32_t& core_register(std::uintptr_t address) {
  return *reinterpret_cast<volatile std::uint32_t*>(address);
}

// SysTick: counts down with the processor's clock, 24 bits.
inline volatile std::uint32_t& systick_control() {
  return core_register(0xE000'E010U);
}
inline volatile std::uint32_t& systick_reload() {
  return core_register(0xE000'E014U);
}
inline volatile std::uint32_t& systick_value() {
  return core_register(0xE000'E018U);
}
inline constexpr std::uint32_t kSystickRuns = 5;        // enabled, processor clock
inline constexpr std::uint32_t kSystickInterrupts = 7;  // the same, with its interrupt
inline constexpr std::uint32_t kSystickLargest = 0xFF'FFFFU;
inline constexpr std::uint32_t kProcessorClock_Hz = 168'000'000;

inline void pend_low_priority_work() {
  core_register(0xE000'ED04U) = 1U << 28U;
}  // ICSR.PENDSVSET
inline void enable_interrupt(std::uint32_t number) {
  core_register(0xE000'E100U + 4U * (number / 32U)) = 1U << (number % 32U);
}
inline void pend_interrupt(std::uint32_t number) {
  core_register(0xE000'E200U + 4U * (number / 32U)) = 1U << (number % 32U);
}
// The lower the more urgent; the STM32F405 has the upper four bits.
inline void set_interrupt_priority(std::uint32_t number, std::uint8_t priority) {
  *reinterpret_cast<volatile std::uint8_t*>(0xE000'E400U + number) = priority;
}
inline void set_system_priority(std::uint32_t exception, std::uint8_t priority) {
  *reinterpret_cast<volatile std::uint8_t*>(0xE000'ED14U + exception) = priority;
}
inline constexpr std::uint32_t kPendSv = 14, kSysTick = 15;

inline void wait_for_interrupt() {
  asm volatile("wfi" ::: "memory");
}

// How deep the stack has been: the free part is painted at start-up and looked over later.
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
