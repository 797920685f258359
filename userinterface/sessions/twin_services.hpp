// The services under /simulation/twin/: of a simulation that is the twin of a real robot.
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/service_types.hpp"
#include "gaitway/api/simulation_types.hpp"
#include "simulation_orders.hpp"

namespace gaitway::api {

class TwinServices {
 public:
  // `orders` outlives it.
  explicit TwinServices(SimulationOrders& orders) : orders_(orders) {}

  void follow(const SimulationCall& call, const ros::SetBool::Request& asked);
  // Throws Refused for what no robot could be sent.
  void send(const SimulationCall& call, const ros::SendToRobot::Request& asked);
  void stop(const SimulationCall& call, const ros::Trigger::Request& asked);
  void reconnect(const SimulationCall& call, const ros::Trigger::Request& asked);
  void tell_picture(const SimulationCall& call, const ros::GetPicture::Request& asked);

 private:
  // An order whose answer is that it is done, or why not.
  void give(const SimulationCall& call, const nlohmann::json& order);

  SimulationOrders& orders_;
};

}  // namespace gaitway::api
