// Counts, medians, bounds; and the table.
#include "tools/campaign/real_time/real_time_summary.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

void add_real_time_losses(RealTimeLosses& sum, const RealTimeLosses& one) {
  sum.batches += one.batches;
  sum.tail_cycles += one.tail_cycles;
  sum.joint_cycles += one.joint_cycles;
  sum.restarts += one.restarts;
  sum.plugin_faults += one.plugin_faults;
  sum.event_lines += one.event_lines;
}

// Of the expected ones all are told by their times; else so many of them.
std::string shown_real_times(const TimeSummary& times, std::size_t expected) {
  const std::string of = times.count == expected ? "" : fmt::format("{} of {}", times.count, expected);
  if (times.count == 0) return expected == 0 ? "" : of;
  return fmt::format("{}{}{:.2f}, {:.2f}", of, of.empty() ? "" : ": ", times.median_s, times.largest_s);
}

std::string shown_real_time_losses(const RealTimeSummary& summary) {
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    const double each =
        static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(summary.trials, 1));
    if (count > 0) text += fmt::format("{}{:.2g} {}", text.empty() ? "" : ", ", each, what);
  };
  add(summary.lost.batches, "batches");
  add(summary.lost.tail_cycles, "tail cycles");
  add(summary.lost.joint_cycles, "cycles of the joints alone");
  add(summary.lost.restarts, "restarts");
  add(summary.lost.plugin_faults, "plug-in faults");
  add(summary.lost.event_lines, "lines of events");
  return text;
}

std::string real_time_line(const RealTimeRowResult& row) {
  const RealTimeSummary summary = summary_of(row);
  return fmt::format("| `{}`: {} | {} | {} (≤ {:.0f} %) | {} | {} | {} | {} | {} | {} | {} | {} |\n",
                     row.row.name, row.row.what, summary.trials, summary.falls,
                     100.0 * summary.most_falls_share, summary.walked_on, summary.walked_again,
                     shown_real_times(summary.commandable, summary.trials - summary.stopped),
                     shown_real_times(summary.order, summary.trials - summary.stopped),
                     shown_real_times(summary.walks, summary.trials - summary.stopped),
                     shown_real_times(summary.parts, summary.trials),
                     shown_real_times(summary.stop, summary.stopped), shown_real_time_losses(summary));
}

Json times_json(const TimeSummary& times) {
  if (times.count == 0) return nullptr;
  return {{"count", times.count}, {"median_s", times.median_s}, {"largest_s", times.largest_s}};
}

}  // namespace

RealTimeSummary summary_of(const RealTimeRowResult& row) {
  RealTimeSummary summary;
  std::vector<double> commandable, order, walks, parts, stop;
  const auto add = [](std::vector<double>& times_s, const std::optional<double>& time_s) {
    if (time_s) times_s.push_back(*time_s);
  };
  for (std::size_t number = 0; number < row.outcomes.size(); ++number) {
    const RealTimeOutcome& one = row.outcomes[number];
    const bool is_stopped = draw_real_time_trial(row.row.name, number, 0.0).is_stopped;
    ++summary.trials;
    summary.falls += one.fell ? 1U : 0U;
    summary.walked_on += one.walked_on ? 1U : 0U;
    summary.walked_again += !one.fell && !one.walked_on && one.walks_s ? 1U : 0U;
    summary.stopped += is_stopped ? 1U : 0U;
    if (!is_stopped) {
      add(commandable, one.commandable_s);
      add(order, one.order_s);
      add(walks, one.walks_s);
    }
    add(parts, one.parts_s);
    if (is_stopped) add(stop, one.stop_s);
    add_real_time_losses(summary.lost, one.lost);
  }
  summary.most_falls_share = most_share(summary.falls, summary.trials);
  summary.commandable = times_of(std::move(commandable));
  summary.order = times_of(std::move(order));
  summary.walks = times_of(std::move(walks));
  summary.parts = times_of(std::move(parts));
  summary.stop = times_of(std::move(stop));
  return summary;
}

std::string real_time_markdown(const RealTimeHead& head, const RealTimeCampaign& campaign) {
  std::string text = fmt::format(
      "{} under `gaitway robot up --simulate`, walking at {} m/s{}.\n\n"
      "| fault | trials | falls (95 %) | walks on | walks again | may be commanded after s | order obeyed "
      "after s "
      "| walks after s | processes back after s | stop obeyed after s | lost, each trial |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n",
      head.robot, head.speed_m_per_s, campaign.is_whole ? "" : "; broken off");
  std::size_t trials = 0, falls = 0, well = 0;
  for (const RealTimeRowResult& row : campaign.rows) {
    if (row.outcomes.empty()) continue;
    text += real_time_line(row);
    trials += row.outcomes.size();
    falls += summary_of(row).falls;
    well += static_cast<std::size_t>(std::ranges::count_if(row.outcomes, &RealTimeOutcome::is_well));
  }
  return text + fmt::format("\n{} of {} trials fell; in {} all came back, and the robot walked when asked.\n",
                            falls, trials, well);
}

std::string real_time_csv(const RealTimeCampaign& campaign) {
  std::string text =
      "row,number,seed,stopped,fell_s,walked_on,commandable_s,order_s,walks_s,parts_s,stop_s,batches,tail_"
      "cycles,"
      "joint_cycles,restarts,plugin_faults,event_lines,note\n";
  const auto time = [](const std::optional<double>& time_s) {
    return time_s ? fmt::format("{:.4f}", *time_s) : std::string();
  };
  for (const RealTimeRowResult& row : campaign.rows) {
    for (std::size_t number = 0; number < row.outcomes.size(); ++number) {
      const RealTimeOutcome& one = row.outcomes[number];
      text += fmt::format("{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\"\n", row.row.name, number,
                          one.seed, draw_real_time_trial(row.row.name, number, 0.0).is_stopped ? 1 : 0,
                          time(one.fell_s), one.walked_on ? 1 : 0, time(one.commandable_s), time(one.order_s),
                          time(one.walks_s), time(one.parts_s), time(one.stop_s), one.lost.batches,
                          one.lost.tail_cycles, one.lost.joint_cycles, one.lost.restarts,
                          one.lost.plugin_faults, one.lost.event_lines, one.note);
    }
  }
  return text;
}

Json real_time_json(const RealTimeHead& head, const RealTimeCampaign& campaign) {
  Json json = {{"robot", head.robot},
               {"speed_m_per_s", head.speed_m_per_s},
               {"whole", campaign.is_whole},
               {"rows", Json::array()}};
  for (const RealTimeRowResult& row : campaign.rows) {
    const RealTimeSummary summary = summary_of(row);
    Json one = {{"row", row.row.name},
                {"what", row.row.what},
                {"trials", summary.trials},
                {"falls", summary.falls},
                {"most_falls_share", summary.most_falls_share},
                {"walked_on", summary.walked_on},
                {"walked_again", summary.walked_again},
                {"commandable_s", times_json(summary.commandable)},
                {"order_s", times_json(summary.order)},
                {"walks_s", times_json(summary.walks)},
                {"parts_s", times_json(summary.parts)},
                {"stops_asked", summary.stopped},
                {"stop_s", times_json(summary.stop)},
                {"not_well", Json::array()}};
    for (const RealTimeOutcome& outcome : row.outcomes) {
      if (!outcome.is_well()) one["not_well"].push_back(to_json(outcome));
    }
    json["rows"].push_back(std::move(one));
  }
  return json;
}

}  // namespace gaitway::tools
