// The robot's topics into the link's channels.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "gaitway/contract/channel_table.hpp"
#include "gaitway/contract/event_list.hpp"
#include "gaitway/link/controller_end.hpp"
#include "gaitway/msgclient/client.hpp"

namespace gaitway::api {

// Looks what is new, and publishes it. Allocates in the constructor only.
class StateExport {
 public:
  // Opens the topics: throws msgclient::TopicError. `client` outlives it. `narrow`: the carrier is no Unix
  // socket.
  StateExport(msgclient::Client& client, const contract::TopicCodec& codec, bool narrow);

  void step(link::ControllerEnd& end, std::int64_t robot_ns) noexcept;

 private:
  struct Topic {
    const TypeDescriptor* type;
    msgclient::UntypedReader reader;
    std::uint64_t seen = 0;            // its newest sequence in `value`
    std::vector<std::uint64_t> value;  // words: aligned for every type
    bool there = false;
  };
  struct Channel {
    std::int64_t period_ns = 0, published_ns = 0;
    std::int64_t waits_since_ns = 0;  // that its first topic is new, and the second is not
    std::vector<Topic> topics;
  };

  [[nodiscard]] bool is_due(Channel& channel, std::int64_t robot_ns) noexcept;
  void publish(std::size_t channel, link::ControllerEnd& end, std::int64_t robot_ns) noexcept;
  void export_events(link::ControllerEnd& end, std::int64_t robot_ns) noexcept;

  contract::TopicCodec codec_;
  std::vector<Channel> channels_;
  msgclient::StreamReader<Event> events_;
  contract::EventList newest_events_;
  std::vector<std::uint8_t> buffer_;
};

}  // namespace gaitway::api
