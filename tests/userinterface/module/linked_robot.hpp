// The robot's desk and the module's link, joined by a carrier in virtual time.
#pragma once

#include <cstdint>
#include <functional>

#include "gaitway/api/module_link.hpp"
#include "gaitway/api/robot_desk.hpp"
#include "gaitway/link/i2c_bus.hpp"
#include "gaitway/msgclient/client.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "simulated_wire.hpp"

namespace gaitway::api::test {

// `socket`: what is written is there at once. `i2c`: at 400 kHz, exact to the bit.
enum class Line : std::uint8_t { socket, i2c };

class LinkedRobot {
 public:
  LinkedRobot(msgclient::Client& client, const urdf::RobotModel& robot, Line chosen = Line::i2c)
      : line(chosen),
        link(robot, {.boot = 9}),
        desk(client, robot, {.boot = 7, .name = "robot", .narrow = chosen == Line::i2c, .link = {}}) {}

  // The millisecond that begins at `now_ns`, of the clock of both. Both look whenever something has come, as
  // who is woken by it.
  // `say(at_ns)` is called in it after `into_ns`.
  void pass_millisecond(std::int64_t now_ns, std::int64_t into_ns = 0,
                        const std::function<void(std::int64_t)>& say = {}) {
    exchange(now_ns);
    if (say) {
      pass_until(now_ns + into_ns);
      say(now_ns + into_ns);
      exchange(now_ns + into_ns);
    }
    pass_until(now_ns + facts::kMillisecond_ns);
    exchange(now_ns + facts::kMillisecond_ns);
  }
  // What both have to say now, and what becomes of it at once.
  void exchange(std::int64_t at_ns) {
    constexpr int kThereAndBack = 2;
    for (int way = 0; way < (line == Line::socket ? kThereAndBack : 1); ++way) {
      link.pump(!connected ? nullptr : line == Line::i2c ? &bus.master() : &wire.left(), at_ns);
      link::pump(desk.end(), line == Line::i2c ? bus.slave() : wire.right(), at_ns);
      desk.step(at_ns);
      if (exchanged) {
        exchanged(at_ns);
      }
    }
  }

  const Line line;
  link::I2cBus bus;
  link::test::SimulatedWire wire{0, 4096, 1};
  ModuleLink link;
  RobotDesk desk;
  bool connected = true;
  std::function<void(std::int64_t)> exchanged;  // called after each, when it is set

 private:
  void pass_until(std::int64_t until_ns) {
    if (line == Line::i2c) {
      while (const auto at_ns = bus.advance(until_ns)) {
        exchange(*at_ns);
      }
    }
    wire.advance(until_ns);
  }
};

}  // namespace gaitway::api::test
