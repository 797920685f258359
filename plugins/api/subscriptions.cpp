#include "subscriptions.hpp"

#include <algorithm>

namespace gaitway::api {

bool Subscriptions::has(Topic topic, const std::string& id) const {
  return topics_[static_cast<std::size_t>(topic)].contains(id);
}

void Subscriptions::set(Topic topic, const std::string& id, const Terms& terms) {
  const bool is_new = topics_[static_cast<std::size_t>(topic)].insert_or_assign(id, terms).second;
  count_ += is_new ? 1 : 0;
}

bool Subscriptions::remove(Topic topic, const std::string& id) {
  const std::size_t removed = topics_[static_cast<std::size_t>(topic)].erase(id);
  count_ -= removed;
  return removed > 0;
}

bool Subscriptions::remove_all(Topic topic) {
  auto& subscriptions = topics_[static_cast<std::size_t>(topic)];
  const bool any = !subscriptions.empty();
  count_ -= subscriptions.size();
  subscriptions.clear();
  return any;
}

std::optional<Terms> Subscriptions::together(Topic topic) const {
  std::optional<Terms> all;
  for (const auto& [id, terms] : topics_[static_cast<std::size_t>(topic)]) {
    if (!all) {
      all = terms;
      continue;
    }
    all->throttle_ns = std::min(all->throttle_ns, terms.throttle_ns);
    all->queue_length = std::max(all->queue_length, terms.queue_length);
    if (all->fragment_bytes == 0 ||
        (terms.fragment_bytes > 0 && terms.fragment_bytes < all->fragment_bytes)) {
      all->fragment_bytes = terms.fragment_bytes;
    }
    all->encoding = std::max(all->encoding, terms.encoding);
  }
  return all;
}

}  // namespace gaitway::api
