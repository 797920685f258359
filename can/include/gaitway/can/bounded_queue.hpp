// A queue for records that are worth reading but not worth stopping for. Fixed capacity, no allocation.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace gaitway::can {

// When it is full, the oldest gives way and is counted.
template <class Record, std::size_t kSize>
class BoundedQueue {
 public:
  void push(const Record& record) noexcept {
    if (count_ == kSize) {
      first_ = (first_ + 1) % kSize;
      --count_;
      ++dropped_;
    }
    records_[(first_ + count_++) % kSize] = record;
  }
  std::optional<Record> pop() noexcept {
    if (count_ == 0) {
      return std::nullopt;
    }
    const Record& record = records_[first_];
    first_ = (first_ + 1) % kSize;
    --count_;
    return record;
  }
  [[nodiscard]] std::uint64_t dropped() const noexcept { return dropped_; }

 private:
  std::array<Record, kSize> records_{};
  std::size_t first_ = 0;
  std::size_t count_ = 0;
  std::uint64_t dropped_ = 0;
};

}  // namespace gaitway::can
