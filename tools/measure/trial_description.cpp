// Trials and outcomes as JSON. What a trial leaves at its default is left out.
#include <nlohmann/json.hpp>
#include <optional>

#include "tools/measure/gait_trial.hpp"

namespace gaitway::tools {
namespace {

using Json = nlohmann::ordered_json;

// A value that may be missing has no field then.
void put(Json& json, const char* name, const std::optional<double>& value) {
  if (value) {
    json[name] = *value;
  }
}

std::optional<double> taken(const Json& json, const char* name) {
  return json.contains(name) ? std::optional(json.at(name).get<double>()) : std::nullopt;
}

Json ground_of(const simulator::GroundConditions& ground) {
  Json json = Json::object();
  put(json, "friction", ground.friction);
  if (!ground.slope_rad.isZero(0.0)) {
    json["slope_rad"] = {ground.slope_rad.x(), ground.slope_rad.y()};
  }
  if (ground.tile_height_m != 0.0) {
    json["tiles_m"] = ground.tile_height_m;
  }
  if (ground.step) {
    json["step"] = {{"at_m", ground.step->at_m}, {"height_m", ground.step->height_m}};
  }
  return json;
}

Json body_of(const simulator::BodyConditions& body) {
  const simulator::BodyConditions plain;
  Json json = Json::object();
  const auto put_unusual = [&json](const char* name, double value, double usual) {
    if (value != usual) {
      json[name] = value;
    }
  };
  put_unusual("trunk_mass_factor", body.trunk_mass_factor, plain.trunk_mass_factor);
  put_unusual("torque_factor", body.torque_factor, plain.torque_factor);
  put_unusual("backlash_rad", body.backlash_rad, plain.backlash_rad);
  put_unusual("gyro_bias_deviation_rad_per_s", body.gyro_bias_deviation_rad_per_s,
              plain.gyro_bias_deviation_rad_per_s);
  put_unusual("cell_gain_deviation", body.cell_gain_deviation, plain.cell_gain_deviation);
  if (body.dead_cell) {
    json["dead_cell"] = {body.dead_cell->foot == urdf::Side::left ? "left" : "right", body.dead_cell->cell};
  }
  return json;
}

Json fall_json(const FallOutcome& fall) {
  Json json = {{"hardest_force_N", fall.hardest_force_N}, {"trunk_speed_m_per_s", fall.trunk_speed_m_per_s}};
  put(json, "told_s", fall.told_s);
  put(json, "impact_s", fall.impact_s);
  return json;
}

FallOutcome fall_from(const Json& json) {
  FallOutcome fall;
  fall.hardest_force_N = json.at("hardest_force_N").get<double>();
  fall.trunk_speed_m_per_s = json.at("trunk_speed_m_per_s").get<double>();
  fall.told_s = taken(json, "told_s");
  fall.impact_s = taken(json, "impact_s");
  return fall;
}

}  // namespace

std::optional<double> FallOutcome::lead_s() const {
  if (!impact_s) {
    return std::nullopt;
  }
  return told_s && *told_s < *impact_s ? *impact_s - *told_s : 0.0;
}

Json describe(const Trial& trial) {
  Json json = {{"seed", trial.seed}, {"seconds", trial.seconds}};
  if (!trial.commands.empty()) {
    Json& commands = json["commands"] = Json::array();
    for (const TimedVelocity& command : trial.commands) {
      commands.push_back({command.at_s, command.velocity.x(), command.velocity.y(), command.velocity.z()});
    }
    json["steady_from_s"] = trial.steady_from_s;
    json["gait_cycle_s"] = trial.gait_cycle_s;
  }
  if (trial.push) {
    json["push"] = {{"at_s", trial.push->at_s},
                    {"direction_rad", trial.push->direction_rad},
                    {"impulse_Ns", trial.push->impulse_Ns}};
  }
  if (trial.watches_fall) {
    json["watches_fall"] = true;
  }
  if (trial.stiff_in_fall) {
    json["stiff_in_fall"] = true;
  }
  if (trial.rise) {
    json["rise"] = {{"at_s", trial.rise->at_s}, {"motion", trial.rise->motion}};
  }
  json["ground"] = ground_of(trial.conditions.ground);
  json["body"] = body_of(trial.conditions.body);
  if (trial.corrupted_share != 0.0) {
    json["corrupted_share"] = trial.corrupted_share;
  }
  if (trial.times_compute) {
    json["times_compute"] = true;
  }
  return json;
}

Json to_json(const TrialOutcome& outcome) {
  Json json = {
      {"fell", outcome.fell},
      {"ended_s", outcome.ended_s},
      {"mean_velocity", {outcome.mean_velocity.x(), outcome.mean_velocity.y(), outcome.mean_velocity.z()}},
      {"heading_drift_rad", outcome.heading_drift_rad},
      {"heading_deg", outcome.heading_deg},
      {"foot_moved_m", outcome.foot_moved_m},
      {"foot_lifted_m", outcome.foot_lifted_m}};
  put(json, "zmp_error_rms_m", outcome.zmp_error_rms_m);
  if (outcome.fall) {
    json["fall"] = fall_json(*outcome.fall);
  }
  put(json, "stands_since_s", outcome.stands_since_s);
  if (outcome.batch_compute_p99_us > 0.0) {
    json["batch_compute_p99_us"] = outcome.batch_compute_p99_us;
  }
  return json;
}

TrialOutcome outcome_from_json(const Json& json) {
  TrialOutcome outcome;
  outcome.fell = json.at("fell").get<bool>();
  outcome.ended_s = json.at("ended_s").get<double>();
  for (std::size_t i = 0; i < 3; ++i) {
    outcome.mean_velocity[static_cast<Eigen::Index>(i)] = json.at("mean_velocity").at(i).get<double>();
  }
  outcome.heading_drift_rad = json.at("heading_drift_rad").get<double>();
  outcome.heading_deg = json.at("heading_deg").get<std::vector<float>>();
  outcome.foot_moved_m = json.at("foot_moved_m").get<double>();
  outcome.foot_lifted_m = json.at("foot_lifted_m").get<double>();
  outcome.zmp_error_rms_m = taken(json, "zmp_error_rms_m");
  if (json.contains("fall")) {
    outcome.fall = fall_from(json.at("fall"));
  }
  outcome.stands_since_s = taken(json, "stands_since_s");
  outcome.batch_compute_p99_us = json.value("batch_compute_p99_us", 0.0);
  return outcome;
}

}  // namespace gaitway::tools
