// Instants from a stream of random numbers, outcomes as JSON.
#include "tools/campaign/real_time/real_time_trial.hpp"

#include <nlohmann/json.hpp>

#include "gaitway/facts/random_stream.hpp"
#include "tools/measure/outcome_store.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

// It has left the first steps behind then; two steps with each foot, so that each phase may be met.
constexpr double kFirstWalked_s = 0.5, kDrawnFrom_s = 1.6;

Json optional_json(const std::optional<double>& time_s) {
  return time_s ? Json(*time_s) : Json(nullptr);
}

std::optional<double> optional_from(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace

RealTimeTrial draw_real_time_trial(const std::string& row, std::uint64_t number, double speed_m_per_s) {
  ContentHash name;
  name.add(row);
  facts::RandomStream random(number + 1, name.value());
  return {.row = row,
          .number = number,
          .speed_m_per_s = speed_m_per_s,
          .instant_s = kFirstWalked_s + kDrawnFrom_s * random.uniform(),
          .is_stopped = number % 2 == 1};
}

Json describe(const RealTimeTrial& trial) {
  return {{"row", trial.row},
          {"number", trial.number},
          {"speed_m_per_s", trial.speed_m_per_s},
          {"instant_s", trial.instant_s},
          {"stopped", trial.is_stopped}};
}

Json to_json(const RealTimeOutcome& outcome) {
  const RealTimeLosses& lost = outcome.lost;
  return {{"seed", outcome.seed},
          {"fell", outcome.fell},
          {"fell_s", optional_json(outcome.fell_s)},
          {"interrupted", outcome.was_interrupted},
          {"commandable_s", optional_json(outcome.commandable_s)},
          {"order_s", optional_json(outcome.order_s)},
          {"walked_on", outcome.walked_on},
          {"walks_s", optional_json(outcome.walks_s)},
          {"parts_s", optional_json(outcome.parts_s)},
          {"stop_s", optional_json(outcome.stop_s)},
          {"lost",
           {{"batches", lost.batches},
            {"tail_cycles", lost.tail_cycles},
            {"joint_cycles", lost.joint_cycles},
            {"restarts", lost.restarts},
            {"plugin_faults", lost.plugin_faults},
            {"event_lines", lost.event_lines}}},
          {"note", outcome.note}};
}

RealTimeOutcome real_time_outcome_from_json(const Json& json) {
  RealTimeOutcome outcome;
  json.at("seed").get_to(outcome.seed);
  json.at("fell").get_to(outcome.fell);
  outcome.fell_s = optional_from(json.at("fell_s"));
  json.at("interrupted").get_to(outcome.was_interrupted);
  outcome.commandable_s = optional_from(json.at("commandable_s"));
  outcome.order_s = optional_from(json.at("order_s"));
  json.at("walked_on").get_to(outcome.walked_on);
  outcome.walks_s = optional_from(json.at("walks_s"));
  outcome.parts_s = optional_from(json.at("parts_s"));
  outcome.stop_s = optional_from(json.at("stop_s"));
  const Json& lost = json.at("lost");
  lost.at("batches").get_to(outcome.lost.batches);
  lost.at("tail_cycles").get_to(outcome.lost.tail_cycles);
  lost.at("joint_cycles").get_to(outcome.lost.joint_cycles);
  lost.at("restarts").get_to(outcome.lost.restarts);
  lost.at("plugin_faults").get_to(outcome.lost.plugin_faults);
  lost.at("event_lines").get_to(outcome.lost.event_lines);
  json.at("note").get_to(outcome.note);
  return outcome;
}

}  // namespace gaitway::tools
