// Lays out the tables.
#include "tools/bus/bus_measurement.hpp"

#include <fmt/format.h>

#include <array>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>
#include <vector>

#include "tools/bus/bus_watch_text.hpp"

namespace gaitway::tools {
namespace {

using can::MessageKind;
using nlohmann::ordered_json;

// In the order of MessageKind.
constexpr std::array<std::string_view, can::kMessageKinds> kContents{"hold or go soft",
                                                                     "node, count, time slots",
                                                                     "cycle, slot, batch, tail",
                                                                     "8 corrections, 1 byte each",
                                                                     "position, torque, state, 2 sensors",
                                                                     "bit mask of faults",
                                                                     "8 points, 1 byte each",
                                                                     "absolute count, 5 points",
                                                                     "mode, cycle",
                                                                     "8 points after the batch"};

std::string number(const std::optional<double>& value, int decimals) {
  return value ? fmt::format("{:.{}f}", *value, decimals) : std::string("-");
}

std::optional<double> in_milliseconds(std::optional<std::int64_t> time_ns) {
  return time_ns ? std::optional(static_cast<double>(*time_ns) * 1e-6) : std::nullopt;
}

std::size_t nodes_of(MessageKind kind, const BusRobot& robot) {
  return robot.profile.row(kind).rule == can::IdRule::one ? 1 : robot.nodes.size();
}

// User commands are sent to a robot that stands, after the walk: they have figures of their own.
Spread lengths_of(const BusMeasurement& measurement, MessageKind kind) {
  return kind == MessageKind::user_command ? measurement.user_commands().length_us
                                           : measurement.watch().message(kind).length_us;
}
Spread responses_of(const BusMeasurement& measurement, MessageKind kind) {
  return kind == MessageKind::user_command ? measurement.user_commands().on_joints_ms
                                           : measurement.watch().message(kind).response_ms;
}
std::string_view response_from(const BusMeasurement& measurement, MessageKind kind) {
  return kind == MessageKind::user_command && measurement.user_commands().on_joints_ms.count > 0
             ? "the mailbox"
             : measurement.watch().response_from(kind);
}

double rate_per_s(const BusMeasurement& measurement, MessageKind kind) {
  const double seconds = measurement.watch().seconds();
  return seconds > 0.0 ? static_cast<double>(measurement.watch().message(kind).frames) / seconds : 0.0;
}

std::string message_row(const BusMeasurement& measurement, const BusRobot& robot, MessageKind kind) {
  const can::ProfileRow& row = robot.profile.row(kind);
  const Spread lengths = lengths_of(measurement, kind), responses = responses_of(measurement, kind);
  const auto bound = in_milliseconds(robot.proof.worst_response_ns(kind));
  return fmt::format(
      "{:<18}{:<15}{:<36}{:>7}{:>7}{:>9.1f}{:>8}{:>16}{:>10}{:>8}  {}\n", can::layout(kind).name,
      identifiers_of(robot.profile, kind, nodes_of(kind, robot)), kContents[static_cast<std::size_t>(kind)],
      row.on_event ? std::string("event") : fmt::format("{} ms", row.period_ns / 1'000'000),
      can::layout(kind).size, rate_per_s(measurement, kind),
      lengths.count == 0 ? std::string("-") : fmt::format("{:.1f}", lengths.mean()),
      lengths.count == 0 ? std::string("-") : fmt::format("{:.0f}..{:.0f}", lengths.min, lengths.max),
      responses.count == 0 ? std::string("-") : fmt::format("{:.3f}", responses.max), number(bound, 3),
      response_from(measurement, kind));
}

struct TimeRow {
  std::string name;
  Spread measured_ms;
  std::optional<double> published_ms;
  std::string note;
};

Spread in_ms(const Spread& microseconds) {
  return {microseconds.count, microseconds.sum * 1e-3, microseconds.min * 1e-3, microseconds.max * 1e-3};
}

Spread less(const Spread& spread, double each) {
  return {spread.count, spread.sum - static_cast<double>(spread.count) * each, spread.min - each,
          spread.max - each};
}

// Of one message from every node: by the bus's clock, and what of it belongs to the frames themselves.
void add_set_rows(std::vector<TimeRow>& rows, const std::string& name, const FrameSetMeter& meter,
                  std::size_t nodes, std::optional<double> published_ms, const std::string& note) {
  const double spaces_ms = static_cast<double>(nodes) * kInterframe_ms;
  rows.push_back({name, meter.bus_time_ms(), published_ms, note + "; interframe spaces included"});
  rows.push_back({"  sent without gaps", meter.back_to_back_ms(), published_ms,
                  "first bit of the first to the last interframe space, by the bus's clock"});
  if (meter.back_to_back_ms().count < meter.span_ms().count) {
    rows.push_back({"  first to last", meter.span_ms(), std::nullopt, "with what lay between them"});
  }
  rows.push_back({"  frames alone", less(meter.bus_time_ms(), spaces_ms), published_ms,
                  "without the interframe spaces"});
}

// The published robot had twelve nodes; another number of them has nothing to be compared with.
std::vector<TimeRow> time_rows(const BusMeasurement& measurement, const BusRobot& robot) {
  const std::size_t nodes = robot.nodes.size();
  const bool comparable = nodes == PublishedTimes::kNodes;
  const auto published = [&](double time_ms) { return comparable ? std::optional(time_ms) : std::nullopt; };
  const UserCommandFigures& commands = measurement.user_commands();
  constexpr double kCommand_ms = PublishedTimes::kUserCommand_ms;
  std::vector<TimeRow> rows;
  add_set_rows(rows, fmt::format("{} trajectory messages", nodes), measurement.trajectories(), nodes,
               published(PublishedTimes::kTrajectories_ms), "one a node and cycle");
  add_set_rows(rows, fmt::format("{} sensor messages", nodes), measurement.feedbacks(), nodes,
               published(PublishedTimes::kSensors_ms), "one a node and slot, position and sensors");
  const Spread two_ms = in_ms(commands.two_commands_length_us);
  rows.push_back({"user command", in_ms(commands.length_us), kCommand_ms, "4 data bytes, as sent"});
  rows.push_back({"  filled up with zeros", in_ms(commands.eight_byte_length_us), kCommand_ms,
                  "8 data bytes, computed from those that were sent"});
  rows.push_back({"  two in one frame", two_ms, kCommand_ms, "8 data bytes, computed"});
  rows.push_back({"  frame alone", less(two_ms, kInterframe_ms), kCommand_ms,
                  "8 data bytes, computed, without the interframe space"});
  return rows;
}

ordered_json to_json(const Spread& spread) {
  return spread.count == 0 ? ordered_json(nullptr)
                           : ordered_json{{"count", spread.count},
                                          {"mean", spread.mean()},
                                          {"min", spread.min},
                                          {"max", spread.max}};
}

ordered_json time_json(const Spread& measured_ms, std::optional<double> published_ms) {
  ordered_json json = {{"measured_ms", to_json(measured_ms)}, {"published_ms", nullptr}};
  if (published_ms) {
    json["published_ms"] = *published_ms;
    if (measured_ms.count > 0) {
      json["difference_percent"] = difference_percent(measured_ms.mean(), *published_ms);
    }
  }
  return json;
}

ordered_json message_json(const BusMeasurement& measurement, const BusRobot& robot, MessageKind kind) {
  const can::ProfileRow& row = robot.profile.row(kind);
  const auto bound = in_milliseconds(robot.proof.worst_response_ns(kind));
  return {{"name", can::layout(kind).name},
          {"identifiers", identifiers_of(robot.profile, kind, nodes_of(kind, robot))},
          {"contents", kContents[static_cast<std::size_t>(kind)]},
          {"period_ms", static_cast<double>(row.period_ns) * 1e-6},
          {"on_event", row.on_event},
          {"bytes", can::layout(kind).size},
          {"rate_per_s", rate_per_s(measurement, kind)},
          {"length_us", to_json(lengths_of(measurement, kind))},
          {"response_ms", to_json(responses_of(measurement, kind))},
          {"response_from", response_from(measurement, kind)},
          {"bound_ms", bound ? ordered_json(*bound) : ordered_json(nullptr)}};
}

}  // namespace

std::string message_table(const BusMeasurement& measurement, const BusRobot& robot) {
  const BusWatch& watch = measurement.watch();
  std::string text =
      fmt::format("Table 6: the messages of the profile '{}', {} nodes; {:.2f} s, load {:.1f} %\n",
                  robot.profile.name, robot.nodes.size(), watch.seconds(), 100.0 * watch.load());
  text += fmt::format("{:<18}{:<15}{:<36}{:>7}{:>7}{:>9}{:>8}{:>16}{:>10}{:>8}  {}\n", "message",
                      "identifiers", "contents", "period", "bytes", "rate/s", "mean us", "min..max us",
                      "worst ms", "bound", "response from");
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    if (robot.profile.has(message.kind)) {
      text += message_row(measurement, robot, message.kind);
    }
  }
  return text +
         "published         1..12 trajectory, 8 bytes, 80 ms; 13..24 sensors, 8 bytes, 10 ms; 25 user "
         "command, on the joints within 10 ms; 0.117 ms a message\n";
}

