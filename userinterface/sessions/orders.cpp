// Who waits for which order, and until when.
#include "orders.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/api/authority.hpp"

namespace gaitway::api {

void Orders::require_room(std::uint64_t client) const {
  const auto count = std::ranges::count_if(
      waiting_, [client](const auto& order) { return order.second.client == client && order.second.counts; });
  if (static_cast<std::size_t>(count) >= kMostOfOneClient) {
    throw CommandDenied("this connection waits for " + std::to_string(count) +
                        " answers already: wait for one of them first");
  }
}

void Orders::wait(std::uint32_t number, std::uint64_t client, std::int64_t ends_ns, Finish finish,
                  bool counts) {
  waiting_.insert_or_assign(number, Waiting{client, ends_ns, std::move(finish), counts});
}

void Orders::step(std::int64_t now_ns) {
  // What is finished may give the next order, so it is taken out first.
  while (const auto result = take_result_()) {
    if (const auto order = waiting_.extract(result->number)) {
      order.mapped().finish(&*result);
    }
  }
  std::vector<Finish> late;
  std::erase_if(waiting_, [&](auto& order) {
    const bool over = now_ns >= order.second.ends_ns;
    if (over) {
      late.push_back(std::move(order.second.finish));
    }
    return over;
  });
  for (const Finish& finish : late) {
    finish(nullptr);
  }
}

void Orders::forget(std::uint64_t client) {
  std::erase_if(waiting_, [client](const auto& order) { return order.second.client == client; });
}

}  // namespace gaitway::api
