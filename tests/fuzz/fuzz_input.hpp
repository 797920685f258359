// The bytes that a fuzz target gets, taken piece by piece, and the way in which it says that a property does
// not hold. What a piece lacks at the end counts as zeros, so every input means something.
#pragma once

#include <algorithm>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>

namespace gaitway::fuzz {

class Input {
 public:
  explicit Input(std::span<const std::uint8_t> bytes) noexcept : rest_(bytes) {}

  // Little-endian.
  template <std::integral T>
  T take() noexcept {
    static_assert(!std::same_as<T, bool>, "use flag()");
    std::uint64_t value = 0;
    const std::span<const std::uint8_t> bytes = take_bytes(sizeof(T));
    for (std::size_t i = 0; i < bytes.size(); ++i) {
      value |= std::uint64_t{bytes[i]} << (8 * i);
    }
    return static_cast<T>(value);
  }
  float take_float() noexcept {
    const auto bits = take<std::uint32_t>();
    float value = 0.0F;
    std::memcpy(&value, &bits, sizeof value);
    return value;
  }
  bool flag() noexcept { return (take<std::uint8_t>() & 1U) != 0; }
  // 0 .. count - 1; count is not 0.
  std::size_t choose(std::size_t count) noexcept { return take<std::uint8_t>() % count; }

  // At most `most` bytes.
  std::span<const std::uint8_t> take_bytes(std::size_t most) noexcept {
    const auto front = rest_.first(std::min(most, rest_.size()));
    rest_ = rest_.subspan(front.size());
    return front;
  }
  std::string_view take_text(std::size_t most) noexcept {
    const auto bytes = take_bytes(most);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }
  std::string_view rest_as_text() noexcept { return take_text(rest_.size()); }
  [[nodiscard]] bool empty() const noexcept { return rest_.empty(); }
  [[nodiscard]] std::size_t size() const noexcept { return rest_.size(); }

 private:
  std::span<const std::uint8_t> rest_;
};

// A property of a target does not hold. No std::exception: the handlers under test must not swallow it.
struct BrokenProperty {
  std::string what;
};

inline void require(bool holds, std::string_view property) {
  if (!holds) {
    throw BrokenProperty{std::string(property)};
  }
}

}  // namespace gaitway::fuzz
