// The campaign as Markdown, JSON and CSV.
#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "tools/campaign/campaign.hpp"
#include "tools/campaign/row_summary.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kStopDeadline_s = 0.010;

std::string shown_times(const TimeSummary& times) {
  return times.count == 0 ? "" : fmt::format("{:.2f}, {:.2f}", times.median_s, times.largest_s);
}

std::string shown_stop(const CampaignRow& row, const RowSummary& summary) {
  std::size_t in_time = 0;
  for (const PlayedTrial& one : row.trials) {
    if (one.outcome.stop_s && *one.outcome.stop_s <= kStopDeadline_s) ++in_time;
  }
  return fmt::format("{}{}", in_time,
                     summary.stop.count == 0 ? "" : fmt::format(", {:.1f} ms", 1e3 * summary.stop.largest_s));
}

std::string shown_losses(const RowSummary& summary) {
  const FaultLosses& lost = summary.lost;
  std::string text;
  const auto add = [&](std::uint64_t count, const char* what) {
    const double each =
        static_cast<double>(count) / static_cast<double>(std::max<std::size_t>(summary.trials, 1));
    if (count > 0) text += fmt::format("{}{:.2g} {}", text.empty() ? "" : ", ", each, what);
  };
  add(lost.late + lost.refused, "batches");
  add(lost.trajectories_lost, "frames");
  add(lost.repaired + lost.resynchronised, "repairs");
  add(lost.tail_played, "tail cycles");
  if (summary.wrong_joints > 0) {
    text += fmt::format("{}joints wrong at the end in {}", text.empty() ? "" : ", ", summary.wrong_joints);
  }
  return text;
}

std::string shown_expectation(const CampaignRow& row) {
  switch (row.row.expected) {
    case FaultExpectation::survives:
      return row.holds() ? "survives" : "**ought to survive**";
    case FaultExpectation::physics:
      return fmt::format("may fall: {}{}", row.row.why, row.holds() ? "" : " **and did not know**");
    case FaultExpectation::not_yet:
      return fmt::format("not yet: {}", row.row.why);
    case FaultExpectation::reported:
      break;
  }
  return "no promise";
}

std::string table_line(const CampaignRow& row) {
  const RowSummary summary = summary_of(row);
  std::string line = fmt::format("| `{}`: {} | {} | {} (≤ {:.1f} %) |", row.row.name, row.row.what,
                                 summary.trials, row.falls(), 100.0 * summary.most_falls_share);
  for (std::size_t end = 0; end < kFaultEnds; ++end) {
    if (end != static_cast<std::size_t>(FaultEnd::falls)) line += fmt::format(" {} |", summary.ends[end]);
  }
  return line + fmt::format(" {} | {} | {} | {} | {} | {} |\n", shown_times(summary.stands),
                            shown_times(summary.walks), shown_times(summary.lead), shown_stop(row, summary),
                            shown_losses(summary), shown_expectation(row));
}

// Of the rows that physics allows to survive.
std::string verdict(const Campaign& campaign) {
  std::size_t allowed = 0, survived = 0;
  for (const CampaignRow& row : campaign.rows) {
    if (row.row.expected == FaultExpectation::physics || row.row.expected == FaultExpectation::reported)
      continue;
    ++allowed;
    survived += row.falls() == 0 ? 1U : 0U;
  }
  if (allowed == 0) return "";
  return fmt::format("No fall in {} of the {} rows that physics allows to survive ({:.0f} %).\n", survived,
                     allowed, 100.0 * static_cast<double>(survived) / static_cast<double>(allowed));
}

Json times_json(const TimeSummary& times) {
  if (times.count == 0) return nullptr;
  return {{"count", times.count}, {"median_s", times.median_s}, {"largest_s", times.largest_s}};
}

Json row_json(const CampaignRow& row) {
  const RowSummary summary = summary_of(row);
  Json json = {{"row", row.row.name},
               {"what", row.row.what},
               {"trials", summary.trials},
               {"falls", row.falls()},
               {"most_falls_share", summary.most_falls_share},
               {"holds", row.holds()}};
  for (std::size_t end = 0; end < kFaultEnds; ++end) {
    json["ends"][std::string(kFaultEndLooks[end].words)] = summary.ends[end];
  }
  json["stands_s"] = times_json(summary.stands);
  json["walks_s"] = times_json(summary.walks);
  json["stop_s"] = times_json(summary.stop);
  json["known_before_impact_s"] = times_json(summary.lead);
  json["fell"] = Json::array();
  for (const auto& [trial, outcome] : row.trials) {
    if (outcome.fell) json["fell"].push_back({{"trial", describe(trial)}, {"outcome", to_json(outcome)}});
  }
  return json;
}

}  // namespace

std::string campaign_markdown(const CampaignHead& head, const Campaign& campaign) {
  std::string text = fmt::format(
      "{} with {}, walking at {} m/s, {} robots in turn{}.\n\n"
      "| fault | instants | falls (95 %) | walks on | walks again | stands | falls, knew or soft | stands "
      "after "
      "s | walks after s | knew before impact s | stop ≤ 10 ms | lost, each trial | expected |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|---|---|\n",
      head.robot, head.configuration, head.options.speed_m_per_s, head.options.robots,
      head.quick ? "; quick" : "");
  for (const CampaignRow& row : campaign.rows) text += table_line(row);
  return text + "\n" + verdict(campaign);
}

std::string campaign_csv(const Campaign& campaign) {
  std::string text =
      "row,number,seed,instant_s,end,fell_s,told_s,soft_s,impact_s,stands_s,walks_s,stop_s,late,refused,"
      "tail_played,repaired,resynchronised,trajectories_lost,feedback_lost,wrong_joints,fault\n";
  const auto time = [](const std::optional<double>& time_s) {
    return time_s ? fmt::format("{:.4f}", *time_s) : std::string();
  };
  for (const CampaignRow& row : campaign.rows) {
    for (const auto& [trial, outcome] : row.trials) {
      const FaultLosses& lost = outcome.lost;
      std::string faults;
      for (const FaultAction& action : trial.actions) faults += (faults.empty() ? "" : "; ") + action.text;
      text +=
          fmt::format("{},{},{},{:.3f},\"{}\",{},{},{},{},{},{},{},{},{},{},{},{},{},{},{},\"{}\"\n",
                      trial.row, trial.number, trial.seed, trial.instant_s,
                      kFaultEndLooks[static_cast<std::size_t>(end_of(outcome))].words, time(outcome.fell_s),
                      time(outcome.told_s), time(outcome.soft_s), time(outcome.impact_s),
                      time(outcome.stands_s), time(outcome.walks_s), time(outcome.stop_s), lost.late,
                      lost.refused, lost.tail_played, lost.repaired, lost.resynchronised,
                      lost.trajectories_lost, lost.feedback_lost, lost.wrong_joints, faults);
    }
  }
  return text;
}

Json campaign_json(const CampaignHead& head, const Campaign& campaign) {
  Json json = {{"robot", head.robot},
               {"configuration", head.configuration},
               {"speed_m_per_s", head.options.speed_m_per_s},
               {"robots", head.options.robots},
               {"instants", head.options.instants},
               {"quick", head.quick},
               {"rows", Json::array()}};
  for (const CampaignRow& row : campaign.rows) json["rows"].push_back(row_json(row));
  return json;
}

}  // namespace gaitway::tools
