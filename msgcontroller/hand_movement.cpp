// Checks a movement, makes room for it and sends it.
#include "gaitway/msgcontroller/hand_movement.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::msgcontroller {

using facts::kSlotsPerCycle;

HandMovement::HandMovement(const urdf::RobotModel& robot, BusLink& link, Playback& playback,
                           JointSupervision& supervision)
    : link_(link), playback_(playback), supervision_(supervision) {
  for (std::size_t j = 0; j < robot.joints.size(); ++j) {
    sway_counts_[j] = static_cast<std::int32_t>(kStandingSway_rad / robot.joints[j].count_rad);
  }
}

// Where a batch starts as its frames arrive, those of the next one may be on their way.
bool HandMovement::stands() const noexcept {
  if (link_.mode() == Mode::holding) {
    return !playback_.prepared();
  }
  return link_.mode() == Mode::batches && link_.synchronised() && playback_.rests(sway_counts_);
}

// The joint takes a movement only if nothing of its running batch moves it.
bool HandMovement::rests(std::uint32_t joint) const noexcept {
  if (!playback_.running_segment().active) {
    return true;
  }
  for (int slot = playback_.slot(); slot < kBatchPoints; ++slot) {
    if (playback_.running_delta(static_cast<int>(joint), slot) != 0) {
      return false;
    }
  }
  return true;
}

msgclient::Reason HandMovement::move(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept {
  using msgclient::Reason;
  if (mail.joint >= static_cast<std::uint32_t>(link_.joint_count)) {
    return Reason::unknown_joint;
  }
  const auto j = static_cast<std::size_t>(mail.joint);
  if (link_.node[j] == 0) {
    return Reason::node_fault;
  }
  if (link_.mode() == Mode::emergency_stop) {
    return Reason::emergency_stopped;
  }
  if (!waiting_ && !stands()) {
    return Reason::not_standing;
  }
  // The proof of the bus counts on user commands keeping their distance.
  if (waiting_ || now_ns < next_ns_) {
    return Reason::moving_by_hand;
  }
  const double position = static_cast<double>(mail.position);
  if (!(position >= link_.lower_rad[j] && position <= link_.upper_rad[j])) {
    return Reason::beyond_limits;
  }
  constexpr std::uint32_t kLongestMove_slots = 255;
  const std::uint32_t duration = std::clamp<std::uint32_t>(mail.duration_slots, 1, kLongestMove_slots);
  const std::int32_t count = static_cast<std::int32_t>(std::lround(position / link_.count_rad[j]));
  const std::int32_t from = playback_.next_start()[j];
  if (std::abs(count - from) > facts::kLargestByte_counts * static_cast<std::int32_t>(duration)) {
    return Reason::too_fast;
  }
  const can::UserCommand command{.node = link_.node[j],
                                 .target_count = static_cast<std::int16_t>(count),
                                 .duration_slots = static_cast<std::uint8_t>(duration)};
  next_ns_ = now_ns + link_.profile.row(can::MessageKind::user_command).period_ns;
  moved_[j] = true;
  supervision_.drop_waiting();
  if (rests(mail.joint)) {
    begin(command, mail.joint);
    return Reason::none;
  }
  waiting_ = Waiting{command, mail.joint};
  const std::uint32_t batch_left = static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  playback_.hold(static_cast<int>(j), from);  // nothing follows what runs
  supervision_.leave_alone(static_cast<int>(j), batch_left + 2U);
  moving_until_ = std::max(moving_until_, link_.slots_since_start + batch_left + duration + 4U);
  return Reason::none;
}

void HandMovement::begin(const can::UserCommand& command, std::uint32_t joint) noexcept {
  link_.send(can::encode(link_.profile, command));
  playback_.hold(static_cast<int>(joint), command.target_count);
  // While it moves there, and while the batch that it has left still runs, its reference is its own affair.
  const std::uint32_t batch_left = static_cast<std::uint32_t>(kSlotsPerCycle - playback_.slot());
  const std::uint32_t slots = std::max<std::uint32_t>(command.duration_slots, batch_left) + 2U;
  supervision_.leave_alone(static_cast<int>(joint), slots);
  moving_until_ = std::max(moving_until_, link_.slots_since_start + slots);
}

// The SYNC of a cycle's first slot ends the batch on the joints; a user command overtakes it.
void HandMovement::enter_slot() noexcept {
  if (waiting_ && !playback_.running_segment().active && playback_.slot() > 0) {
    begin(waiting_->command, waiting_->joint);
    waiting_.reset();
  }
}

CountPlanProblem HandMovement::pulled_back_by(const CountPlan& plan,
                                              std::span<const std::int32_t> start) const noexcept {
  constexpr std::int32_t kThere = 2;  // counts
  const auto complaint_about = [&](int point, std::int32_t most,
                                   std::size_t j) -> std::optional<CountPlanProblem> {
    const std::int32_t away = plan.count[static_cast<std::size_t>(point)][j] - start[j];
    if (std::abs(away) <= most) return std::nullopt;
    return CountPlanProblem{msgclient::Reason::moving_by_hand, static_cast<std::int32_t>(j), point,
                            static_cast<double>(away)};
  };
  for (std::size_t j = 0; j < link_.node.size(); ++j) {
    if (!moved_[j]) continue;
    if (const auto at_once = complaint_about(0, kThere, j)) return *at_once;
    // A plan may also lead it back little by little.
    if (const auto in_the_end = complaint_about(plan.point_count - 1, sway_counts_[j], j)) return *in_the_end;
  }
  return {};
}

void HandMovement::forget() noexcept {
  moved_.fill(false);
  moving_until_ = 0;
  waiting_.reset();
}

}  // namespace gaitway::msgcontroller
