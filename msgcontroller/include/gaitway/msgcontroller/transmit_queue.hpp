// The message controller's transmit queue: always offers the frame of highest priority (lowest identifier) to
// the bus; frames of one identifier keep their order. A frame whose transmit deadline has passed is dropped:
// stale, it would do more harm than good. Fixed capacity, no allocation.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

#include "gaitway/can/frame.hpp"

namespace gaitway::msgcontroller {

inline constexpr std::int64_t kNeverExpires_ns = std::numeric_limits<std::int64_t>::max();

class TransmitQueue {
 public:
  static constexpr std::size_t kCapacity = 640;  // two batches and a tail of 64 joints, repairs

  // False, and counted, when the queue is full.
  bool push(const can::Frame& frame, std::int64_t expires_ns = kNeverExpires_ns) noexcept {
    return insert({order_++ | rank_of(frame), expires_ns, frame});
  }
  // Puts the frame that was taken last back before all others of its identifier.
  bool push_front(const can::Frame& frame) noexcept {
    return insert({rank_of(frame), taken_expires_ns_, frame});
  }

  // Moves the most urgent frame into `frame`; false when the queue is empty.
  bool pop(can::Frame& frame) noexcept {
    if (size_ == 0) {
      return false;
    }
    std::pop_heap(entries_.begin(), end(), comes_later);
    frame = entries_[--size_].frame;
    taken_expires_ns_ = entries_[size_].expires_ns;
    return true;
  }

  // Drops what should have been sent before `now_ns`; how many frames.
  std::size_t expire(std::int64_t now_ns) noexcept {
    return now_ns < earliest_expiry_ns_
               ? 0
               : drop([now_ns](const Entry& entry) { return entry.expires_ns <= now_ns; });
  }
  // Drops the frames with identifiers from `first` to `last`, which something newer makes useless; how many.
  std::size_t drop_identifiers(std::uint32_t first, std::uint32_t last) noexcept {
    return drop(
        [first, last](const Entry& entry) { return entry.frame.id >= first && entry.frame.id <= last; });
  }
  // Drops everything; how many frames.
  std::size_t clear() noexcept {
    const std::size_t dropped = size_;
    size_ = 0;
    earliest_expiry_ns_ = kNeverExpires_ns;
    return dropped;
  }

  // Past every identifier when the queue is empty.
  [[nodiscard]] std::uint32_t next_id() const noexcept { return size_ == 0 ? 0xFFFF : entries_[0].frame.id; }
  [[nodiscard]] bool empty() const noexcept { return size_ == 0; }
  [[nodiscard]] std::size_t size() const noexcept { return size_; }
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }

 private:
  struct Entry {
    std::uint64_t rank = 0;  // identifier, then order of arrival
    std::int64_t expires_ns = kNeverExpires_ns;
    can::Frame frame;
  };
  template <class Predicate>
  std::size_t drop(const Predicate& useless) noexcept {
    const auto kept = std::remove_if(entries_.begin(), end(), useless);
    const auto dropped = static_cast<std::size_t>(end() - kept);
    size_ -= dropped;
    std::make_heap(entries_.begin(), end(), comes_later);
    earliest_expiry_ns_ = kNeverExpires_ns;
    for (std::size_t i = 0; i < size_; ++i) {
      earliest_expiry_ns_ = std::min(earliest_expiry_ns_, entries_[i].expires_ns);
    }
    return dropped;
  }
  static std::uint64_t rank_of(const can::Frame& frame) noexcept { return std::uint64_t{frame.id} << 48U; }
  static bool comes_later(const Entry& a, const Entry& b) noexcept { return a.rank > b.rank; }
  [[nodiscard]] std::array<Entry, kCapacity>::iterator end() noexcept {
    return entries_.begin() + static_cast<std::ptrdiff_t>(size_);
  }
  bool insert(const Entry& entry) noexcept {
    if (size_ == kCapacity) {
      ++refused_;
      return false;
    }
    entries_[size_++] = entry;
    earliest_expiry_ns_ = std::min(earliest_expiry_ns_, entry.expires_ns);
    std::push_heap(entries_.begin(), end(), comes_later);
    return true;
  }

  std::array<Entry, kCapacity> entries_{};
  std::size_t size_ = 0;
  std::uint64_t order_ = 1;
  std::int64_t earliest_expiry_ns_ = kNeverExpires_ns;
  std::int64_t taken_expires_ns_ = kNeverExpires_ns;  // of the frame that was popped last
  std::uint64_t refused_ = 0;
};

}  // namespace gaitway::msgcontroller
