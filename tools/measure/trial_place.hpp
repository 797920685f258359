// Where the measurement's trials are played: in copies of this process, or elsewhere.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "tools/measure/seed_trials.hpp"

namespace gaitway::tools {

class TrialPlace {
 public:
  using Ticket = std::uint64_t;  // of a seed whose trials are played

  struct Played {
    std::size_t trial = 0;  // of the seed's
    TrialOutcome outcome;
  };
  // Of one seed.
  struct News {
    Ticket ticket = 0;
    std::vector<Played> played;  // each trial once
    bool ran = true;             // or somebody knew their outcomes
    bool done = false;           // all that counts has been told, and the ticket is void
  };

  TrialPlace() = default;
  TrialPlace(const TrialPlace&) = delete;
  TrialPlace& operator=(const TrialPlace&) = delete;
  virtual ~TrialPlace() = default;

  // Whether another seed may be started now.
  [[nodiscard]] virtual bool has_room() const = 0;
  // `wanted`: those of its trials whose outcomes are not known, ascending, one at least. Trials behind the
  // first that decides are played or not. `seed` stays where it is until it is done or given up.
  virtual Ticket start(const SeedTrials& seed, std::vector<std::size_t> wanted) = 0;
  // Its trials are wanted no longer, and nothing more is told of it. The ticket may be void.
  virtual void give_up(Ticket ticket) = 0;
  // Waits until there is something to tell; it may be of no seed, where only the workers have changed. Throws
  // std::runtime_error when a trial cannot be played.
  virtual std::vector<News> wait() = 0;
  // Who plays trials now.
  [[nodiscard]] virtual int workers() const = 0;
};

}  // namespace gaitway::tools
