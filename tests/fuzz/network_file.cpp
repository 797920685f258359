// robot.yaml (urdf/robot_files.hpp) and the bus that it describes (msgcontroller/network_profile.hpp).
// Whatever the text: it is refused with urdf::RobotError and nothing else, or every joint has a node and
// sizes of its own that can be worked with, and no two messages of the profile share an identifier.
#include "urdf/robot_files.hpp"

#include <cmath>
#include <cstdint>
#include <set>
#include <span>

#include "fuzz_input.hpp"
#include "gaitway/can/message_layout.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"
#include "memory_file.hpp"
#include "robot.hpp"

namespace gaitway::fuzz {
namespace {

void check_joints(const urdf::NetworkFile& network) {
  std::set<int> nodes;
  for (const urdf::NetworkJoint& entry : network.joints) {
    const urdf::Joint& joint = entry.joint;
    require(joint.node >= 1 && joint.node <= can::kLargestNode && nodes.insert(joint.node).second,
            "every joint has a node of its own");
    require(
        joint.count_rad > 0.0 && joint.encoder_count_rad > 0.0 && joint.encoder_count_rad <= joint.count_rad,
        "counts have a size");
    require(std::isfinite(joint.motor.torque_limit_Nm) && joint.motor.torque_limit_Nm > 0.0 &&
                joint.motor.speed_limit_rad_per_s > 0.0,
            "motors have limits");
    require(joint.trim_channel >= -1 && joint.trim_channel < facts::kTrimChannels, "trim channels exist");
  }
}

void check_identifiers(const can::Profile& profile) {
  for (std::uint32_t id = 0; id <= can::kLargestId; ++id) {
    if (const auto identified = profile.identify(id)) {
      require(profile.id_of(identified->kind, identified->node, identified->toggle, identified->part) == id,
              "an identifier belongs to one message");
    }
  }
  for (std::size_t k = 0; k < can::kMessageKinds; ++k) {
    const auto kind = static_cast<can::MessageKind>(k);
    const bool of_nodes = profile.row(kind).rule >= can::IdRule::per_node;
    const can::NodeId node = of_nodes ? profile.largest_node : can::NodeId{0};
    if (profile.has(kind)) {
      const auto identified = profile.identify(profile.id_of(kind, node));
      require(identified && identified->kind == kind && identified->node == node,
              "a message's identifier names it");
      require(profile.last_id(kind) <= can::kLargestId, "identifiers have eleven bits");
      require(profile.row(kind).period_ns > 0 && profile.row(kind).deadline_ns > 0, "times are positive");
    }
  }
}

}  // namespace

void network_file(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  try {
    const urdf::NetworkFile network = urdf::read_network_file(file.path());
    check_joints(network);
    urdf::RobotModel robot = shipped_robot();
    robot.network = network.network;
    check_identifiers(msgcontroller::network_profile(robot));
  } catch (const urdf::RobotError&) {
  }
}

}  // namespace gaitway::fuzz
