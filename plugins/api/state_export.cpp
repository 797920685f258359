// Joints, estimate and plan of one slot go together, so they wait for each other.
#include "gaitway/api/state_export.hpp"

#include <algorithm>
#include <span>
#include <string>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::int64_t kNever = INT64_MIN / 2;

}  // namespace

StateExport::StateExport(msgclient::Client& client, const contract::TopicCodec& codec, bool narrow)
    : codec_(codec), events_(client.read_stream<Event>("events")) {
  for (const contract::ChannelRow& row : contract::kChannels) {
    Channel& channel = channels_.emplace_back();
    channel.period_ns = narrow ? row.narrow_period_ns : row.period_ns;
    channel.published_ns = channel.waits_since_ns = kNever;
    for (const contract::MirroredTopic& topic : row.topics) {
      channel.topics.push_back(
          {.type = topic.type,
           .reader = client.read_untyped(contract::descriptor_of(topic)),
           .value = std::vector<std::uint64_t>(topic.type->size / sizeof(std::uint64_t))});
    }
  }
  std::size_t most = 0;
  for (const link::Channel& channel : contract::link_channels(codec)) {
    most = std::max(most, channel.most_bytes);
  }
  buffer_.resize(most);
}

void StateExport::step(link::ControllerEnd& end, std::int64_t robot_ns) noexcept {
  for (std::size_t channel = 0; channel < channels_.size(); ++channel) {
    if (is_due(channels_[channel], robot_ns)) {
      publish(channel, end, robot_ns);
    }
  }
  export_events(end, robot_ns);
}

// A channel of several topics is published when its second one, which comes after the first, is new; or a
// while after the first without it.
bool StateExport::is_due(Channel& channel, std::int64_t robot_ns) noexcept {
  constexpr std::int64_t kPatience_ns = facts::kSlot_ns / 2;
  const auto is_new = [](const Topic& topic) { return topic.reader.newest_sequence() != topic.seen; };
  if (robot_ns < channel.published_ns) {
    channel.published_ns = channel.waits_since_ns = kNever;  // the robot was started anew
  }
  if (robot_ns - channel.published_ns < channel.period_ns) {
    return false;
  }
  const bool first = is_new(channel.topics.front());
  if (channel.topics.size() == 1 || is_new(channel.topics[1])) {
    return channel.topics.size() > 1 || first;
  }
  if (first && channel.waits_since_ns == kNever) {
    channel.waits_since_ns = robot_ns;
  }
  return first && robot_ns - channel.waits_since_ns >= kPatience_ns;
}

void StateExport::publish(std::size_t number, link::ControllerEnd& end, std::int64_t robot_ns) noexcept {
  Channel& channel = channels_[number];
  channel.published_ns = robot_ns;
  channel.waits_since_ns = kNever;
  std::size_t size = 1;
  buffer_[0] = 0;
  for (std::size_t i = 0; i < channel.topics.size(); ++i) {
    Topic& topic = channel.topics[i];
    if (const auto read = topic.reader.read(topic.value.data())) {
      topic.seen = read.sequence;
      topic.there = true;
    }
    if (topic.there) {
      buffer_[0] |= contract::topic_bit(i);
      size += codec_.encode(*topic.type, topic.value.data(), std::span(buffer_).subspan(size));
    }
  }
  static_cast<void>(end.publish(number, std::span(buffer_).first(size), robot_ns));
}

void StateExport::export_events(link::ControllerEnd& end, std::int64_t robot_ns) noexcept {
  Event event;
  const std::uint64_t before = newest_events_.last();
  while (events_.read(event)) {
    newest_events_.add(event);
  }
  if (newest_events_.last() != before) {
    const std::size_t size = newest_events_.encode(codec_, buffer_);
    static_cast<void>(end.publish(contract::kEventChannel, std::span(buffer_).first(size), robot_ns));
  }
}

}  // namespace gaitway::api
