// Trials in copies of this process, side by side.
#pragma once

#include <list>

#include "gaitway/process/working_copy.hpp"
#include "tools/measure/trial_place.hpp"
#include "tools/measure/trial_store.hpp"

namespace gaitway::tools {

// Used where there is a single thread. A copy plays one seed's trials, one after the other.
class TrialsHere final : public TrialPlace {
 public:
  // `store`: the copies leave its file. Both outlive this.
  TrialsHere(const TrialRobot& robot, TrialStore& store, int jobs);

  [[nodiscard]] bool has_room() const override { return runs_.size() < jobs_; }
  Ticket start(const SeedTrials& seed, std::vector<std::size_t> wanted) override;
  void give_up(Ticket ticket) override;
  std::vector<News> wait() override;
  [[nodiscard]] int workers() const override { return static_cast<int>(jobs_); }

 private:
  struct Run {
    Ticket ticket = 0;
    std::vector<std::size_t> wanted;
    std::size_t told = 0;  // of them
    process::WorkingCopy copy;
  };

  const TrialRobot& robot_;
  TrialStore& store_;
  std::size_t jobs_;
  std::list<Run> runs_;
  Ticket last_ticket_ = 0;
};

}  // namespace gaitway::tools
