// What all sessions of a hub share.
#pragma once

#include <cstdint>
#include <map>

#include "gaitway/api/hub.hpp"
#include "publications.hpp"
#include "robot_commands.hpp"
#include "service_desk.hpp"

namespace gaitway::api {

class ClientSession;

struct HubState {
  HubState(RobotPort& port, HubOptions hub_options);

  const RobotPort& robot;
  HubOptions options;
  RobotCommands commands;
  ServiceDesk desk;
  Publications publications;
  std::map<std::uint64_t, ClientSession*> sessions;  // by Claimant::number
  std::uint64_t last_number = 0;
  std::int64_t now_ns = 0;  // of the latest call
  HubStatistics counts;     // only what is counted since the start
};

}  // namespace gaitway::api
