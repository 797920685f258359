// The robot's desk and the module's link, joined by simulated I2C, in virtual time.
#pragma once

#include <cstdint>

#include "gaitway/api/module_link.hpp"
#include "gaitway/api/robot_desk.hpp"
#include "gaitway/link/i2c_bus.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::api::test {

class LinkedRobot {
 public:
  LinkedRobot(msgclient::Client& client, const urdf::RobotModel& robot)
      : link(robot, {.boot = 9}),
        desk(client, robot, {.boot = 7, .name = "robot", .narrow = true, .link = {}}) {}

  // The millisecond that begins at `now_ns`, of the clock of both. Both look at each transfer's end, as who
  // is woken by what has come.
  void pass_millisecond(std::int64_t now_ns) {
    for (std::int64_t at_ns = now_ns;;) {
      link.pump(connected ? &bus.master() : nullptr, at_ns);
      link::pump(desk.end(), bus.slave(), at_ns);
      desk.step(at_ns);
      const auto next = bus.advance(now_ns + facts::kMillisecond_ns);
      if (!next) {
        break;
      }
      at_ns = *next;
    }
    desk.step(now_ns + facts::kMillisecond_ns);
  }

  link::I2cBus bus;
  ModuleLink link;
  RobotDesk desk;
  bool connected = true;
};

}  // namespace gaitway::api::test
