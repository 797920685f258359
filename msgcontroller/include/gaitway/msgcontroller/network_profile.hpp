// The messages of one robot's bus: the profile that its network file names, with what the file wants changed;
// whether they keep every deadline, and so how late a batch may be handed over.
#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::msgcontroller {

// The robot of a folder, on whose bus is the profile of that name; empty: what its network file says.
[[nodiscard]] urdf::RobotModel load_robot(const std::filesystem::path& folder, const std::string& profile);

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

// What a robot's bus has to stand: every message up to a millisecond late at its sender, everything that
// comes on events at once on all nodes, and the bus jammed for two milliseconds.
inline constexpr std::int64_t kReleaseJitter_ns = 1'000'000;
inline constexpr std::int64_t kJam_ns = 2'000'000;

// Throws urdf::RobotError for a network file that makes no profile.
[[nodiscard]] can::Proof prove_network(const urdf::RobotModel& robot);

// Empty when the bus is proven; otherwise a sentence that names the first message that misses its deadline
// and by how much, and what to do.
[[nodiscard]] std::string complaint_about_network(const urdf::RobotModel& robot);

// Empty when the joints get as many points for the time after their batch as this robot's steps take;
// otherwise a sentence that says what that means.
[[nodiscard]] std::string note_on_tails(const urdf::RobotModel& robot);

// Throws urdf::RobotError with that complaint, unless it is accepted: then it goes to stderr as a warning. So
// does the note on tails.
void require_proven_network(const urdf::RobotModel& robot, bool accept_unproven);

// A batch is handed over at the latest so long before it starts: its last trajectory frame has arrived by
// then, whatever else is on the bus, as long as that is free of errors. Whole milliseconds. (After errors it
// may be later; then the joints that have no batch yet are resynchronised within the next time slots.)
[[nodiscard]] std::int64_t hand_over_lead_ns(const urdf::RobotModel& robot);

}  // namespace gaitway::msgcontroller
