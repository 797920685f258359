// Orders get their numbers and stamps here.
#include "gaitway/behaviour_leaves/orders.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>

namespace gaitway::behaviour_leaves {
namespace {

// Numbers come out of the time, so that a plug-in that has been started anew gives none again.
constexpr std::int64_t kNumberEvery_ns = 10'000'000;

}  // namespace

void Orders::begin(std::int64_t now_ns) noexcept {
  now_ns_ = now_ns;
  walking_.reset();
  way_.reset();
  motion_.reset();
  head_.reset();
  said_ = 0;
}

std::uint32_t Orders::next_number() noexcept {
  const auto by_time = static_cast<std::uint32_t>(now_ns_ / kNumberEvery_ns) & ~kBehaviourNumber;
  last_number_ = kBehaviourNumber | std::max(by_time, (last_number_ & ~kBehaviourNumber) + 1);
  return last_number_;
}

void Orders::walk(const Velocity& velocity) noexcept {
  walking_ = velocity;
}

std::uint32_t Orders::walk_to(const Pose& goal_in_world) noexcept {
  way_number_ = next_number();
  way_ = WalkToRequest{};
  way_->stamp_ns = now_ns_;
  way_->number = way_number_;
  way_->goal[0] = goal_in_world.x_m;
  way_->goal[1] = goal_in_world.y_m;
  way_->goal[2] = wrapped_rad(goal_in_world.yaw_rad);
  return way_number_;
}

std::uint32_t Orders::cancel_way() noexcept {
  way_number_ = next_number();
  way_ = WalkToRequest{};
  way_->stamp_ns = now_ns_;
  way_->number = way_number_;
  way_->cancel = 1;
  return way_number_;
}

std::uint32_t Orders::play(std::string_view motion) noexcept {
  motion_number_ = next_number();
  motion_ = MotionRequest{};
  motion_->stamp_ns = now_ns_;
  motion_->number = motion_number_;
  std::memcpy(motion_->name, motion.data(), std::min(motion.size(), sizeof motion_->name - 1));
  return motion_number_;
}

std::uint32_t Orders::leave_motion() noexcept {
  return play("");
}

std::uint32_t Orders::look(HeadCommand command) noexcept {
  command.stamp_ns = now_ns_;
  head_ = command;
  return ++head_number_;
}

void Orders::look_ahead_after(std::uint32_t number) noexcept {
  if (number == head_number_) look_ahead();
}

void Orders::look_ahead() noexcept {
  look(HeadCommand{});
}

Orders::Saying* Orders::new_saying(bool is_trouble) noexcept {
  if (said_ == kMostSayings) return nullptr;
  Saying& saying = sayings_[said_++];
  saying = {};
  saying.is_trouble = is_trouble;
  return &saying;
}

void Orders::say(std::string_view text) noexcept {
  if (Saying* const to = new_saying(false)) {
    std::memcpy(to->text.data(), text.data(), std::min(text.size(), to->text.size() - 1));
  }
}

void Orders::tell_trouble(std::string_view leaf, std::string_view why) noexcept {
  if (Saying* const to = new_saying(true)) {
    fmt::format_to_n(to->text.data(), to->text.size() - 1, "{}: {}", leaf, why);
  }
}

}  // namespace gaitway::behaviour_leaves
