// Tables from the message table and the network file, between paragraphs.
#include "tools/bus/network_description.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <set>
#include <span>
#include <string_view>
#include <utility>

#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

// The paragraphs that no table can give. Facts with numbers come from the tables: what stands here is why.
constexpr std::string_view kHowTheNetworkWorks =
    R"(One CAN bus at 1 Mb/s connects the message controller with one local controller a joint. Frames are classic CAN with 11-bit
identifiers and at most 8 data bytes. A lower identifier wins the bus, so an identifier is a priority; identifiers follow the
deadlines, the shortest first.

**Time.** A cycle is 80 ms: eight time slots of 10 ms. At every slot's edge the message controller sends SYNC with the number of
the cycle and the slot. Every joint takes its place in time from it, answers with one feedback frame, and moves to the point of
this slot; by the slot's end it has reached that point. A joint that misses a SYNC goes on by its own clock for the rest of the
batch, and along the joints' tail that it holds for the time after it, and is realigned by the next SYNC.

**Batches.** A trajectory frame holds eight points for one joint, one byte each: what is executed in one cycle. A point is the
change of the joint's reference in counts since the point before (the count's size is in the robot's network file). The message
controller rounds absolute references and sends their differences, so rounding errors never add up; a change that a signed byte
cannot hold is refused before it comes here, by name, and never clipped. Frames of the next batch are sent while the
current one runs. Nothing moves on their arrival: the SYNC of slot 0 says whether a batch was committed and which toggle it has, and
every joint that holds it starts together with all others.

**Toggle.** Eight points fill the frame, so nothing in it can number it. Instead each joint has two trajectory identifiers, which
take turns from batch to batch. A frame that CAN delivers twice, or that is sent again as a repair, bears the same toggle and changes
nothing; only the next batch has the other one.

**Feedback** is position, torque, two sensor channels, and what the joint knows of its batches: the toggle that it plays, the newest
that it holds, and the low four bits of its own reference count. The message controller knows what each of these must be. So a
lost, doubled or stale trajectory frame shows within one time slot, and a missing joint within two: feedback is the heartbeat, too.

**Repair.** The feedback of the last slot says who holds the next batch. To whoever does not, its frame is sent again before the
start. A joint that has a wrong count, or no batch, once the cycle runs gets one absolute frame (resynchronisation): the count that it
must have at the end of the next slot, and the changes of the slots after it. It glides there within that slot; it does not jump.

**Joints' tails.** After the frames of a batch, when nothing more urgent wants the bus, each joint gets the points that would follow it if nobody
were there any more: up to the first moment at which both feet are down, of the safe tail that was handed over with the batch. They are eight
changes a frame like those of a batch, in parts of a tail: the first part, the second, and so on, as many as it takes (none when both feet are
down where the batch ends). Each tail has the other toggle than the one before. Once every frame of it has been on the bus, SYNC says in each slot of its batch
how many points it has and which toggle; no joint uses a tail that SYNC has not named, so all have the same points, or none. A joint
that does not hold what SYNC names reports it, of each tail anew, and gets it again; so does one that was away. The others keep what they have
meanwhile. One that has been sent its tail in three cycles running and still lacks it gets none, it seems: for a second no tail is named. When SYNC fails to come (the message controller
has died, hangs, is off the bus, or the bus is cut), the joints play out their batch and its joints' tail by their own clocks and hold: the step
is finished and the robot stands on both feet. Their clocks may differ by ±100 ppm, which is less than 0.1 ms over a batch and the longest tail.
A joint that has nothing to play and has not heard SYNC for six slots is compliant (one that was stopped keeps its place): a fifth of its stiffness, two and a half times its damping, which takes the sway out of the robot. It is
as stiff as before a tenth of a second after SYNC has come back, and says until then that it is *running*. A bus that
cannot be proven with the tails carries fewer parts of them, or none: then the joints hold where their batch ends. `network: {tail_parts: N}` in the
robot's network file sets the number of parts (0: none).

**Trims** are small corrections for balance, made from the newest sensor values: absolute angles for up to eight joints in one
broadcast frame every slot, added to the references, limited in size and speed by the joint itself, and fading out when none comes
for three slots.

