// The leaves that the user of the library writes: conditions and actions, and what they are given when
// called.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>

#include "gaitway/behaviour/description.hpp"
#include "gaitway/behaviour/node_type.hpp"
#include "gaitway/behaviour/value.hpp"

namespace gaitway::behaviour {

// The time and the ports of one leaf, for the length of one call. Ports count in the order of the LeafSpec.
class Call {
 public:
  Call(std::int64_t now_ns, std::span<const PortBinding> ports, std::span<const Value> constants,
       std::span<Value> values, std::span<const Entry> entries) noexcept
      : now_ns_(now_ns), ports_(ports), constants_(constants), values_(values), entries_(entries) {}

  // As given to Tree::tick().
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }

  // std::monostate where the entry has never been set, or the port is none or not connected.
  [[nodiscard]] const Value& value(std::size_t port) const noexcept;
  // The same as one type: bool, std::int64_t, double or Text; nothing where the port holds no such value.
  template <class T>
  [[nodiscard]] std::optional<T> get(std::size_t port) const noexcept {
    const T* const found = std::get_if<T>(&value(port));
    return found != nullptr ? std::optional<T>(*found) : std::nullopt;
  }

  // Writes the entry that the port is connected with. False, and nothing written: the value is not of the
  // entry's type, or the port is not connected or no output.
  bool set(std::size_t port, const Value& value) noexcept;

 private:
  std::int64_t now_ns_;
  std::span<const PortBinding> ports_;
  std::span<const Value> constants_;
  std::span<Value> values_;
  std::span<const Entry> entries_;
};

// Tells at once whether something holds.
class Condition {
 public:
  Condition() = default;
  virtual ~Condition() = default;
  Condition(const Condition&) = delete;
  Condition& operator=(const Condition&) = delete;

  [[nodiscard]] virtual bool holds(Call& call) noexcept = 0;
};

// Does something that may take many ticks. The calls of one run: on_start(), then on_running() once a tick as
// long as the answer is `running`; or, in place of the next on_running(), on_halt() exactly once, and then
// on_halting() once a tick until it says that the end is reached. No other call comes in between.
class Action {
 public:
  enum class Halt : std::uint8_t {
    ended,
    ending  // it takes more ticks; on_halting() will be called
  };

  Action() = default;
  virtual ~Action() = default;
  Action(const Action&) = delete;
  Action& operator=(const Action&) = delete;

  [[nodiscard]] virtual Outcome on_start(Call& call) noexcept = 0;
  [[nodiscard]] virtual Outcome on_running(Call& call) noexcept = 0;
  [[nodiscard]] virtual Halt on_halt(Call& call) noexcept = 0;
  [[nodiscard]] virtual Halt on_halting(Call& call) noexcept;  // ended
};

}  // namespace gaitway::behaviour
