// Puts player, servo, trim and sensors together and answers each SYNC with one feedback frame.
#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr double kStiffeningPerStep = kServoPeriod_s / 0.5;  // from no torque to all of it in half a second
constexpr double kStiffeningAgainPerStep = kServoPeriod_s / 0.1;  // of a joint that held compliant
constexpr double kTurn_rad = 6.283185307179586;
constexpr double kPositionCount_rad = kTurn_rad / 65536.0;
constexpr float kCurrentCount_Nm = 0.125F;
// No joint moves at this many times its motor's largest speed.
constexpr double kImplausibleSpeeds = 10.0;
constexpr int kEncoderDistrust_ms = 5;
constexpr int kSaturation_ms = 40;
constexpr int kSlotsUntilSyncIsLost = 2;
constexpr int kSlotsUntilAlone = 6;  // the message controller gives joints up that hear nothing for four
constexpr double kYieldingPerStep = kServoPeriod_s / 0.02;  // from stiff to compliant

double magnitude(double value) noexcept {
  return value < 0.0 ? -value : value;
}

std::int32_t rounded(double value) noexcept {
  return static_cast<std::int32_t>(value < 0.0 ? value - 0.5 : value + 0.5);
}

// Rounds into [-limit, limit].
std::int32_t saturated(double value, std::int32_t limit) noexcept {
  return value >= limit ? limit : value <= -limit ? -limit : rounded(value);
}

// The outermost counts that keep the joint within its limits.
std::int32_t lowest_count(const JointConfig& config) noexcept {
  const double count = config.lower_rad / config.count_rad;
  const auto truncated = static_cast<std::int32_t>(count);
  return truncated < count ? truncated + 1 : truncated;
}
std::int32_t highest_count(const JointConfig& config) noexcept {
  const double count = config.upper_rad / config.count_rad;
  const auto truncated = static_cast<std::int32_t>(count);
  return truncated > count ? truncated - 1 : truncated;
}

}  // namespace

JointController::JointController(const JointConfig& config) noexcept
    : config_(config),
      player_(config.initial_reference_count, lowest_count(config), highest_count(config),
              config.profile.has(can::MessageKind::sync) ? BatchStart::on_sync : BatchStart::on_arrival),
      servo_({config.stiffness_Nm_per_rad, config.damping_Nms_per_rad, config.torque_limit_Nm,
              config.speed_limit_rad_per_s}),
      trim_(config.trim_limit_rad, config.trim_slew_rad_per_s),
      reference_rad_(config.initial_reference_count * config.count_rad) {}

can::JointState JointController::state() const noexcept {
  if (soft_) {
    return can::JointState::soft;
  }
  if (player_.frozen()) {
    return can::JointState::stopped;
  }
  // While it is compliant, its torque does not tell how far it is from its reference.
  return player_.running() || compliance_ > 0.0 ? can::JointState::running : can::JointState::holding;
}

void JointController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
  const can::Profile& profile = config_.profile;
  if (!on_bus()) {
    return;
  }
  // Most frames on the bus are other joints' feedback: the identifier alone tells.
  const auto is = [&](can::MessageKind kind, can::NodeId node = 0, bool toggle = false) {
    return profile.has(kind) && frame.id == profile.id_of(kind, node, toggle);
  };
  if (is(can::MessageKind::sync)) {
    if (const auto sync = can::decode_sync(profile, frame)) {
      on_sync(*sync, now_ns);
    }
  } else if (is(can::MessageKind::trim)) {
    const auto trim = config_.trim_channel >= 0 ? can::decode_trim(profile, frame) : std::nullopt;
    if (trim) {
      trim_.command(trim->count[static_cast<std::size_t>(config_.trim_channel)] * config_.trim_count_rad,
                    now_ns);
    }
  } else if (is(can::MessageKind::trajectory, config_.node, false) ||
             is(can::MessageKind::trajectory, config_.node, true)) {
    if (const auto batch = can::decode_trajectory(profile, frame)) {
      on_trajectory(*batch, now_ns);
    }
  } else if (profile.has(can::MessageKind::tail) && frame.id >= profile.row(can::MessageKind::tail).base_id &&
             frame.id <= profile.last_id(can::MessageKind::tail)) {
    const auto tail = can::decode_tail(profile, frame);
    if (tail && tail->node == config_.node) {
      player_.on_tail(*tail);
    }
  } else if (is(can::MessageKind::resynchronisation, config_.node)) {
    if (const auto repair = can::decode_resynchronisation(profile, frame)) {
      player_.on_resynchronisation(*repair);
    }
  } else if (is(can::MessageKind::user_command)) {
    if (const auto command = can::decode_user_command(profile, frame)) {
      on_user_command(*command, now_ns);
    }
  } else if (is(can::MessageKind::emergency_stop)) {
    if (const auto stop = can::decode_emergency_stop(profile, frame)) {
      on_stop(stop->mode, now_ns);
    }
  }
}

