// What a simulation that runs shows of itself.
#pragma once

#include <nlohmann/json.hpp>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::timeline {

// Reads what it needs of the robot's own estimate.
class LiveState {
 public:
  // Throws msgclient::TopicError. `run` outlives it.
  explicit LiveState(simulator::Cosimulation& run);

  // Time, truth, and where the view's frame lies.
  [[nodiscard]] nlohmann::json describe();
  // Of at most kSolidsAtOnce from `first` on.
  [[nodiscard]] nlohmann::json geometry(std::size_t first) const;

 private:
  static constexpr std::size_t kSolidsAtOnce = 200;

  simulator::Cosimulation& run_;
  msgclient::Reader<Estimate> estimate_;
  Estimate newest_{};
};

}  // namespace gaitway::timeline
