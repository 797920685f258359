// Values are published only when the whole of their channel's value makes sense.
#include "gaitway/api/state_mirror.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <string_view>

#include "gaitway/contract/event_list.hpp"

namespace gaitway::api {
namespace {

constexpr std::uint32_t kEventCapacity = 64;

Event lost_events(std::uint64_t count) {
  Event event{};
  constexpr std::string_view kSource = "link";
  const std::string text = fmt::format("{} events were lost on the way to the user interface module", count);
  std::copy(kSource.begin(), kSource.end(), event.source);
  std::copy_n(text.begin(), std::min(text.size(), sizeof event.text - 1), event.text);
  return event;
}

}  // namespace

StateMirror::StateMirror(const contract::TopicCodec& codec)
    : codec_(codec),
      client_(block_.local_client("link")),
      events_(client_.write_stream<Event>("events", kEventCapacity)) {
  for (const contract::ChannelRow& row : contract::kChannels) {
    std::vector<Topic>& topics = channels_.emplace_back();
    for (const contract::MirroredTopic& topic : row.topics) {
      topics.push_back({.type = topic.type,
                        .writer = client_.write_untyped(contract::descriptor_of(topic)),
                        .value = std::vector<std::uint64_t>(topic.type->size / sizeof(std::uint64_t))});
    }
  }
}

void StateMirror::take(link::StateReceiver& state) {
  while (const auto channel = state.next_changed()) {
    const link::StateValue& value = state.value(*channel);
    const bool sound =
        *channel == contract::kEventChannel ? take_events(value.bytes) : take_channel(*channel, value);
    newest_ns_ = std::max(newest_ns_, value.stamp_ns);
    broken_ += sound ? 0U : 1U;
  }
}

void StateMirror::beat(std::int64_t robot_ns) noexcept {
  constexpr std::int64_t kMostAhead_ns = facts::kSecond_ns;
  if (newest_ns_ > robot_ns + kMostAhead_ns) {
    newest_ns_ = robot_ns;
  }
  block_.beat(std::max(robot_ns, newest_ns_));
}

bool StateMirror::take_channel(std::size_t number, const link::StateValue& value) {
  std::vector<Topic>& topics = channels_[number];
  if (value.bytes.empty()) {
    return false;
  }
  link::Bytes rest = value.bytes.subspan(1);
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if ((value.bytes[0] & contract::topic_bit(i)) == 0) {
      continue;
    }
    const std::size_t read = codec_.decode(*topics[i].type, rest, topics[i].value.data());
    if (read == 0) {
      return false;
    }
    rest = rest.subspan(read);
  }
  for (std::size_t i = 0; i < topics.size(); ++i) {
    if ((value.bytes[0] & contract::topic_bit(i)) != 0) {
      topics[i].writer.publish(topics[i].value.data(), value.stamp_ns);
    }
  }
  return rest.empty();
}

bool StateMirror::take_events(link::Bytes bytes) {
  const auto list = contract::EventList::decode(codec_, bytes);
  if (!list) {
    return false;
  }
  if (list->last() < last_event_) {
    last_event_ = list->first() - 1;  // the plug-in was started anew, and counts from 1
  }
  if (last_event_ != 0 && list->first() > last_event_ + 1) {
    events_.publish(lost_events(list->first() - last_event_ - 1), 0);
  }
  for (std::uint64_t number = std::max(list->first(), last_event_ + 1); number <= list->last(); ++number) {
    events_.publish(list->event(number), list->event(number).stamp_ns);
  }
  last_event_ = list->last();
  return true;
}

}  // namespace gaitway::api
