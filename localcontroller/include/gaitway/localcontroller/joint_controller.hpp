// One joint's local controller: plays the points of its batch, servoes at 1 ms, filters its sensors and
// answers with one feedback frame a time slot. No heap, no exceptions, no operating system: it runs on a
// microcontroller.
#pragma once

#include <array>
#include <cstdint>

#include "gaitway/can/frame.hpp"
#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/localcontroller/point_player.hpp"
#include "gaitway/localcontroller/servo.hpp"
#include "gaitway/localcontroller/trim_slew.hpp"

namespace gaitway::localcontroller {

// A sensor channel, or the motor's current: sampled every millisecond, sent as the mean of its last ten
// samples.
class SensorFilter {
 public:
  static constexpr int kSamples = static_cast<int>(facts::kSlot_ns / facts::kMillisecond_ns);

  void add(float sample) noexcept {
    sum_ += sample - samples_[next_];
    samples_[next_] = sample;
    next_ = (next_ + 1) % kSamples;
    if (next_ == 0) {  // rounding of the running sum does not pile up
      sum_ = 0.0F;
      for (const float value : samples_) {
        sum_ += value;
      }
    }
    count_ = count_ < kSamples ? count_ + 1 : kSamples;
  }
  // Mean in counts of `scale` sensor units, rounded, saturating at the 16 bits of its channel.
  [[nodiscard]] std::int16_t counts(float scale) const noexcept {
    const float mean = count_ == 0 ? 0.0F : sum_ / static_cast<float>(count_) / scale;
    if (!(mean > -32767.0F)) {  // also what is not a number
      return -32767;
    }
    return mean < 32767.0F ? static_cast<std::int16_t>(mean < 0.0F ? mean - 0.5F : mean + 0.5F)
                           : std::int16_t{32767};
  }

 private:
  std::array<float, kSamples> samples_{};
  std::size_t next_ = 0;
  int count_ = 0;
  float sum_ = 0.0F;
};

// How often a joint's controller steps.
inline constexpr std::int64_t kServoPeriod_ns = facts::kMillisecond_ns;
inline constexpr double kServoPeriod_s = 0.001;

// What one joint's firmware is configured with; the loader fills it from the robot's network file.
struct JointConfig {
  can::Profile profile = can::kFullProfile;
  can::NodeId node = 0;
  double count_rad = 0.0;             // size of a count on the wire
  double encoder_count_rad = 0.0;     // size of an encoder count
  double encoder_zero_rad = 0.0;      // what the encoder says where the joint is at 0
  double stiffness_Nm_per_rad = 0.0;  // position gain of the servo
  double damping_Nms_per_rad = 0.0;   // velocity gain; the reference's velocity is fed forward
  double torque_limit_Nm = 0.0;       // fades to zero at speed_limit_rad_per_s in the driving direction
  double speed_limit_rad_per_s = 0.0;
  double lower_rad = 0.0, upper_rad = 0.0;  // position limits that the reference never leaves
  std::int32_t initial_reference_count = 0;
  bool senses_current = false;  // else it tells the torque that its servo asks for
  int trim_channel = -1;        // which of the trim frame's 8 values is this joint's; -1: none
  double trim_count_rad = 0.0;
  double trim_slew_rad_per_s = 0.0;
  double trim_limit_rad = 0.0;
  float channel_scale[can::kFeedbackChannels] = {1.0F, 1.0F};  // sensor unit per wire count
};

// What the joint's electronics read in one millisecond.
struct JointSensors {
  std::int32_t encoder_count = 0;
  float channel[can::kFeedbackChannels] = {0.0F, 0.0F};  // in sensor units (N, rad/s, m/s², rad)
  float motor_current_Nm = 0.0F;  // measured, times the torque constant that the motor should have
};

class JointController {
 public:
  explicit JointController(const JointConfig& config) noexcept;

  // Takes one received frame; `now_ns` is the joint's own clock.
  void on_frame(const can::Frame& frame, std::int64_t now_ns) noexcept;

  // One servo period (1 ms): returns the motor torque in N·m.
  double step(std::int64_t now_ns, const JointSensors& sensors) noexcept;

  // Ends an emergency stop, by a person's order only, which comes as the release of an emergency stop: the
  // joint holds where it was measured last, without trim, and takes batches again from the next SYNC on.
  void reset() noexcept;

  // The next frame to send, highest priority first; false when there is none.
  bool take_frame(can::Frame& frame) noexcept;
  // Identifier of that frame; past every identifier when there is none.
  [[nodiscard]] std::uint32_t next_id() const noexcept;
  // A frame that was offered to the bus and taken back, because a more urgent one came.
  void put_back(const can::Frame& frame) noexcept;

  // Reference count for the end of the running slot, and the interpolated reference that the servo tracks.
  [[nodiscard]] std::int32_t reference_count() const noexcept { return player_.count(); }
  [[nodiscard]] double reference_rad() const noexcept { return reference_rad_; }  // without trim
  [[nodiscard]] double trim_rad() const noexcept { return trim_.angle_rad(); }
  [[nodiscard]] can::JointState state() const noexcept;

 private:
  void on_sync(const can::Sync& sync, std::int64_t now_ns) noexcept;
  // A joint beyond the profile's nodes holds still and is not heard.
  [[nodiscard]] bool on_bus() const noexcept { return config_.node <= config_.profile.largest_node; }
  void on_trajectory(const can::Trajectory& batch, std::int64_t now_ns) noexcept;
  void on_user_command(const can::UserCommand& command, std::int64_t now_ns) noexcept;
  void on_stop(can::StopMode mode, std::int64_t now_ns) noexcept;
  void set_fault(can::Fault fault, bool present) noexcept;
  [[nodiscard]] bool report_due() const noexcept;
  void find_faults() noexcept;
  void follow_compliance() noexcept;
  [[nodiscard]] bool sync_is_lost() const noexcept;
  [[nodiscard]] double plausible_position_rad(std::int32_t encoder_count) noexcept;

  JointConfig config_;
  PointPlayer player_;
  Servo servo_;
  TrimSlew trim_;
  std::array<SensorFilter, can::kFeedbackChannels> channels_;
  SensorFilter current_;
  double reference_rad_;
  double measured_rad_ = 0.0;
  double torque_Nm_ = 0.0;
  double share_ = 1.0;  // of the servo's torque: less while the robot falls
  double share_asked_ = 1.0;
  double compliance_ = 0.0;  // of the servo: 1 while the joint holds and SYNC is lost
  bool soft_ = false;        // after an emergency stop; ends with a restart
  std::int64_t now_ns_ = 0;  // of the last step
  bool measured_ = false;    // the encoder has been read
  int implausible_ms_ = 0;   // for how long the encoder has stood where the joint cannot be
  int saturated_ms_ = 0;     // counts up while the servo is saturated, and down otherwise
  int slots_alone_ = 0;      // taken without a SYNC, in a row
  std::uint8_t faults_ = static_cast<std::uint8_t>(can::Fault::restarted);
  std::uint8_t new_faults_ = 0;  // that have begun since the last report, even if they have ended again
  std::uint8_t reported_faults_ = 0;
  std::int64_t next_report_ns_ = 0;  // not before: reports keep the profile's period
  bool feedback_pending_ = false;
};

}  // namespace gaitway::localcontroller
