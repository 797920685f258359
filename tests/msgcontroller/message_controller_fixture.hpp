// The message controller of the shipped robot and its joints' real local controllers on a small bus, for
// tests: frames can be dropped, and other stations can speak.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <vector>

#include "gaitway/can/profile.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/localcontroller/joint_controller.hpp"
#include "gaitway/msgcontroller/message_controller.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

using facts::kCycle_ns;
using facts::kMillisecond_ns;
using facts::kSlot_ns;
using msgclient::Verdict;

// All joints' real local controllers; every frame arrives 120 µs after the one before, unless it is dropped.
class JointsOnABus {
 public:
  explicit JointsOnABus(const urdf::RobotModel& robot) : robot_(robot) {
    for (const urdf::Joint& joint : robot.joints) {
      joints_.emplace_back(config_of(joint));
    }
    sensors.resize(joints_.size());
    for (std::size_t j = 0; j < joints_.size(); ++j) {  // they stand where they are meant to
      const urdf::Joint& joint = robot.joints[j];
      sensors[j].encoder_count = static_cast<std::int32_t>(
          std::lround(home_count(joint) * joint.count_rad / joint.encoder_count_rad));
    }
  }
  static std::int32_t home_count(const urdf::Joint& joint) {
    return static_cast<std::int32_t>(std::lround(joint.home_rad / joint.count_rad));
  }

  // Frames of the message controller that no joint gets, and of joints that it does not get.
  std::function<bool(const can::Frame&)> drop = [](const can::Frame&) { return false; };
  std::function<bool(const can::Frame&)> drop_from_joint = [](const can::Frame&) { return false; };
  std::map<can::MessageKind, int> sent;
  std::vector<localcontroller::JointSensors> sensors;  // of each joint

  void millisecond(MessageController& controller, std::int64_t now_ns) {
    for (std::size_t joint = 0; joint < joints_.size(); ++joint) {
      joints_[joint].step(now_ns, sensors[joint]);
    }
    controller.step(now_ns);
    std::int64_t at_ns = now_ns;
    can::Frame frame;
    bool busy = true;
    while (busy) {
      busy = false;
      while (controller.take_frame(frame)) {
        busy = true;
        at_ns += kFrame_ns;
        ++sent[controller.profile().identify(frame.id)->kind];
        controller.on_notice({can::BusNotice::Kind::sent, {frame, at_ns - kFrame_ns, at_ns}});
        if (!drop(frame)) {
          for (localcontroller::JointController& joint : joints_) {
            joint.on_frame(frame, at_ns);
          }
        }
      }
      for (localcontroller::JointController& joint : joints_) {
        while (joint.take_frame(frame)) {
          busy = true;
          if (!drop_from_joint(frame)) {
            controller.on_frame(frame, at_ns);
          }
        }
      }
    }
  }
  // A frame of a station that does not belong there: everybody hears it.
  void intrude(MessageController& controller, const can::Frame& frame, std::int64_t now_ns) {
    controller.on_frame(frame, now_ns);
    for (localcontroller::JointController& joint : joints_) {
      joint.on_frame(frame, now_ns);
    }
  }
  // Without its supply for a moment: what it has been told is gone.
  void restart(std::size_t joint) {
    joints_[joint] = localcontroller::JointController(config_of(robot_.joints[joint]));
  }
  [[nodiscard]] localcontroller::JointController& joint(std::size_t index) { return joints_[index]; }
  [[nodiscard]] std::int32_t count(std::size_t joint) const { return joints_[joint].reference_count(); }
  [[nodiscard]] std::size_t size() const { return joints_.size(); }

 private:
  [[nodiscard]] localcontroller::JointConfig config_of(const urdf::Joint& joint) const {
    localcontroller::JointConfig config;
    config.profile = network_profile(robot_);
    config.node = joint.node;
    config.count_rad = joint.count_rad;
    config.encoder_count_rad = joint.encoder_count_rad;
    config.lower_rad = joint.lower_rad;
    config.upper_rad = joint.upper_rad;
    config.initial_reference_count = home_count(joint);
    return config;
  }
  static constexpr std::int64_t kFrame_ns = 10'000;  // short enough that a burst fits its millisecond
  const urdf::RobotModel& robot_;
  std::vector<localcontroller::JointController> joints_;
};

