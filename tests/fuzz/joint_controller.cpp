// A joint's local controller (localcontroller/joint_controller.hpp) under any frames, at any times, with any
// sensor readings. Whatever comes:
// - torque and references are numbers; the torque is within its limit, the reference within the joint's
// limits,
//   the trim within its own,
// - soft means no torque, and a stopped joint stays stopped until its release comes,
// - its frames are ones that the profile gives this node; at most one feedback comes for each SYNC (or batch,
//   where there is no SYNC) and each time slot of its own clock.
#include "gaitway/localcontroller/joint_controller.hpp"

#include <cmath>
#include <cstdint>
#include <span>

#include "fuzz_frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::fuzz {
namespace {

using localcontroller::JointConfig;
using localcontroller::JointController;
using localcontroller::JointSensors;

constexpr can::NodeId kNode = 7;
using facts::kMillisecond_ns;
constexpr double kTolerance = 1e-9;

JointConfig take_config(Input& input) {
  JointConfig config;
  config.profile = take_profile(input);
  config.node = kNode;
  config.count_rad = 0.05 * 3.141592653589793 / 180.0;
  config.encoder_count_rad = 6.283185307179586 / 65536.0;
  config.stiffness_Nm_per_rad = 300.0;
  config.damping_Nms_per_rad = 4.0;
  config.torque_limit_Nm = 8.0;
  config.speed_limit_rad_per_s = 8.0;
  config.lower_rad = -0.5;
  config.upper_rad = 1.0;
  config.trim_channel = static_cast<int>(input.choose(9)) - 1;
  config.senses_current = config.trim_channel % 2 == 0;
  config.trim_count_rad = 0.001;
  config.trim_slew_rad_per_s = 2.0;
  config.trim_limit_rad = 0.05;
  config.channel_scale[0] = 0.01F;
  return config;
}

class Joint {
 public:
  explicit Joint(const JointConfig& config) : config_(config), controller_(config) {}

  void receive(const can::Frame& frame) {
    const auto identified = config_.profile.identify(frame.id);
    const bool starts_slots =
        identified && !frame.extended && !frame.remote &&
        (identified->kind == can::MessageKind::sync ||
         (identified->kind == can::MessageKind::trajectory && !config_.profile.has(can::MessageKind::sync)));
    allowed_feedback_ += starts_slots ? 1 : 0;
    controller_.on_frame(frame, now_ns_);
    stopped_ = stopped_ && !is_release(frame);
    check_stop();
  }

  void step(std::int64_t elapsed_ns, const JointSensors& sensors) {
    now_ns_ += elapsed_ns;
    const double torque_Nm = controller_.step(now_ns_, sensors);
    require(std::abs(torque_Nm) <= config_.torque_limit_Nm, "the torque is a number within its limit");
    const double reference_rad = controller_.reference_rad();
    require(
        reference_rad >= config_.lower_rad - kTolerance && reference_rad <= config_.upper_rad + kTolerance,
        "the reference is a number within the joint's limits");
    require(controller_.reference_count() * config_.count_rad >= config_.lower_rad - kTolerance &&
                controller_.reference_count() * config_.count_rad <= config_.upper_rad + kTolerance,
            "the reference count is within the joint's limits");
    require(std::abs(controller_.trim_rad()) <= config_.trim_limit_rad + kTolerance,
            "the trim is a number within its limit");
    require(controller_.state() != can::JointState::soft || torque_Nm == 0.0, "soft means no torque");
    check_stop();
  }

  void take_frames() {
    can::Frame frame;
    constexpr int kMost = 4;  // one feedback and one fault report wait at most
    int frames = 0;
    for (; frames < kMost && controller_.take_frame(frame); ++frames) {
      const auto identified = config_.profile.identify(frame.id);
      require(can::is_valid(frame) && identified && identified->node == kNode,
              "it sends its own frames only");
      if (const auto feedback = can::decode_feedback(config_.profile, frame)) {
        ++feedback_;
        require(feedback->state == controller_.state(), "feedback tells its state");
      } else {
        require(can::decode_fault_report(config_.profile, frame).has_value(), "it sends no other messages");
      }
    }
    require(frames < kMost, "its frames come to an end");
    // One more for the slot that began before the first step.
    require(feedback_ <= allowed_feedback_ + now_ns_ / facts::kSlot_ns + 1, "one feedback a SYNC or slot");
  }

  void reset() {
    controller_.reset();
    stopped_ = false;
    ++allowed_feedback_;  // its slots begin again
  }

 private:
  void check_stop() {
    const can::JointState state = controller_.state();
    const bool stopped = state == can::JointState::soft || state == can::JointState::stopped;
    require(stopped || !stopped_, "nothing on the bus but its release ends a stop");
    stopped_ = stopped;
  }

  bool is_release(const can::Frame& frame) const {
    if (const auto stop = can::decode_emergency_stop(config_.profile, frame)) {
      return stop->mode == can::StopMode::release;
    }
    const auto command = can::decode_user_command(config_.profile, frame);
    return command && command->node == 0 && command->target_count == static_cast<int>(can::StopMode::release);
  }

  JointConfig config_;
  JointController controller_;
  std::int64_t now_ns_ = 0;
  std::int64_t allowed_feedback_ = 0, feedback_ = 0;
  bool stopped_ = false;
};

JointSensors take_sensors(Input& input) {
  JointSensors sensors;
  sensors.encoder_count = input.take<std::int32_t>();
  for (float& channel : sensors.channel) {
    channel = input.take_float();
  }
  sensors.motor_current_Nm = sensors.channel[0];
  return sensors;
}

}  // namespace

void joint_controller(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const JointConfig config = take_config(input);
  Joint joint(config);
  JointSensors sensors;
  while (!input.empty()) {
    switch (input.choose(8)) {
      case 0:
        joint.receive(take_frame(input));
        break;
      case 1:
        sensors = take_sensors(input);
        break;
      case 2:
        sensors.encoder_count = input.take<std::int16_t>();
        break;
      case 3:  // some servo periods in a row
        for (std::size_t period = input.choose(64); period > 0; --period) {
          joint.step(kMillisecond_ns, sensors);
        }
        break;
      case 4:  // a clock that jumps, by up to 70 minutes
        joint.step(std::int64_t{input.take<std::uint32_t>()} * 1000, sensors);
        break;
      case 5:
        joint.reset();
        break;
      default:
        joint.receive(take_known_frame(input, config.profile, kNode));
    }
    joint.take_frames();
  }
}

}  // namespace gaitway::fuzz
