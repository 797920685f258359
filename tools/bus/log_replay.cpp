// Replays in the co-simulation's order: local controllers, frames of the millisecond, body.
#include "tools/bus/log_replay.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "tools/bus/bus_watch.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using facts::kMillisecond_ns;

// An answer that is not in the log by the time the next one is due was lost.
constexpr std::int64_t kOverdue_ns = facts::kSlot_ns - kMillisecond_ns;

// A station that is switched on takes part after so many recessive bits.
constexpr std::int64_t kBitsUntilInStep = 11;

std::int64_t start_ns(const can::LoggedFrame& logged) noexcept {
  return logged.time_ns - can::frame_bits(logged.frame) * facts::kBitTime_ns;
}

std::int64_t field_value(const can::Frame& frame, const can::FieldSpec& field) noexcept {
  std::uint64_t bits = 0;
  for (std::size_t byte = 0; byte < frame.size; ++byte) {
    bits |= std::uint64_t{frame.data[byte]} << (8 * byte);
  }
  const std::uint64_t raw = (bits >> field.first_bit) & ((std::uint64_t{1} << field.width) - 1);
  const std::uint64_t sign = std::uint64_t{1} << (field.width - 1U);
  const bool negative = field.is_signed && (raw & sign) != 0;
  return static_cast<std::int64_t>(raw) - (negative ? static_cast<std::int64_t>(2 * sign) : 0);
}

// Fields of an answer that the frames on the bus decide alone, whatever the body does.
bool is_reference(MessageKind kind, std::string_view field) noexcept {
  constexpr std::array<std::string_view, 4> kDecided{"reference_low", "executing_toggle", "pending_toggle",
                                                     "state"};
  return kind == MessageKind::feedback && std::ranges::find(kDecided, field) != kDecided.end();
}

}  // namespace

LogReplay::LogReplay(const urdf::RobotModel& robot, const ReplayOptions& options)
    : options_(options),
      profile_(msgcontroller::network_profile(robot)),
      robot_(robot),
      plant_(robot, options.plant),
      joints_(robot, options.plant.seed, options.largest_clock_drift_ppm, options.plant.mismatch),
      waiting_(robot.joints.size()),
      answered_(robot.joints.size()),
      power_on_ns_(robot.joints.size()),
      in_step_ns_(robot.joints.size(), 0) {
  for (const urdf::Joint& joint : robot.joints) {
    node_.push_back(joint.node);
  }
}

ReplayResult LogReplay::run(std::span<const can::LoggedFrame> log) {
  to_come_ = log;
  for (std::int64_t now_ns = 0; !to_come_.empty(); now_ns += kMillisecond_ns) {
    apply_events(now_ns);
    joints_.step(now_ns, plant_.sensors());
    offer_all(now_ns);
    while (!to_come_.empty() && to_come_.front().time_ns <= now_ns + kMillisecond_ns) {
      const can::LoggedFrame& logged = to_come_.front();
      to_come_ = to_come_.subspan(1);
      deliver(logged);
    }
    plant_.step(joints_.torque_Nm());
    result_.fell = result_.fell || plant_.fallen();
    result_.end_ns = now_ns + kMillisecond_ns;
    if (observer_ && result_.end_ns % facts::kSlot_ns == 0) {
      observer_(result_.end_ns, joints_, plant_);
    }
  }
  return result_;
}

void LogReplay::apply_events(std::int64_t now_ns) {
  const double now_s = static_cast<double>(now_ns) * 1e-9;
  for (; next_event_ < options_.events.size() && options_.events[next_event_].at_s <= now_s + 1e-9;
       ++next_event_) {
    apply(options_.events[next_event_], now_ns);
  }
  for (int joint = 0; joint < joints_.size(); ++joint) {
    auto& power_on_ns = power_on_ns_[static_cast<std::size_t>(joint)];
    if (power_on_ns && *power_on_ns <= now_ns) {
      joints_.power_on(joint, plant_.sensors());
      power_on_ns.reset();
      in_step_ns_[static_cast<std::size_t>(joint)] = now_ns + kBitsUntilInStep * facts::kBitTime_ns;
    }
  }
}

void LogReplay::apply(const simulator::ScenarioEvent& event, std::int64_t now_ns) {
  if (const auto* const push = std::get_if<simulator::PushEvent>(&event.action)) {
    plant_.push(push->body, push->direction, push->impulse_Ns, push->duration_s);
  } else if (const auto* const restart = std::get_if<simulator::JointRestartsFault>(&event.action)) {
    const int joint = robot_.joint_index(restart->joint);
    joints_.power_off(joint);
    waiting_[static_cast<std::size_t>(joint)].reset();
    power_on_ns_[static_cast<std::size_t>(joint)] = now_ns + std::llround(restart->duration_s * 1e9);
  }
}

