// The robot API's conversation with its clients: rosbridge v2, without a network. One hub for all sessions;
// passive and for one thread.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/cbor_codec.hpp"
#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/session.hpp"
#include "gaitway/api/simulation_port.hpp"

namespace gaitway::api {

struct HubState;

struct HubOptions {
  Limits limits;
  // Whether this is the token that clients must show, in constant time; without it none is right.
  std::function<bool(std::string_view offered)> is_token;
  // For rosapi: name ("plug-in:parameter") -> value, as in a configuration. Kept up to date by what clients
  // set and read.
  std::map<std::string, std::string, std::less<>> parameters;
  SimulationPorts simulation;  // outlive the hub
};

// What clients cost, for diagnostics; counts are since the start.
struct HubStatistics {
  std::size_t clients = 0;
  std::size_t subscriptions = 0;
  std::size_t waiting_bytes = 0;   // of all clients
  std::uint64_t messages = 0;      // that clients sent
  std::uint64_t refused = 0;       // of these: answered by an error status
  std::uint64_t dropped = 0;       // publications that a client was too slow for
  std::uint64_t closed_by_us = 0;  // connections: dead, too fast, never authorised
  std::string commander;           // name of who has the command; empty: nobody
};

// Sessions must not outlive their hub.
class Hub final : public SessionHub {
 public:
  Hub(RobotPort& robot, HubOptions options);
  ~Hub() override;
  Hub(const Hub&) = delete;
  Hub& operator=(const Hub&) = delete;

  std::unique_ptr<Session> open(Connection& connection, std::string peer, bool authorised,
                                std::int64_t wall_ns) override;
  void step(std::int64_t wall_ns) override;
  // The link to the robot was lost, or is there again: nobody commands, and who did must take the command
  // again.
  void robot_lost();
  // Somebody who is no session has stopped the robot: as after a /stop, nobody commands and nothing walks on.
  void stopped_by_datagram();
  // Passes on the answers of the robot; step() does so, too.
  void answer(std::int64_t wall_ns);

  // What the simulator has told of its state since the last call, for who publishes it; nothing, too, where
  // there is no simulator, or one that tells none.
  [[nodiscard]] std::optional<ros::SimulationState> take_simulation_state();
  [[nodiscard]] std::optional<ros::TwinState> take_twin_state();
  // The velocity that clients have the robot walk with, where it is another one than at the last call.
  [[nodiscard]] std::optional<Velocity> take_walk_command();

  // A message for all who subscribe to `topic`: encoded at most once per encoding, and not at all for nobody,
  // unless the topic is latched. Throws std::logic_error when M is not the topic's type.
  template <Message M>
  void publish(Topic topic, const M& message) {
    require_type(topic, M::kName);
    publish_encoded(topic, [this, &message, topic](Encoding encoding, std::string& out) {
      switch (encoding) {
        case Encoding::json:
          return append_publish_json(out, row(topic).name, message);
        case Encoding::cbor:
          return append_publish_cbor(out, row(topic).name, message);
        case Encoding::cbor_raw: {
          std::string cdr;
          append_cdr(cdr, message);
          return append_publish_cbor_raw(out, row(topic).name, robot_ns(), cdr);
        }
      }
    });
  }
  // Whether publish() would do anything: what is costly to make may be left out otherwise.
  [[nodiscard]] bool wanted(Topic topic) const noexcept;

  [[nodiscard]] HubStatistics statistics() const;
  // Name of who commands, until the next call of the hub; empty: nobody.
  [[nodiscard]] std::string_view commander() const noexcept;

 private:
  using Encode = std::function<void(Encoding encoding, std::string& out)>;
  static void require_type(Topic topic, std::string_view type);
  [[nodiscard]] std::int64_t robot_ns() const;
  void publish_encoded(Topic topic, const Encode& encode);

  std::unique_ptr<HubState> state_;
};

}  // namespace gaitway::api
