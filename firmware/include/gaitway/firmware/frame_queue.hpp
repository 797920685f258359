// Received frames on their way from the CAN interrupt to the servo's priority level: one writer, one reader,
// neither ever waits. Freestanding.
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::firmware {

struct ReceivedFrame {
  can::Frame frame;
  std::uint32_t ticks = 0;  // of the board's free-running counter, at reception
};

// `Capacity` is a power of two. The writer may interrupt the reader at any instruction, or run beside it on
// another core.
template <std::size_t Capacity>
class FrameQueue {
  static_assert(Capacity >= 2 && (Capacity & (Capacity - 1)) == 0, "the capacity is a power of two");

 public:
  // Writer only. False when the queue is full: the frame is dropped and counted.
  bool push(const ReceivedFrame& received) noexcept {
    const std::uint32_t written = written_.load(std::memory_order_relaxed);  // nobody else writes it
    // Acquire: the reader has copied the place's old frame before it said so.
    if (written - read_.load(std::memory_order_acquire) == Capacity) {
      dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
      return false;
    }
    frames_[written % Capacity] = received;
    written_.store(written + 1, std::memory_order_release);  // the frame is there before its number
    return true;
  }

  // Reader only. False when the queue is empty.
  bool pop(ReceivedFrame& received) noexcept {
    const std::uint32_t read = read_.load(std::memory_order_relaxed);
    if (written_.load(std::memory_order_acquire) == read) {
      return false;
    }
    received = frames_[read % Capacity];
    read_.store(read + 1, std::memory_order_release);  // copied: the place is free
    return true;
  }

  // Any context.
  [[nodiscard]] std::uint32_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
  std::array<ReceivedFrame, Capacity> frames_{};
  std::atomic<std::uint32_t> written_{0}, read_{0};  // frames so far; both wrap
  std::atomic<std::uint32_t> dropped_{0};
};

}  // namespace gaitway::firmware
