// Whose turn it is to be worked for: a budget of time for each and for all together.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>

namespace gaitway::api {

// A piece of work is never cut short. Whose piece takes longer than his budget pays for it by turns in which
// others are worked for; while nobody else waits, he pays nothing.
class FairTurns {
 public:
  class Worker {
   public:
    virtual ~Worker() = default;
    // Does one piece; whether more waits.
    virtual bool work() = 0;

   private:
    friend class FairTurns;
    std::int64_t credit_ns_ = 0;
  };
  // Monotonic.
  using Clock = std::int64_t (*)() noexcept;
  struct Budget {
    std::int64_t each_ns = 0;  // more than 0
    std::int64_t all_ns = 0;   // of one run()
  };

  FairTurns(Budget budget, Clock clock) noexcept : budget_(budget), clock_(clock) {}

  // Joins the line; not who stands in it already.
  void add(std::shared_ptr<Worker> worker) { line_.push_back(std::move(worker)); }
  // Works until nothing waits or the budget of all is spent; whether more waits.
  bool run();

 private:
  Budget budget_;
  Clock clock_;
  std::deque<std::shared_ptr<Worker>> line_;
};

}  // namespace gaitway::api
