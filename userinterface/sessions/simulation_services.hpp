// The services under /simulation/: of this project's simulator, and of the package simulation_interfaces.
#pragma once

#include <cstdint>
#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "entity_services.hpp"
#include "gaitway/api/limits.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/service_table.hpp"
#include "gaitway/api/simulation_port.hpp"
#include "simulation_orders.hpp"
#include "twin_services.hpp"

namespace gaitway::api {

class SimulationServices {
 public:
  // The ports outlive it. `twin`: nullptr: the simulation is no twin.
  SimulationServices(SimulationPort& port, SimulationPort* twin, const Limits& limits,
                     const SimulationOrders::Send& send)
      : orders_(port, limits, send, {"state", [this](const std::string& answer) { take_state(answer); }}),
        entities_(orders_) {
    if (twin != nullptr) twin_.emplace(*twin, limits, send);
  }
  SimulationServices(const SimulationServices&) = delete;
  SimulationServices& operator=(const SimulationServices&) = delete;

  // Answers the call of a row that is of_simulation, now or later. Throws Refused or MessageError for wrong
  // arguments, CommandDenied when the client waits for too many answers.
  void call(const ServiceRow& row, const ServiceCall& call, const nlohmann::json& arguments,
            std::int64_t now_ns);
  void step(std::int64_t now_ns) {
    orders_.step(now_ns);
    entities_.step(now_ns);
    if (twin_) twin_->step(now_ns);
  }
  // The connection has ended: its calls are answered to nobody.
  void leave(std::uint64_t client) {
    orders_.forget(client);
    entities_.forget(client);
    if (twin_) twin_->leave(client);
  }
  // What was last heard, since it was last taken.
  [[nodiscard]] std::optional<ros::SimulationState> take_state() {
    return std::exchange(news_, std::nullopt);
  }
  [[nodiscard]] std::optional<ros::TwinState> take_twin() {
    return twin_ ? twin_->take_state() : std::nullopt;
  }

 private:
  using Arguments = nlohmann::json;
  struct Answers;

  void push(const SimulationCall& call, const Arguments& arguments);
  void set_speed(const SimulationCall& call, const Arguments& arguments);
  void seek(const SimulationCall& call, const Arguments& arguments);
  void apply(const SimulationCall& call, const Arguments& arguments);
  void plan(const SimulationCall& call, const Arguments& arguments);
  void tell_geometry(const SimulationCall& call, const Arguments& arguments);
  void tell_features(const SimulationCall& call, const Arguments& arguments);
  void tell_state(const SimulationCall& call, const Arguments& arguments);
  void set_state(const SimulationCall& call, const Arguments& arguments);
  void step_simulation(const SimulationCall& call, const Arguments& arguments);
  void reset(const SimulationCall& call, const Arguments& arguments);
  void tell_spawnables(const SimulationCall& call, const Arguments& arguments);
  void tell_world(const SimulationCall& call, const Arguments& arguments);
  // One of TwinServices' members.
  template <class S, void (TwinServices::*member)(const SimulationCall&, const typename S::Request&)>
  void of_twin(const SimulationCall& call, const Arguments& arguments) {
    const auto asked = request_of<typename S::Request>(arguments);
    if (twin_) return (*twin_.*member)(call, asked);
    refuse_twin(call);
  }
  // There is none.
  void refuse_twin(const SimulationCall& call) const;
  void take_state(const std::string& answer);
  // One of EntityServices' members.
  template <class S, void (EntityServices::*member)(const SimulationCall&, const typename S::Request&)>
  void of_entities(const SimulationCall& call, const Arguments& arguments) {
    (entities_.*member)(call, request_of<typename S::Request>(arguments));
  }

  // S's response, of this project's services, out of what became of the order.
  template <class S>
  void ask(const SimulationCall& call, const nlohmann::json& order, std::int64_t patience_ns,
           std::function<typename S::Response(const std::string& answer)> response_of_answer);
  // S's response, of simulation_interfaces.
  template <class S>
  void conclude(const SimulationCall& call, std::uint8_t code, std::string text) const;
  template <class S>
  [[nodiscard]] SimulationOrders::Then conclude_refused(const SimulationCall& call) const;
  // Goes over into the target state from another one.
  void change_state(const SimulationCall& call, std::uint8_t target, const StateAnswer& from);
  // The orders one after the other.
  void carry_out(const SimulationCall& call, std::vector<nlohmann::json> orders);

  SimulationOrders orders_;
  EntityServices entities_;
  std::optional<TwinServices> twin_;
  std::optional<ros::SimulationState> news_;
};

}  // namespace gaitway::api
