// The joint's firmware on the emulated board: joint_main.cpp has its interrupts and configuration.
#pragma once

#include <cstdint>

#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::target {

inline constexpr std::uint32_t kCanReceiveInterrupt = 20;  // CAN1_RX0 of the STM32F405

// A builder keeps this in flash, one for each joint. Here: the left ankle pitch of humanoid22.
[[nodiscard]] localcontroller::JointConfig joint_configuration() noexcept;

// Received frames that the joint had no room for.
[[nodiscard]] std::uint32_t dropped_frames() noexcept;

// What the main program does between interrupts. The joint's own sleeps; a test's stands on the board's other
// side.
void between_interrupts() noexcept;

}  // namespace gaitway::target
