// Puts player, servo, trim and sensors together and answers each SYNC with one feedback frame.
#include "gaitway/localcontroller/joint_controller.hpp"

namespace gaitway::localcontroller {
namespace {

constexpr double kServoPeriod_s = 0.001;
constexpr double kTurn_rad = 6.283185307179586;
constexpr double kPositionCount_rad = kTurn_rad / 65536.0;
constexpr double kCurrentCount_Nm = 0.125;

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
      player_(config.initial_reference_count, lowest_count(config), highest_count(config)),
      servo_({config.stiffness_Nm_per_rad, config.damping_Nms_per_rad, config.torque_limit_Nm,
              config.speed_limit_rad_per_s}),
      trim_(config.trim_limit_rad, config.trim_slew_rad_per_s),
      reference_rad_(config.initial_reference_count * config.count_rad) {}

can::JointState JointController::state() const noexcept {
  if (soft_) {
    return can::JointState::soft;
  }
  return player_.running() ? can::JointState::running : can::JointState::holding;
}

void JointController::on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept {
  // Most frames on the bus are other joints' feedback: the identifier alone tells.
  if (frame.id == config_.profile.id_of(can::MessageKind::sync)) {
    if (const auto sync = can::decode_sync(config_.profile, frame)) {
      on_sync(*sync, now_ns);
    }
  } else if (frame.id == config_.profile.id_of(can::MessageKind::trim)) {
    const auto trim = config_.trim_channel >= 0 ? can::decode_trim(config_.profile, frame) : std::nullopt;
    if (trim) {
      trim_.command(trim->count[static_cast<std::size_t>(config_.trim_channel)] * config_.trim_count_rad,
                    now_ns);
    }
  } else if ((frame.id | 1U) == config_.profile.id_of(can::MessageKind::trajectory, config_.node, true)) {
    if (const auto batch = can::decode_trajectory(config_.profile, frame)) {
      player_.on_trajectory(*batch);
    }
  } else if (frame.id == config_.profile.id_of(can::MessageKind::resynchronisation, config_.node)) {
    if (const auto repair = can::decode_resynchronisation(config_.profile, frame)) {
      player_.on_resynchronisation(*repair);
    }
  } else if (frame.id == config_.profile.id_of(can::MessageKind::user_command)) {
    const auto command = can::decode_user_command(config_.profile, frame);
    if (command && command->node == config_.node) {
      player_.move_to(command->target_count, command->duration_slots, now_ns);
    }
  } else if (frame.id == config_.profile.id_of(can::MessageKind::emergency_stop)) {
    if (const auto stop = can::decode_emergency_stop(config_.profile, frame)) {
      // A joint that has gone soft may lie anywhere by now: a later `hold` must not pull it back.
      soft_ = soft_ || stop->mode == can::StopMode::soft;
      player_.freeze(now_ns);
      trim_.freeze();
    }
  }
}

void JointController::on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept {
  feedback_pending_ = player_.on_sync(sync, now_ns) || feedback_pending_;
}

void JointController::reset() noexcept {
  player_.restart(rounded(measured_rad_ / config_.count_rad));
  trim_ = TrimSlew(config_.trim_limit_rad, config_.trim_slew_rad_per_s);
  reference_rad_ = player_.count() * config_.count_rad;
  soft_ = false;
}

double JointController::step(std::int64_t now_ns, const JointSensors& sensors) noexcept {
  if (player_.advance_without_sync(now_ns)) {
    feedback_pending_ = true;
  }
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    channels_[channel].add(sensors.channel[channel]);
  }
  trim_.step(now_ns, kServoPeriod_s);
  const PointPlayer::Reference reference = player_.reference(now_ns);
  reference_rad_ = reference.count * config_.count_rad;
  measured_rad_ = sensors.encoder_count * config_.encoder_count_rad;
  torque_Nm_ = servo_.step(reference_rad_ + trim_.angle_rad(),
                           reference.rate_per_s * config_.count_rad + trim_.rate_rad_per_s(), measured_rad_,
                           kServoPeriod_s);
  if (soft_) {
    torque_Nm_ = 0.0;
  }
  report_fault(can::Fault::position_limit, player_.at_limit());
  return torque_Nm_;
}

void JointController::report_fault(can::Fault fault, bool present) noexcept {
  const auto bit = static_cast<std::uint8_t>(fault);
  const auto faults = static_cast<std::uint8_t>(present ? faults_ | bit : faults_ & ~bit);
  fault_report_pending_ = fault_report_pending_ || faults != faults_;
  faults_ = faults;
}

bool JointController::take_frame(can::Frame& frame) noexcept {
  if (feedback_pending_) {
    feedback_pending_ = false;
    can::Feedback feedback;
    feedback.node = config_.node;
    feedback.position = static_cast<std::int16_t>(saturated(measured_rad_ / kPositionCount_rad, 32767));
    feedback.current = static_cast<std::int8_t>(saturated(torque_Nm_ / kCurrentCount_Nm, 127));
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
  if (fault_report_pending_) {
    fault_report_pending_ = false;
    frame = can::encode(config_.profile, can::FaultReport{config_.node, faults_});
    return true;
  }
  return false;
}

}  // namespace gaitway::localcontroller
