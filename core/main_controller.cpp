// Tick by tick: answers, plug-ins, trims, hand-over.
#include "gaitway/core/main_controller.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace gaitway::core {
namespace {

constexpr std::string_view kOwnName = "main_controller";

PluginManagerOptions with_robot(PluginManagerOptions options, const urdf::RobotModel& robot) {
  options.robot_directory = robot.directory;
  return options;
}

// Topics of the message controller lie beyond the EMI.
std::size_t bytes_over_emi(const PluginManager& manager) {
  std::size_t bytes = 0;
  for (const StandardTopic& topic : kStandardTopics) {
    const bool always =
        topic.name == "joint_states" || topic.name == "network_state" || topic.name == "network_health";
    if (topic.writer == "message_controller" && (always || manager.plugins().uses(topic.name))) {
      bytes += topic.type->size;
    }
  }
  return bytes;
}

// " (joint 3, point 5, 12)", without what the answer is not about; may be empty.
std::array<char, 64> place_text(const msgclient::Answer& answer) noexcept {
  std::array<char, 64> text{};
  if (answer.joint >= 0 && answer.point >= 0) {
    format_into(text, " (joint {}, point {}, {:g})", answer.joint, answer.point,
                static_cast<double>(answer.value));
  } else if (answer.joint >= 0) {
    format_into(text, " (joint {}, {:g})", answer.joint, static_cast<double>(answer.value));
  }
  return text;
}

}  // namespace

MainController::MainController(const urdf::RobotModel& robot, msgclient::Client& client,
                               msgclient::EmiHost& host, const MainControllerOptions& options)
    : check_(robot),
      host_(host),
      wall_clock_(options.wall_clock),
      event_publisher_(client),
      manager_(options.plugins ? *options.plugins : read_configuration(options.configuration),
               with_robot(options, robot), client),
      joint_plan_reader_(client.read<JointPlan>("joint_plan")),
      trim_reader_(client.read<TrimCommand>("trim")),
      joint_states_reader_(client.read<JointStates>("joint_states")),
      network_state_reader_(client.read<NetworkState>("network_state")),
      network_health_reader_(client.read<NetworkHealth>("network_health")),
      command_reader_(client.read<CommandState>("command_state")),
      crossing_bytes_(bytes_over_emi(manager_)) {}

TickReport MainController::step(std::int64_t now_ns) noexcept {
  const std::int64_t begin_ns = wall_clock_ == nullptr ? 0 : wall_clock_();
  const Tick tick = tick_at(now_ns);
  TickReport report{.batch = tick.batch};
  ++counts_.ticks;
  counts_.batches += tick.batch ? 1U : 0U;
  take_answers(tick);
  note_network(tick);
  note_commander(tick);
  host_.charge_read(crossing_bytes_, now_ns);
  manager_.step(tick);
  report.declared_cost_ns = manager_.declared_cost_ns();
  post_trim(tick, report);
  if (tick.batch) {
    prepare_batch(tick, report);
  }
  manager_.end_trial(tick);
  const std::int64_t duration_ns = wall_clock_ == nullptr ? 0 : wall_clock_() - begin_ns;
  if (tick.batch) {
    batch_wall_.add(duration_ns);
  }
  return report;
}

void MainController::maintain(std::int64_t now_ns) noexcept {
  manager_.maintain(now_ns);
  event_publisher_.step(manager_.events(), now_ns);
}

void MainController::take_answers(const Tick& tick) noexcept {
  while (const std::optional<msgclient::Answer> answer = host_.take_answer(tick.now_ns)) {
    const auto verdict =
        std::min<std::size_t>(static_cast<std::size_t>(answer->verdict), counts_.answers.size() - 1);
    counts_.answers[verdict] += answer->mail == msgclient::MailKind::user_command ? 0U : 1U;
    if (answer->verdict == msgclient::Verdict::accepted) {
      if (answer->mail == msgclient::MailKind::hand_over && answer->sequence == posted_->sequence) {
        std::swap(posted_, accepted_);
        posted_->sequence = 0;
      }
      continue;
    }
    std::array<char, 200> text{};
    const std::string_view mail =
        answer->mail == msgclient::MailKind::user_command ? "user command" : "batch";
    note_refusal(tick, format_into(text, "{} {} {}: {}{}", mail, answer->sequence,
                                   msgclient::verdict_name(answer->verdict),
                                   msgclient::reason_text(answer->reason), place_text(*answer).data()));
  }
}

