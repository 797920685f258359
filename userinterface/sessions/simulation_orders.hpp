// Orders to a simulator: given for clients, one after the other where one call takes several, and ten times a
// second for what is published.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

#include "gaitway/api/limits.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/simulation_port.hpp"
#include "gaitway/facts/facts.hpp"
#include "orders.hpp"
#include "service_call.hpp"
#include "simulation_states.hpp"

namespace gaitway::api {

// A call, since when and until when it waits; kept while the simulator has not answered.
struct SimulationCall {
  ServiceCall call;
  std::int64_t began_ns = 0;
  std::int64_t ends_ns = 0;
};

class SimulationOrders {
 public:
  static constexpr std::int64_t kStatePeriod_ns = 100 * facts::kMillisecond_ns;
  // A simulator that has refused to tell its state, or has no twin, is asked again after this.
  static constexpr std::int64_t kAfterRefusal_ns = facts::kSecond_ns;
  // For answers that come at once, and for what has to be simulated first.
  static constexpr std::int64_t kPatience_ns = 2 * facts::kSecond_ns,
                                kLongPatience_ns = 10 * facts::kSecond_ns;

  // Takes an answer to its client, if that is still there.
  using Send = std::function<void(const ServiceCall& call, Frame frame)>;
  // Whether the order was carried out, and the JSON of the answer or why not. What it throws is told to the
  // client.
  using Then = std::function<void(const OrderResult& result)>;
  using ThenState = std::function<void(const StateAnswer& state)>;

  // An order that the clock gives, ten times a second, for what is published; `take` has its answers, and
  // throws for one that it does not understand.
  struct Watched {
    const char* order;
    std::function<void(const std::string& answer)> take;
  };

  // `port` outlives it.
  SimulationOrders(SimulationPort& port, const Limits& limits, Send send, Watched watched);

  // Takes what the simulator says, ends what has waited for too long, and gives the order that is watched.
  void step(std::int64_t now_ns);
  // The client is gone: its orders are answered to nobody.
  void forget(std::uint64_t client) { orders_.forget(client); }

  // Throws CommandDenied when the client waits for too many answers already.
  [[nodiscard]] SimulationCall begin(const ServiceCall& call, std::int64_t now_ns) const;
  // Gives the order for this call; `then` is called with what became of it, unless the call ends before. Both
  // throw std::invalid_argument for what no order may be.
  void ask(const SimulationCall& call, const nlohmann::json& order, std::int64_t patience_ns, Then then);
  void push(const SimulationCall& call, const LinkPush& push, Then then);
  // The state as it is now. `refused`: instead, when there is none.
  void ask_state(const SimulationCall& call, ThenState then, Then refused);

  // An order that no client waits for; `finish` may be called with nullptr, and throws nothing.
  void ask_for_nobody(const nlohmann::json& order, Orders::Finish finish);
  template <Message M>
  void reply(const SimulationCall& call, const M& response) const {
    send_(call.call, service_response(call.call, response));
  }
  // The service could not be carried out: `why`, for people.
  void fail(const SimulationCall& call, std::string_view why) const {
    send_(call.call, service_failure(call.call, why));
  }
  // For how long the call was to wait, for people: "10 s".
  [[nodiscard]] std::string patience_of(const SimulationCall& call) const;

  [[nodiscard]] SimulationStates& states() noexcept { return states_; }

 private:
  void wait(const SimulationCall& call, std::uint32_t number, Then then);
  void watch(std::int64_t now_ns);
  void take_watched(const OrderResult* result);

  SimulationPort& port_;
  Limits limits_;
  Send send_;
  Orders orders_;
  SimulationStates states_;
  Watched watched_;
  std::int64_t now_ns_ = 0, ask_ns_ = 0;
  bool is_asked_ = false;  // by the clock, and not answered yet
};

}  // namespace gaitway::api
