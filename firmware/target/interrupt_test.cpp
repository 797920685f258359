// The joint's firmware with its real interrupts, tested from the other side of the board's registers: runs as
// the main program between them. Exit code 0, or 1 with the check that failed.
#include <cstdint>

#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway_target/core_registers.hpp"
#include "gaitway_target/emulated_board.hpp"
#include "gaitway_target/joint_firmware.hpp"
#include "gaitway_target/semihosting.hpp"

namespace gaitway::target {

constexpr std::int32_t kPowerUpEncoderCount = -10'000;  // -18 degrees
volatile BoardRegisters board_registers{.encoder_count = kPowerUpEncoderCount};

namespace {

constexpr can::NodeId kNode = 5;

void check(bool holds, const char* what) {
  if (!holds) {
    print("failed: ");
    print(what);
    print("\n");
    exit(1);
  }
}

void barrier() {
  asm volatile("dsb\n isb" ::: "memory");
}

// Through the CAN interrupt; on_work() runs, unless it is masked, before this returns.
template <class Message>
void deliver(const Message& message) {
  put_frame(can::encode(can::kFullProfile, message), board_registers.received);
  pend_interrupt(kCanReceiveInterrupt);
  barrier();
}

// What the joint wants to send.
can::Frame sent_frame() {
  check(board_registers.transmit_requested != 0, "a frame is sent");
  return frame_in(board_registers.transmit);
}
can::Feedback sent_feedback() {
  const auto feedback = can::decode_feedback(can::kFullProfile, sent_frame());
  check(feedback.has_value() && feedback->node == kNode, "it is this joint's feedback");
  return *feedback;
}

// The bus has taken the frame: the transmit interrupt pends the joint's work.
void take_sent() {
  board_registers.transmit_requested = 0;
  pend_low_priority_work();
  barrier();
}

void wait_for_servo_ticks(int count) {
  for (int tick = 0; tick < count; ++tick) {
    board_registers.watchdog_key = 0;
    while (board_registers.watchdog_key != kWatchdogReload) {
    }
  }
}

void holds_where_it_was_found() {
  wait_for_servo_ticks(3);
  const float torque_Nm = board_registers.torque_Nm;
  check(torque_Nm > -0.14F && torque_Nm < 0.14F, "less than half a count's torque after power-up");
  const auto report = can::decode_fault_report(can::kFullProfile, sent_frame());
  check(report.has_value() && report->faults == static_cast<std::uint8_t>(can::Fault::restarted),
        "says that it has started");
  take_sent();
  wait_for_servo_ticks(20);
  check(board_registers.transmit_requested == 0, "silent before the first SYNC");
}

void answers_a_sync_without_waiting_for_the_servo_tick() {
  board_registers.watchdog_key = 0;
  deliver(can::Sync{.cycle = 1, .slot = 0});
  const bool before_tick = board_registers.watchdog_key == 0;
  const can::Feedback feedback = sent_feedback();
  check(before_tick, "answered at once");
  check(feedback.position == -3277, "-18 degrees in 1/65536 of a turn");
  check(feedback.state == can::JointState::holding, "holds");
  take_sent();
  check(board_registers.transmit_requested == 0, "one answer for one SYNC");
}

void leaves_a_frame_that_waits_for_the_bus_alone() {
  deliver(can::Sync{.cycle = 1, .slot = 1});
  board_registers.encoder_count = kPowerUpEncoderCount + 2000;
  wait_for_servo_ticks(9);
  deliver(can::Sync{.cycle = 1, .slot = 2});
  check(sent_feedback().position == -3277, "the first frame still waits");
  take_sent();
  check(sent_feedback().position == -2621, "then comes the next, with what is measured now");
  take_sent();
  board_registers.encoder_count = kPowerUpEncoderCount;
}

void plays_a_batch() {
  deliver(can::Trajectory{.node = kNode, .toggle = true, .delta = {10, 10, 10, 10, 10, 10, 10, 10}});
  deliver(can::Sync{.cycle = 2, .slot = 0, .batch_committed = true, .toggle = true});
  check(sent_feedback().state == can::JointState::running, "the batch runs");
  take_sent();
  wait_for_servo_ticks(8);
  check(board_registers.torque_Nm > 1.0F, "drives towards the first point");
}

// The bus carries the stop while the main program holds low priority up: it is not lost, and what does not
// fit is counted.
void keeps_what_comes_while_low_priority_is_held_up() {
  constexpr int kFrames = 40, kQueue = 32;
  constexpr std::uint32_t kLowPriority = 0x80;
  asm volatile("msr basepri, %0" ::"r"(kLowPriority) : "memory");
  deliver(can::EmergencyStop{.mode = can::StopMode::soft});
  for (int frame = 1; frame < kFrames; ++frame) {
    deliver(can::Heartbeat{.mode = 0, .cycle = 1});
  }
  asm volatile("msr basepri, %0" ::"r"(0) : "memory");
  wait_for_servo_ticks(1);
  check(board_registers.torque_Nm == 0.0F, "an emergency stop takes the torque away within one servo tick");
  check(dropped_frames() == kFrames - kQueue, "each dropped frame is counted");
  wait_for_servo_ticks(1);
  deliver(can::Sync{.cycle = 2, .slot = 1, .batch_committed = true, .toggle = true});
  check(sent_feedback().state == can::JointState::soft, "says that it is soft");
}

}  // namespace

void between_interrupts() noexcept {
  holds_where_it_was_found();
  answers_a_sync_without_waiting_for_the_servo_tick();
  leaves_a_frame_that_waits_for_the_bus_alone();
  plays_a_batch();
  keeps_what_comes_while_low_priority_is_held_up();
  print("stack_bytes ");
  print(static_cast<std::uint32_t>(deepest_stack_bytes()));
  print("\n");
  exit(0);
}

}  // namespace gaitway::target

extern "C" void HardFault_Handler() {
  gaitway::target::exit(12);
}
