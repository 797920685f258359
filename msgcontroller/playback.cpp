// Turns hand-overs into counts, checks that a trajectory frame can carry them, keeps the running and the
// prepared eight points and walks along the safe tail.
#include "gaitway/msgcontroller/playback.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {
namespace {

constexpr std::uint8_t kBothFeet = 2;

}  // namespace

CountPlanProblem to_counts(const msgclient::HandOver& hand_over, std::span<const double> count_rad,
                           std::span<const std::int32_t> start_count, CountPlan& plan) noexcept {
  using msgclient::Reason;
  const auto joints = static_cast<int>(hand_over.joint_count);
  const auto points = static_cast<int>(hand_over.point_count);
  if (static_cast<std::size_t>(joints) != count_rad.size() || points < kBatchPoints || points > kMaxPoints) {
    return {.reason = Reason::wrong_size};
  }
  for (int point = 0; point < points; ++point) {
    auto& row = plan.count[static_cast<std::size_t>(point)];
    for (int joint = 0; joint < joints; ++joint) {
      const auto j = static_cast<std::size_t>(joint);
      const double counts = static_cast<double>(hand_over.position_at(point, joint)) / count_rad[j];
      if (!(std::abs(counts) < 1e9)) {
        return {Reason::not_finite, joint, point, 0.0};
      }
      row[j] = static_cast<std::int32_t>(std::lround(counts));
      const std::int32_t before =
          point == 0 ? start_count[j] : plan.count[static_cast<std::size_t>(point - 1)][j];
      const std::int32_t delta = row[j] - before;
      if (delta > facts::kLargestByte_counts || delta < -facts::kLargestByte_counts) {
        return {point == 0 ? Reason::jump : Reason::too_fast, joint, point, static_cast<double>(delta)};
      }
    }
    plan.support[static_cast<std::size_t>(point)] = hand_over.support[static_cast<std::size_t>(point)];
  }
  plan.sequence = hand_over.sequence;
  plan.joint_count = joints;
  plan.point_count = points;
  return {};
}

Playback::Playback(std::span<const std::int32_t> initial_count) noexcept
    : joint_count_(static_cast<int>(initial_count.size())) {
  std::copy(initial_count.begin(), initial_count.end(), held_.begin());
}

void Playback::accept(const CountPlan& plan) noexcept {
  keep_outgoing_plan();
  running_plan_ = plan_;
  running_cursor_ = cursor_;
  plan_waits_ = true;
  plan_ = plan;
  prepare(0);
}

bool Playback::return_to_running_tail() noexcept {
  if (!plan_waits_ || !running_.active) {
    return false;
  }
  plan_waits_ = false;
  plan_ = running_plan_;
  cursor_ = running_cursor_;
  prepared_.active = false;
  static_cast<void>(prepare_from_tail());
  return true;
}

// Before another plan takes its place.
void Playback::keep_outgoing_plan() noexcept {
  if (outgoing_is_plan_) {
    outgoing_plan_ = plan_;
    outgoing_is_plan_ = false;
  }
}

bool Playback::prepare_from_tail() noexcept {
  if (alone_.on) {
    cursor_ = alone_.first + std::min(alone_.passed + kBatchPoints, alone_.points);
  }
  if (!tail_left()) {
    return false;
  }
  prepare(cursor_);
  return true;
}

void Playback::prepare(int first_point) noexcept {
  for (int slot = 0; slot < kBatchPoints; ++slot) {
    const auto point = static_cast<std::size_t>(std::min(first_point + slot, plan_.point_count - 1));
    const auto s = static_cast<std::size_t>(slot);
    prepared_.count[s] = plan_.count[point];
    prepared_.support[s] = plan_.support[point];
  }
  prepared_.toggle = next_toggle_;
  prepared_.active = true;
  prepared_from_ = first_point;
  cursor_ = std::min(first_point + kBatchPoints, plan_.point_count);
}

void Playback::begin_cycle() noexcept {
  outgoing_is_plan_ = !plan_waits_;
  if (plan_waits_) {
    outgoing_plan_ = running_plan_;
  }
  outgoing_ = alone_;
  if (!alone_.on) {
    outgoing_.first = plan_waits_ ? running_cursor_ : prepared_.active ? prepared_from_ : cursor_;
    outgoing_.passed = -kBatchPoints;
  }
  if (alone_.on && alone_.points > 0) {
    std::copy_n(alone_counts(kBatchPoints - 1), held_.size(), held_.begin());
  } else if (running_.active) {
    held_ = running_.count.back();
  }
  if (prepared_.active) {
    running_ = prepared_;
    next_toggle_ = !prepared_.toggle;
    prepared_.active = false;
    alone_.on = false;
  } else {
    running_.active = false;
    go_on_alone();
  }
  slot_ = 0;
  plan_waits_ = false;
}

void Playback::go_on_alone() noexcept {
  if (!alone_.on) {
    return;
  }
  alone_.passed += kBatchPoints;
  if (alone_.passed >= alone_.points) {
    alone_.on = false;
    cursor_ = alone_.first + alone_.points;
  }
}

