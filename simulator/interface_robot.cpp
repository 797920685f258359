// Frames in, a millisecond of the body, frames out.
#include "interface_robot.hpp"

#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {

using facts::kMillisecond_ns;
namespace {

constexpr std::int64_t kEverything = std::numeric_limits<std::int64_t>::max();

}  // namespace

InterfaceRobot::InterfaceRobot(const urdf::RobotModel& robot, const PlantOptions& plant,
                               can::SocketCanPort& port, bool log_wanted, std::int64_t start_ns)
    : port_(port),
      plant_(robot, plant),
      joints_(robot, plant.seed, kLargestClockDrift_ppm),
      watch_(plant_, log_wanted, start_ns),
      next_ns_(start_ns + kMillisecond_ns) {
  joints_.step(start_ns, plant_.sensors());
}

void InterfaceRobot::advance_to(std::int64_t now_ns) {
  for (; next_ns_ <= now_ns; next_ns_ += kMillisecond_ns) {
    hear(next_ns_);
    plant_.step(joints_.torque_Nm());
    joints_.step(next_ns_, plant_.sensors());
    watch_.look(plant_, next_ns_);
    speak(next_ns_);
  }
  hear(kEverything);
  speak(now_ns);
}

void InterfaceRobot::hear(std::int64_t until_ns) {
  while (true) {
    if (!arrived_) {
      arrived_ = port_.receive();
    }
    if (!arrived_ || arrived_->end_ns > until_ns) {
      return;
    }
    for (int joint = 0; joint < joints_.size(); ++joint) {
      joints_.on_frame(joint, arrived_->frame, arrived_->end_ns);
    }
    arrived_.reset();
  }
}

void InterfaceRobot::speak(std::int64_t now_ns) {
  can::Frame frame;
  for (int joint = 0; joint < joints_.size(); ++joint) {
    while (port_.free_buffers() > 0 && joints_.take_frame(joint, frame)) {
      port_.transmit(frame, now_ns);
    }
  }
  port_.flush(now_ns);
}

}  // namespace gaitway::simulator
