// Each order waits with its call; the state's own order is nobody's.
#include "simulation_orders.hpp"

#include <algorithm>
#include <exception>
#include <utility>

#include "client_message.hpp"

namespace gaitway::api {

using nlohmann::json;

SimulationOrders::SimulationOrders(SimulationPort& port, const Limits& limits, Send send, Watched watched)
    : port_(port),
      limits_(limits),
      send_(std::move(send)),
      orders_([&port] { return port.take_result(); }),
      watched_(std::move(watched)) {}

void SimulationOrders::step(std::int64_t now_ns) {
  now_ns_ = now_ns;
  orders_.step(now_ns);
  if (!is_asked_ && now_ns >= ask_ns_) watch(now_ns);
}

void SimulationOrders::watch(std::int64_t now_ns) {
  is_asked_ = true;
  ask_ns_ = now_ns + kStatePeriod_ns;
  ask_for_nobody({{"order", watched_.order}}, [this](const OrderResult* result) { take_watched(result); });
}

void SimulationOrders::take_watched(const OrderResult* result) {
  is_asked_ = false;
  try {
    if (result != nullptr && result->done) return watched_.take(result->text);
  } catch (const std::exception&) {
    // Nothing that this release understands; whoever calls a service is told so.
  }
  ask_ns_ = now_ns_ + kAfterRefusal_ns;
}

void SimulationOrders::ask_for_nobody(const json& order, Orders::Finish finish) {
  constexpr std::uint64_t kNobody = 0;
  orders_.wait(port_.order(order.dump(), kPatience_ns), kNobody, now_ns_ + kPatience_ns, std::move(finish),
               false);
}

std::string SimulationOrders::patience_of(const SimulationCall& call) const {
  const std::int64_t waited_ns = std::min(call.call.timeout_ns, limits_.answer_ns);
  return shown_json(json(static_cast<double>(waited_ns) * 1e-9)) + " s";
}

SimulationCall SimulationOrders::begin(const ServiceCall& call, std::int64_t now_ns) const {
  orders_.require_room(call.client);
  return {call, now_ns, now_ns + std::min(call.timeout_ns, limits_.answer_ns)};
}

void SimulationOrders::ask(const SimulationCall& call, const json& order, std::int64_t patience_ns,
                           Then then) {
  wait(call, port_.order(order.dump(-1, ' ', false, json::error_handler_t::replace), patience_ns),
       std::move(then));
}

void SimulationOrders::push(const SimulationCall& call, const LinkPush& push, Then then) {
  wait(call, port_.push(push), std::move(then));
}

void SimulationOrders::wait(const SimulationCall& call, std::uint32_t number, Then then) {
  orders_.wait(number, call.call.client, call.ends_ns,
               [this, call, then = std::move(then)](const OrderResult* result) {
                 if (result == nullptr) {
                   return fail(call, "the simulator has not answered within " + patience_of(call));
                 }
                 try {
                   then(*result);
                 } catch (const std::exception& error) {
                   fail(call, error.what());
                 }
               });
}

void SimulationOrders::ask_state(const SimulationCall& call, ThenState then, Then refused) {
  ask(call, {{"order", "state"}}, kPatience_ns,
      [this, then = std::move(then), refused = std::move(refused)](const OrderResult& result) {
        if (!result.done) {
          return refused(result);
        }
        states_.take(read_answer<StateAnswer>(result.text));
        then(*states_.newest());
      });
}

}  // namespace gaitway::api