void Playback::leave_to_joints(int tail_points) noexcept {
  if (!outgoing_is_plan_) {
    plan_ = outgoing_plan_;
  }
  const bool was_alone = outgoing_.on;
  alone_ = outgoing_;
  alone_.on = true;
  alone_.passed += kBatchPoints;
  if (!was_alone) {
    alone_.points = std::min(tail_points, plan_.point_count - alone_.first);
  }
  cursor_ = alone_.first;
  if (running_.active) {
    next_toggle_ = running_.toggle;  // whose frames they have, but have not begun
  }
  running_.active = prepared_.active = false;
  plan_waits_ = false;
}

const std::int32_t* Playback::alone_counts(int slot) const noexcept {
  const int point = std::min(alone_.passed + slot, alone_.points - 1);
  return point < 0 ? held_.data() : plan_.count[static_cast<std::size_t>(alone_.first + point)].data();
}

std::optional<int> Playback::points_to_both_feet(int most) const noexcept {
  if (!tail_left() || plan_.support[static_cast<std::size_t>(cursor_ - 1)] == kBothFeet) {
    return 0;
  }
  for (int point = cursor_; point < std::min(plan_.point_count, cursor_ + most); ++point) {
    if (plan_.support[static_cast<std::size_t>(point)] == kBothFeet) {
      return point - cursor_ + 1;
    }
  }
  return std::nullopt;
}

std::int32_t Playback::tail_delta(int joint, int point) const noexcept {
  const auto p = static_cast<std::size_t>(cursor_ + point);
  const auto j = static_cast<std::size_t>(joint);
  return plan_.count[p][j] - plan_.count[p - 1][j];
}

bool Playback::rests(std::span<const std::int32_t> tolerance) const noexcept {
  if (alone_.on) {
    return false;
  }
  const auto& here = running_.active ? running_.count[static_cast<std::size_t>(slot_)] : held_;
  const auto stays = [&](const std::array<std::int32_t, kMaxJoints>& point) {
    for (std::size_t j = 0; j < static_cast<std::size_t>(joint_count_); ++j) {
      if (std::abs(point[j] - here[j]) > tolerance[j]) {
        return false;
      }
    }
    return true;
  };
  const auto first = running_.active ? running_.count.begin() + slot_ : running_.count.end();
  const bool prepared_stays =
      !prepared_.active || std::all_of(prepared_.count.begin(), prepared_.count.end(), stays);
  return std::all_of(first, running_.count.end(), stays) && prepared_stays &&
         std::all_of(plan_.count.begin() + std::min(cursor_, plan_.point_count),
                     plan_.count.begin() + plan_.point_count, stays);
}

void Playback::restart(std::span<const std::int32_t> count) noexcept {
  std::copy(count.begin(), count.end(), held_.begin());
  running_.active = prepared_.active = false;
  running_.toggle = false;
  next_toggle_ = true;
  alone_.on = false;
  plan_waits_ = false;
  plan_.sequence = 0;
  cursor_ = plan_.point_count;
}

void Playback::hold(int joint, std::int32_t count) noexcept {
  const auto j = static_cast<std::size_t>(joint);
  held_[j] = count;
  for (auto& point : running_.count) {
    point[j] = count;
  }
  prepared_.active = false;
  plan_waits_ = false;
  cursor_ = plan_.point_count;
}

std::int32_t Playback::expected_count(int joint, int slot) const noexcept {
  const auto j = static_cast<std::size_t>(joint);
  return alone_.on         ? alone_counts(slot)[j]
         : running_.active ? running_.count[static_cast<std::size_t>(slot)][j]
                           : held_[j];
}

std::span<const std::int32_t> Playback::next_start() const noexcept {
  const std::int32_t* const last = alone_.on         ? alone_counts(kBatchPoints - 1)
                                   : running_.active ? running_.count.back().data()
                                                     : held_.data();
  return {last, static_cast<std::size_t>(joint_count_)};
}

std::int32_t Playback::waiting_delta(int joint, int slot) const noexcept {
  const auto j = static_cast<std::size_t>(joint);
  const std::int32_t before =
      slot == 0 ? next_start()[j] : prepared_.count[static_cast<std::size_t>(slot - 1)][j];
  return prepared_.count[static_cast<std::size_t>(slot)][j] - before;
}

std::int32_t Playback::running_delta(int joint, int slot) const noexcept {
  const auto j = static_cast<std::size_t>(joint);
  const std::int32_t before = slot == 0 ? held_[j] : running_.count[static_cast<std::size_t>(slot - 1)][j];
  return running_.count[static_cast<std::size_t>(slot)][j] - before;
}

std::uint8_t Playback::support() const noexcept {
  if (alone_.on && alone_.passed + slot_ < alone_.points) {
    return plan_.support[static_cast<std::size_t>(alone_.first + alone_.passed + slot_)];
  }
  if (running_.active) {
    return running_.support[static_cast<std::size_t>(slot_)];
  }
  return kBothFeet;
}

}  // namespace gaitway::msgcontroller
