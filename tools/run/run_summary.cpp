// The figures of a run as JSON and as a table.
#include "tools/run/run_report.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {
namespace {

nlohmann::ordered_json batches(const simulator::Cosimulation& run) {
  const NetworkState& state = run.message_controller().state();
  const core::MainControllerStatistics statistics = run.main_controller().statistics();
  return {{"handed_over", state.handed_over},
          {"late", state.late},
          {"refused", state.refused + statistics.refused_locally},
          {"tail_played", state.tail_played},
          {"repaired", state.repaired},
          {"compute_us",
           {{"p50", statistics.batch_compute_us.p50},
            {"p99", statistics.batch_compute_us.p99},
            {"max", statistics.batch_compute_us.max}}}};
}

nlohmann::ordered_json bus(const simulator::Cosimulation& run) {
  const can::BusStatistics& statistics = run.bus().statistics();
  return {{"frames", statistics.frames},
          {"load", statistics.load(run.now_ns())},
          {"frame_us",
           {{"min", statistics.eight_byte_us.min},
            {"mean", statistics.eight_byte_us.mean()},
            {"max", statistics.eight_byte_us.max}}}};
}

// What the message controller found, and what was really done to the bus.
nlohmann::ordered_json network(const simulator::Cosimulation& run) {
  const NetworkHealth& health = run.message_controller().health();
  const can::BusStatistics& statistics = run.bus().statistics();
  const can::InjectedFaults& injected = statistics.injected;
  return {{"found",
           {{"trajectories_lost", health.trajectories_lost},
            {"counts_differed", health.counts_differed},
            {"feedback_lost", health.feedback_lost},
            {"nodes_silent", health.feedback_missing},
            {"nodes_returned", health.nodes_returned},
            {"nodes_restarted", health.nodes_restarted},
            {"bus_offs", health.bus_offs},
            {"flushed", health.flushed},
            {"expired", health.expired},
            {"queue_full", health.queue_full},
            {"doubled", health.doubled},
            {"second_senders", health.second_senders},
            {"forged", health.forged},
            {"unknown_identifiers", health.unknown_identifiers},
            {"wrong_lengths", health.wrong_lengths},
            {"remote_frames", health.remote_frames},
            {"extended_frames", health.extended_frames},
            {"undefined_values", health.undefined_values},
            {"stops_repeated", health.stops_repeated}}},
          {"injected",
           {{"lost", statistics.lost},
            {"corruptions", injected.corruptions},
            {"duplicates", injected.duplicates},
            {"omissions", injected.omissions},
            {"omitted_receptions", injected.omitted_receptions},
            {"jams", injected.jams},
            {"jammed_frames", injected.jammed_frames},
            {"forced_bus_offs", injected.forced_bus_offs},
            {"forced_failures", injected.forced_failures},
            {"restarts", injected.power_offs}}},
          {"bus",
           {{"error_frames", statistics.error_frames},
            {"retransmissions", statistics.retransmissions},
            {"bus_offs", statistics.bus_offs},
            {"recoveries", statistics.recoveries}}}};
}

// Null for a robot that never walked steadily.
nlohmann::ordered_json if_walked(const RunMetrics& metrics, double value) {
  return metrics.walked_s > 0.0 ? nlohmann::ordered_json(value) : nlohmann::ordered_json(nullptr);
}

// What plug-ins, manager and message controller had to say; the oldest may have been overwritten.
nlohmann::ordered_json events(const simulator::Cosimulation& run) {
  const core::EventLog& log = run.main_controller().events();
  auto list = nlohmann::ordered_json::array();
  for (std::uint64_t number = log.first(); number < log.total(); ++number) {
    const core::Event& event = log[number];
    list.push_back({{"time_s", static_cast<double>(event.stamp_ns) * 1e-9},
                    {"kind", core::event_kind_name(event.kind)},
                    {"source", event.source()},
                    {"text", event.text()}});
  }
  return {{"total", log.total()}, {"newest", list}};
}

nlohmann::ordered_json world_json(const std::optional<world::World>& world) {
  if (!world) return nullptr;
  nlohmann::ordered_json json = {{"name", world->name}, {"file", world->file.string()}};
  if (world->random_seed) json["random_seed"] = *world->random_seed;
  return json;
}

// What is told again and again has one line, at its first time. Of many lines the first and the last ones:
// how it began, and what came of it.
template <class Row>
void add_event_rows(const nlohmann::ordered_json& events, const Row& row) {
  struct Told {
    std::string text;
    double first_s = 0.0, last_s = 0.0;
    int times = 0;
  };
  std::vector<Told> lines;
  std::unordered_map<std::string, std::size_t> line_of;
  for (const auto& event : events["newest"]) {
    std::string text = fmt::format("{} {}: {}", event["source"].get<std::string>(),
                                   event["kind"].get<std::string>(), event["text"].get<std::string>());
    const double time_s = event["time_s"].get<double>();
    const auto [found, is_new] = line_of.try_emplace(text, lines.size());
    if (is_new) lines.push_back({.text = std::move(text), .first_s = time_s});
    Told& line = lines[found->second];
    line.last_s = time_s;
    ++line.times;
  }
  constexpr std::size_t kFirst = 6, kLast = 6;
  const bool is_cut = lines.size() > kFirst + kLast + 1;
  for (std::size_t i = 0; i < lines.size(); ++i) {
    if (is_cut && i == kFirst) {
      row("", fmt::format("... {} more, all in events.jsonl", lines.size() - kFirst - kLast));
      i = lines.size() - kLast;
    }
    const Told& line = lines[i];
    row(i == 0 ? fmt::format("events ({})", events["total"].get<std::uint64_t>()) : "",
        fmt::format(
            "{:.3f} s {}{}", line.first_s, line.text,
            line.times > 1 ? fmt::format(" ({} times, last at {:.3f} s)", line.times, line.last_s) : ""));
  }
}

// A line for each, the first few of them.
template <class Row>
void add_contact_rows(const nlohmann::ordered_json& contacts, const Row& row) {
  const auto total = contacts["total"].get<std::uint64_t>();
  if (total == 0) row("body contacts", "none");
  constexpr std::size_t kShown = 5;
  for (std::size_t i = 0; i < std::min(kShown, contacts["first"].size()); ++i) {
    const auto& contact = contacts["first"][i];
    const auto kind = contact["kind"].get<std::string>(), with = contact["with"].get<std::string>();
    row(i == 0 ? fmt::format("body contacts ({})", total) : "",
        fmt::format("{:.3f} s {} touches {}: {:.1f} N at most, {:.3f} N*s in {:.3f} s",
                    contact["from_s"].get<double>(), contact["link"].get<std::string>(),
                    kind == with ? with : fmt::format("{} '{}'", kind, with), contact["peak_N"].get<double>(),
                    contact["impulse_Ns"].get<double>(),
                    contact["to_s"].get<double>() - contact["from_s"].get<double>()));
  }
}

}  // namespace

