// From reset to main() on a Cortex-M4, and the vector table. Handlers that a program does not define stop the
// processor; on a board the watchdog then resets it, and the motor is off until the joint runs again.
#include <cstddef>
#include <cstdint>

#include "gaitway_target/core_registers.hpp"

extern "C" {

extern std::uint32_t data_begin[], data_end[], bss_begin[], bss_end[], stack_top[];
extern const std::uint32_t data_in_flash[];
using Function = void (*)();
extern const Function init_array_begin[], init_array_end[];

int main();

void Unexpected_Handler() {
  while (true) {
    asm volatile("bkpt 0");  // halts under a debugger; without one it faults, and the core locks up
  }
}
[[gnu::weak, gnu::alias("Unexpected_Handler")]] void HardFault_Handler();
[[gnu::weak, gnu::alias("Unexpected_Handler")]] void PendSV_Handler();
[[gnu::weak, gnu::alias("Unexpected_Handler")]] void SysTick_Handler();
[[gnu::weak, gnu::alias("Unexpected_Handler")]] void CanReceive_Handler();

[[noreturn]] void Reset_Handler() {
  // Full access to the floating-point unit (CPACR: coprocessors 10 and 11) before anything may use it.
  auto* const cpacr = reinterpret_cast<volatile std::uint32_t*>(0xE000'ED88U);
  *cpacr = *cpacr | (0xFU << 20U);
  asm volatile("dsb\n isb" ::: "memory");

  const std::uint32_t* from = data_in_flash;
  for (std::uint32_t* to = data_begin; to != data_end; ++to, ++from) {
    *to = *from;
  }
  for (std::uint32_t* to = bss_begin; to != bss_end; ++to) {
    *to = 0;
  }
  gaitway::target::paint_stack();
  for (const Function* constructor = init_array_begin; constructor != init_array_end; ++constructor) {
    (*constructor)();
  }
  main();
  Unexpected_Handler();
  __builtin_unreachable();
}

}  // extern "C"

namespace {

constexpr std::size_t kSystemExceptions = 16;
constexpr std::size_t kCan1ReceiveInterrupt = 20;  // CAN1_RX0 of the STM32F405

struct VectorTable {
  const void* initial_stack = stack_top;
  Function exceptions[kSystemExceptions - 1] = {
      Reset_Handler,
      Unexpected_Handler,  // NMI
      HardFault_Handler,
      Unexpected_Handler,  // memory management
      Unexpected_Handler,  // bus fault
      Unexpected_Handler,  // usage fault
      nullptr,
      nullptr,
      nullptr,
      nullptr,
      Unexpected_Handler,  // SVCall
      Unexpected_Handler,  // debug monitor
      nullptr,
      PendSV_Handler,
      SysTick_Handler,
  };
  Function interrupts[kCan1ReceiveInterrupt + 1] = {
      Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler,
      Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler,
      Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler,
      Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler, Unexpected_Handler,
      CanReceive_Handler,
  };
};

[[gnu::used, gnu::section(".vectors")]] constinit const VectorTable vector_table{};

}  // namespace
