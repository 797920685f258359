// The robot's topics, as the link brings them, in a memory block of the module's own: whoever reads the
// robot's topics reads these.
#pragma once

#include <cstdint>
#include <vector>

#include "gaitway/contract/channel_table.hpp"
#include "gaitway/link/state_receiver.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::api {

class StateMirror {
 public:
  // Throws msgclient::TopicError.
  explicit StateMirror(const contract::TopicCodec& codec);

  // A client of its memory block.
  [[nodiscard]] msgclient::Client client(const std::string& name) { return block_.local_client(name); }

  // Publishes what is new in the channels. Values that are none are counted and left out.
  void take(link::StateReceiver& state);
  // What the robot's clock shows, as it was told last; what came with a later stamp goes before it, unless it
  // is so much later that the clock must have begun anew.
  void beat(std::int64_t robot_ns) noexcept;
  [[nodiscard]] std::uint64_t broken_values() const noexcept { return broken_; }

 private:
  struct Topic {
    const TypeDescriptor* type;
    msgclient::UntypedWriter writer;
    std::vector<std::uint64_t> value;  // words: aligned for every type
  };
  [[nodiscard]] bool take_channel(std::size_t channel, const link::StateValue& value);
  [[nodiscard]] bool take_events(link::Bytes bytes);

  contract::TopicCodec codec_;
  msgclient::MemoryBlock block_;
  msgclient::Client client_;
  std::vector<std::vector<Topic>> channels_;
  msgclient::Writer<Event> events_;
  std::int64_t newest_ns_ = 0;    // stamp
  std::uint64_t last_event_ = 0;  // its number
  std::uint64_t broken_ = 0;
};

}  // namespace gaitway::api
