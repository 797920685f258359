// Numbers as they lie on the wire: least significant byte first, without gaps.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <type_traits>

namespace gaitway::link {

// What does not fit is left out, and ok() tells.
class ByteWriter {
 public:
  explicit ByteWriter(std::span<std::uint8_t> room) noexcept : room_(room) {}

  template <std::integral T>
  ByteWriter& put(T value) noexcept {
    auto bits = static_cast<std::uint64_t>(static_cast<std::make_unsigned_t<T>>(value));
    if (fits(sizeof(T))) {
      for (std::size_t i = 0; i < sizeof(T); ++i, bits >>= 8U) {
        room_[size_++] = static_cast<std::uint8_t>(bits);
      }
    }
    return *this;
  }
  ByteWriter& put(std::span<const std::uint8_t> bytes) noexcept {
    if (fits(bytes.size())) {
      std::ranges::copy(bytes, room_.begin() + static_cast<std::ptrdiff_t>(size_));
      size_ += bytes.size();
    }
    return *this;
  }
  [[nodiscard]] bool ok() const noexcept { return ok_; }
  [[nodiscard]] std::size_t size() const noexcept { return ok_ ? size_ : 0; }

 private:
  bool fits(std::size_t bytes) noexcept { return ok_ = ok_ && room_.size() - size_ >= bytes; }

  std::span<std::uint8_t> room_;
  std::size_t size_ = 0;
  bool ok_ = true;
};

// What is lacking is read as zeros, and ok() tells.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::uint8_t> bytes) noexcept : rest_(bytes) {}

  template <std::integral T>
  T get() noexcept {
    std::uint64_t bits = 0;
    const std::span<const std::uint8_t> bytes = get_bytes(sizeof(T));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      bits |= std::uint64_t{bytes[i]} << (8 * i);
    }
    return static_cast<T>(bits);
  }
  template <std::integral T>
  ByteReader& get(T& value) noexcept {
    value = get<T>();
    return *this;
  }
  // Exactly so many, or none.
  std::span<const std::uint8_t> get_bytes(std::size_t count) noexcept {
    ok_ = ok_ && rest_.size() >= count;
    if (!ok_) {
      return {};
    }
    const auto front = rest_.first(count);
    rest_ = rest_.subspan(count);
    return front;
  }
  std::span<const std::uint8_t> get_rest() noexcept { return get_bytes(rest_.size()); }
  [[nodiscard]] bool ok() const noexcept { return ok_; }
  // All was there, and nothing is left.
  [[nodiscard]] bool ended() const noexcept { return ok_ && rest_.empty(); }

 private:
  std::span<const std::uint8_t> rest_;
  bool ok_ = true;
};

}  // namespace gaitway::link
