// A pool of processes: each plays trials of one robot, which share its walk.
#include "tools/campaign/campaign.hpp"

#include <poll.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <deque>
#include <list>
#include <map>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "gaitway/process/working_copy.hpp"
#include "tools/campaign/fault_run.hpp"

namespace gaitway::tools {
namespace {

using Clock = std::chrono::steady_clock;

// So many share a walk: it costs as much as one of them.
constexpr std::size_t kTrialsOfAWalk = 40;

struct WalkOfTrials {
  std::vector<FaultTrial> trials;  // in order of their instants
  std::size_t told = 0;            // outcomes
  std::optional<process::WorkingCopy> copy;
};

class CampaignPool {
 public:
  CampaignPool(const TrialRobot& robot, OutcomeStore& store, const CampaignOptions& options)
      : robot_(robot), store_(store), options_(options) {}

  // Returns when all of them are in the store.
  void play(std::vector<FaultTrial> unknown) {
    planned_ = unknown.size();
    plan(std::move(unknown));
    while (!waiting_.empty() || !at_work_.empty()) {
      while (!waiting_.empty() && at_work_.size() < static_cast<std::size_t>(options_.jobs)) start_next();
      listen_to_all();
    }
  }

 private:
  void plan(std::vector<FaultTrial> unknown);
  void start_next();
  void listen_to_all();
  void note_progress() const;

  const TrialRobot& robot_;
  OutcomeStore& store_;
  const CampaignOptions& options_;
  std::deque<WalkOfTrials> waiting_;
  std::list<WalkOfTrials> at_work_;
  std::uint64_t planned_ = 0, done_ = 0;
  Clock::time_point started_ = Clock::now();
};

// Low numbers first, so that a campaign that is broken off knows something of each row.
void CampaignPool::plan(std::vector<FaultTrial> unknown) {
  std::ranges::stable_sort(unknown, {}, &FaultTrial::number);
  std::map<std::uint64_t, std::vector<FaultTrial>> open;  // by robot
  const auto close = [this](std::vector<FaultTrial>& trials) {
    std::ranges::stable_sort(trials, {}, &FaultTrial::instant_s);
    waiting_.push_back({std::exchange(trials, {}), 0, std::nullopt});
  };
  for (FaultTrial& trial : unknown) {
    std::vector<FaultTrial>& trials = open[trial.seed];
    trials.push_back(std::move(trial));
    if (trials.size() == kTrialsOfAWalk) close(trials);
  }
  for (auto& [seed, trials] : open) {
    if (!trials.empty()) close(trials);
  }
}

void CampaignPool::start_next() {
  at_work_.push_back(std::move(waiting_.front()));
  waiting_.pop_front();
  WalkOfTrials& walk = at_work_.back();
  walk.copy.emplace([&](const process::WorkingCopy::Tell& tell) {
    store_.leave_file();
    run_fault_trials(robot_, walk.trials,
                     [&](std::size_t, const FaultOutcome& outcome) { tell(to_json(outcome).dump()); });
  });
}

void CampaignPool::listen_to_all() {
  std::vector<pollfd> told;
  for (const WalkOfTrials& walk : at_work_) told.push_back({walk.copy->descriptor(), POLLIN, 0});
  while (poll(told.data(), told.size(), -1) < 0) {
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "cannot wait for trials");
    }
  }
  auto walk = at_work_.begin();
  for (const pollfd& one : told) {
    const auto here = walk++;
    if (one.revents == 0) continue;
    for (const std::string& line : here->copy->listen()) {
      store_.keep(describe(here->trials.at(here->told++)).dump(), nlohmann::ordered_json::parse(line));
      ++done_;
      note_progress();
    }
    if (here->copy->done()) at_work_.erase(here);
  }
}

void CampaignPool::note_progress() const {
  if (!options_.progress) return;
  const double wall_s = std::chrono::duration<double>(Clock::now() - started_).count();
  options_.progress(
      {done_, planned_, wall_s * static_cast<double>(planned_ - done_) / static_cast<double>(done_)});
}

}  // namespace

std::size_t CampaignRow::falls() const {
  return static_cast<std::size_t>(
      std::ranges::count_if(trials, [](const PlayedTrial& one) { return one.outcome.fell; }));
}

bool CampaignRow::holds() const {
  if (row.expected == FaultExpectation::survives) return falls() == 0;
  const auto is_known = [](const PlayedTrial& one) { return !one.outcome.fell || one.outcome.reacted(); };
  return row.expected != FaultExpectation::physics || !row.is_told || std::ranges::all_of(trials, is_known);
}

Campaign run_campaign(const TrialRobot& robot, const std::vector<FaultRow>& rows, OutcomeStore& store,
                      const CampaignOptions& options) {
  Campaign campaign;
  std::vector<FaultTrial> unknown;
  for (const FaultRow& row : rows) {
    campaign.rows.push_back({row, {}});
    for (std::uint64_t number = 0; number < options.instants; ++number) {
      FaultTrial trial = draw_trial(row, number, options.robots, options.speed_m_per_s);
      static_cast<void>(events_of(trial, robot.model));  // what is wrong with a row is said at once
      if (store.find(describe(trial).dump()) == nullptr) unknown.push_back(trial);
      campaign.rows.back().trials.push_back({std::move(trial), {}});
    }
  }
  campaign.run = unknown.size();
  campaign.known = rows.size() * options.instants - campaign.run;
  CampaignPool(robot, store, options).play(std::move(unknown));
  for (CampaignRow& row : campaign.rows) {
    for (PlayedTrial& one : row.trials) {
      one.outcome = fault_outcome_from_json(*store.find(describe(one.trial).dump()));
    }
  }
  return campaign;
}

}  // namespace gaitway::tools
