// The firmware of one joint: configuration, interrupts, and a main program that starts them. Interrupt
// priorities follow gaitway/firmware/joint.hpp; SysTick is the servo's timer.
#include <atomic>
#include <cstdint>
#include <optional>

#include "gaitway/facts/facts.hpp"
#include "gaitway/firmware/joint.hpp"
#include "gaitway_target/core_registers.hpp"
#include "gaitway_target/emulated_board.hpp"
#include "gaitway_target/joint_firmware.hpp"

namespace gaitway::target {
namespace {

constexpr std::uint8_t kHighPriority = 0x40, kLowPriority = 0x80;
constexpr std::uint32_t kServoRate_Hz = facts::kSecond_ns / localcontroller::kServoPeriod_ns;

struct Firmware {
  EmulatedBoard board;
  firmware::Joint<EmulatedBoard> joint{joint_configuration(), board};
};
std::optional<Firmware> running;  // made before interrupts are enabled, and never again

}  // namespace

localcontroller::JointConfig joint_configuration() noexcept {
  localcontroller::JointConfig config;
  config.node = 5;
  config.count_rad = 0.05 * facts::kRadPerDegree;
  config.encoder_count_rad = 360.0 / 200'000.0 * facts::kRadPerDegree;
  config.stiffness_Nm_per_rad = 300.0;
  config.damping_Nms_per_rad = 4.0;
  config.torque_limit_Nm = 8.0;
  config.speed_limit_rad_per_s = 8.0;
  config.lower_rad = -60.0 * facts::kRadPerDegree;
  config.upper_rad = 60.0 * facts::kRadPerDegree;
  config.trim_channel = 4;
  config.trim_count_rad = 0.05 * facts::kRadPerDegree;
  config.trim_slew_rad_per_s = 200.0 * facts::kRadPerDegree;
  config.trim_limit_rad = 6.35 * facts::kRadPerDegree;
  config.channel_scale[0] = config.channel_scale[1] = 0.01F;  // N
  return config;
}

std::uint32_t dropped_frames() noexcept {
  return running->joint.dropped_frames();
}

}  // namespace gaitway::target

extern "C" void CanReceive_Handler() {
  gaitway::target::running->joint.on_frame_received(gaitway::target::running->board.received());
  gaitway::target::pend_low_priority_work();
}
extern "C" void PendSV_Handler() {
  gaitway::target::running->joint.on_work();
}
extern "C" void SysTick_Handler() {
  gaitway::target::running->joint.on_servo_tick();
}

int main() {
  using namespace gaitway::target;
  running.emplace();
  std::atomic_signal_fence(std::memory_order_seq_cst);  // the interrupts find a whole object
  set_interrupt_priority(kCanReceiveInterrupt, kHighPriority);
  set_system_priority(kPendSv, kLowPriority);
  set_system_priority(kSysTick, kLowPriority);
  systick_reload() = kProcessorClock_Hz / kServoRate_Hz - 1U;
  systick_value() = 0;
  systick_control() = kSystickInterrupts;
  enable_interrupt(kCanReceiveInterrupt);
  while (true) {
    between_interrupts();
  }
}
