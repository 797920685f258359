// The messages of one robot's bus: the profile that its network file names, with what the file wants changed.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/can/profile.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

// Throws urdf::RobotError naming file, line and rule: an unknown profile or message, an identifier that two
// messages would share, a message that is longer under way than it may be.
[[nodiscard]] can::Profile network_profile(const urdf::RobotModel& robot);

// Whether a joint has a local controller on the bus; the others of a small profile hold still.
[[nodiscard]] inline bool is_on_bus(const can::Profile& profile, const urdf::Joint& joint) noexcept {
  return joint.node <= profile.largest_node;
}
// The node of each joint; 0: it is not on the bus.
[[nodiscard]] std::vector<can::NodeId> joint_nodes(const urdf::RobotModel& robot,
                                                   const can::Profile& profile);
// The nodes on the bus, in the order of the joints.
[[nodiscard]] std::vector<can::NodeId> nodes_on_bus(const can::Profile& profile,
                                                    const urdf::RobotModel& robot);

}  // namespace gaitway::msgcontroller
