// A thread that waits for jobs.
#include "gaitway/navigation/planning_desk.hpp"

#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::navigation {

PlanningDesk::PlanningDesk(Where where) : where_(where) {
  if (where == Where::beside) {
    thread_ = std::jthread([this](const std::stop_token& stop) { work(stop); });
  }
}

PlanningDesk::~PlanningDesk() = default;

void PlanningDesk::submit(std::function<planning::Plan()> job, std::int64_t now_ns) {
  waits_ = true;
  submitted_ns_ = now_ns;
  ++submitted_;
  if (where_ == Where::in_step) {
    done_ = job();
    done_number_ = submitted_;
    return;
  }
  {
    const std::scoped_lock lock(mutex_);
    job_ = std::move(job);
    job_number_ = submitted_;
    done_.reset();
  }
  wake_.notify_one();
}

std::optional<planning::Plan> PlanningDesk::take(std::int64_t now_ns) {
  if (!waits_ || (where_ == Where::in_step && now_ns - submitted_ns_ < facts::kCycle_ns)) return std::nullopt;
  const std::scoped_lock lock(mutex_);
  if (!done_ || done_number_ != submitted_) return std::nullopt;
  waits_ = false;
  return std::exchange(done_, std::nullopt);
}

void PlanningDesk::work(const std::stop_token& stop) {
  std::unique_lock lock(mutex_);
  while (wake_.wait(lock, stop, [this] { return job_ != nullptr; })) {
    const std::function<planning::Plan()> job = std::exchange(job_, nullptr);
    const std::uint64_t number = job_number_;
    lock.unlock();
    planning::Plan plan = job();
    lock.lock();
    done_ = std::move(plan);
    done_number_ = number;
  }
}

}  // namespace gaitway::navigation