RunOutcome outcome_of(const simulator::Cosimulation& run, const RunRecorder& recorder) {
  const std::optional<MissionEnd> mission = recorder.mission().end();
  RunMetrics metrics = recorder.metrics();
  if (mission) metrics.fell = !mission->on_feet;  // what happened before it got up is not its end
  const NetworkState& state = run.message_controller().state();
  RunOutcome outcome =
      outcome_of(metrics,
                 {.handed_over = state.handed_over,
                  .refused = state.refused + run.main_controller().statistics().refused_locally,
                  .refused_by_a_stop = run.message_controller().refused_by_a_stop()},
                 static_cast<double>(run.now_ns()) * 1e-9, recorder.way().missing());
  return mission ? outcome_of(*mission, std::move(outcome)) : outcome;
}

nlohmann::ordered_json summary(const simulator::Cosimulation& run, const RunRecorder& recorder,
                               const RunTiming& timing, std::uint64_t seed, double mismatch) {
  const RunMetrics& metrics = recorder.metrics();
  const double virtual_s = static_cast<double>(run.now_ns()) * 1e-9;
  const RunOutcome outcome = outcome_of(run, recorder);
  nlohmann::ordered_json result = {
      {"robot", run.robot().name},
      {"profile", run.message_controller().profile().name},
      {"seed", seed},
      {"mismatch", mismatch},
      {"world", world_json(run.plant().world())},
      {"virtual_seconds", virtual_s},
      {"wall_seconds", timing.wall_s},
      {"real_time_factor", virtual_s / timing.wall_s},
      {"physics_only_real_time_factor", timing.physics_only_wall_s > 0.0
                                            ? nlohmann::ordered_json(virtual_s / timing.physics_only_wall_s)
                                            : nlohmann::ordered_json(nullptr)},
      {"fell", metrics.fell},
      {"outcome", name(outcome.verdict)},
      {"result", outcome.text},
      {"commanded_m", metrics.way_m.commanded},
      {"commanded_and_done_m", metrics.way_m.done},
      {"distance_m", metrics.distance_m()},
      {"mean_speed_m_s", if_walked(metrics, metrics.mean_speed_m_per_s())},
      {"mean_side_speed_m_s", if_walked(metrics, metrics.mean_side_speed_m_per_s())},
      {"lateral_drift_m", metrics.lateral_drift_m()},
      {"heading_drift_rad", metrics.heading_drift_rad()},
      {"batches", batches(run)},
      {"bus", bus(run)},
      {"network", network(run)},
      {"joints",
       {{"tracking_rms_rad", metrics.tracking_rad.value()},
        {"refused_points", run.main_controller().statistics().refused_points},
        {"resynchronised", run.message_controller().state().resynchronised}}},
      {"zmp",
       {{"reference_error_rms_m", metrics.zmp_reference_error_m.value()},
        {"estimate_error_rms_m", metrics.zmp_estimate_error_m.value()},
        {"margin_min_m", metrics.zmp_reference_error_m.count() > 0
                             ? nlohmann::ordered_json(metrics.zmp_margin_min_m)
                             : nlohmann::ordered_json(nullptr)}}},
      {"way", recorder.way().json()},
      {"mission", recorder.mission().json()},
      {"contacts", contacts_json(recorder.contacts(), run.robot())},
      {"events", events(run)},
      {"digest", fmt::format("{:016x}", recorder.digest())}};
  if (metrics.fell) {
    result["fell_at_s"] = metrics.fell_at_s;
  }
  return result;
}

