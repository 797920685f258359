// What a scenario asks of the robot, and does to it: each event where it takes effect.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"
#include "gaitway/simulator/cosimulation.hpp"

namespace gaitway::simulator {
namespace {

Eigen::Isometry3d pose_at(const Eigen::Vector3d& position_m, double yaw_rad) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = position_m;
  pose.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  return pose;
}

std::int64_t duration_ns(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * 1e9));
}

}  // namespace

void Cosimulation::inject_losses() {
  bus_.set_loss([this](const can::Frame&, std::int64_t start_ns) {
    const double unit = static_cast<double>(fault_random_() >> 11U) * 0x1.0p-53;
    return start_ns < losses_until_ns_ && unit < loss_probability_;
  });
}

int Cosimulation::station_of(const std::string& node) const {
  return node == "message_controller"
             ? message_transmitter_.station()
             : joint_transmitters_[static_cast<std::size_t>(robot_.joint_index(node))].station();
}

void Cosimulation::restart(const JointRestartsFault& fault) {
  const int joint = robot_.joint_index(fault.joint);
  joints_.power_off(joint);
  bus_.power_off(station_of(fault.joint), now_ns_);
  restarts_.push_back({joint, now_ns_ + duration_ns(fault.duration_s)});
}

void Cosimulation::inject(const PluginFault& fault) {
  std::vector<std::string> known;
  for (std::size_t i = 0; i < plugins().size(); ++i) {
    known.push_back(plugins().plugin(i).name());
  }
  if (std::ranges::find(known, fault.plugin) == known.end()) {
    throw urdf::RobotError(fmt::format("fault of plug-in '{}': the main controller has none of this name. {}",
                                       fault.plugin, input::suggest(fault.plugin, known)));
  }
  const bool overruns = fault.how == core::PluginFaultKind::overruns;
  plugin_faults_.inject(fault.plugin, {fault.how, overruns ? duration_ns(fault.cost_s) : 0},
                        fault.duration_s > 0.0 ? now_ns_ + duration_ns(fault.duration_s)
                                               : std::numeric_limits<std::int64_t>::max());
}

void Cosimulation::apply(const ScenarioEvent& event) {
  struct Visitor {
    Cosimulation& self;
    bool asked;
    void operator()(const WalkEvent& walk) const {
      if (!self.walk_command_) {
        throw std::invalid_argument("a plug-in or somebody outside alone commands the walk");
      }
      WalkCommand command{};
      command.stamp_ns = self.now_ns_;
      command.walk = walk.walk ? 1U : 0U;
      command.velocity[0] = walk.velocity_m_per_s.x();
      command.velocity[1] = walk.velocity_m_per_s.y();
      command.turn_rate = walk.turn_rate_rad_per_s;
      self.walk_command_->publish(command, self.now_ns_);
      self.scenario_walk_ = command;
    }
    void operator()(const MotionEvent& motion) const { self.ask(motion); }
    void operator()(const WalkToEvent& way) const { self.ask(way); }
    void operator()(const StopEvent&) const { post(msgclient::UserCommandKind::stop); }
    void operator()(const ReleaseEvent&) const { post(msgclient::UserCommandKind::release); }
    void operator()(const EmergencyStopEvent& stop) const {
      post(stop.soft ? msgclient::UserCommandKind::emergency_stop_soft
                     : msgclient::UserCommandKind::emergency_stop_hold);
    }
    void operator()(const ManualJointEvent& move) const {
      post({.kind = msgclient::UserCommandKind::manual_joint,
            .joint = static_cast<std::uint32_t>(move.joint),
            .position = static_cast<float>(move.position_rad),
            .duration_slots = static_cast<std::uint32_t>(move.duration_slots)});
    }
    void operator()(const PushEvent& push) const {
      self.plant_.push(push.body, push.direction, push.impulse_Ns, push.duration_s);
    }
    void operator()(const MainControllerSilentFault& fault) const {
      self.silent_until_ns_ = fault.duration_s > 0.0 ? self.now_ns_ + duration_ns(fault.duration_s)
                                                     : std::numeric_limits<std::int64_t>::max();
    }
    void operator()(const LoseFramesFault& fault) const {
      self.loss_probability_ = fault.probability;
      self.losses_until_ns_ = self.now_ns_ + duration_ns(fault.duration_s);
      self.inject_losses();
    }
    void operator()(const DisturbBusFault& fault) const {
      self.disturbed_until_ns_ = self.now_ns_ + duration_ns(fault.duration_s);
      self.bus_.set_random_faults({.seed = self.fault_random_(),
                                   .corruption = fault.corruption,
                                   .duplicate = fault.duplicate,
                                   .omission = fault.omission});
    }
    void operator()(const JamFault& fault) const {
      self.bus_.jam(fault.stuck ? can::JamKind::stuck_dominant : can::JamKind::noise, self.now_ns_,
                    duration_ns(fault.duration_s));
    }
    void operator()(const BusOffFault& fault) const {
      self.bus_.force_bus_off(self.station_of(fault.node), self.now_ns_);
    }
    void operator()(const JointRestartsFault& fault) const { self.restart(fault); }
    void operator()(const ForeignFrameFault& fault) const { self.foreign_frames_.push_back(fault.frame); }
    void operator()(const PluginFault& fault) const { self.inject(fault); }
    void operator()(const SensorFault& fault) const {
      self.sensor_faults_.begin(fault, self.plant_.sensors(), self.now_ns_);
    }
    void operator()(const CameraFault& fault) const { self.inject(fault); }
    void operator()(const SpawnEvent& spawn) const { self.change_world(spawn); }
    void operator()(const MoveEvent& move) const {
      self.plant_.move(move.name, pose_at(move.position_m, move.yaw_rad));
    }
    void operator()(const RemoveEvent& remove) const { self.plant_.remove(remove.name); }
    void post(msgclient::UserCommandKind kind) const { post(msgclient::UserCommandMail{.kind = kind}); }
    void post(msgclient::UserCommandMail mail) const {
      mail.sequence = ++self.user_commands_;
      if (asked) {
        self.ask(mail);
        return;
      }
      self.ring_at(self.now_ns_ + self.adapter_.host().post(mail, self.now_ns_).transfer_ns);
    }
  };
  std::visit(Visitor{*this, event.asked}, event.action);
}

