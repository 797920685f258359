// What a scenario asks of the robot, and does to it: each event where it takes effect.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <memory>
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
  bus_.set_loss([this](const can::Frame& frame, std::int64_t start_ns) {
    const double unit = static_cast<double>(fault_random_() >> 11U) * 0x1.0p-53;
    return start_ns < losses_until_ns_ && unit < loss_probability_ && is_in_losses(frame);
  });
}

bool Cosimulation::is_in_losses(const can::Frame& frame) const {
  if (losses_of_joint_ < 0) return true;
  const auto of = message_controller_->profile().identify(frame.id);
  return of && of->kind == can::MessageKind::trajectory &&
         of->node == robot_.joints[static_cast<std::size_t>(losses_of_joint_)].node;
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

void Cosimulation::inject(const MissesFramesFault& fault) {
  disturbed_until_ns_ = now_ns_ + duration_ns(fault.duration_s);
  bus_.set_random_faults(
      {.seed = fault_random_(), .omission = 1.0, .victims = can::StationSet::of(station_of(fault.node))});
}

void Cosimulation::inject(const BatchFault& fault) {
  using How = BatchFault::How;
  msgclient::EmiFaults& faults = adapter_.host().faults();
  if (fault.how == How::late) {
    faults.delay_next_ns = duration_ns(fault.late_s);
  } else if (fault.how == How::damaged) {
    constexpr std::uint32_t kSomePoint = 77, kSomeBit = 1U << 19U;
    faults.flip_next = msgclient::EmiFaults::Flip{msgclient::MailKind::hand_over, kSomePoint, kSomeBit};
  } else {
    hand_over_wrongly(fault.how);
  }
}

// Without any plan so far there is nothing to hand over.
void Cosimulation::hand_over_wrongly(BatchFault::How how) {
  using How = BatchFault::How;
  const auto plan = std::make_unique<JointPlan>();
  const auto hand_over = std::make_unique<msgclient::HandOver>();
  TrimCommand trim{};
  static_cast<void>(observer_client_.read<TrimCommand>("trim").read(trim));
  if (!observer_client_.read<JointPlan>("joint_plan").read(*plan) ||
      !msgclient::make_hand_over(*plan, trim, *hand_over)) {
    return;
  }
  hand_over->sequence = message_controller_->state().cycle + (how == How::old     ? 0U
                                                              : how == How::early ? 2U
                                                                                  : 1U);
  for (float& position : hand_over->position) {
    constexpr double kWidth_rad = 2.0;
    const double unit = static_cast<double>(fault_random_() >> 11U) * 0x1.0p-53;
    if (how == How::garbage) position = static_cast<float>(kWidth_rad * (unit - 0.5));
  }
  ring_at(now_ns_ + adapter_.host().post(*hand_over, now_ns_).transfer_ns);
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
    void operator()(const WalkEvent& walk) const { self.order(walk); }
    void operator()(const MotionEvent& motion) const { self.order(motion); }
    void operator()(const WalkToEvent& way) const { self.order(way); }
    void operator()(const HeadEvent& head) const { self.order(head); }
    void operator()(const CommandEvent& command) const { self.arbiter_->order(command.verb, self.now_ns_); }
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
    void operator()(const MessageControllerSilentFault& fault) const { self.inject(fault); }
    void operator()(const LoseFramesFault& fault) const {
      self.loss_probability_ = fault.probability;
      self.losses_until_ns_ = self.now_ns_ + duration_ns(fault.duration_s);
      self.losses_of_joint_ = fault.batch_of.empty() ? -1 : self.robot_.joint_index(fault.batch_of);
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
    void operator()(const MissesFramesFault& fault) const { self.inject(fault); }
    void operator()(const BatchFault& fault) const { self.inject(fault); }
    void operator()(const BabbleFault& fault) const {
      const int station = fault.node.empty() ? self.foreign_station_ : self.station_of(fault.node);
      self.bus_.babble(station, fault.frame, self.now_ns_, self.now_ns_ + duration_ns(fault.duration_s));
    }
    void operator()(const SupplySagsFault& fault) const {
      self.plant_.weaken_motors(fault.torque_factor, fault.duration_s);
    }
    void operator()(const JointDiesFault& fault) const {
      self.joints_.power_off(self.robot_.joint_index(fault.joint));
      self.bus_.power_off(self.station_of(fault.joint), self.now_ns_);
    }
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

void Cosimulation::demand_that_scenario_commands(const char* what) const {
  if (options_.people_outside) {
    throw std::invalid_argument(fmt::format("somebody outside alone commands {}", what));
  }
}

void Cosimulation::order(const WalkEvent& walk) {
  demand_that_scenario_commands("the walk");
  WalkCommand command{};
  command.walk = walk.walk ? 1U : 0U;
  command.velocity[0] = walk.velocity_m_per_s.x();
  command.velocity[1] = walk.velocity_m_per_s.y();
  command.turn_rate = walk.turn_rate_rad_per_s;
  arbiter_->order(command, now_ns_);
}

void Cosimulation::order(const MotionEvent& motion) {
  demand_that_scenario_commands("the motions");
  MotionRequest request{};
  request.number = ++motions_asked_;
  std::memcpy(request.name, motion.name.data(), std::min(motion.name.size(), sizeof request.name - 1));
  arbiter_->order(request, now_ns_);
}

void Cosimulation::order(const WalkToEvent& way) {
  demand_that_scenario_commands("the ways");
  WalkToRequest request{};
  request.number = ++ways_asked_;
  request.cancel = way.goal ? 0 : 1;
  if (way.goal) std::copy_n(way.goal->data(), way.goal->size(), request.goal);
  arbiter_->order(request, now_ns_);
}

void Cosimulation::order(const HeadEvent& head) {
  demand_that_scenario_commands("the head");
  HeadCommand command{};
  command.mode = static_cast<std::uint32_t>(head.mode);
  std::copy_n(head.direction_rad.data(), head.direction_rad.size(), command.direction);
  std::copy_n(head.point_m.data(), 3, command.point);
  command.extent = head.extent_rad;
  command.period = head.period_s;
  command.speed = head.speed_rad_per_s;
  arbiter_->order(command, now_ns_);
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
