// Values that ports and blackboard entries hold, their types, and how they are written in XML.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace gaitway::behaviour {

enum class ValueKind : std::uint8_t {
  any,      // whatever the blackboard entry holds that it is connected with
  boolean,  // "true", "false", "1", "0"
  integer,
  number,    // with a unit where the port has one: "0.5 m"
  text,      // at most Text::kMost bytes
  choice,    // one of some names
  duration,  // "0.5 s", "200 ms"; a whole number alone counts milliseconds, as BehaviorTree.CPP has it
};
[[nodiscard]] std::string_view name(ValueKind kind) noexcept;

// A short text that is copied without asking for memory.
class Text {
 public:
  static constexpr std::size_t kMost = 127;

  Text() = default;
  // Cuts off what is longer than kMost bytes.
  explicit Text(std::string_view text) noexcept;
  [[nodiscard]] std::string_view view() const noexcept { return {bytes_.data(), size_}; }
  friend bool operator==(const Text& a, const Text& b) noexcept { return a.view() == b.view(); }

 private:
  std::array<char, kMost> bytes_{};
  std::uint8_t size_ = 0;
};

// Nothing; boolean; integer, choice (the place among its names) and duration (ns); number (in the port's
// unit); text.
using Value = std::variant<std::monostate, bool, std::int64_t, double, Text>;

struct ValueType {
  ValueKind kind = ValueKind::any;
  // Of a number: "m", "rad", "s", "m/s", "rad/s", "N", "N s", "kg", "%"; empty: it has none. What is written
  // must name it, or one that is converted to it ("30 deg", "20 mm").
  std::string unit{};
  std::vector<std::string> choices{};
  double lowest = -std::numeric_limits<double>::infinity();  // of a number (in its unit) or an integer
  double highest = std::numeric_limits<double>::infinity();
};

// Whether an entry of one type can be read or written as the other: kind, unit and names are the same.
[[nodiscard]] bool same_type(const ValueType& a, const ValueType& b) noexcept;
// "number in m", "one of slow, fast".
[[nodiscard]] std::string describe(const ValueType& type);
// Whether the value is one of this type. What has no value is none.
[[nodiscard]] bool fits(const Value& value, const ValueType& type) noexcept;

// A value as it is written in XML; of `any`, text. Throws input::ValueError.
[[nodiscard]] Value parse_value(std::string_view text, const ValueType& type);
// The value as parse_value() reads it.
[[nodiscard]] std::string written(const Value& value, const ValueType& type);

// Whether parse_value() knows that unit of a number.
[[nodiscard]] bool is_known_unit(std::string_view unit) noexcept;

}  // namespace gaitway::behaviour