int LogReplay::sender_of(const can::Frame& frame) const noexcept {
  const auto message = frame.extended || frame.remote ? std::nullopt : profile_.identify(frame.id);
  if (!message || can::layout(message->kind).sender != can::Sender::local_controller) {
    return -1;
  }
  const auto joint = std::ranges::find(node_, message->node);
  return joint == node_.end() ? -1 : static_cast<int>(joint - node_.begin());
}

void LogReplay::deliver(const can::LoggedFrame& logged) {
  if (logged.error) {
    ++result_.error_reports;
    return;
  }
  const int sender = sender_of(logged.frame);
  result_.fed += sender < 0 ? 1U : 0U;
  if (sender >= 0) {
    take_answer(sender, logged);
  }
  for (int joint = 0; joint < joints_.size(); ++joint) {
    if (joint != sender && start_ns(logged) >= in_step_ns_[static_cast<std::size_t>(joint)]) {
      joints_.on_frame(joint, logged.frame, logged.time_ns);
    }
  }
  offer_all(logged.time_ns);  // an answer to a SYNC is released at once
}

// A sender whose frame everybody had, but which did not see that, sends it once more.
void LogReplay::take_answer(int joint, const can::LoggedFrame& logged) {
  auto& waiting = waiting_[static_cast<std::size_t>(joint)];
  auto& answered = answered_[static_cast<std::size_t>(joint)];
  const bool doubled = answered && answered->frame == logged.frame &&
                       !(waiting && waiting->frame == logged.frame) &&
                       logged.time_ns - answered->released_ns < kOverdue_ns;
  if (doubled) {
    ++result_.compared;
    ++result_.matched;
    ++result_.doubled;
    return;
  }
  compare(joint, logged);
  answered = Answer{logged.frame, logged.time_ns};
  waiting.reset();
}

void LogReplay::offer_all(std::int64_t now_ns) {
  for (int joint = 0; joint < joints_.size(); ++joint) {
    offer(joint, now_ns);
  }
}

bool LogReplay::is_on_wire(int joint, std::int64_t now_ns) const noexcept {
  return !to_come_.empty() && sender_of(to_come_.front().frame) == joint &&
         start_ns(to_come_.front()) < now_ns;
}

void LogReplay::offer(int joint, std::int64_t now_ns) {
  auto& waiting = waiting_[static_cast<std::size_t>(joint)];
  const bool overdue = waiting && now_ns - waiting->released_ns > kOverdue_ns;
  if (waiting && !overdue) {
    if (joints_.joint(joint).next_id() >= waiting->frame.id || is_on_wire(joint, now_ns)) {
      return;
    }
    joints_.joint(joint).put_back(waiting->frame);  // as its station does, for something more urgent
    waiting.reset();
  }
  can::Frame frame;
  if (!joints_.take_frame(joint, frame)) {
    return;
  }
  if (overdue) {
    ++result_.not_in_log;
    if (!options_.losses) {
      const auto message = profile_.identify(waiting->frame.id);
      differ(joint, waiting->released_ns,
             message ? std::string(can::layout(message->kind).name) : std::string("frame"), "not in the log",
             "sent");
    }
  }
  waiting = Answer{frame, now_ns};
}

void LogReplay::compare(int joint, const can::LoggedFrame& logged) {
  ++result_.compared;
  const auto& waiting = waiting_[static_cast<std::size_t>(joint)];
  const can::MessageKind kind = profile_.identify(logged.frame.id)->kind;  // sender_of() found one
  const can::MessageLayout& message = can::layout(kind);
  const bool references = options_.comparison == ReplayComparison::references;
  const auto difference = [&](std::string_view field, std::string recorded, std::string replayed) {
    differ(joint, logged.time_ns, fmt::format("{}{}{}", message.name, field.empty() ? "" : " ", field),
           std::move(recorded), std::move(replayed));
  };
  if (references && kind != MessageKind::feedback) {
    ++result_.matched;  // what it reports is the body's affair
    return;
  }
  if (!waiting || waiting->frame.id != logged.frame.id) {
    return difference("", "sent", "not sent");
  }
  const can::Frame& replayed = waiting->frame;
  if (replayed == logged.frame) {
    ++result_.matched;
    return;
  }
  if (replayed.size != logged.frame.size) {
    return difference("size", fmt::format("{}", logged.frame.size), fmt::format("{}", replayed.size));
  }
  for (const can::FieldSpec& field : message.fields) {
    const std::int64_t was = field_value(logged.frame, field), is = field_value(replayed, field);
    if (was != is && (!references || is_reference(kind, field.name))) {
      return difference(field.name, fmt::format("{}", was), fmt::format("{}", is));
    }
  }
  ++result_.matched;  // apart from fields that are not compared
}

void LogReplay::differ(int joint, std::int64_t time_ns, std::string field, std::string recorded,
                       std::string replayed) {
  if (!result_.first) {
    result_.first = ReplayDifference{time_ns, node_[static_cast<std::size_t>(joint)], std::move(field),
                                     std::move(recorded), std::move(replayed)};
  }
}

}  // namespace gaitway::tools
