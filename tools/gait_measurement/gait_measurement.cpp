// A pool of threads plays the trials; each row's search says which level comes next. The unit of work is one
// seed at one level: its trials run one after the other and end with the first failure.
#include "gaitway/tools/gait_measurement.hpp"

#include <algorithm>
#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <limits>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <thread>
#include <utility>

#include "gaitway/tools/level_search.hpp"

namespace gaitway::tools {
namespace {

using Clock = std::chrono::steady_clock;

std::vector<double> levels_of(const GaitRow& row) {
  return row.has_levels() ? row.levels : std::vector{row.floor};
}

std::size_t floor_of(const GaitRow& row) {
  const std::vector<double> levels = levels_of(row);
  return static_cast<std::size_t>(std::find(levels.begin(), levels.end(), row.floor) - levels.begin());
}

// One level of one row at work.
struct LevelRun {
  LevelRun(int seeds, bool is_floor) : tally(seeds, is_floor), results(static_cast<std::size_t>(seeds)) {}
  LevelTally tally;
  std::vector<SeedResult> results;
  bool closed = false;  // decided: what still runs for it is in vain
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

double seconds_of(const std::vector<Trial>& trials) {
  double sum_s = 0.0;
  for (const Trial& trial : trials) {
    sum_s += trial.seconds;
  }
  return sum_s;
}

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
  void work() noexcept;
  void play(const Unit& unit);
  // The seed's result if all of it that counts is in the store.
  [[nodiscard]] std::optional<SeedResult> known_result(const Unit& unit) const;
  static void add(const Unit& unit, const Trial& trial, const TrialOutcome& outcome, SeedResult& result);
  [[nodiscard]] static bool ends(const Unit& unit,
                                 const SeedResult& result);  // the other trials change nothing
  static void note(LevelRun& run, const Unit& unit, SeedResult result);
  static void close(RowRun& row, LevelRun& run);
  [[nodiscard]] std::uint64_t seed_of(int index) const {
    return options_.first_seed + static_cast<std::uint64_t>(index);
  }
  TrialOutcome outcome_of(const Trial& trial);
  [[nodiscard]] bool in_vain(const Unit& unit);
  void note_progress(const Unit& unit, std::size_t trials, double seconds);

  const TrialRobot& robot_;
  TrialStore& store_;
  const GaitMeasurementOptions& options_;

  std::mutex mutex_;  // guards all that follows
  std::condition_variable changed_;
  std::deque<Unit> waiting_;
  int working_ = 0;  // units that threads are at
  std::exception_ptr failure_;
  std::uint64_t trials_run_ = 0, trials_known_ = 0, trials_done_ = 0, trials_planned_ = 0;
  double planned_s_ = 0.0, done_s_ = 0.0;  // virtual time
  double played_s_ = 0.0;                  // virtual time, of trials that really ran
  Clock::time_point started_ = Clock::now();
};

void Pool::measure(const std::vector<RowRun*>& rows, int jobs) {
  {
    const std::lock_guard lock(mutex_);
    for (RowRun* const row : rows) {
      plan_next_level(*row);
    }
  }
  std::vector<std::jthread> threads;
  threads.reserve(static_cast<std::size_t>(jobs));
  for (int i = 0; i < jobs; ++i) {
    threads.emplace_back([this] { work(); });
  }
  threads.clear();  // joins
  if (failure_) {
    std::rethrow_exception(failure_);
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
    changed_.notify_all();
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
    if (ends(unit, result)) {
      break;
    }
  }
  return result;
}

void Pool::add(const Unit& unit, const Trial& trial, const TrialOutcome& outcome, SeedResult& result) {
  const GaitRow& row = unit.row->row;
  if (row.has_levels()) {
    result.passed = row.passes(outcome, trial, unit.row->search.levels()[unit.level]);
  } else {
    result.figure = std::max(result.figure, row.figure(outcome, trial));
    result.passed = result.figure <= row.floor;
  }
  result.trials.push_back(trial);
  result.outcomes.push_back(outcome);
}

bool Pool::ends(const Unit& unit, const SeedResult& result) {
  return unit.row->row.has_levels() && !result.passed;
}

void Pool::note(LevelRun& run, const Unit& unit, SeedResult result) {
  run.tally.note(unit.seed_index, result.passed);
  run.results[static_cast<std::size_t>(unit.seed_index)] = std::move(result);
}

void Pool::close(RowRun& row, LevelRun& run) {
  run.closed = true;
  row.search.judged(run.tally.holds());
}

void Pool::work() noexcept {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return !waiting_.empty() || working_ == 0 || failure_ != nullptr; });
    if (failure_ != nullptr || waiting_.empty()) {
      break;
    }
    const Unit unit = std::move(waiting_.front());
    waiting_.pop_front();
    ++working_;
    lock.unlock();
    try {
      play(unit);
      lock.lock();
    } catch (...) {
      lock.lock();
      failure_ = std::current_exception();
    }
    --working_;
    changed_.notify_all();
  }
}

bool Pool::in_vain(const Unit& unit) {
  const std::lock_guard lock(mutex_);
  return failure_ != nullptr || unit.row->levels.at(unit.level).closed;
}

TrialOutcome Pool::outcome_of(const Trial& trial) {
  if (const auto known = store_.find(trial)) {
    const std::lock_guard lock(mutex_);
    ++trials_known_;
    return *known;
  }
  const TrialOutcome outcome = run_trial(robot_, trial);
  store_.keep(trial, outcome);
  const std::lock_guard lock(mutex_);
  ++trials_run_;
  played_s_ += trial.seconds;
  return outcome;
}

void Pool::play(const Unit& unit) {
  SeedResult result;
  result.seed = seed_of(unit.seed_index);
  std::size_t left = unit.trials.size();
  double left_s = seconds_of(unit.trials);
  for (const Trial& trial : unit.trials) {
    if (in_vain(unit)) {
      break;
    }
    add(unit, trial, outcome_of(trial), result);
    --left;
    left_s -= trial.seconds;
    note_progress(unit, 1, trial.seconds);
    if (ends(unit, result)) {
      break;
    }
  }
  note_progress(unit, left, left_s);
  const std::lock_guard lock(mutex_);
  LevelRun& run = unit.row->levels.at(unit.level);
  if (run.closed || failure_ != nullptr) {
    return;
  }
  note(run, unit, std::move(result));
  if (run.tally.decided()) {
    close(*unit.row, run);
    plan_next_level(*unit.row);
  }
}

void Pool::note_progress(const Unit& unit, std::size_t trials, double seconds) {
  const std::lock_guard lock(mutex_);
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
  std::sort(figures.begin(), figures.end());
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
  } else {
    result.limit = kept_figure(result.levels.front().seeds);
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