std::string time_table(const BusMeasurement& measurement, const BusRobot& robot) {
  std::string text = fmt::format("Table 7: what the bus needs\n{:<26}{:>7}{:>9}{:>17}{:>11}{:>12}  {}\n", "",
                                 "sets", "mean ms", "min..max ms", "published", "difference", "");
  for (const TimeRow& row : time_rows(measurement, robot)) {
    const bool seen = row.measured_ms.count > 0;
    text += fmt::format(
        "{:<26}{:>7}{:>9}{:>17}{:>11}{:>12}  {}\n", row.name, row.measured_ms.count,
        seen ? fmt::format("{:.3f}", row.measured_ms.mean()) : "-",
        seen ? fmt::format("{:.3f}..{:.3f}", row.measured_ms.min, row.measured_ms.max) : "-",
        number(row.published_ms, 3),
        seen && row.published_ms
            ? fmt::format("{:+.1f} %", difference_percent(row.measured_ms.mean(), *row.published_ms))
            : "-",
        row.note);
  }
  return text;
}

ordered_json to_json(const BusMeasurement& measurement, const BusRobot& robot) {
  ordered_json messages = ordered_json::array();
  for (const can::MessageLayout& message : can::kMessageLayouts) {
    if (robot.profile.has(message.kind)) {
      messages.push_back(message_json(measurement, robot, message.kind));
    }
  }
  ordered_json times = ordered_json::array();
  for (const TimeRow& row : time_rows(measurement, robot)) {
    times.push_back(time_json(row.measured_ms, row.published_ms));
    times.back()["name"] = row.name.substr(row.name.find_first_not_of(' '));
    times.back()["note"] = row.note;
  }
  return {{"profile", robot.profile.name},
          {"nodes", robot.nodes.size()},
          {"seconds", measurement.watch().seconds()},
          {"load", measurement.watch().load()},
          {"messages", messages},
          {"times", times}};
}

}  // namespace gaitway::tools