class MessageControllerTest : public ::testing::Test {
 protected:
  // From now on the bus drops one in twenty of the frames that move joints, the same ones in every run.
  void lose_some_of_the_motion() {
    bus_.drop = [state = std::uint32_t{1}](const can::Frame& frame) mutable {
      state = state * 1664525U + 1013904223U;
      const auto kind = can::kFullProfile.identify(frame.id)->kind;
      const bool may_be_lost = kind == can::MessageKind::trajectory ||
                               kind == can::MessageKind::resynchronisation || kind == can::MessageKind::sync;
      return may_be_lost && (state >> 16U) % 20U == 0;
    };
  }
  void run_until(std::int64_t time_ns) {
    for (; now_ns_ < time_ns; now_ns_ += kMillisecond_ns) {
      bus_.millisecond(controller_, now_ns_);
      if (every_millisecond) {
        every_millisecond();
      }
    }
  }

  // A batch that moves every joint by one count a point, then a tail of `tail` points that goes on half as
  // fast.
  msgclient::HandOver batch(std::uint32_t sequence, int tail = 20) {
    msgclient::HandOver hand_over;
    hand_over.sequence = sequence;
    hand_over.joint_count = static_cast<std::uint32_t>(robot_.joints.size());
    hand_over.point_count = static_cast<std::uint32_t>(kBatchPoints + tail);
    const int batches_before = static_cast<int>(sequence) - first_sequence_;
    for (int point = 0; point < kBatchPoints + tail; ++point) {
      const int tail_point = std::max(point - kBatchPoints + 1, 0);
      const int moved = 8 * batches_before + std::min(point + 1, kBatchPoints) + tail_point / 2;
      for (int joint = 0; joint < static_cast<int>(robot_.joints.size()); ++joint) {
        const urdf::Joint& description = robot_.joints[static_cast<std::size_t>(joint)];
        const double angle = (JointsOnABus::home_count(description) + moved) * description.count_rad;
        hand_over.set_position(point, joint, static_cast<float>(angle));
      }
    }
    return hand_over;
  }
  // Hands over at 64 ms in the cycle before.
  msgclient::Answer hand_over(std::uint32_t sequence, int tail = 20) {
    run_until(std::int64_t{sequence} * kCycle_ns - 16 * kMillisecond_ns);
    const auto mail = std::make_unique<msgclient::HandOver>(batch(sequence, tail));
    EXPECT_TRUE(adapter_.host().post(*mail, now_ns_));
    run_until(now_ns_ + 3 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    EXPECT_TRUE(answer.has_value());
    return answer.value_or(msgclient::Answer{.verdict = Verdict::corrupt});
  }
  // Every joint's count, from its home, is `moved`.
  void expect_moved(std::int32_t moved) {
    for (std::size_t joint = 0; joint < bus_.size(); ++joint) {
      EXPECT_EQ(bus_.count(joint) - JointsOnABus::home_count(robot_.joints[joint]), moved)
          << "joint " << joint;
    }
  }

  explicit MessageControllerTest(const std::string& profile = "full") : robot_(robot_with(profile)) {}
  static urdf::RobotModel robot_with(const std::string& profile) {
    urdf::RobotModel robot =
        urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
    robot.network.profile = profile;
    return robot;
  }
  void command(msgclient::UserCommandKind kind) {
    const msgclient::UserCommandMail mail{.sequence = ++commands_, .kind = kind};
    ASSERT_TRUE(adapter_.host().post(mail, now_ns_));
    run_until(now_ns_ + 2 * kMillisecond_ns);
    const auto answer = adapter_.host().take_answer(now_ns_);
    ASSERT_TRUE(answer);
    ASSERT_EQ(answer->verdict, Verdict::accepted);
  }

  urdf::RobotModel robot_;
  msgclient::MemoryBlock block_;
  msgclient::EmiAdapter adapter_{block_};
  msgclient::Client client_ = block_.local_client("message_controller");
  MessageController controller_{robot_, client_, adapter_.message()};
  JointsOnABus bus_{robot_};
  std::int64_t now_ns_ = 0;
  int first_sequence_ = 2;
  std::function<void()> every_millisecond;
  std::uint32_t commands_ = 0;
};

}  // namespace gaitway::msgcontroller
