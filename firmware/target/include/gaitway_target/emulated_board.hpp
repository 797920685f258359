// The board that QEMU's STM32F405 lacks around its processor: encoder, sensors, motor, CAN controller and
// watchdog as one block of registers in memory, so that a test can stand at the other side of each. On real
// hardware this file is what a builder replaces by drivers; docs/hardware.md says what each must do.
#pragma once

#include <cstdint>

#include "gaitway/can/frame.hpp"
#include "gaitway/firmware/joint.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"
#include "gaitway_target/core_registers.hpp"

namespace gaitway::target {

// A CAN message object as controllers have it: identifier and size, then the data in two words.
struct MessageObject {
  std::uint32_t id_and_size = 0;  // identifier << 4 | size
  std::uint32_t low = 0, high = 0;
};

inline void put_frame(const can::Frame& frame, volatile MessageObject& into) noexcept {
  std::uint32_t words[2] = {0, 0};
  for (std::size_t byte = 0; byte < frame.data.size(); ++byte) {
    words[byte / 4] |= std::uint32_t{frame.data[byte]} << (8U * (byte % 4U));
  }
  into.id_and_size = frame.id << 4U | frame.size;
  into.low = words[0];
  into.high = words[1];
}
[[nodiscard]] inline can::Frame frame_in(const volatile MessageObject& object) noexcept {
  can::Frame frame;
  const std::uint32_t id_and_size = object.id_and_size;
  frame.id = id_and_size >> 4U;
  frame.size = static_cast<std::uint8_t>(id_and_size & 0xFU);
  const std::uint32_t words[2] = {object.low, object.high};
  for (std::size_t byte = 0; byte < frame.data.size(); ++byte) {
    frame.data[byte] = static_cast<std::uint8_t>(words[byte / 4] >> (8U * (byte % 4U)));
  }
  return frame;
}

struct BoardRegisters {
  std::int32_t encoder_count = 0;
  float channel[can::kFeedbackChannels] = {0.0F, 0.0F};
  float motor_current_Nm = 0.0F;
  float torque_Nm = 0.0F;
  MessageObject received{};
  MessageObject transmit{};
  std::uint32_t transmit_requested = 0;  // 1 until the frame is on the bus
  std::uint32_t watchdog_key = 0;
};
inline constexpr std::uint32_t kWatchdogReload = 0xAAAA;  // what the STM32's independent watchdog wants

extern volatile BoardRegisters board_registers;

class EmulatedBoard {
 public:
  static constexpr std::int64_t kTick_ns = 1000;

  // Starts the counter: TIM2, 32 bits, 1 MHz.
  EmulatedBoard() noexcept {
    core_register(kTim2 + kPrescaler) = kTimerClock_Hz / 1'000'000U - 1U;
    core_register(kTim2 + kEvent) = 1;  // takes the prescaler over
    core_register(kTim2 + kControl) = 1;
  }
  [[nodiscard]] std::uint32_t ticks() const noexcept { return core_register(kTim2 + kCounter); }

  void read(localcontroller::JointSensors& sensors) const noexcept {
    sensors.encoder_count = board_registers.encoder_count;
    for (int channel = 0; channel < can::kFeedbackChannels; ++channel) {
      sensors.channel[channel] = board_registers.channel[channel];
    }
    sensors.motor_current_Nm = board_registers.motor_current_Nm;
  }
  void set_torque_Nm(double torque_Nm) const noexcept {
    board_registers.torque_Nm = static_cast<float>(torque_Nm);
  }
  [[nodiscard]] bool transmit_busy() const noexcept { return board_registers.transmit_requested != 0; }
  void transmit(const can::Frame& frame) const noexcept {
    put_frame(frame, board_registers.transmit);
    board_registers.transmit_requested = 1;
  }
  void feed_watchdog() const noexcept { board_registers.watchdog_key = kWatchdogReload; }

  // What the CAN interrupt finds.
  [[nodiscard]] can::Frame received() const noexcept { return frame_in(board_registers.received); }

 private:
  static constexpr std::uintptr_t kTim2 = 0x4000'0000U;
  static constexpr std::uintptr_t kControl = 0x00, kEvent = 0x14, kCounter = 0x24, kPrescaler = 0x28;
  static constexpr std::uint32_t kTimerClock_Hz = 1'000'000'000;  // of the emulator; a real board has 84 MHz
};
static_assert(firmware::JointPort<EmulatedBoard>);

}  // namespace gaitway::target
