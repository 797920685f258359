// Deficit round robin, in time instead of bytes.
#include "fair_turns.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::api {

bool FairTurns::run() {
  const std::int64_t begin_ns = clock_();
  std::int64_t now_ns = begin_ns;
  while (!line_.empty() && now_ns - begin_ns < budget_.all_ns) {
    const std::shared_ptr<Worker> worker = std::move(line_.front());
    line_.pop_front();
    worker->credit_ns_ = std::min(worker->credit_ns_ + budget_.each_ns, budget_.each_ns);
    bool more = true;
    while (more && worker->credit_ns_ > 0 && now_ns - begin_ns < budget_.all_ns) {
      more = worker->work();
      const std::int64_t before_ns = std::exchange(now_ns, clock_());
      worker->credit_ns_ -= now_ns - before_ns;
    }
    if (more) {
      line_.push_back(worker);
    }
  }
  return !line_.empty();
}

}  // namespace gaitway::api