**Faults.** A joint reports a fault when it begins and when it ends. A joint that has restarted stands where its encoder
says, tells so, and is brought back by a resynchronisation. When no new batch is handed over in time, the message controller
plays the safe tail that came with the last one and the robot stands. If the message controller itself is gone, the joints play out
their batch and its joints' tail and hold. One that starts again finds out from the joints' feedback where their references stand before it
moves anything. A frame with an identifier that is not on this page, with another length, or in remote or extended format is
counted under its cause and changes nothing. Classic CAN cannot tell who sent a frame, but the message controller hears them all: one that
bears its own identifier and is not its own is a forgery, what it may have done to the joint is put right, and the robot stops
safely.

**Emergency stop** is the most urgent frame of all, and is sent again in each slot until every joint's feedback shows that it has stopped.
)";

constexpr std::string_view kHowToReadTheFields =
    R"(Bits are counted as in a `.dbc` file with little-endian signals: bit 8·b + i is bit i of byte b, so bits 0 to 7 are the first byte. Numbers
are two's complement where they are signed. Bits that no field has are sent as 0 and not looked at. A frame with another
number of bytes than its message is not that message.
)";

constexpr std::string_view kThePaperProfile =
    R"(The published network has 25 messages and nothing else: twelve leg joints, one trajectory and one sensor message each, and the user
command. There is no SYNC: a batch starts as it arrives, and each joint counts its slots by its own clock. There is no
toggle, no trim and no resynchronisation either, so a joint that lost its batch gets the rest of it as a batch of its own. An
emergency stop is a user command to node 0. Feedback has the same bits as in the full profile, in the place of the published sensor
message. The robot walks slowly with it, and the joints without a local controller are held still. `network: {profile: paper}` in
the robot's network file chooses it.
)";

constexpr std::string_view kWhereElse =
    R"(- [gaitway.dbc](gaitway.dbc) is this page for tools: `./dev gaitway bus dbc --out docs/gaitway.dbc` makes it, and
  `gaitway bus dbc --robot DIR` makes the one of your robot.
- [bus-tools.md](bus-tools.md): how to attach python-can, cantools, can-utils or SavvyCAN to a running robot.
- `can/include/gaitway/can/message_layout.hpp` and `profile.hpp` are the tables that this page, the `.dbc` file, the codecs and the
  scheduler follow. After a change there: `./dev gaitway bus document --out docs/network.md`.
)";

using can::IdRule;
using can::MessageLayout;
using can::ProfileRow;

constexpr double kNanosecondsAMillisecond = 1e6;
constexpr double kBitsASecond = 1e6;

std::string period_text(std::int64_t time_ns) {
  return number_text(static_cast<double>(time_ns) / kNanosecondsAMillisecond) + " ms";
}

std::string identifiers(const can::Profile& profile, const MessageLayout& message) {
  const ProfileRow& row = profile.row(message.kind);
  switch (row.rule) {
    case IdRule::per_node:
      return row.base_id == 0 ? "node" : fmt::format("0x{:03X} + node", row.base_id);
    case IdRule::per_node_and_toggle:
      return fmt::format("0x{:03X} + 2·node + toggle", row.base_id);
    case IdRule::per_part_node_and_toggle:
      return fmt::format("0x{:03X} + {}·part + 2·node + toggle", row.base_id, 2 * can::kNodesAPart);
    default:
      return fmt::format("0x{:03X}", row.base_id);
  }
}

std::string_view sender(const MessageLayout& message) {
  return message.sender == can::Sender::message_controller ? "message controller" : "joint";
}

std::string bits(const can::FieldSpec& field) {
  const int last = field.first_bit + field.width - 1;
  return field.width == 1 ? fmt::format("{}", field.first_bit) : fmt::format("{}–{}", field.first_bit, last);
}

std::string bytes(const can::FieldSpec& field) {
  const int first = field.first_bit / 8, last = (field.first_bit + field.width - 1) / 8;
  return first == last ? fmt::format("{}", first) : fmt::format("{}–{}", first, last);
}

// How many fields from the first on differ in their number alone, such as delta_0 to delta_7.
std::size_t alike(can::MessageKind kind, std::span<const can::FieldSpec> fields) {
  const auto stem = [](const can::FieldSpec& field) {
    return field.name.substr(0, field.name.find_last_not_of("0123456789") + 1);
  };
  const can::FieldSpec& first = fields.front();
  const bool numbered = stem(first) != first.name;
  const auto differs = [&](const can::FieldSpec& field) {
    return !numbered || stem(field) != stem(first) || field.width != first.width ||
           field.unit != first.unit || meaning_of(kind, field.name) != meaning_of(kind, first.name);
  };
  const auto end = std::find_if(fields.begin() + 1, fields.end(), differs);
  return static_cast<std::size_t>(end - fields.begin());
}

