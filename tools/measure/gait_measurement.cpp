// Each row's search says which level comes next; what its seeds do there is played at a place for trials. The
// unit of work is one seed at one level: its trials count one after the other and end with the first failure.
#include "tools/measure/gait_measurement.hpp"

#include <algorithm>
#include <chrono>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "tools/measure/level_search.hpp"
#include "tools/measure/trials_elsewhere.hpp"
#include "tools/measure/trials_here.hpp"

namespace gaitway::tools {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<double> levels_of(const GaitRow& row) {
  return row.has_levels() ? row.levels : std::vector{row.floor};
}

std::size_t floor_of(const GaitRow& row) {
  const std::vector<double> levels = levels_of(row);
  return static_cast<std::size_t>(std::ranges::find(levels, row.floor) - levels.begin());
}

// One level of one row at work.
struct LevelRun {
  LevelRun(int seeds, bool is_floor) : tally(seeds, is_floor), results(static_cast<std::size_t>(seeds)) {}
  LevelTally tally;
  std::vector<SeedResult> results;
};

struct RowRun {
  RowRun(const GaitRow& what, int most_seeds)
      : row(what),
        seeds(row.most_seeds > 0 ? std::min(row.most_seeds, most_seeds) : most_seeds),
        search(levels_of(row), floor_of(row)) {}
  GaitRow row;
  int seeds;
  LevelSearch search;
  std::map<std::size_t, LevelRun> levels;  // by their index
};

struct Unit {
  RowRun* run = nullptr;
  std::size_t level = 0;
  int seed_index = 0;
  SeedTrials seed;
};

// A unit whose trials are played.
struct UnitRun {
  Unit unit;
  TrialPlace::Ticket ticket = 0;
  std::size_t told = 0;   // outcomes
  double told_s = 0.0;    // virtual time of theirs
  std::uint64_t ran = 0;  // of them; the others were known to somebody
};

class Searches {
 public:
  Searches(TrialStore& store, const GaitMeasurementOptions& options) : store_(store), options_(options) {}

  // Returns when all searches of the rows are over.
  void measure(const std::vector<RowRun*>& rows, TrialPlace& place);
  void count(GaitMeasurement& measurement) const {
    measurement.trials_run = trials_run_;
    measurement.trials_known = trials_known_;
  }

 private:
  void plan_next_level(RowRun& row);
  void start_next(TrialPlace& place);
  [[nodiscard]] std::vector<std::size_t> unknown_trials(const SeedTrials& seed) const;
  void take(const TrialPlace::News& news);
  void finish(const UnitRun& run, TrialPlace& place);
  void give_up(const RowRun& row, std::size_t level, TrialPlace& place);
  void skip_rest(const UnitRun& run);
  // The seed's result if all of it that counts is in the store.
  [[nodiscard]] std::optional<SeedResult> known_result(const SeedTrials& seed) const;
  static void add(const SeedTrials& seed, const Trial& trial, const TrialOutcome& outcome,
                  SeedResult& result);
  static void note(LevelRun& run, int seed_index, SeedResult result);
  static void close(RowRun& row, LevelRun& run);
  [[nodiscard]] std::uint64_t seed_of(int index) const {
    return options_.first_seed + static_cast<std::uint64_t>(index);
  }
  void note_progress(const Unit& unit, std::size_t trials, double seconds);
  void tell_progress(const TrialPlace& place);

  TrialStore& store_;
  const GaitMeasurementOptions& options_;

