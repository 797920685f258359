// The message table and its proof into JSON.
#include "gaitway/page/bus_assets.hpp"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <vector>

#include "gaitway/can/analysis/network_messages.hpp"
#include "gaitway/can/message_layout.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::page {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kMicrosecond_ns = 1e3;

double us(std::int64_t time_ns) {
  return static_cast<double>(time_ns) / kMicrosecond_ns;
}

const char* name_of(can::ReleaseSign sign) {
  static constexpr std::array<const char*, 6> kNames{"",     "slot_edge", "cycle_edge",
                                                     "sync", "batch",     "trajectory"};
  return kNames[static_cast<std::size_t>(sign)];
}

std::vector<std::uint32_t> identifiers_of(const can::Profile& profile, const can::Identified& message) {
  std::vector<std::uint32_t> ids{profile.id_of(message.kind, message.node, false, message.part)};
  if (can::has_toggle(profile.row(message.kind).rule)) {
    ids.push_back(profile.id_of(message.kind, message.node, true, message.part));
  }
  return ids;
}

Json message_of(const can::Profile& profile, const std::vector<can::NodeId>& nodes,
                const can::AnalysedMessage& analysed, const can::MessageResponse& response) {
  const can::Identified message = *profile.identify(analysed.id);
  const auto joint = std::ranges::find(nodes, message.node);
  const bool of_joint = message.node != 0 && joint != nodes.end();
  Json json;
  json["kind"] = can::layout(message.kind).name;
  json["id"] = analysed.id;
  json["ids"] = identifiers_of(profile, message);
  json["bytes"] = analysed.bytes;
  json["joint"] = of_joint ? joint - nodes.begin() : -1;
  json["sent_by_joint"] = can::layout(message.kind).sender == can::Sender::local_controller;
  json["period_us"] = us(analysed.period_ns);
  json["on_event"] = profile.row(message.kind).on_event;
  json["transmission_us"] = us(response.length_bits * facts::kBitTime_ns);
  json["released"] = name_of(can::release_sign(profile, message.kind));
  json["worst_us"] = response.worst_response_ns ? Json(us(*response.worst_response_ns)) : Json(nullptr);
  json["deadline_us"] = us(analysed.deadline_ns);
  return json;
}

}  // namespace

void add_bus(AssetTable& table, const urdf::RobotModel& robot) {
  const can::Profile profile = msgcontroller::network_profile(robot);
  const std::vector<can::NodeId> nodes = msgcontroller::joint_nodes(robot, profile);
  const can::Proof proof = msgcontroller::prove_network(robot);
  Json json{{"profile", profile.name},
            {"slot_us", us(facts::kSlot_ns)},
            {"cycle_slots", facts::kSlotsPerCycle},
            {"interframe_us", us(can::kInterframeBits * facts::kBitTime_ns)},
            {"load", proof.load},
            {"jitter_us", us(msgcontroller::kReleaseJitter_ns)},
            {"jam_us", us(msgcontroller::kJam_ns)},
            {"messages", Json::array()}};
  for (std::size_t i = 0; i < proof.messages.size(); ++i) {
    json["messages"].push_back(message_of(profile, nodes, proof.messages[i], proof.responses[i]));
  }
  table.add("/bus.json", "application/json", json.dump(), true);
}

}  // namespace gaitway::page
