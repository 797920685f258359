// A trace from a seed: joints of both profiles with random configurations, every kind of message at its
// usual and at unusual times, losses, repetitions, frames that are none of the network's, sensors that say
// anything, restarts.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <random>
#include <vector>

#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/firmware/joint.hpp"
#include "trace_writer.hpp"

namespace gaitway::firmware {

class SyntheticTrace {
 public:
  static constexpr int kJoints = 8;

  explicit SyntheticTrace(std::uint64_t seed) : random_(seed) {
    for (int index = 0; index < kJoints; ++index) {
      configs_[static_cast<std::size_t>(index)] = random_config(index);
    }
  }
  [[nodiscard]] localcontroller::JointConfig& config(int index) {
    return configs_[static_cast<std::size_t>(index)];
  }

  // Plays the network for so many milliseconds.
  [[nodiscard]] std::vector<std::uint8_t> write(int milliseconds) {
    for (int index = 0; index < kJoints; ++index) {
      trace_.joint(index, config(index));
    }
    for (int ms = 0; ms < milliseconds; ++ms) {
      now_ns_ = ms * std::int64_t{1'000'000};
      if (ms % 10 == 0) {
        slot(ms / 10);
      }
      if (chance(0.02)) {
        deliver(random_frame());
      }
      if (chance(0.001)) {
        emergency_stop();
      }
      if (chance(0.001)) {
        const int index = static_cast<int>(below(kJoints));  // its power fails for a moment
        trace_.joint(index, held_where_found(config(index), encoder_[static_cast<std::size_t>(index)]));
      }
      for (int index = 0; index < kJoints; ++index) {
        trace_.step(index, local_time_ns(index), sensors(index, ms));
        trace_.take(index);
      }
    }
    return trace_.finish();
  }

 private:
  std::uint64_t below(std::uint64_t limit) { return random_() % limit; }
  // [0, 1)
  double unit() { return static_cast<double>(random_() >> 11U) * 0x1.0p-53; }
  bool chance(double probability) { return unit() < probability; }
  double between(double lowest, double highest) { return lowest + (highest - lowest) * unit(); }
  std::int8_t byte() { return static_cast<std::int8_t>(below(256)); }
  std::int8_t small_step() { return static_cast<std::int8_t>(static_cast<int>(below(61)) - 30); }

  localcontroller::JointConfig random_config(int index) {
    localcontroller::JointConfig config;
    config.profile = index < 6 ? can::kFullProfile : can::kPaperProfile;
    config.node = static_cast<can::NodeId>(index + 1);
    config.count_rad = between(0.0003, 0.002);
    config.encoder_count_rad = between(0.00001, 0.0001);
    config.stiffness_Nm_per_rad = between(50.0, 400.0);
    config.damping_Nms_per_rad = between(0.5, 5.0);
    config.torque_limit_Nm = between(2.0, 20.0);
    config.speed_limit_rad_per_s = chance(0.2) ? 0.0 : between(2.0, 10.0);
    config.lower_rad = between(-2.0, -0.2);
    config.upper_rad = between(0.2, 2.0);
    config.initial_reference_count = static_cast<std::int32_t>(between(-90.0, 90.0));
    config.senses_current = chance(0.5);
    config.trim_channel = chance(0.7) ? static_cast<int>(below(8)) : -1;
    config.trim_count_rad = between(0.0005, 0.002);
    config.trim_slew_rad_per_s = between(0.5, 5.0);
    config.trim_limit_rad = between(0.05, 0.2);
    for (float& scale : config.channel_scale) {
      scale = static_cast<float>(between(0.0001, 0.02));
    }
    return config;
  }

  // Clocks differ by up to 2 %, which is worse than any crystal, and a frame's time has its jitter.
  std::int64_t local_time_ns(int index) {
    return now_ns_ + now_ns_ / 50 * (index - kJoints / 2) / (kJoints / 2) +
           static_cast<std::int64_t>(below(1000));
  }

