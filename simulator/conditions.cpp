// Reads from a scenario what a trial does to ground and body.

#include <array>
#include <string_view>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/yaml_value.hpp"
#include "gaitway/simulator/conditions.hpp"

namespace gaitway::simulator {
namespace {

using input::YamlValue;

using facts::kRadPerDegree;
constexpr double kSteepest_deg = 30.0;

void read_number(const YamlValue& map, std::string_view key, const input::Range& range, double& target,
                 double unit = 1.0) {
  if (const auto value = map.find(key)) target = unit * value->number(range);
}

GroundStep read_step(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 2>{"at_m", "height_m"});
  return {value.at("at_m").number({-50.0, 50.0, "m"}), value.at("height_m").number({-0.2, 0.2, "m"})};
}

DeadCell read_dead_cell(const YamlValue& value) {
  value.require_map(std::array<std::string_view, 2>{"foot", "cell"});
  const YamlValue foot = value.at("foot");
  const std::string side = foot.text();
  if (side != "left" && side != "right") foot.refuse("must be left or right", "Choose one of them.");
  return {side == "left" ? urdf::Side::left : urdf::Side::right,
          static_cast<std::size_t>(value.at("cell").integer(0, 3))};
}

GroundConditions read_ground(const YamlValue& value) {
  GroundConditions ground;
  if (const auto friction = value.find("friction")) ground.friction = friction->number({0.01, 5.0, ""});
  if (const auto slope = value.find("slope_deg")) {
    const std::array<double, 2> rise = slope->numbers<2>({-kSteepest_deg, kSteepest_deg, "deg"});
    ground.slope_rad = {kRadPerDegree * rise[0], kRadPerDegree * rise[1]};
  }
  read_number(value, "tiles_m", {0.0, 0.05, "m"}, ground.tile_height_m);
  if (const auto step = value.find("step")) {
    if (ground.tile_height_m > 0.0) step->refuse("cannot be together with tiles", "Leave one of them out.");
    ground.step = read_step(*step);
  }
  return ground;
}

BodyConditions read_body(const YamlValue& value) {
  BodyConditions body;
  read_number(value, "trunk_mass_factor", {0.1, 5.0, ""}, body.trunk_mass_factor);
  read_number(value, "torque_factor", {0.0, 5.0, ""}, body.torque_factor);
  read_number(value, "backlash_deg", {0.0, 5.0, "deg"}, body.backlash_rad, kRadPerDegree);
  read_number(value, "gyro_bias_deg_per_s", {0.0, 10.0, "deg/s"}, body.gyro_bias_deviation_rad_per_s,
              kRadPerDegree);
  read_number(value, "cell_gain_deviation", {0.0, 0.5, ""}, body.cell_gain_deviation);
  if (const auto cell = value.find("dead_cell")) body.dead_cell = read_dead_cell(*cell);
  return body;
}

}  // namespace

Conditions read_conditions(const YamlValue& value) {
  constexpr std::array<std::string_view, 10> kKeys{
      "friction",     "slope_deg",           "tiles_m",
      "step",         "trunk_mass_factor",   "torque_factor",
      "backlash_deg", "gyro_bias_deg_per_s", "cell_gain_deviation",
      "dead_cell"};
  value.require_map(kKeys);
  return {.ground = read_ground(value), .body = read_body(value)};
}

}  // namespace gaitway::simulator
