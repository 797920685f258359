// Two numbers, and events one behind the other.
#include "gaitway/contract/event_list.hpp"

#include <algorithm>

namespace gaitway::contract {

std::size_t EventList::encode(const TopicCodec& codec, std::span<std::uint8_t> room) const noexcept {
  const std::uint64_t count = last_ == 0 ? 0 : last_ - first() + 1;
  std::size_t size = 0;
  for (const std::uint64_t number : {first(), count}) {
    const std::size_t bytes = put_number(number, room.subspan(size));
    if (bytes == 0) {
      return 0;
    }
    size += bytes;
  }
  for (std::uint64_t number = first(); number <= last_; ++number) {
    const std::size_t bytes = codec.encode(TopicType<Event>::descriptor, &event(number), room.subspan(size));
    if (bytes == 0) {
      return 0;
    }
    size += bytes;
  }
  return size;
}

std::optional<EventList> EventList::decode(const TopicCodec& codec,
                                           std::span<const std::uint8_t> bytes) noexcept {
  const auto take_number = [&bytes](std::uint64_t& number) {
    const std::size_t read = get_number(bytes, number);
    bytes = bytes.subspan(read);
    return read > 0;
  };
  std::uint64_t first = 0, count = 0;
  if (!take_number(first) || !take_number(count) || first == 0 || count > kKept ||
      first > UINT64_MAX - count) {
    return std::nullopt;
  }
  EventList list;
  list.last_ = first - 1;
  for (std::uint64_t i = 0; i < count; ++i) {
    Event event;
    const std::size_t read = codec.decode(TopicType<Event>::descriptor, bytes, &event);
    if (read == 0) {
      return std::nullopt;
    }
    bytes = bytes.subspan(read);
    event.source[sizeof event.source - 1] = event.text[sizeof event.text - 1] = 0;
    list.add(event);
  }
  // A list holds as many as it can.
  return bytes.empty() && list.first() == first ? std::optional(list) : std::nullopt;
}

std::size_t EventList::most_bytes(const TopicCodec& codec) noexcept {
  constexpr std::size_t kMostNumberBytes = 10;
  return 2 * kMostNumberBytes + kKept * codec.most_bytes(TopicType<Event>::descriptor);
}

}  // namespace gaitway::contract
