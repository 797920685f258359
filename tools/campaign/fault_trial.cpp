// Draws trials; trials and outcomes as JSON, and as scenarios.
#include "tools/campaign/fault_trial.hpp"

#include <fmt/format.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "tools/measure/outcome_store.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

void put_time(Json& json, const char* name, const std::optional<double>& time_s) {
  if (time_s) json[name] = *time_s;
}
std::optional<double> time_of(const Json& json, const char* name) {
  return json.contains(name) ? std::optional(json.at(name).get<double>()) : std::nullopt;
}

double whole_ms(double time_s) {
  return std::round(time_s * 1e3) * 1e-3;
}

}  // namespace

FaultTrial draw_trial(const FaultRow& row, std::uint64_t number, int robots, double speed_m_per_s) {
  ContentHash name;
  name.add(row.name);
  facts::RandomStream random(number, name.value());
  FaultTrial trial{.row = row.name,
                   .number = number,
                   .seed = 1 + number % static_cast<std::uint64_t>(robots),
                   .speed_m_per_s = speed_m_per_s,
                   .instant_s = whole_ms(kFirstInstant_s + kInstants_s * random.uniform()),
                   .actions = {}};
  trial.actions = row.draw(random);
  return trial;
}

Json describe(const FaultTrial& trial) {
  Json json = {{"row", trial.row},
               {"number", trial.number},
               {"seed", trial.seed},
               {"speed_m_per_s", trial.speed_m_per_s},
               {"instant_s", trial.instant_s}};
  for (const FaultAction& action : trial.actions) {
    json["actions"].push_back({{"after_s", action.after_s}, {"text", action.text}});
  }
  return json;
}

Json to_json(const FaultOutcome& outcome) {
  Json json = {{"fell", outcome.fell}, {"walked_on", outcome.walked_on}};
  put_time(json, "fell_s", outcome.fell_s);
  put_time(json, "told_s", outcome.told_s);
  put_time(json, "soft_s", outcome.soft_s);
  put_time(json, "impact_s", outcome.impact_s);
  put_time(json, "stands_s", outcome.stands_s);
  put_time(json, "walks_s", outcome.walks_s);
  put_time(json, "stop_s", outcome.stop_s);
  const FaultLosses& lost = outcome.lost;
  json["lost"] = {{"late", lost.late},
                  {"refused", lost.refused},
                  {"tail_played", lost.tail_played},
                  {"repaired", lost.repaired},
                  {"resynchronised", lost.resynchronised},
                  {"trajectories_lost", lost.trajectories_lost},
                  {"feedback_lost", lost.feedback_lost},
                  {"wrong_joints", lost.wrong_joints}};
  return json;
}

FaultOutcome fault_outcome_from_json(const Json& json) {
  FaultOutcome outcome{.fell = json.at("fell").get<bool>(),
                       .fell_s = time_of(json, "fell_s"),
                       .told_s = time_of(json, "told_s"),
                       .soft_s = time_of(json, "soft_s"),
                       .impact_s = time_of(json, "impact_s"),
                       .stands_s = time_of(json, "stands_s"),
                       .walked_on = json.at("walked_on").get<bool>(),
                       .walks_s = time_of(json, "walks_s"),
                       .stop_s = time_of(json, "stop_s"),
                       .lost = {}};
  const Json& lost = json.at("lost");
  outcome.lost = {.late = lost.at("late").get<std::uint64_t>(),
                  .refused = lost.at("refused").get<std::uint64_t>(),
                  .tail_played = lost.at("tail_played").get<std::uint64_t>(),
                  .repaired = lost.at("repaired").get<std::uint64_t>(),
                  .resynchronised = lost.at("resynchronised").get<std::uint64_t>(),
                  .trajectories_lost = lost.at("trajectories_lost").get<std::uint64_t>(),
                  .feedback_lost = lost.at("feedback_lost").get<std::uint64_t>(),
                  .wrong_joints = lost.at("wrong_joints").get<int>()};
  return outcome;
}

std::string scenario_text(const FaultTrial& trial) {
  std::string text = fmt::format("# Trial {} of the fault campaign's row {}: play it with --seed {}.\n",
                                 trial.number, trial.row, trial.seed);
  text += fmt::format("seconds: {:.3f}\nevents:\n", trial.instant_s + kWatched_s + kWalkAgain_s);
  const std::string walk = fmt::format("walk: [{}, 0, 0]", trial.speed_m_per_s);
  const auto event = [&text](double at_s, const std::string& action) {
    text += fmt::format("  - {{at_s: {:.3f}, {}}}\n", at_s, action);
  };
  event(kWalkFrom_s, walk);
  for (const FaultAction& action : trial.actions) event(trial.instant_s + action.after_s, action.text);
  event(trial.instant_s + kWatched_s, walk);
  return text;
}

}  // namespace gaitway::tools
