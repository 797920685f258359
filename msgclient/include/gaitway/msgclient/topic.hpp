// How a topic is described and what set-up refuses. Used when topics are opened, never in the cycle.
#pragma once

#include <cstdint>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/msgclient/type_descriptor.hpp"

namespace gaitway::msgclient {

// A topic cannot be opened: the message names the topic, both sides and the remedy. Thrown by set-up calls
// only.
class TopicError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

enum class TopicKind : std::uint32_t {
  latest = 0,  // readers want the newest value
  queue = 1,   // bounded; one writer, one named reader; refuses when full
  stream = 2,  // bounded; one writer, any readers, each counts what it missed
  window = 3   // bare words, no publishing: the EMI adapter's
};
std::string_view kind_name(TopicKind kind) noexcept;

inline constexpr std::size_t kMaxNameLength = 63;           // of topics, types and clients
inline constexpr std::uint32_t kDefaultQueueCapacity = 16;  // values
inline constexpr std::uint32_t kMaxCapacity = 65536;        // values

// What a reader or a writer asks for. Whoever comes first declares the topic; the others must agree.
struct TopicDescriptor {
  std::string name;
  std::string type_name;
  std::uint64_t type_hash = 0;
  std::uint32_t size = 0;  // bytes of a value
  TopicKind kind = TopicKind::latest;
  std::uint32_t capacity =
      0;  // values of a queue or stream; 0: as declared by the other side, or kDefaultQueueCapacity

  template <class T>
  static TopicDescriptor of(std::string_view topic, TopicKind kind = TopicKind::latest,
                            std::uint32_t capacity = 0) {
    using Type = TopicType<T>;
    static_assert(sizeof(T) == Type::descriptor.size);
    return {std::string(topic), std::string(Type::name), Type::hash, Type::descriptor.size, kind, capacity};
  }
};

// A row of the directory.
struct TopicInfo {
  TopicDescriptor descriptor;
  std::string writer;            // empty: none at the moment
  std::string reader;            // the named reader of a queue; empty: none, or not a queue
  std::uint32_t generation = 0;  // how often a writer has claimed the topic
  std::uint64_t storage_bytes = 0;
};

}  // namespace gaitway::msgclient