std::string_view unit(const can::FieldSpec& field) {
  if (field.unit == "turn/65536") {
    return "1/65536 turn";
  }
  return field.unit == "N*m/8" ? "1/8 N·m" : field.unit;
}

std::string meaning(can::MessageKind kind, const can::FieldSpec& field) {
  std::string text(meaning_of(kind, field.name));
  const char* separator = ": ";
  for (const NamedValue& value : values_of(kind, field.name)) {
    text += fmt::format("{}{} *{}* ({})", separator, value.value, value.name, value.meaning);
    separator = ", ";
  }
  return text;
}

class Document {
 public:
  template <class... Arguments>
  void put(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
    fmt::format_to(std::back_inserter(text_), format, std::forward<Arguments>(arguments)...);
  }
  std::string take() { return std::move(text_); }

  void messages(const NetworkDescription& network) {
    put("| message | identifiers | sent by | bytes | comes | deadline | longest on the wire |\n"
        "|---|---|---|---|---|---|---|\n");
    for (const MessageLayout* const message : by_priority(network.profile)) {
      const ProfileRow& row = network.profile.row(message->kind);
      put("| {} | {} | {} | {} | {} {} | {} | {} µs |\n", message->name,
          identifiers(network.profile, *message), sender(*message), message->size,
          row.on_event ? "on events, at most every" : "every", period_text(row.period_ns),
          period_text(row.deadline_ns), can::worst_case_bits(message->size));
    }
    const auto [periodic, all] = loads(network);
    put("\nThe most urgent comes first. A deadline counts from the instant at which the sender wants to send "
        "until the frame "
        "has arrived.\nThe longest frame has all the stuff bits that it can have, and the interframe space. "
        "With {} joints, "
        "the periodic messages take at most {:.1f} % of\nthe bus, and {:.1f} % if every event happens as "
        "often as it may.\n",
        network.nodes.size(), 100.0 * periodic, 100.0 * all);
  }

  void fields(const MessageLayout& message) {
    put("\n### {}\n\n{}\n\n| field | bits | byte | signed | unit | meaning |\n|---|---|---|---|---|---|\n",
        message.name, meaning_of(message.kind));
    for (std::span<const can::FieldSpec> rest = message.fields; !rest.empty();) {
      const std::size_t count = alike(message.kind, rest);
      const can::FieldSpec& first = rest.front();
      const can::FieldSpec& last = rest[count - 1];
      const std::string name =
          count == 1 ? fmt::format("`{}`", first.name) : fmt::format("`{}` … `{}`", first.name, last.name);
      can::FieldSpec whole = first;
      whole.width = static_cast<std::uint8_t>(last.first_bit + last.width - first.first_bit);
      put("| {} | {}{} | {} | {} | {} | {} |\n", name, bits(whole),
          count == 1 ? "" : fmt::format(", {} each", first.width), bytes(whole),
          first.is_signed ? "yes" : "no", unit(first), meaning(message.kind, first));
      rest = rest.subspan(count);
    }
  }

  void joints(const urdf::RobotModel& robot, const NetworkDescription& network) {
    const std::vector<const MessageLayout*> messages = by_priority(network.profile);
    const auto is_per_node = [&](const MessageLayout* message) {
      return network.profile.row(message->kind).rule != IdRule::one;
    };
    put("| node | joint |");
    for (const MessageLayout* const message : messages) {
      if (is_per_node(message)) {
        put(" {} |", message->name);
      }
    }
    put(" count | limits | sensor channels |\n|---|---|");
    for (auto column = std::ranges::count_if(messages, is_per_node); column > 0; --column) {
      put("---|");
    }
    put("---|---|---|\n");
    for (const DescribedNode& node : network.nodes) {
      put("| {} | {} |", node.node, node.name);
      for (const MessageLayout* const message : messages) {
        if (is_per_node(message)) {
          put(" {} |", identifiers_of(network, *message, node.node));
        }
      }
      const urdf::Joint& joint = robot.joints[static_cast<std::size_t>(node.joint)];
      put(" {}° | {:.1f}° to {:.1f}° | {} |\n", number_text(joint.count_rad * facts::kDegreePerRad),
          joint.lower_rad * facts::kDegreePerRad, joint.upper_rad * facts::kDegreePerRad,
          channels(network, node.node));
    }
  }

