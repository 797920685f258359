// A joint controller without a bus, for tests: steps, SYNCs and what it sends.
#pragma once

#include "gaitway/facts/facts.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>
#include <vector>

namespace gaitway::localcontroller {
using facts::kMillisecond_ns;
inline constexpr can::NodeId kNode = 7;

class JointControllerTest : public testing::Test {
 protected:
  static JointConfig config() {
    JointConfig joint;
    joint.node = kNode;
    joint.count_rad = 0.05 * 3.141592653589793 / 180.0;
    joint.encoder_count_rad = 6.283185307179586 / 65536.0;
    joint.stiffness_Nm_per_rad = 300.0;
    joint.damping_Nms_per_rad = 4.0;
    joint.torque_limit_Nm = 8.0;
    joint.speed_limit_rad_per_s = 8.0;
    joint.lower_rad = -1.0;
    joint.upper_rad = 1.0;
    joint.trim_channel = 2;
    joint.trim_count_rad = 0.001;
    joint.trim_slew_rad_per_s = 2.0;
    joint.trim_limit_rad = 0.05;
    joint.channel_scale[0] = 0.01F;
    joint.channel_scale[1] = 0.001F;
    return joint;
  }
  // Every joint says first of all that it has started; the tests look at what comes after.
  void SetUp() override {
    joint.step(now_ns, sensors);
    EXPECT_EQ(fault_reports(), std::vector<int>{kRestarted});
  }
  static constexpr int kRestarted = static_cast<int>(can::Fault::restarted);
  static constexpr int kReportPeriod_ms = 80;

  // One millisecond.
  double step() {
    now_ns += kMillisecond_ns;
    return joint.step(now_ns, sensors);
  }
  void run(int milliseconds) {
    for (int i = 0; i < milliseconds; ++i) {
      step();
    }
  }
  // Time slots of a robot that stands.
  void run_slots(int count) {
    for (int i = 0; i < count; ++i) {
      sync(next_slot);
      next_slot = (next_slot + 1) % 8;
      cycle = static_cast<std::uint16_t>(cycle + (next_slot == 0 ? 1 : 0));
      run(10);
    }
  }
  template <class Message>
  void send(const Message& message) {
    joint.on_frame(can::encode(can::kFullProfile, message), now_ns);
  }
  void sync(int slot, bool committed = false, bool toggle = false) {
    send(can::Sync{cycle, static_cast<std::uint8_t>(slot), committed, toggle});
  }
  std::vector<can::Frame> frames() {
    std::vector<can::Frame> all;
    can::Frame frame;
    while (joint.take_frame(frame)) {
      all.push_back(frame);
    }
    return all;
  }
  std::optional<can::Feedback> feedback() {
    std::optional<can::Feedback> last;
    for (const can::Frame& frame : frames()) {
      if (const auto decoded = can::decode_feedback(can::kFullProfile, frame)) {
        last = decoded;
      }
    }
    return last;
  }

  std::vector<int> fault_reports() {
    std::vector<int> masks;
    for (const can::Frame& frame : frames()) {
      if (const auto report = can::decode_fault_report(can::kFullProfile, frame)) {
        EXPECT_EQ(report->node, kNode);
        masks.push_back(report->faults);
      }
    }
    return masks;
  }

  std::uint16_t cycle = 1;
  std::int64_t now_ns = 0;
  int next_slot = 0;
  JointSensors sensors;
  JointController joint{config()};
};

}  // namespace gaitway::localcontroller
