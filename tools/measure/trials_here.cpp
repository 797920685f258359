// Copies the process for each seed, and listens to the copies.
#include "tools/measure/trials_here.hpp"

#include <poll.h>

#include <cerrno>
#include <nlohmann/json.hpp>
#include <system_error>
#include <utility>

#include "tools/measure/trial_run.hpp"

namespace gaitway::tools {

TrialsHere::TrialsHere(const TrialRobot& robot, TrialStore& store, int jobs)
    : robot_(robot), store_(store), jobs_(static_cast<std::size_t>(jobs)) {}

TrialPlace::Ticket TrialsHere::start(const SeedTrials& seed, std::vector<std::size_t> wanted) {
  std::vector<Trial> trials;
  trials.reserve(wanted.size());
  for (const std::size_t trial : wanted) {
    trials.push_back(seed.trials[trial]);
  }
  process::WorkingCopy copy([&](const process::WorkingCopy::Tell& tell) {
    store_.leave_file();
    run_trials(robot_, trials, [&](std::size_t trial, const TrialOutcome& outcome) {
      tell(to_json(outcome).dump());
      return !seed.end_with(trials[trial], outcome);
    });
  });
  runs_.push_back({++last_ticket_, std::move(wanted), 0, std::move(copy)});
  return last_ticket_;
}

void TrialsHere::give_up(Ticket ticket) {
  std::erase_if(runs_, [ticket](const Run& run) { return run.ticket == ticket; });
}

std::vector<TrialPlace::News> TrialsHere::wait() {
  std::vector<pollfd> told;
  for (const Run& run : runs_) {
    told.push_back({run.copy.descriptor(), POLLIN, 0});
  }
  while (poll(told.data(), told.size(), -1) < 0) {
    if (errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "cannot wait for trials");
    }
  }
  std::vector<News> all;
  auto run = runs_.begin();
  for (const pollfd& one : told) {
    if (one.revents != 0) {
      News news{.ticket = run->ticket, .played = {}};
      for (const std::string& line : run->copy.listen()) {
        news.played.push_back(
            {run->wanted.at(run->told++), outcome_from_json(nlohmann::ordered_json::parse(line))});
      }
      news.done = run->copy.done();
      all.push_back(std::move(news));
    }
    ++run;
  }
  std::erase_if(runs_, [](const Run& one) { return one.copy.done(); });
  return all;
}

}  // namespace gaitway::tools
