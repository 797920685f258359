// What the parts of the message controller share: the way onto the bus, the time slot that runs, and what is
// told of them in the topic `network_state`.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/can/messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "gaitway/msgcontroller/network_watch.hpp"
#include "gaitway/msgcontroller/transmit_queue.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

enum class Mode : std::uint32_t {
  batches = network_state::mode::batches,
  safe_tail = network_state::mode::safe_tail,
  holding = network_state::mode::holding,
  emergency_stop = network_state::mode::emergency_stop
};

class BusLink {
 public:
  explicit BusLink(const urdf::RobotModel& robot)
      : profile(network_profile(robot)),
        joint_count(static_cast<int>(robot.joints.size())),
        node(joint_nodes(robot, profile)),
        watch(profile, node) {
    for (const urdf::Joint& joint : robot.joints) {
      count_rad.push_back(joint.count_rad);
      lower_rad.push_back(joint.lower_rad);
      upper_rad.push_back(joint.upper_rad);
    }
    set_mode(Mode::holding);
  }

  // Into the queue; while this station is off the bus, or the queue is full, the frame is counted as lost.
  void send(const can::Frame& frame, std::int64_t expires_ns = kNeverExpires_ns) noexcept {
    if (off_the_bus()) {
      watch.count(Incident::flushed);
    } else if (!queue.push(frame, expires_ns)) {
      watch.count(Incident::queue_full);
    }
  }
  // Whether batches start on a SYNC; else each starts as it arrives.
  [[nodiscard]] bool synchronised() const noexcept { return profile.has(can::MessageKind::sync); }
  [[nodiscard]] bool off_the_bus() const noexcept { return watch.bus_state() >= can::BusState::bus_off; }
  [[nodiscard]] Mode mode() const noexcept { return static_cast<Mode>(state.mode); }
  void set_mode(Mode mode) noexcept { state.mode = static_cast<std::uint32_t>(mode); }

  can::Profile profile;
  int joint_count;
  std::vector<can::NodeId> node;  // of each joint; 0: not on the bus, holds still
  std::vector<double> count_rad;  // of each joint
  std::vector<double> lower_rad, upper_rad;
  TransmitQueue queue;
  NetworkWatch watch;
  std::int64_t slot_start_ns = 0;
  std::uint32_t slots_since_start = 0;
  NetworkState state{};
};

}  // namespace gaitway::msgcontroller
