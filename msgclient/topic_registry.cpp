// Declares topics, checks that both sides agree, and lends each topic to one writer.
#include "topic_registry.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

namespace gaitway::msgclient {
namespace {

constexpr std::size_t kPageBytes = 4096;

std::size_t whole_pages(std::size_t bytes) {
  return (bytes + kPageBytes - 1) / kPageBytes * kPageBytes;
}

std::string describe_type(const TopicDescriptor& descriptor) {
  return fmt::format("{} of {} ({} bytes, type hash {:016x}{})", kind_name(descriptor.kind),
                     descriptor.type_name, descriptor.size, descriptor.type_hash,
                     descriptor.capacity > 0 ? fmt::format(", capacity {}", descriptor.capacity) : "");
}

void check_name(std::string_view what, std::string_view name) {
  const bool printable = std::ranges::all_of(name, [](char c) { return c > ' ' && c < 0x7f; });
  if (name.empty() || name.size() > kMaxNameLength || !printable) {
    throw TopicError(fmt::format("{} '{}': a name has 1 to {} printable characters without spaces", what,
                                 name, kMaxNameLength));
  }
}

void check_request(const TopicDescriptor& wanted) {
  check_name("topic", wanted.name);
  check_name(fmt::format("topic '{}', type", wanted.name), wanted.type_name);
  if (wanted.kind > TopicKind::window) {
    throw TopicError(
        fmt::format("topic '{}': unknown kind {}", wanted.name, static_cast<std::uint32_t>(wanted.kind)));
  }
  if (wanted.size == 0 || wanted.size > kMaxBlockBytes) {
    throw TopicError(fmt::format("topic '{}', type {}: {} bytes; a value has 1 to {} bytes", wanted.name,
                                 wanted.type_name, wanted.size, kMaxBlockBytes));
  }
  if (wanted.capacity > kMaxCapacity) {
    throw TopicError(fmt::format("topic '{}': capacity {} is above the largest one, {}", wanted.name,
                                 wanted.capacity, kMaxCapacity));
  }
}

RingGeometry geometry_of(const TopicDescriptor& topic) {
  switch (topic.kind) {
    case TopicKind::queue:
      return {topic.size, topic.capacity};
    case TopicKind::stream:
      return {topic.size, topic.capacity + 1};  // one slot is always the writer's
    case TopicKind::latest:
    case TopicKind::window:
      break;
  }
  return {topic.size, topic.size > kLargeTopicBytes ? kSlotsOfLargeTopic : kSlots};
}

}  // namespace

std::string_view kind_name(TopicKind kind) noexcept {
  constexpr std::string_view kNames[] = {"latest value", "queue", "stream", "window"};
  const auto index = static_cast<std::size_t>(kind);
  return index < std::size(kNames) ? kNames[index] : "unknown kind";  // as a broken peer may name one
}

std::string sealed_text(std::string_view client, std::string_view topic) {
  return fmt::format("topic '{}': '{}' is sealed: it opens nothing more. Open all topics before seal()",
                     topic, client);
}

TopicRegistry::TopicRegistry(std::size_t block_bytes)
    : block_bytes_(block_bytes),
      used_bytes_(whole_pages(Directory::bytes())),
      directory_segment_(Segment::create("gaitway_directory", whole_pages(Directory::bytes()))),
      directory_(directory_segment_) {
  if (block_bytes < used_bytes_ || block_bytes > kMaxBlockBytes) {
    throw TopicError(
        fmt::format("a memory block of {} bytes: it needs {} for its directory and has at most {}",
                    block_bytes, used_bytes_, kMaxBlockBytes));
  }
  directory_.format(block_bytes);
  topics_.reserve(kMaxTopics);
}

ClientId TopicRegistry::new_client() noexcept {
  const std::scoped_lock lock(mutex_);
  return ++last_client_;
}

std::size_t TopicRegistry::used_bytes() const noexcept {
  const std::scoped_lock lock(mutex_);
  return used_bytes_;
}

TopicGrant TopicRegistry::open(ClientId client, const std::string& client_name, const TopicDescriptor& wanted,
                               Role role) {
  check_name("client", client_name);
  check_request(wanted);
  const std::scoped_lock lock(mutex_);
  Topic& topic = declare(wanted, client_name);
  claim(topic, client, client_name, role);
  return {topic.info.descriptor, topic.geometry, topic.info.generation, topic.storage, topic.cursor, Claim()};
}

TopicRegistry::Topic& TopicRegistry::declare(const TopicDescriptor& wanted, const std::string& client_name) {
  if (const auto found = index_.find(wanted.name); found != index_.end()) {
    Topic& topic = topics_[found->second];
    const TopicDescriptor& declared = topic.info.descriptor;
    const bool same = declared.type_name == wanted.type_name && declared.type_hash == wanted.type_hash &&
                      declared.size == wanted.size && declared.kind == wanted.kind &&
                      (wanted.capacity == 0 || wanted.capacity == declared.capacity);
    if (!same) {
      throw TopicError(fmt::format(
          "topic '{}': '{}' wants a {}, but '{}' declared it as a {}: build both from the same schema, "
          "or give one topic another name",
          wanted.name, client_name, describe_type(wanted), topic.declared_by, describe_type(declared)));
    }
    return topic;
  }
  Topic topic;
  topic.info.descriptor = wanted;
  const bool counted = wanted.kind == TopicKind::queue || wanted.kind == TopicKind::stream;
  topic.info.descriptor.capacity = !counted              ? 0
                                   : wanted.capacity > 0 ? wanted.capacity
                                                         : kDefaultQueueCapacity;
  topic.declared_by = client_name;
  topic.geometry = geometry_of(topic.info.descriptor);
  const std::size_t storage =
      whole_pages(wanted.kind == TopicKind::window ? wanted.size : topic.geometry.bytes());
  const std::size_t cursor = wanted.kind == TopicKind::queue ? kPageBytes : 0;
  topic.info.storage_bytes = storage + cursor;
  if (topics_.size() == kMaxTopics) {
    throw TopicError(
        fmt::format("topic '{}' of '{}': the memory block's directory is full, it holds {} topics",
                    wanted.name, client_name, kMaxTopics));
  }
  if (used_bytes_ + storage + cursor > block_bytes_) {
    throw TopicError(fmt::format(
        "topic '{}' of '{}' needs {} bytes for values of {} bytes, but only {} of the memory block's {} "
        "bytes are free: make the block larger (at most {}) or the type smaller",
        wanted.name, client_name, storage + cursor, wanted.size, block_bytes_ - used_bytes_, block_bytes_,
        kMaxBlockBytes));
  }
  topic.storage = std::make_shared<Segment>(Segment::create("gaitway_" + wanted.name, storage));
  if (cursor > 0) {
    topic.cursor = std::make_shared<Segment>(Segment::create("gaitway_cursor_" + wanted.name, cursor));
  }
  used_bytes_ += storage + cursor;
  index_.emplace(wanted.name, topics_.size());
  topics_.push_back(std::move(topic));
  show(topics_.back());
  return topics_.back();
}

void TopicRegistry::claim(Topic& topic, ClientId client, const std::string& client_name, Role role) {
  const bool queue = topic.info.descriptor.kind == TopicKind::queue;
  if (role == Role::reader && !queue) {
    return;
  }
  ClientId& holder = role == Role::writer ? topic.writer : topic.reader;
  std::string& holder_name = role == Role::writer ? topic.info.writer : topic.info.reader;
  if (holder != 0) {
    throw TopicError(fmt::format(
        "topic '{0}' is already {1} by '{2}', so '{3}' cannot: one {4} a topic; end '{2}' first, or give one "
        "of them another topic",
        topic.info.descriptor.name, role == Role::writer ? "written" : "read", holder_name, client_name,
        role == Role::writer ? "writer" : "reader of its queue"));
  }
  holder = client;
  holder_name = client_name;
  if (role == Role::writer) {
    ++topic.info.generation;
  }
  show(topic);
}

void TopicRegistry::give_back(Topic& topic, ClientId client, Role role) noexcept {
  ClientId& holder = role == Role::writer ? topic.writer : topic.reader;
  if (holder != client) {
    return;
  }
  holder = 0;
  (role == Role::writer ? topic.info.writer : topic.info.reader).clear();
  show(topic);
}

void TopicRegistry::release(ClientId client, const std::string& topic, Role role) noexcept {
  const std::scoped_lock lock(mutex_);
  if (const auto found = index_.find(topic); found != index_.end()) {
    give_back(topics_[found->second], client, role);
  }
}

void TopicRegistry::release_all(ClientId client) noexcept {
  const std::scoped_lock lock(mutex_);
  for (Topic& topic : topics_) {
    give_back(topic, client, Role::writer);
    give_back(topic, client, Role::reader);
  }
}

ClientId TopicRegistry::holder(std::string_view topic, Role role) const noexcept {
  const std::scoped_lock lock(mutex_);
  const auto found = index_.find(topic);
  if (found == index_.end()) {
    return 0;
  }
  const Topic& held = topics_[found->second];
  return role == Role::writer ? held.writer : held.reader;
}

void TopicRegistry::keep_to_this_process() {
  const std::scoped_lock lock(mutex_);
  directory_segment_.keep_to_this_process();
  for (const Topic& topic : topics_) {
    topic.storage->keep_to_this_process();
    if (topic.cursor) {
      topic.cursor->keep_to_this_process();
    }
  }
}

void TopicRegistry::share_anew() {
  const std::scoped_lock lock(mutex_);
  directory_segment_.share_anew("gaitway_directory");
  for (const Topic& topic : topics_) {
    topic.storage->share_anew("gaitway_" + topic.info.descriptor.name);
    if (topic.cursor) {
      topic.cursor->share_anew("gaitway_cursor_" + topic.info.descriptor.name);
    }
  }
}

}  // namespace gaitway::msgclient
