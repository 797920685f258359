// Frames that wait for the bus, the one that would win arbitration first; frames of one identifier and format
// keep their order. Fixed capacity, no allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>

#include "gaitway/can/frame.hpp"

namespace gaitway::can {

class FrameHeap {
 public:
  static constexpr std::size_t kCapacity = 256;

  // False, and nothing changes, when it is full.
  bool push(const Frame& frame) noexcept {
    if (size_ == kCapacity) {
      return false;
    }
    entries_[size_++] = {arbitration_key(frame), next_order_++, frame};
    std::push_heap(entries_.data(), entries_.data() + size_, comes_later);
    return true;
  }
  // The most urgent frame; only while there is one.
  [[nodiscard]] const Frame& top() const noexcept { return entries_[0].frame; }
  void pop() noexcept {
    std::pop_heap(entries_.data(), entries_.data() + size_, comes_later);
    --size_;
  }
  // Returns how many frames it dropped.
  std::size_t clear() noexcept { return std::exchange(size_, 0); }

  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }

 private:
  struct Entry {
    std::uint32_t key = 0;
    std::uint64_t order = 0;
    Frame frame;
  };
  static bool comes_later(const Entry& a, const Entry& b) noexcept {
    return std::pair(a.key, a.order) > std::pair(b.key, b.order);
  }

  std::array<Entry, kCapacity> entries_{};
  std::size_t size_ = 0;
  std::uint64_t next_order_ = 0;
};

}  // namespace gaitway::can