void JointController::on_trajectory(const can::Trajectory& batch, std::int64_t now_ns) noexcept {
  if (config_.profile.has(can::MessageKind::sync)) {
    player_.on_trajectory(batch);
    return;
  }
  feedback_pending_ = player_.start(batch, now_ns) || feedback_pending_;  // its slots begin here
}

void JointController::on_user_command(const can::UserCommand& command, std::int64_t now_ns) noexcept {
  if (command.node == 0) {
    on_stop(static_cast<can::StopMode>(command.target_count), now_ns);
  } else if (command.node == config_.node) {
    player_.move_to(command.target_count, command.duration_slots, now_ns);
  }
}

// A joint that has gone soft may lie anywhere by now: a later `hold` must not pull it back.
void JointController::on_stop(can::StopMode mode, std::int64_t now_ns) noexcept {
  if (mode == can::StopMode::release) {
    if (soft_ || player_.frozen()) {
      reset();
    }
    return;
  }
  soft_ = soft_ || mode == can::StopMode::soft;
  player_.freeze(now_ns);
  trim_.freeze();
}

void JointController::on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept {
  slots_alone_ = 0;
  feedback_pending_ = player_.on_sync(sync, now_ns) || feedback_pending_;
  share_asked_ = 1.0 - static_cast<double>(sync.softness) / can::kMostSoftness;
}

void JointController::reset() noexcept {
  player_.restart(rounded(measured_rad_ / config_.count_rad));
  trim_ = TrimSlew(config_.trim_limit_rad, config_.trim_slew_rad_per_s);
  reference_rad_ = player_.count() * config_.count_rad;
  soft_ = false;
}

double JointController::step(std::int64_t now_ns, const JointSensors& sensors) noexcept {
  now_ns_ = now_ns;
  if (player_.advance_without_sync(now_ns)) {
    feedback_pending_ = true;
    ++slots_alone_;
  }
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    channels_[channel].add(sensors.channel[channel]);
  }
  current_.add(sensors.motor_current_Nm);
  trim_.step(now_ns, kServoPeriod_s);
  // Soft at once; stiff little by little, since the joint may lie far from its reference by now.
  share_ = share_asked_ <= share_                       ? share_asked_
           : share_asked_ - share_ < kStiffeningPerStep ? share_asked_
                                                        : share_ + kStiffeningPerStep;
  servo_.set_share(share_);
  follow_compliance();
  const PointPlayer::Reference reference = player_.reference(now_ns);
  reference_rad_ = reference.count * config_.count_rad;
  measured_rad_ = plausible_position_rad(sensors.encoder_count);
  torque_Nm_ = servo_.step(reference_rad_ + trim_.angle_rad(),
                           reference.rate_per_s * config_.count_rad + trim_.rate_rad_per_s(), measured_rad_,
                           kServoPeriod_s);
  if (soft_) {
    torque_Nm_ = 0.0;
  }
  find_faults();
  return torque_Nm_;
}

// Compliant while it holds and nobody says what is next, for so long that all joints must be alone; a batch
// that comes finds it stiff soon. Who stopped it wants it to keep its place.
void JointController::follow_compliance() noexcept {
  const bool alone = config_.profile.has(can::MessageKind::sync) && slots_alone_ >= kSlotsUntilAlone;
  const bool compliant = alone && !player_.running() && !player_.frozen() && player_.reference_confirmed();
  compliance_ += compliant ? kYieldingPerStep : -kStiffeningAgainPerStep;
  compliance_ = compliance_ < 0.0 ? 0.0 : compliance_ > 1.0 ? 1.0 : compliance_;
  servo_.set_compliance(compliance_);
}

bool JointController::sync_is_lost() const noexcept {
  return config_.profile.has(can::MessageKind::sync) && slots_alone_ >= kSlotsUntilSyncIsLost;
}

