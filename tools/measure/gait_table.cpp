// The table itself.
#include "tools/measure/gait_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/trajectory/gait_parameters.hpp"
#include "tools/measure/trial_lists.hpp"

namespace gaitway::tools {
namespace {

constexpr double kTold = 1.1;             // times the speed that a row wants the robot to reach
constexpr double kFootInPlace_m = 0.020;  // so far a foot may slide
// A body that tips to one side takes the weight off the other foot, which then rises some millimetres and
// comes back to its place; a foot that steps is lifted by centimetres.
constexpr double kFootOnGround_m = 0.010;    // of its lowest corner
constexpr double kSteadyWalk_m_per_s = 0.2;  // where a row does not search the speed
constexpr double kCellGainDeviation = 0.03;
constexpr double kStandForBias_s = 10.0;  // before a heading is measured: the gyro's bias is learned in it
constexpr double kFailed = std::numeric_limits<double>::infinity();

using Trials = std::vector<Trial>;

bool stays_up(const TrialOutcome& outcome, const Trial&, double) {
  return !outcome.fell;
}
bool stays_up_in_place(const TrialOutcome& outcome, const Trial&, double) {
  return !outcome.fell && outcome.foot_moved_m <= kFootInPlace_m && outcome.foot_lifted_m <= kFootOnGround_m;
}
bool walks_at_speed(const TrialOutcome& outcome, const Trial& trial, double level) {
  return !outcome.fell && true_speed(outcome, trial) >= level;
}

// Of a robot that does not fall there is nothing to tell.
bool is_told(const TrialOutcome& outcome, const Trial&, double lead_s) {
  return !outcome.fall || outcome.fall->lead_s().value_or(kFailed) >= lead_s;
}
bool is_no_false_alarm(const TrialOutcome& outcome, const Trial&, double) {
  return !outcome.fall || !outcome.fall->told_s || outcome.fell;
}

// It lay, and stands at the end of the trial, in time.
bool has_risen(const TrialOutcome& outcome, const Trial& trial, double) {
  return outcome.fell && outcome.stands_since_s && *outcome.stands_since_s <= trial.rise->at_s + kRise_s;
}

double speed_error(const TrialOutcome& outcome, const Trial& trial) {
  if (outcome.fell) return kFailed;
  return std::abs(true_speed(outcome, trial) / trial.commands.front().velocity.norm() - 1.0);
}
double heading_error_rad(const TrialOutcome& outcome, const Trial&) {
  return outcome.fell ? kFailed : std::abs(outcome.heading_drift_rad);
}
double zmp_error_m(const TrialOutcome& outcome, const Trial&) {
  return outcome.fell ? kFailed : outcome.zmp_error_rms_m.value_or(kFailed);
}
double batch_compute_us(const TrialOutcome& outcome, const Trial&) {
  return outcome.fell ? kFailed : outcome.batch_compute_p99_us;
}

GaitRow named_row(std::string name, std::string measure, std::string unit, double floor, double aim) {
  GaitRow row;
  row.name = std::move(name);
  row.measure = std::move(measure);
  row.unit = std::move(unit);
  row.floor = floor;
  row.aim = aim;
  return row;
}

GaitRow level_row(std::string name, std::string measure, std::string unit, double floor, double aim,
                  std::vector<double> levels) {
  GaitRow row = named_row(std::move(name), std::move(measure), std::move(unit), floor, aim);
  row.levels = std::move(levels);
  row.passes = stays_up;
  return row;
}

GaitRow figure_row(std::string name, std::string measure, std::string unit, double floor, double aim,
                   double shown_scale) {
  GaitRow row = named_row(std::move(name), std::move(measure), std::move(unit), floor, aim);
  row.shown_scale = shown_scale;
  return row;
}

// Walking at a true speed that grows, along `directions`: the robot is told somewhat more.
GaitRow speed_row(const TrialFrame& frame, GaitRow row, std::vector<Eigen::Vector3d> directions,
                  double walked_s) {
  row.trials = [frame, directions = std::move(directions), walked_s](std::uint64_t seed, double level) {
    Trials trials;
    for (const Eigen::Vector3d& direction : directions) {
      trials.push_back(walk(frame, seed, kTold * level * direction, walked_s));
    }
    return trials;
  };
  row.passes = walks_at_speed;
  row.picture = GaitRow::Picture::speeds;
  return row;
}

void add_walking_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  const Eigen::Vector3d x = Eigen::Vector3d::UnitX(), y = Eigen::Vector3d::UnitY(),
                        z = Eigen::Vector3d::UnitZ();
  const double minute_s = frame.quick ? 15.0 : 60.0, short_s = frame.quick ? 10.0 : 30.0;
  table.push_back(
      speed_row(frame,
                level_row("straight", fmt::format("straight walking, true speed, {:.0f} s", minute_s), "m/s",
                          0.40, 0.63,
                          {0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35, 0.40, 0.42, 0.44, 0.46, 0.48, 0.50, 0.52,
                           0.54, 0.56, 0.58, 0.60, 0.63}),
                {x}, minute_s));

