// JSON to a file and back; a table.
#include "tools/robot/keeper/robot_status.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <system_error>

#include "gaitway/input/text.hpp"
#include "gaitway/process/wall_clock.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::ordered_json;

ordered_json json_of(const PartStatus& part) {
  return {{"name", part.name},
          {"state", part.state},
          {"pid", part.process},
          {"worker_pid", part.worker},
          {"since_ns", part.since_ns},
          {"progress_ns", part.progress_ns},
          {"restarts", part.restarts},
          {"failures", part.failures},
          {"real_time", part.real_time},
          {"reason", part.reason},
          {"last_end_ns", part.last_end_ns}};
}

ordered_json json_of(const RobotStatus& status) {
  ordered_json parts = ordered_json::array();
  for (const PartStatus& part : status.parts) parts.push_back(json_of(part));
  return {{"supervisor", status.supervisor},
          {"written_ns", status.written_ns},
          {"up_ns", status.up_ns},
          {"may_be_commanded", status.may_be_commanded},
          {"commanded_since_ns", status.commanded_since_ns},
          {"why_not", status.why_not},
          {"commander", status.commander},
          {"lost_lines", status.lost_lines},
          {"events", status.events},
          {"parts", parts}};
}

PartStatus part_of(const ordered_json& json) {
  return {.name = json.at("name"),
          .state = json.at("state"),
          .process = json.at("pid"),
          .worker = json.at("worker_pid"),
          .since_ns = json.at("since_ns"),
          .progress_ns = json.at("progress_ns"),
          .restarts = json.at("restarts"),
          .failures = json.at("failures"),
          .real_time = json.at("real_time"),
          .reason = json.at("reason"),
          .last_end_ns = json.value("last_end_ns", std::int64_t{0})};
}

double seconds(std::int64_t duration_ns) {
  return static_cast<double>(duration_ns) * 1e-9;
}

// "3.2 s ago: was ended by signal 9 (Killed)"
std::string last_end(const PartStatus& part, std::int64_t now_ns) {
  if (part.reason.empty()) return "-";
  const std::string reason = input::terminal_text(part.reason);
  return part.last_end_ns == 0 ? reason
                               : fmt::format("{:.1f} s ago: {}", seconds(now_ns - part.last_end_ns), reason);
}

}  // namespace

bool RobotStatus::all_work() const {
  return std::ranges::all_of(parts, [](const PartStatus& part) { return part.state == "works"; });
}

void RobotStatus::deny_command(const std::string& why) {
  may_be_commanded = false;
  why_not = why;
}

bool write_status(const std::filesystem::path& file, const RobotStatus& status) {
  const std::filesystem::path next = file.string() + ".next";
  std::ofstream out(next);
  out << json_of(status).dump(-1, ' ', false, ordered_json::error_handler_t::replace) << "\n";
  out.close();
  std::error_code failed;
  if (out) std::filesystem::rename(next, file, failed);
  return static_cast<bool>(out) && !failed;
}

std::optional<RobotStatus> read_status(const std::filesystem::path& file) {
  std::ifstream in(file);
  const ordered_json json = ordered_json::parse(in, nullptr, false);
  if (!json.is_object()) return std::nullopt;
  try {
    RobotStatus status{.supervisor = json.at("supervisor"),
                       .written_ns = json.at("written_ns"),
                       .up_ns = json.at("up_ns"),
                       .may_be_commanded = json.at("may_be_commanded"),
                       .commanded_since_ns = json.at("commanded_since_ns"),
                       .why_not = json.value("why_not", ""),
                       .commander = json.value("commander", ""),
                       .lost_lines = json.at("lost_lines"),
                       .events = json.at("events"),
                       .parts = {}};
    for (const ordered_json& part : json.at("parts")) status.parts.push_back(part_of(part));
    return status;
  } catch (const nlohmann::json::exception&) {
    return std::nullopt;  // of another version
  }
}

std::string status_text(const RobotStatus& status, bool supervised, std::int64_t now_ns) {
  ordered_json json = json_of(status);
  json["supervised"] = supervised;
  json["age_s"] = seconds(now_ns - status.written_ns);
  for (ordered_json& part : json["parts"]) {
    part["since_s"] = seconds(now_ns - part["since_ns"].get<std::int64_t>());
    part["progress_age_s"] = seconds(now_ns - part["progress_ns"].get<std::int64_t>());
    if (const auto end_ns = part["last_end_ns"].get<std::int64_t>(); end_ns != 0) {
      part["last_end_age_s"] = seconds(now_ns - end_ns);
      part["last_end"] = process::date_and_time_of(end_ns);
    }
  }
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

std::string status_table(const RobotStatus& status, bool supervised, std::int64_t now_ns) {
  std::string text = supervised ? fmt::format("supervisor         process {}, up for {:.1f} s\n",
                                              status.supervisor, seconds(now_ns - status.up_ns))
                                : fmt::format(
                                      "supervisor         GONE (process {}, {:.1f} s ago): the parts live on "
                                      "unwatched. 'gaitway robot up' with the same options takes them over\n",
                                      status.supervisor, seconds(now_ns - status.written_ns));
  text += !status.may_be_commanded
              ? fmt::format("robot              may NOT be commanded now{}{}\n",
                            status.why_not.empty() ? "" : ": ", input::terminal_text(status.why_not))
              : fmt::format("robot              may be commanded, for {:.1f} s\n",
                            seconds(now_ns - status.commanded_since_ns));
  if (!status.commander.empty()) {
    text += fmt::format("command            {}\n", input::terminal_text(status.commander));
  }
  text += fmt::format("\n{:<18} {:<7} {:>8} {:>10} {:>9} {:>10} {:<10} {}\n", "part", "state", "process",
                      "since", "restarts", "progress", "real time", "last end");
  for (const PartStatus& part : status.parts) {
    const double age_ms = static_cast<double>(status.written_ns - part.progress_ns) * 1e-6;
    const std::string progress = part.process == 0 ? "-" : fmt::format("{:.0f} ms", std::max(0.0, age_ms));
    text += fmt::format("{:<18} {:<7} {:>8} {:>8.1f} s {:>9} {:>10} {:<10} {}\n", part.name, part.state,
                        part.worker == 0 ? "-" : std::to_string(part.worker), seconds(now_ns - part.since_ns),
                        part.restarts, progress, part.real_time ? "yes" : "no", last_end(part, now_ns));
  }
  text += fmt::format("\nevents             {}\n", status.events);
  if (status.lost_lines > 0) {
    text += fmt::format("                   {} lines could not be written: is the disk full?\n",
                        status.lost_lines);
  }
  return text;
}

}  // namespace gaitway::tools