  // To every joint that does not miss it.
  void deliver(const can::Frame& frame, double loss = 0.02) {
    trace_.frame(frame);
    for (int index = 0; index < kJoints; ++index) {
      const int times = chance(loss) ? 0 : chance(0.02) ? 2 : 1;
      for (int time = 0; time < times; ++time) {
        trace_.received(index, local_time_ns(index));
        if (chance(0.5)) {
          trace_.take(index);
        }
      }
    }
  }
  template <class Message>
  void send(const Message& message) {
    deliver(can::encode(can::kFullProfile, message));
    if constexpr (std::is_same_v<Message, can::Trajectory> || std::is_same_v<Message, can::UserCommand>) {
      deliver(can::encode(can::kPaperProfile, message));
    }
  }

  void slot(int number) {
    const auto slot = static_cast<std::uint8_t>(number % 8);
    const auto cycle = static_cast<std::uint16_t>(65'530 + number / 8);  // wraps on the way
    const bool walks = number / 8 % 12 < 9;  // then stands for three cycles, when user commands count
    const bool toggle = number / 8 % 2 == 1;
    now_ns_ += static_cast<std::int64_t>(below(chance(0.1) ? 2'000'000 : 100'000));
    send(can::Sync{cycle, slot, walks, toggle});
    send_trim();
    if (slot == 5 && (number / 8 + 1) % 12 < 9) {
      send_batches(!toggle);
    }
    if (chance(0.1)) {
      send(can::Resynchronisation{node(),
                                  toggle,
                                  static_cast<std::uint8_t>(below(8)),
                                  static_cast<std::int16_t>(between(-300.0, 300.0)),
                                  {small_step(), small_step(), small_step(), small_step(), small_step()}});
    }
    if (chance(walks ? 0.02 : 0.2)) {
      send(can::UserCommand{node(), static_cast<std::int16_t>(below(65'536)),
                            static_cast<std::uint8_t>(below(chance(0.2) ? 256 : 20))});
    }
    if (slot == 0) {
      send(can::Heartbeat{1, cycle});
    }
  }
  void send_trim() {
    if (chance(0.7)) {
      send(can::Trim{{byte(), byte(), byte(), byte(), byte(), byte(), byte(), byte()}});
    }
  }
  void send_batches(bool toggle) {
    for (int index = 0; index < kJoints; ++index) {
      can::Trajectory batch{static_cast<can::NodeId>(index + 1), toggle, {}};
      for (std::int8_t& delta : batch.delta) {
        delta = chance(0.02) ? byte() : small_step();
      }
      send(batch);
    }
  }
  can::NodeId node() { return static_cast<can::NodeId>(1 + below(kJoints)); }

  void emergency_stop() {
    send(can::EmergencyStop{chance(0.5) ? can::StopMode::soft : can::StopMode::hold});
    for (int index = 0; index < kJoints; ++index) {
      trace_.step(index, local_time_ns(index), sensors(index, 0));
      trace_.reset(index);
    }
  }

  can::Frame random_frame() {
    can::Frame frame;
    frame.extended = chance(0.2);
    frame.remote = chance(0.2);
    frame.id = static_cast<std::uint32_t>(below(frame.extended ? can::kLargestExtendedId + 1 : 0x400));
    frame.size = static_cast<std::uint8_t>(below(9));
    for (std::uint8_t& data : frame.data) {
      data = static_cast<std::uint8_t>(below(256));
    }
    return frame;
  }

  localcontroller::JointSensors sensors(int index, int ms) {
    std::int32_t& encoder = encoder_[static_cast<std::size_t>(index)];
    encoder += static_cast<std::int32_t>(below(400)) - 200 - encoder / 64;
    localcontroller::JointSensors sensors;
    sensors.encoder_count =
        chance(0.002) ? static_cast<std::int32_t>(below(20'000'000)) - 10'000'000 : encoder;
    sensors.channel[0] = static_cast<float>(between(-30.0, 30.0)) + static_cast<float>(ms % 100);
    sensors.channel[1] =
        chance(0.01) ? std::bit_cast<float>(static_cast<std::uint32_t>(random_()))  // also what is no number
                     : static_cast<float>(between(-1.0, 1.0));
    sensors.motor_current_Nm = static_cast<float>(ms % 97) * 0.25F - 12.0F;
    return sensors;
  }

  std::mt19937_64 random_;
  TraceWriter trace_;
  std::array<localcontroller::JointConfig, kJoints> configs_;
  std::array<std::int32_t, kJoints> encoder_{};
  std::int64_t now_ns_ = 0;
};

}  // namespace gaitway::firmware