void Cosimulation::ask(const msgclient::UserCommandMail& mail) {
  // Whoever people are later finds the queue free.
  msgclient::Client people = memory_block_.local_client("people");
  auto commands = people.write_queue<UserCommand>("user_command");
  UserCommand command{};
  command.number = mail.sequence;
  command.kind = static_cast<std::uint32_t>(mail.kind);
  command.joint = mail.joint;
  command.duration_slots = mail.duration_slots;
  command.position = static_cast<double>(mail.position);
  if (!commands.push(command, now_ns_)) {
    throw std::runtime_error("more user commands in one millisecond than the queue holds");
  }
}

void Cosimulation::ask(const MotionEvent& motion) {
  if (!motion_command_) {
    throw std::invalid_argument("a plug-in or somebody outside alone commands the motions");
  }
  MotionRequest request{};
  request.stamp_ns = now_ns_;
  request.number = ++motions_asked_;
  std::memcpy(request.name, motion.name.data(), std::min(motion.name.size(), sizeof request.name - 1));
  motion_command_->publish(request, now_ns_);
}

void Cosimulation::ask(const WalkToEvent& way) {
  if (!walk_to_command_) {
    throw std::invalid_argument("a plug-in or somebody outside alone commands the ways");
  }
  WalkToRequest request{};
  request.stamp_ns = now_ns_;
  request.number = ++ways_asked_;
  request.cancel = way.goal ? 0 : 1;
  if (way.goal) std::copy_n(way.goal->data(), way.goal->size(), request.goal);
  walk_to_command_->publish(request, now_ns_);
}

void Cosimulation::inject(const CameraFault& fault) {
  if (!camera_) {
    throw urdf::RobotError(fmt::format(
        "fault of the camera: the robot '{}' has none. Give it a camera.yaml, or leave the fault out",
        robot_.name));
  }
  camera_->begin(fault, now_ns_);
}

void Cosimulation::change_world(const SpawnEvent& spawn) {
  world::Solid solid;
  solid.shape = spawn.shape;
  solid.name = spawn.name;
  solid.pose = pose_at(spawn.position_m, spawn.yaw_rad);
  solid.size_m = spawn.size_m;
  plant_.put(solid, spawn.colour, spawn.mass_kg);
}

}  // namespace gaitway::simulator
