// A message is encoded once for each form in which somebody wants it.
#include "subscriptions.hpp"

#include <algorithm>
#include <memory>
#include <utility>

namespace gaitway::api {
namespace {

std::size_t index(Topic topic) {
  return static_cast<std::size_t>(topic);
}
std::size_t index(Encoding encoding) {
  return static_cast<std::size_t>(encoding);
}

}  // namespace

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

std::optional<Terms> terms_together(const std::map<std::string, Terms>& by_id) {
  std::optional<Terms> all;
  for (const auto& [id, terms] : by_id) {
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

void Publications::add(Topic topic, Subscriber& subscriber) {
  auto& subscribers = subscribers_[index(topic)];
  if (std::ranges::find(subscribers, &subscriber) == subscribers.end()) {
    subscribers.push_back(&subscriber);
  }
}

void Publications::remove(Topic topic, const Subscriber& subscriber) {
  std::erase(subscribers_[index(topic)], &subscriber);
}

void Publications::publish(Topic topic, const Encode& encode) {
  Forms forms;
  const auto form = [&](Encoding encoding) -> const Frame& {
    Frame& frame = forms[index(encoding)];
    if (!frame.bytes) {
      auto bytes = std::make_shared<std::string>();
      encode(encoding, *bytes);
      frame = {std::move(bytes), is_binary(encoding)};
    }
    return frame;
  };
  for (Subscriber* const subscriber : subscribers_[index(topic)]) {
    subscriber->offer(topic, form(subscriber->encoding(topic)));
  }
  if (row(topic).latched) {
    latched_[index(topic)] = {form(Encoding::json), form(Encoding::cbor), form(Encoding::cbor_raw)};
  }
}

bool Publications::wanted(Topic topic) const noexcept {
  return row(topic).latched || !subscribers_[index(topic)].empty();
}

std::optional<Frame> Publications::latched(Topic topic, Encoding encoding) const {
  const Frame& frame = latched_[index(topic)][index(encoding)];
  return frame.bytes ? std::optional(frame) : std::nullopt;
}

}  // namespace gaitway::api
