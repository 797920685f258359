// Finds the profile, applies the network file's wishes and checks what comes out.
#include "gaitway/msgcontroller/network_profile.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::msgcontroller {
namespace {

using can::IdRule;
using can::MessageKind;
using can::Profile;

[[noreturn]] void refuse(const urdf::RobotModel& robot, int line, const std::string& field,
                         const std::string& rule, const std::string& remedy) {
  const std::string place = line > 0 ? fmt::format(":{}", line) : std::string();
  throw urdf::RobotError(
      fmt::format("{}{}: {}: {}. {}", (robot.directory / "robot.yaml").string(), place, field, rule, remedy));
}

// "fault report" is `fault_report` in the file.
std::string key_of(MessageKind kind) {
  std::string key(can::layout(kind).name);
  std::ranges::transform(key, key.begin(), [](char c) {
    return c == ' ' ? '_' : c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  return key;
}

MessageKind kind_of(const urdf::RobotModel& robot, const Profile& profile,
                    const urdf::MessageSetting& setting) {
  std::vector<std::string> known;
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    if (!profile.has(message.kind)) {
      continue;
    }
    if (key_of(message.kind) == setting.message) {
      return message.kind;
    }
    known.push_back(key_of(message.kind));
  }
  refuse(robot, setting.line, "network.messages." + setting.message,
         fmt::format("the profile '{}' has no such message", profile.name),
         input::suggest(setting.message, known));
}

void apply(const urdf::RobotModel& robot, const urdf::MessageSetting& setting, Profile& profile) {
  can::ProfileRow& row = profile.rows[static_cast<std::size_t>(kind_of(robot, profile, setting))];
  if (setting.id) {
    row.base_id = static_cast<std::uint16_t>(*setting.id);
  }
  if (setting.period_s) {
    row.period_ns = std::llround(*setting.period_s * 1e9);
  }
  if (setting.deadline_s) {
    row.deadline_ns = std::llround(*setting.deadline_s * 1e9);
  }
}

// The slots' own messages keep their pace: joints and message controller count on it.
void check_periods(const urdf::RobotModel& robot, const urdf::MessageSetting& setting,
                   const Profile& profile) {
  const MessageKind kind = kind_of(robot, profile, setting);
  if (setting.period_s && !profile.row(kind).on_event) {
    refuse(robot, setting.line, fmt::format("network.messages.{}.period_ms", setting.message),
           "this message comes with the time slots",
           "Leave period_ms out; only messages on events have one.");
  }
}

// From a batch's end to the first moment with both feet down it is 240 ms at most in the gait of humanoid22,
// and as much longer on a larger body as its steps take.
int wanted_tail_parts(const urdf::RobotModel& robot) {
  if (robot.network.tail_parts) {
    return *robot.network.tail_parts;
  }
  constexpr double kParts = 3.0, kRounding = 0.01;
  return std::clamp(static_cast<int>(std::ceil(kParts * robot.body_scale().factor("s") - kRounding)), 1,
                    can::kTailParts);
}

void check_identifiers(const urdf::RobotModel& robot, const Profile& profile) {
  std::map<std::uint32_t, std::string> owner;
  const auto claim = [&](std::uint32_t id, MessageKind kind) {
    const std::string name = key_of(kind);
    const auto [place, is_new] = owner.emplace(id, name);
    if (id > can::kLargestId) {
      refuse(robot, robot.network.line, "network.messages." + name + ".id",
             fmt::format("its largest identifier would be 0x{:X}; there are 11 bits", id),
             "Choose a smaller id.");
    }
    if (!is_new) {
      refuse(robot, robot.network.line, "network.messages." + name + ".id",
             fmt::format("identifier 0x{:03X} would belong to {} as well", id, place->second),
             "Give each message a range of its own.");
    }
  };
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    const IdRule rule = profile.row(message.kind).rule;
    if (rule == IdRule::unused) {
      continue;
    }
    const unsigned last = rule == IdRule::one ? 0U : unsigned{profile.largest_node};
    for (unsigned node = last == 0 ? 0U : 1U; node <= last; ++node) {
      claim(profile.id_of(message.kind, static_cast<can::NodeId>(node)), message.kind);
      for (int part = 0; part < profile.parts(message.kind); ++part) {
        for (const bool toggle : {false, true}) {
          if ((part > 0 || toggle) && (!toggle || can::has_toggle(rule))) {
            claim(profile.id_of(message.kind, static_cast<can::NodeId>(node), toggle, part), message.kind);
          }
        }
      }
    }
  }
}

using facts::kMillisecond_ns;

can::Proof prove(const urdf::RobotModel& robot, const can::Profile& profile, const can::ErrorModel& errors) {
  return can::prove(profile, nodes_on_bus(profile, robot),
                    {.jitter_ns = kReleaseJitter_ns, .errors = errors});
}

// A tail is worth no other message's deadline: of a bus that is too full for it, it takes what is left.
void fit_tail(const urdf::RobotModel& robot, Profile& profile) {
  if (!profile.has(MessageKind::tail)) {
    return;
  }
  int parts = wanted_tail_parts(robot);
  profile = profile.with_tail_parts(parts);
  check_identifiers(robot, profile);
  while (parts > 0 && !prove(robot, profile, can::jam(kJam_ns)).holds()) {
    profile = profile.with_tail_parts(--parts);
  }
}

}  // namespace

