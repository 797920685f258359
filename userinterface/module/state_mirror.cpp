// Values are published only when the whole of their channel's value makes sense.
#include "gaitway/api/state_mirror.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>
#include <string>

namespace gaitway::api {
namespace {

constexpr std::uint32_t kEventCapacity = 64;

msgclient::TopicDescriptor descriptor_of(const contract::MirroredTopic& topic) {
  msgclient::TopicDescriptor descriptor;
  descriptor.name = std::string(topic.name);
  descriptor.type_name = std::string(topic.type->name);
  descriptor.type_hash = topic.type->hash;
  descriptor.size = topic.type->size;
  return descriptor;
}

// As in topic_codec.hpp; nothing: it is none.
std::optional<std::uint64_t> take_number(link::Bytes& bytes) noexcept {
  std::uint64_t value = 0;
  for (unsigned shift = 0; shift < 63 && !bytes.empty(); shift += 7) {
    const std::uint8_t next = bytes.front();
    bytes = bytes.subspan(1);
    value |= std::uint64_t{next & 0x7FU} << shift;
    if (next < 0x80) {
      return value;
    }
  }
  return std::nullopt;
}

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
                        .writer = client_.write_untyped(descriptor_of(topic)),
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
  const auto first = take_number(bytes);
  const auto count = take_number(bytes);
  if (!first || !count || *first == 0 || *count == 0 || *count > contract::kKeptEvents) {
    return false;
  }
  const std::uint64_t last = *first + *count - 1;
  if (last < last_event_) {
    last_event_ = *first - 1;  // the plug-in was started anew, and counts from 1
  }
  if (last_event_ != 0 && *first > last_event_ + 1) {
    events_.publish(lost_events(*first - last_event_ - 1), 0);
  }
  for (std::uint64_t number = *first; number <= last; ++number) {
    Event event;
    const std::size_t read = codec_.decode(TopicType<Event>::descriptor, bytes, &event);
    if (read == 0) {
      return false;
    }
    bytes = bytes.subspan(read);
    if (number > last_event_) {
      event.source[sizeof event.source - 1] = event.text[sizeof event.text - 1] = 0;
      events_.publish(event, event.stamp_ns);
      last_event_ = number;
    }
  }
  return bytes.empty();
}

}  // namespace gaitway::api
