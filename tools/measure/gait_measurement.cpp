// A pool of processes plays the trials; each row's search says which level comes next. The unit of work is
// one seed at one level: its trials run one after the other and end with the first failure.
#include "tools/measure/gait_measurement.hpp"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <deque>
#include <list>
#include <map>
#include <memory>
#include <nlohmann/json.hpp>
#include <span>
#include <system_error>
#include <utility>

#include "gaitway/process/working_copy.hpp"
#include "tools/measure/level_search.hpp"
#include "tools/measure/trial_run.hpp"

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
  RowRun* row = nullptr;
  std::size_t level = 0;
  int seed_index = 0;
  std::vector<Trial> trials;
};

double seconds_of(std::span<const Trial> trials) {
  double sum_s = 0.0;
  for (const Trial& trial : trials) {
    sum_s += trial.seconds;
  }
  return sum_s;
}

// A unit whose trials run in a copy of the process.
struct Worker {
  Unit unit;
  std::vector<Trial> trials;  // of the unit, that are not known
  std::size_t told = 0;       // outcomes of them
  process::WorkingCopy copy;
};

class Pool {
 public:
  Pool(const TrialRobot& robot, TrialStore& store, const GaitMeasurementOptions& options)
      : robot_(robot), store_(store), options_(options) {}

  // Returns when all searches of the rows are over.
  void measure(const std::vector<RowRun*>& rows, int jobs);
  void count(GaitMeasurement& measurement) const {
    measurement.trials_run = trials_run_;
    measurement.trials_known = trials_known_;
  }

 private:
  void plan_next_level(RowRun& row);
  void start_next();
  [[nodiscard]] std::vector<Trial> unknown_trials(const Unit& unit) const;
  void listen_to_workers();
  void listen_to(Worker& worker);
  void finish(const Worker& worker);
  void give_up(const RowRun& row, std::size_t level);
  void skip_rest(const Worker& worker);
  // The seed's result if all of it that counts is in the store.
  [[nodiscard]] std::optional<SeedResult> known_result(const Unit& unit) const;
  static void add(const Unit& unit, const Trial& trial, const TrialOutcome& outcome, SeedResult& result);
  // The unit's other trials change nothing.
  [[nodiscard]] static bool ends(const Unit& unit, const Trial& trial, const TrialOutcome& outcome);
  static void note(LevelRun& run, const Unit& unit, SeedResult result);
  static void close(RowRun& row, LevelRun& run);
  [[nodiscard]] std::uint64_t seed_of(int index) const {
    return options_.first_seed + static_cast<std::uint64_t>(index);
  }
  void note_progress(const Unit& unit, std::size_t trials, double seconds);

  const TrialRobot& robot_;
  TrialStore& store_;
  const GaitMeasurementOptions& options_;

  std::deque<Unit> waiting_;
  std::list<Worker> workers_;
  std::uint64_t trials_run_ = 0, trials_known_ = 0, trials_done_ = 0, trials_planned_ = 0;
  double planned_s_ = 0.0, done_s_ = 0.0;  // virtual time
  double played_s_ = 0.0;                  // virtual time, of trials that really ran
  Clock::time_point started_ = Clock::now();
};

void Pool::measure(const std::vector<RowRun*>& rows, int jobs) {
  for (RowRun* const row : rows) {
    plan_next_level(*row);
  }
  while (!waiting_.empty() || !workers_.empty()) {
    while (!waiting_.empty() && workers_.size() < static_cast<std::size_t>(jobs)) {
      start_next();
    }
    listen_to_workers();
  }
}

// What the store knows is judged here, in the seeds' order: so nothing runs again that an earlier measurement
// gave up.
void Pool::plan_next_level(RowRun& row) {
  while (const std::optional<std::size_t> level = row.search.next()) {
    LevelRun& run = row.levels.try_emplace(*level, row.seeds, *level == row.search.floor()).first->second;
    std::vector<Unit> unknown;
    for (int i = 0; i < row.seeds && !run.tally.decided(); ++i) {
      Unit unit{&row, *level, i, row.row.trials(seed_of(i), row.search.levels()[*level])};
      if (auto result = known_result(unit)) {
        trials_known_ += result->trials.size();
        note(run, unit, std::move(*result));
      } else {
        unknown.push_back(std::move(unit));
      }
    }
    if (run.tally.decided()) {
      close(row, run);
      continue;
    }
    for (Unit& unit : unknown) {
      trials_planned_ += unit.trials.size();
      planned_s_ += seconds_of(unit.trials);
      waiting_.push_back(std::move(unit));
    }
    return;
  }
}

std::optional<SeedResult> Pool::known_result(const Unit& unit) const {
  SeedResult result;
  result.seed = seed_of(unit.seed_index);
  for (const Trial& trial : unit.trials) {
    const auto outcome = store_.find(trial);
    if (!outcome) {
      return std::nullopt;
    }
    add(unit, trial, *outcome, result);
    if (ends(unit, trial, *outcome)) {
      break;
    }
  }
  return result;
}