void MainController::post_trim(const Tick& tick, TickReport& report) noexcept {
  if (trim_reader_.newest_sequence() == trim_sequence_) {
    return;
  }
  const msgclient::ReadResult read = trim_reader_.read(trim_);
  if (!read) {
    return;
  }
  trim_sequence_ = read.sequence;
  msgclient::TrimUpdate update{.stamp_ns = trim_.stamp_ns,
                               .channel_count = std::min<std::uint32_t>(trim_.channel_count, kTrimChannels),
                               .softness = static_cast<float>(trim_.softness)};
  for (std::size_t channel = 0; channel < update.channel_count; ++channel) {
    update.angle[channel] = static_cast<float>(trim_.angle[channel]);
  }
  const msgclient::PostResult result = host_.post(update, tick.now_ns);
  ++(result ? counts_.trims_posted : counts_.trims_not_posted);
  if (result) {
    report.posted = true;
    report.transfer_ns = std::max(report.transfer_ns, result.transfer_ns);
  }
}

// A plug-in on trial has failed it if the robot cannot go on with what it does: its plan is unusable, or
// there is none any more.
void MainController::prepare_batch(const Tick& tick, TickReport& report) noexcept {
  HandOverOutcome outcome = hand_over(tick, report);
  const bool is_missed = outcome == HandOverOutcome::nothing && had_plan_;
  if ((outcome == HandOverOutcome::unusable || is_missed) &&
      manager_.changes().is_trial_to_blame("joint_plan") &&
      manager_.take_trial_back(tick, last_refusal_.data())) {
    post_trim(tick, report);
    outcome = hand_over(tick, report);
  }
  counts_.without_plan += outcome == HandOverOutcome::nothing ? 1U : 0U;
  had_plan_ = outcome == HandOverOutcome::posted || outcome == HandOverOutcome::not_taken;
}

MainController::HandOverOutcome MainController::hand_over(const Tick& tick, TickReport& report) noexcept {
  if (const ManagedPlugin* const failed = manager_.fault_behind("joint_plan")) {
    ++counts_.spoiled;
    if (failed != spoiler_ || tick.batch_sequence != spoiled_sequence_ + 1) {  // said once of a row of them
      std::array<char, 160> text{};
      note_refusal(tick, format_into(text, "batch {} is not handed over: plug-in '{}' failed",
                                     tick.batch_sequence, failed->name()));
    }
    spoiler_ = failed;
    spoiled_sequence_ = tick.batch_sequence;
    return HandOverOutcome::unusable;
  }
  const bool planned = static_cast<bool>(joint_plan_reader_.read(*plan_));
  if (!planned || plan_->sequence != tick.batch_sequence) {
    if (had_plan_) {  // said once of a row of them
      std::array<char, 160> text{};
      note_refusal(
          tick,
          format_into(text,
                      "batch {} is not handed over: no plug-in has a plan for it; the newest is of batch {}",
                      tick.batch_sequence, planned ? plan_->sequence : 0));
    }
    return HandOverOutcome::nothing;
  }
  return post(tick, report);
}