std::string summary_table(const nlohmann::ordered_json& s) {
  const auto number = [](const nlohmann::ordered_json& value) {
    return value.is_null() ? 0.0 : value.get<double>();
  };
  std::string text;
  const auto row = [&text](std::string_view label, const std::string& value) {
    text += fmt::format("  {:<26}{}\n", label, value);
  };
  row("result", s["result"].get<std::string>());
  if (!s["world"].is_null()) row("world", s["world"]["file"].get<std::string>());
  // Speed, drift and ZMP are told of walks by commanded velocities: those of ways and missions have no line.
  const auto& zmp = s["zmp"];
  const bool has_walked_by_velocity = !zmp["margin_min_m"].is_null();
  if (has_walked_by_velocity) {
    const auto& speed = s["mean_speed_m_s"];
    row("distance", fmt::format("{:.3f} m, {}", number(s["distance_m"]),
                                speed.is_null() ? "too short for a mean speed"
                                                : fmt::format("mean speed {:.3f} m/s", number(speed))));
    row("drift", fmt::format("{:+.3f} m sideways, {:+.2f} deg heading", number(s["lateral_drift_m"]),
                             number(s["heading_drift_rad"]) * 57.29578));
  } else {
    row("ended", fmt::format("{:.3f} m from where it began", number(s["distance_m"])));
  }
  if (const auto& way = s["way"]; !way.is_null()) {
    row("way", fmt::format("{} at {:.2f} s, {} footsteps, {} plans after the first",
                           way["result"].get<std::string>(), number(way["ended_s"]),
                           way["footsteps"].get<int>(), way["replans"].get<int>()));
    row("footsteps", fmt::format("{:.1f} mm RMS beside their places, {:.1f} mm at most, {:.2f} deg RMS",
                                 number(way["placement_rms_mm"]), number(way["placement_worst_mm"]),
                                 number(way["placement_rms_deg"])));
    row("stands",
        fmt::format("{:.1f} mm and {:.2f} deg beside the goal; it thinks {:.1f} mm and {:.2f} deg beside",
                    number(way["goal_error_mm"]), number(way["goal_error_deg"]), number(way["pose_error_mm"]),
                    number(way["pose_error_deg"])));
  }
  const auto& b = s["batches"];
  row("batches", fmt::format("{} handed over, {} late, {} refused, {} cycles from the safe tail",
                             b["handed_over"].get<std::uint64_t>(), b["late"].get<std::uint64_t>(),
                             b["refused"].get<std::uint64_t>(), b["tail_played"].get<std::uint64_t>()));
  row("batch compute",
      fmt::format("p50 {:.0f} us, p99 {:.0f} us, max {:.0f} us", number(b["compute_us"]["p50"]),
                  number(b["compute_us"]["p99"]), number(b["compute_us"]["max"])));
  const auto& bus = s["bus"];
  row("bus", fmt::format("{} frames, load {:.1f} %, 8-byte frame {:.0f}/{:.1f}/{:.0f} us (min/mean/max)",
                         bus["frames"].get<std::uint64_t>(), 100.0 * number(bus["load"]),
                         number(bus["frame_us"]["min"]), number(bus["frame_us"]["mean"]),
                         number(bus["frame_us"]["max"])));
  row("joints", fmt::format("tracking {:.2f} deg RMS, {} refused points, {} resynchronised",
                            number(s["joints"]["tracking_rms_rad"]) * 57.29578,
                            s["joints"]["refused_points"].get<std::uint64_t>(),
                            s["joints"]["resynchronised"].get<std::uint64_t>()));
  if (has_walked_by_velocity) {
    row("ZMP",
        fmt::format("reference error {:.1f} mm RMS, estimate error {:.1f} mm RMS, margin at least {:.1f} mm",
                    1e3 * number(zmp["reference_error_rms_m"]), 1e3 * number(zmp["estimate_error_rms_m"]),
                    1e3 * number(zmp["margin_min_m"])));
  }
  add_contact_rows(s["contacts"], row);
  const auto& physics = s["physics_only_real_time_factor"];
  row("speed",
      fmt::format("{:.1f} x real time{}", number(s["real_time_factor"]),
                  physics.is_null() ? "" : fmt::format(" (physics alone: {:.1f} x)", number(physics))));
  row("digest", s["digest"].get<std::string>());
  add_event_rows(s["events"], row);
  return text;
}

}  // namespace gaitway::tools