std::vector<Trial> Pool::unknown_trials(const Unit& unit) const {
  std::vector<Trial> unknown;
  for (const Trial& trial : unit.trials) {
    const auto outcome = store_.find(trial);
    if (!outcome) {
      unknown.push_back(trial);
    } else if (ends(unit, trial, *outcome)) {
      break;
    }
  }
  return unknown;
}

void Pool::add(const Unit& unit, const Trial& trial, const TrialOutcome& outcome, SeedResult& result) {
  const GaitRow& row = unit.row->row;
  if (row.has_figure()) {
    result.figure = std::max(result.figure, row.figure(outcome, trial));
    result.passed = result.figure <= row.floor;
  } else {
    result.passed = row.passes(outcome, trial, unit.row->search.levels()[unit.level]);
  }
  result.trials.push_back(trial);
  result.outcomes.push_back(outcome);
}

bool Pool::ends(const Unit& unit, const Trial& trial, const TrialOutcome& outcome) {
  const GaitRow& row = unit.row->row;
  return !row.has_figure() && !row.passes(outcome, trial, unit.row->search.levels()[unit.level]);
}

void Pool::note(LevelRun& run, const Unit& unit, SeedResult result) {
  run.tally.note(unit.seed_index, result.passed);
  run.results[static_cast<std::size_t>(unit.seed_index)] = std::move(result);
}

void Pool::close(RowRun& row, LevelRun& run) {
  row.search.judged(run.tally.holds());
}

void Pool::start_next() {
  Unit unit = std::move(waiting_.front());
  waiting_.pop_front();
  std::vector<Trial> trials = unknown_trials(unit);
  const auto play = [&](const process::WorkingCopy::Tell& tell) {
    store_.leave_file();
    run_trials(robot_, trials, [&](std::size_t trial, const TrialOutcome& outcome) {
      tell(to_json(outcome).dump());
      return !ends(unit, trials[trial], outcome);
    });
  };
  process::WorkingCopy copy(play);
  workers_.push_back({std::move(unit), std::move(trials), 0, std::move(copy)});
}

void Pool::listen_to_workers() {
  std::vector<pollfd> told;
  for (const Worker& worker : workers_) {
    told.push_back({worker.copy.descriptor(), POLLIN, 0});
  }
  while (poll(told.data(), told.size(), -1) < 0) {
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "cannot wait for trials");
    }
  }
  auto worker = workers_.begin();
  for (const pollfd& one : told) {
    if (one.revents != 0) {
      listen_to(*worker);
    }
    ++worker;
  }
  const auto next_done = [this] {
    return std::ranges::find_if(workers_, [](const Worker& one) { return one.copy.done(); });
  };
  for (auto done = next_done(); done != workers_.end(); done = next_done()) {
    std::list<Worker> finished;  // apart from those that its result makes vain
    finished.splice(finished.begin(), workers_, done);
    finish(finished.front());
  }
}

void Pool::listen_to(Worker& worker) {
  for (const std::string& line : worker.copy.listen()) {
    const Trial& trial = worker.trials.at(worker.told++);
    store_.keep(trial, outcome_from_json(nlohmann::ordered_json::parse(line)));
    ++trials_run_;
    played_s_ += trial.seconds;
    note_progress(worker.unit, 1, trial.seconds);
  }
}

void Pool::finish(const Worker& worker) {
  const Unit& unit = worker.unit;
  SeedResult result = known_result(unit).value();
  trials_known_ += result.trials.size() - worker.told;
  skip_rest(worker);
  LevelRun& run = unit.row->levels.at(unit.level);
  note(run, unit, std::move(result));
  if (run.tally.decided()) {
    close(*unit.row, run);
    give_up(*unit.row, unit.level);
    plan_next_level(*unit.row);
  }
}

// What is still to do for a level that is decided.
void Pool::give_up(const RowRun& row, std::size_t level) {
  const auto in_vain = [&](const Unit& unit) { return unit.row == &row && unit.level == level; };
  std::erase_if(workers_, [&](const Worker& worker) {
    if (in_vain(worker.unit)) {
      skip_rest(worker);
    }
    return in_vain(worker.unit);
  });
  std::erase_if(waiting_, [&](const Unit& unit) {
    if (in_vain(unit)) {
      note_progress(unit, unit.trials.size(), seconds_of(unit.trials));
    }
    return in_vain(unit);
  });
}

void Pool::skip_rest(const Worker& worker) {
  const std::span<const Trial> told(worker.trials.data(), worker.told);
  note_progress(worker.unit, worker.unit.trials.size() - told.size(),
                seconds_of(worker.unit.trials) - seconds_of(told));
}

void Pool::note_progress(const Unit& unit, std::size_t trials, double seconds) {
  trials_done_ += trials;
  done_s_ += seconds;
  if (!options_.progress) {
    return;
  }
  GaitProgress progress{unit.row->row.name, trials_done_, trials_planned_, std::nullopt};
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
  Pool pool(robot, store, options);
  pool.measure(together, options.jobs);
  for (const auto& run : runs) {
    if (run->row.runs_alone) {
      pool.measure({run.get()}, 1);
    }
  }
  GaitMeasurement measurement;
  for (const auto& run : runs) {
    measurement.rows.push_back(result_of(*run));
  }
  pool.count(measurement);
  return measurement;
}

}  // namespace gaitway::tools