  GaitRow& held = table.emplace_back(
      figure_row("speed_held", "speed held against command, any direction", "%", 0.10, 0.05, 100.0));
  held.trials = [frame](std::uint64_t seed, double) { return walks_in_all_directions(frame, seed); };
  held.figure = speed_error;
  held.picture = GaitRow::Picture::speeds;

  GaitRow& heading = table.emplace_back(
      figure_row("heading", fmt::format("heading drift, straight, {:.0f} s at 0.2 m/s", minute_s), "deg",
                 5.0 / facts::kDegreePerRad, 2.0 / facts::kDegreePerRad, facts::kDegreePerRad));
  heading.trials = [frame, minute_s](std::uint64_t seed, double) {
    return Trials{walk(frame, seed, {kSteadyWalk_m_per_s, 0.0, 0.0}, minute_s, kStandForBias_s)};
  };
  heading.figure = heading_error_rad;
  heading.picture = GaitRow::Picture::headings;

  table.push_back(
      speed_row(frame,
                level_row("sideways", "sideways, true speed, both ways", "m/s", kFloorSideways_m_per_s, 0.15,
                          {0.02, 0.04, 0.06, 0.08, 0.10, 0.125, 0.15, 0.175, 0.20, 0.25}),
                {y, -y}, short_s));
  table.push_back(speed_row(frame,
                            level_row("backward", "backward, true speed", "m/s", kFloorBackward_m_per_s, 0.3,
                                      {0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35, 0.40, 0.45}),
                            {-x}, short_s));
  table.push_back(
      speed_row(frame,
                level_row("turning", "turning on the spot, true rate, both ways", "rad/s",
                          kFloorTurn_rad_per_s, 1.5, {0.2, 0.4, 0.6, 0.8, 1.0, 1.25, 1.5, 1.75, 2.0}),
                {z, -z}, short_s));

  GaitRow& random = table.emplace_back(level_row(
      "random", "random velocity commands, changed every 1-4 s", "min", 5.0, 30.0,
      frame.quick ? std::vector{0.2, 0.4, 0.8} : std::vector{0.5, 1.0, 2.0, 5.0, 10.0, 20.0, 30.0}));
  if (frame.quick) {
    random.floor = random.aim = random.levels.back();
  }
  random.most_seeds = 10;
  random.trials = [frame](std::uint64_t seed, double level) {
    return Trials{random_walk(frame, seed, 60.0 * level)};
  };
}

void add_push_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  constexpr double pi = std::numbers::pi;
  const std::vector<double> impulses{0.5, 1.0, 1.5, 1.9, 2.2, 2.5, 2.8, 3.0, 3.2, 3.5, 4.0};
  const auto in_place = [&](const char* name, const char* measure, double floor, double aim,
                            std::vector<double> directions_rad) {
    GaitRow& row = table.emplace_back(level_row(name, measure, "N·s", floor, aim, impulses));
    row.trials = [frame, directions = std::move(directions_rad)](std::uint64_t seed, double level) {
      return pushes_while_standing(frame, seed, level, directions);
    };
    row.passes = stays_up_in_place;
  };
  in_place("push_front", "standing push to the front, feet in place", 2.2, 3.2, {0.0});
  in_place("push_back", "standing push to the back, feet in place", 1.9, 3.0, {pi});
  in_place("push_side", "standing push to either side, feet in place", 2.5, 3.2, {pi / 2.0, -pi / 2.0});

  GaitRow& stepping = table.emplace_back(
      level_row("push_stepping", "standing push, stepping allowed, worst of 8 directions", "N·s", 2.2, 5.0,
                {0.5, 1.0, 1.4, 1.8, 2.2, 2.6, 3.0, 3.5, 4.0, 4.5, 5.0, 5.5, 6.0}));
  stepping.trials = [frame](std::uint64_t seed, double level) {
    return pushes_while_standing(frame, seed, level, evenly_spread_directions_rad(8));
  };
  stepping.picture = GaitRow::Picture::pushes;

