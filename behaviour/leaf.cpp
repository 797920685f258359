// How leaves reach their ports.
#include "gaitway/behaviour/leaf.hpp"

namespace gaitway::behaviour {

const Value& Call::value(std::size_t port) const noexcept {
  static const Value kNothing{};
  if (port >= ports_.size()) return kNothing;
  const PortBinding& binding = ports_[port];
  switch (binding.source) {
    case PortBinding::Source::constant:
      return constants_[binding.index];
    case PortBinding::Source::entry:
      return values_[binding.index];
    case PortBinding::Source::none:
      break;
  }
  return kNothing;
}

bool Call::set(std::size_t port, const Value& value) noexcept {
  if (port >= ports_.size() || !ports_[port].writable) return false;
  const std::uint32_t index = ports_[port].index;
  if (!fits(value, entries_[index].type)) return false;
  values_[index] = value;
  return true;
}

Action::Halt Action::on_halting(Call&) noexcept {
  return Halt::ended;
}

}  // namespace gaitway::behaviour
