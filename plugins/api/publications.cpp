#include "publications.hpp"

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

void Publications::add(Topic topic, Subscriber& subscriber) {
  auto& subscribers = subscribers_[index(topic)];
  if (std::find(subscribers.begin(), subscribers.end(), &subscriber) == subscribers.end()) {
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
