// The few registers of the Cortex-M4 itself that the programs use (Armv7-M Architecture Reference Manual,
// B3).
#pragma once

#include <cstdint>

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

}  // namespace gaitway::target
