// One joint on a board: connects the interrupts of a microcontroller to the joint's controller. A builder
// writes the port (encoder, motor, CAN mailbox, counter, watchdog) and calls three functions from interrupts:
//
//   interrupt           priority   calls                 may interrupt
//   CAN receive         high       on_frame_received()   everything
//   1 ms timer          low        on_servo_tick()       the main program
//   pended by software  low        on_work()             the main program
//
// The two of low priority never interrupt each other, so the controller is used by one of them at a time and
// needs no lock. Between the CAN interrupt and them stands a queue. No heap, no exceptions, no virtual calls.
#pragma once

#include <concepts>
#include <cstdint>

#include "gaitway/can/frame.hpp"
#include "gaitway/firmware/frame_queue.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::firmware {

// What a builder supplies. Only ticks() is called from both priorities.
template <class Port>
concept JointPort = requires(Port& port, localcontroller::JointSensors& sensors, const can::Frame& frame) {
  // A counter of 32 bits that runs freely and wraps; less than one wrap lies between two servo ticks.
  { port.ticks() }
  noexcept->std::same_as<std::uint32_t>;
  { Port::kTick_ns } -> std::convertible_to<std::int64_t>;  // a whole number of nanoseconds
  // The encoder, the sensor channels in the units of the configuration's scales, and the motor's current.
  { port.read(sensors) }
  noexcept->std::same_as<void>;
  { port.set_torque_Nm(0.0) }
  noexcept->std::same_as<void>;
  // One transmit mailbox; true as long as the last frame has neither been sent nor given up.
  { port.transmit_busy() }
  noexcept->std::same_as<bool>;
  { port.transmit(frame) }
  noexcept->std::same_as<void>;
  { port.feed_watchdog() }
  noexcept->std::same_as<void>;
};

// The configuration of a joint that wakes where it is and not where it was left: its reference begins at the
// angle that the (absolute) encoder says.
[[nodiscard]] inline localcontroller::JointConfig held_where_found(localcontroller::JointConfig config,
                                                                   std::int32_t encoder_count) noexcept {
  const double count =
      (encoder_count * config.encoder_count_rad - config.encoder_zero_rad) / config.count_rad;
  config.initial_reference_count = static_cast<std::int32_t>(count < 0.0 ? count - 0.5 : count + 0.5);
  return config;
}

template <JointPort Port>
class Joint {
 public:
  // The port must outlive the joint. Interrupts are enabled after this.
  Joint(const localcontroller::JointConfig& config, Port& port) noexcept
      : port_(port), controller_(held_where_found(config, found_at(port))), last_ticks_(port.ticks()) {}

  // CAN receive interrupt: notes the time and stores the frame. Pend on_work() after it.
  void on_frame_received(const can::Frame& frame) noexcept { received_.push({frame, port_.ticks()}); }

  // Low priority, soon after a frame was received or sent: takes in what came and offers the next frame, so
  // that a SYNC is answered, and the torque taken away by an emergency stop, without waiting for the next
  // servo tick.
  void on_work() noexcept {
    take_received();
    if (controller_.state() == can::JointState::soft) {
      port_.set_torque_Nm(0.0);
    }
    offer_frame();
  }

  // Low priority, every millisecond.
  void on_servo_tick() noexcept {
    take_received();
    localcontroller::JointSensors sensors;
    port_.read(sensors);
    controller_ns_ = now_ns();
    port_.set_torque_Nm(controller_.step(controller_ns_, sensors));
    offer_frame();
    port_.feed_watchdog();
  }

  // Low priority: ends an emergency stop by the user's order. The joint holds where it is.
  void reset() noexcept { controller_.reset(); }

  // Low priority, or with it masked.
  [[nodiscard]] const localcontroller::JointController& controller() const noexcept { return controller_; }
  // Any context: received frames that found the queue full, because low priority was held up.
  [[nodiscard]] std::uint32_t dropped_frames() const noexcept { return received_.dropped(); }

 private:
  // The bus carries at most 22 frames a millisecond (47 bits each): room for a servo tick that is half a
  // period late.
  static constexpr std::size_t kQueueCapacity = 32;

  static std::int32_t found_at(Port& port) noexcept {
    localcontroller::JointSensors sensors;
    port.read(sensors);
    return sensors.encoder_count;
  }

  // Extends the wrapping counter.
  std::int64_t now_ns() noexcept {
    const std::uint32_t ticks = port_.ticks();
    now_ns_ += std::int64_t{ticks - last_ticks_} * Port::kTick_ns;
    last_ticks_ = ticks;
    return now_ns_;
  }

  void take_received() noexcept {
    ReceivedFrame received;
    while (received_.pop(received)) {
      const std::int64_t now = now_ns();  // read after the frame's own reading
      const std::int64_t came_ns = now - std::int64_t{last_ticks_ - received.ticks} * Port::kTick_ns;
      // One that came between a servo tick's last look at the queue and its step counts as coming after it.
      controller_ns_ = came_ns > controller_ns_ ? came_ns : controller_ns_;
      controller_.on_frame(received.frame, controller_ns_);
    }
  }

  void offer_frame() noexcept {
    can::Frame frame;
    if (!port_.transmit_busy() && controller_.take_frame(frame)) {
      port_.transmit(frame);
    }
  }

  Port& port_;
  localcontroller::JointController controller_;
  FrameQueue<kQueueCapacity> received_;
  std::int64_t now_ns_ = 0;
  std::int64_t controller_ns_ = 0;  // what the controller was told last; its time never runs backwards
  std::uint32_t last_ticks_;
};

}  // namespace gaitway::firmware
