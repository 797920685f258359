// The response-time analysis of one robot's bus.
#include "gaitway/msgcontroller/network_proof.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::msgcontroller {
namespace {

using facts::kMillisecond_ns;

can::Proof prove(const urdf::RobotModel& robot, const can::ErrorModel& errors) {
  const can::Profile profile = network_profile(robot);
  return can::prove(profile, nodes_on_bus(profile, robot),
                    {.jitter_ns = kReleaseJitter_ns, .errors = errors});
}

}  // namespace

can::Proof prove_network(const urdf::RobotModel& robot) {
  return prove(robot, can::jam(kJam_ns));
}

std::string complaint_about_network(const urdf::RobotModel& robot) {
  const can::Proof proof = prove_network(robot);
  if (proof.holds()) {
    return {};
  }
  return fmt::format(
      "robot '{}': its bus cannot be proven: {} (release jitter {} ms, one jam of {} ms, load {:.1f} %). Put "
      "fewer joints on the bus, choose other identifiers or deadlines (network.messages in {}), see `gaitway "
      "bus analyze`; or accept it with --accept-unproven",
      robot.name, proof.complaint(), kReleaseJitter_ns / kMillisecond_ns, kJam_ns / kMillisecond_ns,
      100.0 * proof.load, (robot.directory / "robot.yaml").string());
}

void require_proven_network(const urdf::RobotModel& robot, bool accept_unproven) {
  const std::string complaint = complaint_about_network(robot);
  if (complaint.empty()) {
    return;
  }
  if (!accept_unproven) {
    throw urdf::RobotError(complaint);
  }
  fmt::print(stderr, "warning: {}\n", complaint);
}

std::int64_t hand_over_lead_ns(const urdf::RobotModel& robot) {
  const auto response_ns = prove(robot, {}).worst_response_ns(can::MessageKind::trajectory);
  // The response counts from the earliest instant of release, but the frames are released at the hand-over.
  const std::int64_t under_way_ns = response_ns ? *response_ns - kReleaseJitter_ns : facts::kCycle_ns;
  const std::int64_t lead_ns = (under_way_ns + kMillisecond_ns - 1) / kMillisecond_ns * kMillisecond_ns;
  return std::clamp(lead_ns, kMillisecond_ns, facts::kCycle_ns - facts::kSlot_ns);
}

}  // namespace gaitway::msgcontroller