  for (const double speed : {0.0, kSteadyWalk_m_per_s}) {
    const bool walks = speed > 0.0;
    GaitRow& row = table.emplace_back(
        level_row(walks ? "push_walking" : "push_on_the_spot",
                  fmt::format("push while walking at {} m/s, worst of {}", speed,
                              frame.quick ? "4 directions x 4 phases" : "8 directions x 16 phases"),
                  "N·s", 1.2, 3.0, {0.3, 0.6, 0.9, 1.2, 1.5, 1.8, 2.1, 2.4, 2.7, 3.0, 3.3}));
    row.trials = [frame, speed](std::uint64_t seed, double level) {
      return pushes_while_walking(frame, seed, level, speed);
    };
    row.picture = GaitRow::Picture::pushes;
  }
}

void add_ground_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  GaitRow& slope =
      table.emplace_back(level_row("slope", "slope unprepared, any direction, walking and standing", "deg",
                                   5.0, 8.0, {1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0, 8.0, 9.0, 10.0}));
  slope.trials = [frame](std::uint64_t seed, double level) { return slopes(frame, seed, level); };

  const double walked_s = frame.quick ? 10.0 : 30.0;
  GaitRow& tiles = table.emplace_back(
      level_row("tiles", "tiles of random height, 100 mm", "mm", 0.005, 0.015,
                {0.001, 0.002, 0.003, 0.004, 0.005, 0.006, 0.008, 0.010, 0.0125, 0.015, 0.0175, 0.020}));
  tiles.shown_scale = 1000.0;
  tiles.trials = [frame, walked_s](std::uint64_t seed, double level) {
    Trial trial = walk(frame, seed, {0.15, 0.0, 0.0}, walked_s);
    trial.conditions.ground.tile_height_m = level;
    return Trials{trial};
  };

  GaitRow& step =
      table.emplace_back(level_row("step", "unexpected step down and up while walking", "mm", 0.008, 0.020,
                                   {0.002, 0.004, 0.006, 0.008, 0.010, 0.0125, 0.015, 0.0175, 0.020, 0.025}));
  step.shown_scale = 1000.0;
  step.trials = [frame](std::uint64_t seed, double level) { return steps_in_the_ground(frame, seed, level); };
}

// Walking ahead under a condition; the level is the speed.
GaitRow condition_row(const TrialFrame& frame, const char* name, const char* measure,
                      std::function<Trials(const Trial& walk)> under) {
  GaitRow row = level_row(name, measure, "m/s", 0.15, 0.25, {0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35});
  const double walked_s = frame.quick ? 10.0 : 30.0;
  row.trials = [frame, walked_s, under = std::move(under)](std::uint64_t seed, double level) {
    return under(walk(frame, seed, {level, 0.0, 0.0}, walked_s));
  };
  return row;
}

void add_condition_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  table.push_back(condition_row(frame, "friction", "ground friction 0.3 to 1.2", [frame](const Trial& plain) {
    Trials trials;
    for (const double friction : frame.quick ? std::vector{0.3, 1.2} : std::vector{0.3, 0.6, 0.9, 1.2}) {
      trials.push_back(plain);
      trials.back().conditions.ground.friction = friction;
    }
    return trials;
  }));
  table.push_back(condition_row(frame, "load", "10 % more trunk mass", [](Trial trial) {
    trial.conditions.body.trunk_mass_factor = 1.1;
    return Trials{trial};
  }));
  table.push_back(condition_row(frame, "torque", "torque -25 %", [](Trial trial) {
    trial.conditions.body.torque_factor = 0.75;
    return Trials{trial};
  }));
  table.push_back(condition_row(frame, "dead_cell", "one force cell dead", [](const Trial& plain) {
    Trials trials;
    for (const urdf::Side side : urdf::kSides) {
      trials.push_back(plain);
      trials.back().conditions.body.dead_cell = simulator::DeadCell{side, plain.seed % 4};
    }
    return trials;
  }));
  table.push_back(condition_row(frame, "corruption", "2 % frames corrupted", [](Trial trial) {
    trial.corrupted_share = 0.02;
    return Trials{trial};
  }));
}

void add_fall_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  GaitRow& told = table.emplace_back(level_row("fall_recognised", "fall recognised before impact", "s", 0.2,
                                               0.3, {0.05, 0.10, 0.15, 0.20, 0.25, 0.30, 0.35, 0.40}));
  told.trials = [frame](std::uint64_t seed, double) { return falls(frame, seed); };
  told.passes = is_told;

  GaitRow& alarms = table.emplace_back(level_row(
      "false_alarms", "hard walking without false alarm of a fall, each seed (20 seeds x 3 min: 1 h)", "min",
      3.0, 3.0, {1.0, 2.0, 3.0}));
  if (frame.quick) {
    alarms.floor = alarms.aim = 1.0;
    alarms.levels = {1.0};
  }
  alarms.trials = [frame](std::uint64_t seed, double level) { return hard_walking(frame, seed, level); };
  alarms.passes = is_no_false_alarm;
}

