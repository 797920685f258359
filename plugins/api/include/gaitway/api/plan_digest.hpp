// From the motion plans to the topic `planned_state`: what is planned now, for those who look on.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>

#include "gaitway/api/planned_motion.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"

namespace gaitway::api {

// `moment`: at the instant, with its plan.
[[nodiscard]] PlannedState planned_state_of(const std::optional<PlannedMoment>& moment,
                                            std::int64_t instant_ns) noexcept;

// Publishes once a slot. Allocates in the constructor only.
class PlanDigest {
 public:
  // Opens the topics: throws msgclient::TopicError. `client` outlives it.
  explicit PlanDigest(msgclient::Client& client);

  // As often as each millisecond.
  void step(std::int64_t robot_ns) noexcept;

 private:
  msgclient::Reader<MotionPlan> plans_;
  msgclient::Reader<NetworkState> network_;
  msgclient::Writer<PlannedState> digests_;
  std::unique_ptr<MotionPlan> plan_;
  std::unique_ptr<PlannedMotion> motion_;
  std::uint64_t plan_seen_ = 0;
  std::int64_t edge_ns_ = -1;
};

}  // namespace gaitway::api
