// Store, progress, results.
#include "tools/campaign/real_time/real_time_command.hpp"

#include <fmt/format.h>
#include <sched.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "tools/campaign/real_time/real_time_summary.hpp"
#include "tools/command_line.hpp"

namespace gaitway::tools {
namespace {

constexpr int kExitARobotFell = 3;

std::string shown_left(const std::optional<double>& remaining_s) {
  if (!remaining_s) return "";
  const auto whole = static_cast<std::int64_t>(*remaining_s);
  return fmt::format(", {}:{:02} min left", whole / 60, whole % 60);
}

// Who looks is not to be kept from it by the noise that it makes; whoever it starts has ordinary priority.
void look_before_others() {
  const sched_param lowest{.sched_priority = 1};
  sched_setscheduler(0, SCHED_FIFO | SCHED_RESET_ON_FORK, &lowest);  // without the right: as the others
}

int exit_code_of(const RealTimeCampaign& campaign) {
  bool all_well = campaign.is_whole, fell = false;
  for (const RealTimeRowResult& row : campaign.rows) {
    fell = fell || std::ranges::any_of(row.outcomes, &RealTimeOutcome::fell);
    all_well = all_well && std::ranges::all_of(row.outcomes, &RealTimeOutcome::is_well);
  }
  return fell ? kExitARobotFell : all_well ? kExitFine : kExitNotBack;
}

}  // namespace

int run_in_real_time(const RealTimeCommand& command) {
  const std::vector<RealTimeRow> table = real_time_table();
  if (command.list) {
    for (const RealTimeRow& row : table) fmt::print("  {:<32}{}\n", row.name, row.what);
    return kExitFine;
  }
  const std::vector<RealTimeRow> rows = chosen_real_time_rows(table, command.rows, command.except);
  const RealTimeHead head{urdf::load_robot(command.robot).name, command.speed_m_per_s};
  prepare_output(command.out);
  OutcomeStore store(
      command.out / "real_time_trials.jsonl", real_time_fingerprint(command.robot),
      [](const nlohmann::ordered_json& outcome) { static_cast<void>(real_time_outcome_from_json(outcome)); });
  process::stop_on_signals();
  look_before_others();
  RealTimeOptions options{.robot = std::filesystem::absolute(command.robot),
                          .trials = command.trials,
                          .speed_m_per_s = command.speed_m_per_s};
  RealTimeCampaign campaign;
  {
    const ProgressLine line(!command.quiet);
    options.progress = [&line](std::uint64_t done, std::uint64_t planned, const std::string& row,
                               const std::optional<double>& remaining_s) {
      line.show(fmt::format("  {} / {} trials{}; {} ", done, planned, shown_left(remaining_s), row));
    };
    campaign = run_real_time_campaign(rows, store, options);
  }
  process::write_text_file(command.out / "real_time.json", real_time_json(head, campaign).dump(2) + "\n");
  process::write_text_file(command.out / "real_time.csv", real_time_csv(campaign));
  const std::string text = real_time_markdown(head, campaign);
  process::write_text_file(command.out / "real_time.md", text);
  if (!command.quiet) {
    fmt::print("{}\n{} trials played, {} known from {}.\n", text, campaign.run, campaign.known,
               (command.out / "real_time_trials.jsonl").string());
  }
  return exit_code_of(campaign);
}

}  // namespace gaitway::tools