// A single wild reading must not kick the joint: its last place counts, until the encoder has stood elsewhere
// for a while.
double JointController::plausible_position_rad(std::int32_t encoder_count) noexcept {
  const double read_rad = encoder_count * config_.encoder_count_rad - config_.encoder_zero_rad;
  const double jump_rad = read_rad - measured_rad_;
  const bool plausible =
      !measured_ || config_.speed_limit_rad_per_s <= 0.0 ||
      magnitude(jump_rad) <= kImplausibleSpeeds * config_.speed_limit_rad_per_s * kServoPeriod_s;
  implausible_ms_ = plausible ? 0 : implausible_ms_ + 1;
  measured_ = true;
  if (implausible_ms_ > kEncoderDistrust_ms) {
    servo_.forget_motion();
  }
  return plausible || implausible_ms_ > kEncoderDistrust_ms ? read_rad : measured_rad_;
}

void JointController::find_faults() noexcept {
  saturated_ms_ = servo_.saturated() && !soft_ ? saturated_ms_ + 1 : saturated_ms_ - 1;
  saturated_ms_ = saturated_ms_ < 0 ? 0 : saturated_ms_ > kSaturation_ms ? kSaturation_ms : saturated_ms_;
  const bool was_saturated = (faults_ & static_cast<std::uint8_t>(can::Fault::torque_saturated)) != 0;
  set_fault(can::Fault::torque_saturated,
            was_saturated ? saturated_ms_ > 0 : saturated_ms_ == kSaturation_ms);
  set_fault(can::Fault::position_limit, player_.at_limit());
  set_fault(can::Fault::sync_lost, sync_is_lost());
  set_fault(can::Fault::encoder, implausible_ms_ > 0);
  set_fault(can::Fault::restarted, !player_.reference_confirmed());
  set_fault(can::Fault::tail_missing, player_.tail_missing());
}

void JointController::set_fault(can::Fault fault, bool present) noexcept {
  const auto bit = static_cast<std::uint8_t>(fault);
  new_faults_ = static_cast<std::uint8_t>(present && (faults_ & bit) == 0 ? new_faults_ | bit : new_faults_);
  faults_ = static_cast<std::uint8_t>(present ? faults_ | bit : faults_ & ~bit);
}

bool JointController::take_frame(can::Frame& frame) noexcept {
  if (!on_bus()) {
    return false;
  }
  if (feedback_pending_) {
    feedback_pending_ = false;
    can::Feedback feedback;
    feedback.node = config_.node;
    feedback.position = static_cast<std::int16_t>(saturated(measured_rad_ / kPositionCount_rad, 32767));
    feedback.current = static_cast<std::int8_t>(
        saturated(config_.senses_current ? current_.counts(kCurrentCount_Nm)
                                         : torque_Nm_ / static_cast<double>(kCurrentCount_Nm),
                  127));
    feedback.state = state();
    feedback.pending_toggle = player_.pending_toggle();
    feedback.executing_toggle = player_.executing_toggle();
    feedback.reference_low = static_cast<std::uint8_t>(static_cast<std::uint32_t>(player_.count()) & 0xFU);
    for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
      feedback.channel[channel] = channels_[channel].counts(config_.channel_scale[channel]);
    }
    frame = can::encode(config_.profile, feedback);
    return true;
  }
  if (report_due()) {
    const auto faults = static_cast<std::uint8_t>(faults_ | new_faults_);
    reported_faults_ = faults;
    new_faults_ = 0;
    next_report_ns_ = now_ns_ + config_.profile.row(can::MessageKind::fault_report).period_ns;
    frame = can::encode(config_.profile, can::FaultReport{config_.node, faults});
    return true;
  }
  return false;
}

// That a tail is missing is said of each tail anew, since it is sent again in answer.
bool JointController::report_due() const noexcept {
  const bool lacks = (faults_ & static_cast<std::uint8_t>(can::Fault::tail_missing)) != 0;
  const bool tells = lacks || (faults_ | new_faults_) != reported_faults_;
  return config_.profile.has(can::MessageKind::fault_report) && tells && now_ns_ >= next_report_ns_;
}

std::uint32_t JointController::next_id() const noexcept {
  constexpr std::uint32_t kNone = 0xFFFF;
  if (!on_bus()) {
    return kNone;
  }
  if (feedback_pending_) {
    return config_.profile.id_of(can::MessageKind::feedback, config_.node);
  }
  return report_due() ? config_.profile.id_of(can::MessageKind::fault_report, config_.node) : kNone;
}

void JointController::put_back(const can::Frame& frame) noexcept {
  if (const auto report = can::decode_fault_report(config_.profile, frame)) {
    new_faults_ = static_cast<std::uint8_t>(new_faults_ | (report->faults & ~faults_));
    reported_faults_ = static_cast<std::uint8_t>(~report->faults);  // nothing has been said yet
    next_report_ns_ = now_ns_;
  } else {
    feedback_pending_ = true;  // with newer readings, if they have come
  }
}

}  // namespace gaitway::localcontroller
