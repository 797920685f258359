#include "topic_share.hpp"

#include <numeric>

#include "resource_name.hpp"

namespace gaitway::api {

bool TopicShare::advertises(const std::string& name, const std::string& id) const {
  return advertisements_.contains({absolute_name(name), id});
}

bool TopicShare::advertises(const std::string& name) const {
  const std::string topic = absolute_name(name);
  const auto first = advertisements_.lower_bound({topic, ""});
  return first != advertisements_.end() && first->first == topic;
}

void TopicShare::advertise(const std::string& name, const std::string& type, const std::string& id,
                           bool latch) {
  const std::string topic = absolute_name(name);
  topics_.advertise(*this, topic, type, id, latch);
  advertisements_.emplace(topic, id);
}

bool TopicShare::unadvertise(const std::string& name, const std::optional<std::string>& id) {
  const std::string topic = absolute_name(name);
  std::erase_if(advertisements_,
                [&](const auto& one) { return one.first == topic && (!id || one.second == *id); });
  return topics_.unadvertise(*this, topic, id);
}

void TopicShare::publish(const std::string& name, const nlohmann::json& message, bool keep,
                         std::int64_t now_ns) {
  topics_.publish(*this, absolute_name(name), message, keep, now_ns);
}

bool TopicShare::subscribes(const std::string& name, const std::string& id) const {
  const auto found = subscriptions_.find(name);
  return found != subscriptions_.end() && found->second.terms.contains(id);
}

void TopicShare::subscribe(const std::string& name, const std::string& type, const std::string& id,
                           const Terms& terms, std::int64_t now_ns) {
  topics_.require_type(absolute_name(name), type);
  auto place = subscriptions_.find(name);
  if (place == subscriptions_.end()) {
    place = subscriptions_.emplace(name, Subscription{outbox_.free_lane(), {}}).first;
  }
  Subscription& subscription = place->second;
  subscription.terms.insert_or_assign(id, terms);
  const Terms together = *terms_together(subscription.terms);
  outbox_.open(subscription.lane, together);
  topics_.listen(absolute_name(name), type, {this, subscription.lane, name, together.encoding}, now_ns);
}

bool TopicShare::unsubscribe(const std::string& name, const std::optional<std::string>& id) {
  const auto found = subscriptions_.find(name);
  if (found == subscriptions_.end()) {
    return false;
  }
  Subscription& subscription = found->second;
  if (id && subscription.terms.erase(*id) == 0) {
    return false;
  }
  if (!id || subscription.terms.empty()) {
    topics_.stop_listening(*this, absolute_name(name), subscription.lane);
    outbox_.close(subscription.lane);
    subscriptions_.erase(found);
  } else {
    const Terms together = *terms_together(subscription.terms);
    outbox_.open(subscription.lane, together);
    topics_.change_encoding(*this, absolute_name(name), subscription.lane, together.encoding);
  }
  return true;
}

std::size_t TopicShare::subscriptions() const noexcept {
  return std::accumulate(
      subscriptions_.begin(), subscriptions_.end(), std::size_t{0},
      [](std::size_t sum, const auto& subscription) { return sum + subscription.second.terms.size(); });
}

void TopicShare::take_drops(const std::function<void(const std::string& name, std::uint64_t count)>& tell) {
  for (const auto& [name, subscription] : subscriptions_) {
    if (const std::uint64_t drops = outbox_.take_drops(subscription.lane); drops > 0) {
      tell(name, drops);
    }
  }
}

void TopicShare::leave() {
  while (!subscriptions_.empty()) {
    unsubscribe(std::string(subscriptions_.begin()->first), std::nullopt);
  }
  while (!advertisements_.empty()) {
    unadvertise(std::string(advertisements_.begin()->first), std::nullopt);
  }
}

void TopicShare::offer(LaneKey lane, const Frame& frame, std::int64_t now_ns) {
  outbox_.offer(lane, frame, now_ns);
  wake_();
}

}  // namespace gaitway::api
