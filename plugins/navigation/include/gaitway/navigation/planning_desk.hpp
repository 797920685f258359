// Where plans are made: in the step that asks for one, or beside the steps in a thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <stop_token>
#include <thread>

#include "gaitway/planning/planner.hpp"

namespace gaitway::navigation {

// One plan at a time.
class PlanningDesk {
 public:
  enum class Where : std::uint8_t {
    in_step,  // at once, and handed out one cycle later: the same in each run, whatever the computer
    beside    // handed out when it is there
  };
  explicit PlanningDesk(Where where);
  ~PlanningDesk();
  PlanningDesk(const PlanningDesk&) = delete;
  PlanningDesk& operator=(const PlanningDesk&) = delete;

  // The plan of a job before, if it has not been taken, is never handed out.
  void submit(std::function<planning::Plan()> job, std::int64_t now_ns);
  // The plan of the last job, once.
  [[nodiscard]] std::optional<planning::Plan> take(std::int64_t now_ns);
  [[nodiscard]] bool waits() const noexcept { return waits_; }
  // Nobody wants the plan any more.
  void forget() noexcept { waits_ = false; }

 private:
  void work(const std::stop_token& stop);

  Where where_;
  bool waits_ = false;  // a plan is still to be taken
  std::int64_t submitted_ns_ = 0;
  std::uint64_t submitted_ = 0;

  std::mutex mutex_;  // of what follows; held for moments
  std::condition_variable_any wake_;
  std::function<planning::Plan()> job_;
  std::uint64_t job_number_ = 0, done_number_ = 0;
  std::optional<planning::Plan> done_;
  std::jthread thread_;  // the last one: it uses all of these
};

}  // namespace gaitway::navigation