MainController::HandOverOutcome MainController::post(const Tick& tick, TickReport& report) noexcept {
  if (!plan_is_usable(tick) || !msgclient::make_hand_over(*plan_, trim_, *posted_)) {
    return HandOverOutcome::unusable;
  }
  const msgclient::PostResult result = host_.post(*posted_, tick.now_ns);
  if (!result) {
    posted_->sequence = 0;
    ++counts_.not_posted;
    note_refusal(tick,
                 result.status == msgclient::PostStatus::bus_stuck
                     ? "the EMI's bus is stuck: the batch was not handed over"
                     : "the message controller has not taken the batch before: this one was not handed over");
    return HandOverOutcome::not_taken;
  }
  ++counts_.handed_over;
  report.handed_over = report.posted = true;
  report.transfer_ns = std::max(report.transfer_ns, result.transfer_ns);
  return HandOverOutcome::posted;
}

bool MainController::plan_is_usable(const Tick& tick) noexcept {
  const JointPlanVerdict verdict = check_.check(*plan_, start_reference(tick));
  if (verdict.accepted()) {
    return true;
  }
  ++counts_.refused_locally;
  counts_.refused_points += verdict.refused_points;
  std::array<char, 220> text{};
  const auto prefix = fmt::format_to_n(text.data(), text.size(), "batch {}: ", plan_->sequence);
  const std::string_view line = check_.describe(verdict, std::span(text).subspan(prefix.size));
  note_refusal(tick, {text.data(), prefix.size + line.size()});
  return false;
}

std::span<const double> MainController::start_reference(const Tick& tick) noexcept {
  const bool known = static_cast<bool>(network_state_reader_.read(network_state_)) &&
                     static_cast<bool>(joint_states_reader_.read(joint_states_));
  if (known && network_state_.mode == network_state::mode::holding) {
    const std::size_t joints = std::min<std::size_t>(joint_states_.joint_count, kMaxJoints);
    std::copy_n(joint_states_.reference_position, joints, start_rad_.begin());
    return std::span(start_rad_).first(joints);
  }
  if (accepted_->sequence == 0 || accepted_->sequence >= tick.batch_sequence) {
    return {};
  }
  // The accepted batch plays from its cycle on, then its safe tail, then the tail's last point.
  const std::int64_t played = std::int64_t{tick.batch_sequence - accepted_->sequence} * facts::kSlotsPerCycle;
  const auto point = static_cast<int>(std::min<std::int64_t>(played, accepted_->point_count) - 1);
  for (std::size_t joint = 0; joint < accepted_->joint_count; ++joint) {
    start_rad_[joint] = static_cast<double>(accepted_->position_at(point, static_cast<int>(joint)));
  }
  return std::span(start_rad_).first(accepted_->joint_count);
}

void MainController::note_network(const Tick& tick) noexcept {
  if (network_state_reader_.read(network_state_)) {
    silence_events_.follow(network_state_, tick.now_ns, [&](EventKind kind, std::string_view text) {
      manager_.events().add(tick, kind, kOwnName, text);
    });
  }
  if (network_health_reader_.read(network_health_)) {
    network_events_.compare(network_health_, [&](std::string_view text) {
      manager_.events().add(tick, EventKind::warning, kOwnName, text);
    });
  }
}

void MainController::note_commander(const Tick& tick) noexcept {
  CommandState state;
  if (command_reader_.newest_sequence() == command_seen_) return;
  const msgclient::ReadResult read = command_reader_.read(state);
  if (!read) return;
  command_seen_ = read.sequence;
  if (state.changes == commander_changes_) return;
  commander_changes_ = state.changes;
  state.text[sizeof state.text - 1] = 0;
  manager_.events().add(tick, EventKind::info, "command", reinterpret_cast<const char*>(state.text));
}

void MainController::note_refusal(const Tick& tick, std::string_view text) noexcept {
  manager_.events().add(tick, EventKind::refusal, kOwnName, text);
  copy_text(text, last_refusal_);
}

MainControllerStatistics MainController::statistics() const {
  MainControllerStatistics result = counts_;
  result.last_refusal = last_refusal_.data();
  result.events_missed = event_publisher_.missed();
  result.batch_compute_us = batch_wall_.summary();
  result.plugins = manager_.timings();
  return result;
}

}  // namespace gaitway::core