urdf::RobotModel load_robot(const std::filesystem::path& folder, const std::string& profile) {
  urdf::RobotModel robot = urdf::load_robot(folder);
  if (!profile.empty()) {
    robot.network.profile = profile;
  }
  return robot;
}

Profile network_profile(const urdf::RobotModel& robot) {
  const std::string& name = robot.network.profile;
  const bool full = name == can::kFullProfile.name;
  if (!full && name != can::kPaperProfile.name) {
    refuse(robot, robot.network.line, "network.profile", fmt::format("there is no profile '{}'", name),
           input::suggest(name, std::vector<std::string>{"full", "paper"}));
  }
  Profile profile = full ? can::kFullProfile : can::kPaperProfile;
  for (const urdf::MessageSetting& setting : robot.network.messages) {
    check_periods(robot, setting, profile);
    apply(robot, setting, profile);
  }
  fit_tail(robot, profile);
  check_identifiers(robot, profile);
  return profile;
}

std::vector<can::NodeId> joint_nodes(const urdf::RobotModel& robot, const can::Profile& profile) {
  std::vector<can::NodeId> nodes;
  nodes.reserve(robot.joints.size());
  for (const urdf::Joint& joint : robot.joints) {
    nodes.push_back(is_on_bus(profile, joint) ? joint.node : can::NodeId{0});
  }
  return nodes;
}

std::vector<can::NodeId> nodes_on_bus(const Profile& profile, const urdf::RobotModel& robot) {
  std::vector<can::NodeId> nodes;
  for (const urdf::Joint& joint : robot.joints) {
    if (is_on_bus(profile, joint)) {
      nodes.push_back(joint.node);
    }
  }
  return nodes;
}

can::Proof prove_network(const urdf::RobotModel& robot) {
  return prove(robot, network_profile(robot), can::jam(kJam_ns));
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

std::string note_on_tails(const urdf::RobotModel& robot) {
  const can::Profile profile = network_profile(robot);
  const int parts = profile.has(MessageKind::tail) ? profile.tail_parts : 0;
  if (!profile.has(MessageKind::sync) || parts >= wanted_tail_parts(robot)) {
    return {};
  }
  return fmt::format(
      "robot '{}': its bus cannot be proven with more than {} of the {} frames that a joint needs to end a "
      "step by "
      "itself. If the message controller dies while a foot is in the air for longer, the joints hold where "
      "their "
      "batch ends, and the robot may fall. Put fewer joints on the bus, or choose quicker steps",
      robot.name, parts, wanted_tail_parts(robot));
}

void require_proven_network(const urdf::RobotModel& robot, bool accept_unproven) {
  if (const std::string note = note_on_tails(robot); !note.empty()) {
    fmt::print(stderr, "note: {}\n", note);
  }
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
  const auto response_ns =
      prove(robot, network_profile(robot), {}).worst_response_ns(can::MessageKind::trajectory);
  // The response counts from the earliest instant of release, but the frames are released at the hand-over.
  const std::int64_t under_way_ns = response_ns ? *response_ns - kReleaseJitter_ns : facts::kCycle_ns;
  const std::int64_t lead_ns = (under_way_ns + kMillisecond_ns - 1) / kMillisecond_ns * kMillisecond_ns;
  return std::clamp(lead_ns, kMillisecond_ns, facts::kCycle_ns - facts::kSlot_ns);
}

}  // namespace gaitway::msgcontroller
