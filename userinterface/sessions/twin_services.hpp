// The services under /simulation/twin/: of a simulation that is the twin of a real robot.
#pragma once

#include <cstdint>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <utility>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/service_types.hpp"
#include "gaitway/api/simulation_types.hpp"
#include "simulation_orders.hpp"

namespace gaitway::api {

class TwinServices {
 public:
  // `port` outlives it: the twin's own, on which no order waits for the simulation.
  TwinServices(SimulationPort& port, const Limits& limits, const SimulationOrders::Send& send)
      : orders_(port, limits, send, {"twin", [this](const std::string& answer) { take(answer); }}) {}
  TwinServices(const TwinServices&) = delete;
  TwinServices& operator=(const TwinServices&) = delete;

  void step(std::int64_t now_ns) { orders_.step(now_ns); }
  // The connection has ended: its calls are answered to nobody.
  void leave(std::uint64_t client) { orders_.forget(client); }
  // What was last heard, since it was last taken.
  [[nodiscard]] std::optional<ros::TwinState> take_state() { return std::exchange(news_, std::nullopt); }

  void follow(const SimulationCall& call, const ros::SetBool::Request& asked);
  // Throws Refused for what no robot could be sent.
  void send(const SimulationCall& call, const ros::SendToRobot::Request& asked);
  void stop(const SimulationCall& call, const ros::Trigger::Request& asked);
  void reconnect(const SimulationCall& call, const ros::Trigger::Request& asked);
  void tell_picture(const SimulationCall& call, const ros::GetPicture::Request& asked);

 private:
  // An order whose answer is that it is done, or why not.
  void give(const SimulationCall& call, const nlohmann::json& order);

  void take(const std::string& answer);

  SimulationOrders orders_;
  std::optional<ros::TwinState> news_;
};

}  // namespace gaitway::api