  void trims(const NetworkDescription& network) {
    for (const DescribedMessage& message : network.messages) {
      if (message.kind != can::MessageKind::trim) {
        continue;
      }
      put("\n| trim channel | joint | unit |\n|---|---|---|\n");
      for (const DescribedSignal& signal : message.signals) {
        const bool used = signal.name.starts_with("trim_") && signal.name != signal.field.name;
        put("| `{}` | {} | {}° |\n", signal.field.name, used ? signal.name.substr(5) : "none",
            number_text(signal.factor));
      }
    }
  }

  static std::vector<const MessageLayout*> by_priority(const can::Profile& profile) {
    std::vector<const MessageLayout*> messages;
    for (const MessageLayout& message : can::kMessageLayouts) {
      if (profile.has(message.kind)) {
        messages.push_back(&message);
      }
    }
    std::ranges::stable_sort(messages, [&](const auto* a, const auto* b) {
      return profile.row(a->kind).base_id < profile.row(b->kind).base_id;
    });
    return messages;
  }

 private:
  // Of the bus: periodic messages alone, and all.
  static std::pair<double, double> loads(const NetworkDescription& network) {
    double periodic = 0.0, all = 0.0;
    std::set<std::pair<can::MessageKind, can::NodeId>> counted;  // two toggles are one message
    for (const DescribedMessage& message : network.messages) {
      if (!counted.emplace(message.kind, message.node).second) {
        continue;
      }
      const ProfileRow& row = network.profile.row(message.kind);
      const double load = can::worst_case_bits(can::layout(message.kind).size) /
                          (static_cast<double>(row.period_ns) * 1e-9 * kBitsASecond);
      periodic += row.on_event ? 0.0 : load;
      all += load;
    }
    return {periodic, all};
  }

  static std::string identifiers_of(const NetworkDescription& network, const MessageLayout& message,
                                    can::NodeId node) {
    std::string text;
    for (const DescribedMessage& one : network.messages) {
      if (one.kind == message.kind && one.node == node) {
        text += fmt::format("{}0x{:03X}", text.empty() ? "" : ", ", one.id);
      }
    }
    return text;
  }

  static std::string channels(const NetworkDescription& network, can::NodeId node) {
    std::string text;
    for (const DescribedMessage& message : network.messages) {
      if (message.kind != can::MessageKind::feedback || message.node != node) {
        continue;
      }
      for (const DescribedSignal& signal : message.signals) {
        if (signal.field.unit == "network file" && !signal.unit.empty()) {
          text += fmt::format("{}{} ({} {})", text.empty() ? "" : ", ", signal.name,
                              number_text(signal.factor), signal.unit);
        }
      }
    }
    return text.empty() ? "none" : text;
  }

  std::string text_;
};

}  // namespace

std::string network_document(const urdf::RobotModel& robot, const NetworkDescription& full,
                             const NetworkDescription& paper) {
  Document document;
  document.put(
      "<!-- Made by `./dev gaitway bus document --out docs/network.md`; change the tables or "
      "tools/bus/network_document*, "
      "not this file. -->\n# The message network\n\n{}\n## Messages\n\n",
      kHowTheNetworkWorks);
  document.messages(full);
  document.put("\n## Every bit\n\n{}", kHowToReadTheFields);
  for (const MessageLayout* const message : Document::by_priority(full.profile)) {
    document.fields(*message);
  }
  document.put(
      "\n## {} on the bus\n\nA position on the wire is 1/65536 of a turn; what a count and a sensor channel "
      "are, the "
      "network file says.\n\n",
      full.robot);
  document.joints(robot, full);
  document.trims(full);
  document.put("\n## The paper's profile\n\n{}\n", kThePaperProfile);
  document.messages(paper);
  document.put("\n");
  document.joints(robot, paper);
  document.put("\n## Where else\n\n{}", kWhereElse);
  return document.take();
}

}  // namespace gaitway::tools