void add_rise_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  const auto rises = [&](const std::string& motion, const char* from, double direction_rad) {
    GaitRow& row = table.emplace_back(
        named_row(motion, fmt::format("gets up from the {} within {:.0f} s", from, kRise_s), "% of the seeds",
                  0.9, 1.0));
    row.shown_scale = 100.0;
    row.trials = [=](std::uint64_t seed, double) {
      return Trials{get_up(frame, seed, direction_rad, motion)};
    };
    row.passes = has_risen;
  };
  rises("get_up_front", "front", 0.0);
  rises("get_up_back", "back", std::numbers::pi);
}

void add_figure_rows(std::vector<GaitRow>& table, const TrialFrame& frame) {
  GaitRow& zmp = table.emplace_back(
      figure_row("zmp", "ZMP estimate against the contact solver, walking, 3 % cell gain errors", "mm RMS",
                 0.003, 0.0015, 1000.0));
  const double walked_s = kStartUp_s + (frame.quick ? 5.0 : 20.0);
  zmp.trials = [frame, walked_s](std::uint64_t seed, double) {
    Trial trial = walk(frame, seed, {kSteadyWalk_m_per_s, 0.0, 0.0}, walked_s);
    trial.conditions.body.cell_gain_deviation = kCellGainDeviation;
    return Trials{trial};
  };
  zmp.figure = zmp_error_m;

  GaitRow& compute = table.emplace_back(
      figure_row("compute", "batch compute with everything on, p99", "us", 500.0, 200.0, 1.0));
  compute.runs_alone = true;
  compute.most_seeds = 5;
  compute.trials = [frame](std::uint64_t seed, double) {
    Trial trial = walk(frame, seed, {kSteadyWalk_m_per_s, 0.0, 0.0}, frame.quick ? 10.0 : 30.0);
    trial.times_compute = true;
    return Trials{trial};
  };
  compute.figure = batch_compute_us;
}

// Of the levels: the floor, the aim above it, and each second one below.
void thin_out(GaitRow& row) {
  std::vector<double> kept;
  const auto floor = std::ranges::find(row.levels, row.floor);
  for (auto level = row.levels.begin(); level != row.levels.end(); ++level) {
    if (level <= floor ? (floor - level) % 2 == 0 : *level == row.aim) {
      kept.push_back(*level);
    }
  }
  row.levels = std::move(kept);
}
}  // namespace

std::vector<GaitRow> gait_table(const GaitTableOptions& options) {
  const TrialFrame frame{.gait_cycle_s = 2.0 * options.step_time_s, .quick = options.quick};
  std::vector<GaitRow> table;
  add_walking_rows(table, frame);
  add_push_rows(table, frame);
  add_ground_rows(table, frame);
  add_condition_rows(table, frame);
  add_fall_rows(table, frame);
  add_rise_rows(table, frame);
  add_figure_rows(table, frame);
  if (options.quick) {
    std::ranges::for_each(table, thin_out);
  }
  return table;
}

double true_speed(const TrialOutcome& outcome, const Trial& trial) {
  return outcome.mean_velocity.dot(trial.commands.front().velocity.normalized());
}

std::vector<GaitRow> chosen_rows(std::vector<GaitRow> table, std::span<const std::string> names,
                                 std::span<const std::string> except) {
  std::vector<std::string> known;
  known.reserve(table.size());
  for (const GaitRow& row : table) {
    known.push_back(row.name);
  }
  const auto check = [&known](const char* option, std::span<const std::string> wanted) {
    for (const std::string& name : wanted) {
      if (std::ranges::find(known, name) == known.end()) {
        throw std::invalid_argument(
            fmt::format("{}: the table has no row '{}'. {}", option, name, input::suggest(name, known)));
      }
    }
  };
  check("--rows", names);
  check("--except", except);
  std::erase_if(table, [names, except](const GaitRow& row) {
    const bool named = names.empty() || std::ranges::find(names, row.name) != names.end();
    return !named || std::ranges::find(except, row.name) != except.end();
  });
  if (table.empty()) {
    throw std::invalid_argument("--except: leaves no row to measure. Leave out fewer");
  }
  return table;
}

double step_time_of(const core::Configuration& plugins) {
  for (const core::PluginEntry& plugin : plugins.plugins) {
    for (const core::ParameterEntry& parameter : plugin.parameters) {
      if (parameter.name == "step_time") {
        return std::stod(parameter.text);  // it was loaded with it: a number in seconds
      }
    }
  }
  return trajectory::GaitParameters{}.step_time_s;
}
}  // namespace gaitway::tools