  std::deque<Unit> waiting_;
  std::list<UnitRun> running_;
  std::uint64_t trials_run_ = 0, trials_known_ = 0, trials_done_ = 0, trials_planned_ = 0;
  double planned_s_ = 0.0, done_s_ = 0.0;  // virtual time
  double played_s_ = 0.0;                  // virtual time, of trials that really ran
  std::string row_;                        // of the newest outcome
  Clock::time_point started_ = Clock::now();
};

void Searches::measure(const std::vector<RowRun*>& rows, TrialPlace& place) {
  for (RowRun* const row : rows) {
    plan_next_level(*row);
  }
  while (!waiting_.empty() || !running_.empty()) {
    while (!waiting_.empty() && place.has_room()) {
      start_next(place);
    }
    const std::vector<TrialPlace::News> all = place.wait();
    std::ranges::for_each(all, [this](const TrialPlace::News& news) { take(news); });
    for (const TrialPlace::News& news : all) {
      const auto run = std::ranges::find(running_, news.ticket, &UnitRun::ticket);
      if (!news.done || run == running_.end()) {
        continue;
      }
      std::list<UnitRun> finished;  // apart from those that its result makes vain
      finished.splice(finished.begin(), running_, run);
      finish(finished.front(), place);
    }
    tell_progress(place);
  }
}

// What the store knows is judged here, in the seeds' order: so nothing runs again that an earlier measurement
// gave up.
void Searches::plan_next_level(RowRun& row) {
  while (const std::optional<std::size_t> level = row.search.next()) {
    LevelRun& run = row.levels.try_emplace(*level, row.seeds, *level == row.search.floor()).first->second;
    std::vector<Unit> unknown;
    for (int i = 0; i < row.seeds && !run.tally.decided(); ++i) {
      Unit unit{&row, *level, i, {row.row, row.search.levels()[*level], seed_of(i)}};
      if (auto result = known_result(unit.seed)) {
        trials_known_ += result->trials.size();
        note(run, i, std::move(*result));
      } else {
        unknown.push_back(std::move(unit));
      }
    }
    if (run.tally.decided()) {
      close(row, run);
      continue;
    }
    for (Unit& unit : unknown) {
      trials_planned_ += unit.seed.trials.size();
      planned_s_ += seconds_of(unit.seed.trials);
      waiting_.push_back(std::move(unit));
    }
    return;
  }
}

std::optional<SeedResult> Searches::known_result(const SeedTrials& seed) const {
  SeedResult result;
  result.seed = seed.seed;
  for (const Trial& trial : seed.trials) {
    const auto outcome = store_.find(trial);
    if (!outcome) {
      return std::nullopt;
    }
    add(seed, trial, *outcome, result);
    if (seed.end_with(trial, *outcome)) {
      break;
    }
  }
  return result;
}

std::vector<std::size_t> Searches::unknown_trials(const SeedTrials& seed) const {
  std::vector<std::size_t> unknown;
  for (std::size_t i = 0; i < seed.trials.size(); ++i) {
    const auto outcome = store_.find(seed.trials[i]);
    if (!outcome) {
      unknown.push_back(i);
    } else if (seed.end_with(seed.trials[i], *outcome)) {
      break;
    }
  }
  return unknown;
}

void Searches::add(const SeedTrials& seed, const Trial& trial, const TrialOutcome& outcome,
                   SeedResult& result) {
  const GaitRow& row = *seed.row;
  if (row.has_figure()) {
    result.figure = std::max(result.figure, row.figure(outcome, trial));
    result.passed = result.figure <= row.floor;
  } else {
    result.passed = row.passes(outcome, trial, seed.level);
  }
  result.trials.push_back(trial);
  result.outcomes.push_back(outcome);
}

void Searches::note(LevelRun& run, int seed_index, SeedResult result) {
  run.tally.note(seed_index, result.passed);
  run.results[static_cast<std::size_t>(seed_index)] = std::move(result);
}

void Searches::close(RowRun& row, LevelRun& run) {
  row.search.judged(run.tally.holds());
}

void Searches::start_next(TrialPlace& place) {
  running_.push_back({.unit = std::move(waiting_.front())});
  waiting_.pop_front();
  UnitRun& run = running_.back();
  run.ticket = place.start(run.unit.seed, unknown_trials(run.unit.seed));
}

void Searches::take(const TrialPlace::News& news) {
  const auto run = std::ranges::find(running_, news.ticket, &UnitRun::ticket);
  if (run == running_.end()) {
    return;  // it was given up meanwhile
  }
  for (const TrialPlace::Played& played : news.played) {
    const Trial& trial = run->unit.seed.trials[played.trial];
    store_.keep(trial, played.outcome);
    ++run->told;
    run->told_s += trial.seconds;
    if (news.ran) {
      ++run->ran;
      ++trials_run_;
      played_s_ += trial.seconds;
    }
    note_progress(run->unit, 1, trial.seconds);
  }
}

void Searches::finish(const UnitRun& run, TrialPlace& place) {
  const Unit& unit = run.unit;
  SeedResult result = known_result(unit.seed).value();
  trials_known_ += std::max(result.trials.size(), run.told) - run.ran;
  skip_rest(run);
  LevelRun& level = unit.run->levels.at(unit.level);
  note(level, unit.seed_index, std::move(result));
  if (level.tally.decided()) {
    close(*unit.run, level);
    give_up(*unit.run, unit.level, place);
    plan_next_level(*unit.run);
  }
}

// What is still to do for a level that is decided.
void Searches::give_up(const RowRun& row, std::size_t level, TrialPlace& place) {
  const auto in_vain = [&](const Unit& unit) { return unit.run == &row && unit.level == level; };
  std::erase_if(running_, [&](const UnitRun& run) {
    if (in_vain(run.unit)) {
      place.give_up(run.ticket);
      skip_rest(run);
    }
    return in_vain(run.unit);
  });
  std::erase_if(waiting_, [&](const Unit& unit) {
    if (in_vain(unit)) {
      note_progress(unit, unit.seed.trials.size(), seconds_of(unit.seed.trials));
    }
    return in_vain(unit);
  });
}

void Searches::skip_rest(const UnitRun& run) {
  note_progress(run.unit, run.unit.seed.trials.size() - run.told,
                seconds_of(run.unit.seed.trials) - run.told_s);
}

void Searches::note_progress(const Unit& unit, std::size_t trials, double seconds) {
  trials_done_ += trials;
  done_s_ += seconds;
  row_ = unit.run->row.name;
}

void Searches::tell_progress(const TrialPlace& place) {
  if (!options_.progress) {
    return;
  }
  GaitProgress progress{row_, trials_done_, trials_planned_, std::nullopt, place.workers()};
  if (played_s_ > 0.0) {
    const double wall_s = std::chrono::duration<double>(Clock::now() - started_).count();
    progress.remaining_s = std::max(0.0, planned_s_ - done_s_) * wall_s / played_s_;
  }
  options_.progress(progress);
}

// The figure that all but the allowed failures keep.
double kept_figure(const std::vector<SeedResult>& seeds) {
  std::vector<double> figures;
  figures.reserve(seeds.size());
  for (const SeedResult& seed : seeds) {
    figures.push_back(seed.figure);
  }
  std::ranges::sort(figures);
  return figures.at(figures.size() - 1 -
                    static_cast<std::size_t>(allowed_failures(static_cast<int>(seeds.size()))));
}

RowResult result_of(RowRun& run) {
  RowResult result;
  result.row = run.row;
  result.seeds = run.seeds;
  for (auto& [index, level] : run.levels) {
    level.results.resize(static_cast<std::size_t>(level.tally.judged()));
    result.levels.push_back({.level = run.search.levels()[index],
                             .holds = level.tally.holds(),
                             .passed = level.tally.passed(),
                             .seeds = std::move(level.results)});
    if (index == run.search.floor()) {
      result.floor_passed = level.tally.passed();
    }
  }
  if (run.row.has_levels()) {
    result.limit = run.search.limit();
    result.open_ended = run.search.open_ended();
  } else if (run.row.has_figure()) {
    result.limit = kept_figure(result.levels.front().seeds);
  } else {
    result.limit = static_cast<double>(result.floor_passed) / result.seeds;
  }
  return result;
}

}  // namespace

GaitMeasurement measure_gait(const TrialRobot& robot, const std::vector<GaitRow>& rows, TrialStore& store,
                             const GaitMeasurementOptions& options) {
  std::vector<std::unique_ptr<RowRun>> runs;
  std::vector<RowRun*> together;
  for (const GaitRow& row : rows) {
    runs.push_back(std::make_unique<RowRun>(row, options.seeds));
    if (!row.runs_alone) {
      together.push_back(runs.back().get());
    }
  }
  Searches searches(store, options);
  if (options.elsewhere != nullptr) {
    searches.measure(together, *options.elsewhere);
    options.elsewhere->finish();
  } else {
    TrialsHere here(robot, store, options.jobs);
    searches.measure(together, here);
  }
  TrialsHere alone(robot, store, 1);
  for (const auto& run : runs) {
    if (run->row.runs_alone) {
      searches.measure({run.get()}, alone);
    }
  }
  GaitMeasurement measurement;
  for (const auto& run : runs) {
    measurement.rows.push_back(result_of(*run));
  }
  searches.count(measurement);
  return measurement;
}

}  // namespace gaitway::tools
