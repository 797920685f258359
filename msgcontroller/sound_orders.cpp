// By the limits of their types.
#include "sound_orders.hpp"

#include <algorithm>
#include <cstring>

namespace gaitway::msgcontroller {
namespace {

template <class Order>
bool numbers_within_limits(const Order& order) noexcept {
  const auto* const bytes = reinterpret_cast<const unsigned char*>(&order);
  return std::ranges::all_of(TopicType<Order>::fields, [bytes](const FieldDescriptor& field) {
    if (field.type != ScalarType::float64_value) return true;
    for (std::uint32_t i = 0; i < field.elements(); ++i) {
      double value = 0.0;
      std::memcpy(&value, bytes + field.offset + i * sizeof value, sizeof value);
      if (!(value >= field.lowest && value <= field.highest)) return false;  // so for NaN, too
    }
    return true;
  });
}

}  // namespace

WalkCommand stand() noexcept {
  return {};
}

WalkCommand made_sound(WalkCommand walk, std::int64_t now_ns) noexcept {
  const bool over = walk.valid_until_ns != 0 && now_ns >= walk.valid_until_ns;
  return over || !numbers_within_limits(walk) ? stand() : walk;
}

MotionRequest made_sound(MotionRequest motion) noexcept {
  motion.name[sizeof motion.name - 1] = 0;
  return motion;
}

bool is_sensible(const HeadCommand& head) noexcept {
  return head.mode <= head_command::mode::hold && numbers_within_limits(head);
}

bool leaves(const MotionRequest& motion) noexcept {
  return motion.name[0] == 0;
}

}  // namespace gaitway::msgcontroller
