// The message controller's transmit queue: always offers the frame of highest priority (lowest identifier) to
// the bus; frames of one identifier keep their order. Fixed capacity, no allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::msgcontroller {

class TransmitQueue {
 public:
  static constexpr std::size_t kCapacity = 256;  // two batches of 64 joints with room for repairs

  // False, and counted, when the queue is full.
  bool push(const can::Frame& frame) noexcept { return insert(frame, order_++); }
  // Puts a frame back before all others of its identifier.
  bool push_front(const can::Frame& frame) noexcept { return insert(frame, 0); }

  // Moves the most urgent frame into `frame`; false when the queue is empty.
  bool pop(can::Frame& frame) noexcept {
    if (size_ == 0) {
      return false;
    }
    std::pop_heap(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(size_), comes_later);
    frame = entries_[--size_].frame;
    return true;
  }

  // Past every identifier when the queue is empty.
  [[nodiscard]] std::uint32_t next_id() const noexcept { return size_ == 0 ? 0xFFFF : entries_[0].frame.id; }
  void clear() noexcept { size_ = 0; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }

 private:
  struct Entry {
    std::uint64_t rank = 0;  // identifier, then order of arrival
    can::Frame frame;
  };
  bool insert(const can::Frame& frame, std::uint64_t order) noexcept {
    if (size_ == kCapacity) {
      ++refused_;
      return false;
    }
    entries_[size_++] = Entry{(std::uint64_t{frame.id} << 48U) | order, frame};
    std::push_heap(entries_.begin(), entries_.begin() + static_cast<std::ptrdiff_t>(size_), comes_later);
    return true;
  }
  static bool comes_later(const Entry& a, const Entry& b) noexcept { return a.rank > b.rank; }

  std::array<Entry, kCapacity> entries_{};
  std::size_t size_ = 0;
  std::uint64_t order_ = 1;
  std::uint64_t refused_ = 0;
};

}  // namespace gaitway::msgcontroller
