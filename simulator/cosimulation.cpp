// The whole chain in virtual time: moves physics, joints, bus and controllers on in lock-step, and does to
// them what a scenario asks.
#include "gaitway/simulator/cosimulation.hpp"

#include <algorithm>
#include <cstring>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

using facts::kMillisecond_ns;

// How long a walk goes on whose commander has gone.
constexpr std::int64_t kOrphanedWalk_ns = 500 * kMillisecond_ns;

}  // namespace

Cosimulation::Cosimulation(const urdf::RobotModel& robot, const CosimulationOptions& options)
    : robot_(robot),
      options_(options),
      own_block_(options.memory_block == nullptr ? std::optional<msgclient::MemoryBlock>(std::in_place)
                                                 : std::nullopt),
      memory_block_(own_block_ ? *own_block_ : *options.memory_block),
      adapter_(memory_block_),
      message_client_(memory_block_.local_client("message_controller")),
      behavior_client_(memory_block_.local_client("behavior")),
      observer_client_(memory_block_.local_client("observer")),
      main_client_(memory_block_.local_client("main_controller")),
      localization_client_(memory_block_.local_client("localization")),
      camera_client_(memory_block_.local_client("camera")),
      plant_(robot_, options.plant),
      joints_(robot_, options.plant.seed, options.largest_clock_drift_ppm),
      sensor_faults_(robot_, options.plant.seed),
      message_controller_(robot_, message_client_, adapter_.message()),
      message_transmitter_(bus_.attach()),
      fault_random_(options.plant.seed ^ 0xFA17'0000'0000'0001ULL) {
  for (int joint = 0; joint < joints_.size(); ++joint) {
    joint_transmitters_.emplace_back(bus_.attach());
  }
  foreign_station_ = bus_.attach();
  if (options_.obey_walk_requests) {
    walk_requests_.emplace(behavior_client_);
    motion_requests_.emplace(behavior_client_);
    way_requests_.emplace(behavior_client_);
  } else if (!options_.plugin_commands_walk) {
    walk_command_.emplace(behavior_client_.write<WalkCommand>("walk_command"));
    walk_command_->publish(WalkCommand{}, 0);
    motion_command_.emplace(behavior_client_.write<MotionRequest>("motion_command"));
    walk_to_command_.emplace(behavior_client_.write<WalkToRequest>("walk_to_command"));
  }
  if (options_.localization.is_there) {
    localization_.emplace(localization_client_, options_.localization, options_.plant.seed);
  }
  if (const auto camera = urdf::stereo_camera_of(robot_)) {
    camera_ =
        std::make_unique<StereoCamera>(camera_client_, robot_, *camera, options_.camera, options_.plant);
  }
  options_.main_controller.injected_faults = &plugin_faults_;
  main_controller_ =
      std::make_unique<core::MainController>(robot_, main_client_, adapter_.host(), options_.main_controller);
}

Cosimulation::~Cosimulation() = default;

void Cosimulation::advance_millisecond() {
  finish_restarts();
  memory_block_.beat(now_ns_);
  if (walk_requests_) {
    const auto command = walk_requests_->step(now_ns_);
    if (command && observer_ != nullptr) {
      observer_->on_walk_request(*command, now_ns_);
    }
    const auto motion = motion_requests_->step(now_ns_);
    if (motion && observer_ != nullptr) {
      observer_->on_motion_request(*motion, now_ns_);
    }
    const auto way = way_requests_->step(now_ns_);
    if (way && observer_ != nullptr) {
      observer_->on_way_request(*way, now_ns_);
    }
  }
  if (localization_) {
    localization_->step(now_ns_, plant_);
  }
  if (camera_) {
    camera_->step(now_ns_, plant_, main_controller_->plugins().plugins().uses(camera_->topic()));
  }
  joints_.step(now_ns_, sensor_faults_.told(plant_.sensors(), now_ns_));
  message_controller_.step(now_ns_);
  memory_block_.beat(now_ns_);
  if (core::is_tick(now_ns_) && now_ns_ >= std::max(silent_until_ns_, busy_until_ns_)) {
    main_controller_tick();
  }
  exchange_frames(now_ns_ + kMillisecond_ns);
  plant_.step(joints_.torque_Nm());
  now_ns_ += kMillisecond_ns;
  if (observer_ != nullptr) {
    observer_->on_millisecond(now_ns_);
  }
}

void Cosimulation::main_controller_tick() {
  const core::TickReport report = main_controller_->step(now_ns_);
  main_controller_->maintain(now_ns_);
  const std::int64_t cost_ns =
      (report.batch ? options_.batch_cost_ns : options_.tick_cost_ns) + report.declared_cost_ns;
  busy_until_ns_ = now_ns_ + report.declared_cost_ns;
  if (report.posted) {
    ring_at(now_ns_ + cost_ns + report.transfer_ns);
  }
}

void Cosimulation::ring_at(std::int64_t due_ns) {
  const auto later = std::ranges::upper_bound(doorbells_due_ns_, due_ns);
  doorbells_due_ns_.insert(later, due_ns);
}

void Cosimulation::exchange_frames(std::int64_t until_ns) {
  offer_from_message_controller(now_ns_);
  for (int joint = 0; joint < joints_.size(); ++joint) {
    offer_from_joint(joint, now_ns_);
  }
  if (!foreign_frames_.empty() && bus_.transmit(foreign_station_, foreign_frames_.front(), now_ns_)) {
    foreign_frames_.erase(foreign_frames_.begin());
  }
  while (true) {
    const bool rings = !doorbells_due_ns_.empty() && doorbells_due_ns_.front() < until_ns;
    const std::int64_t stop_ns = rings ? std::max(doorbells_due_ns_.front(), now_ns_) : until_ns;
    while (const auto delivery = bus_.advance(stop_ns)) {
      deliver(*delivery);
    }
    report_errors();
    report_bus_states();
    if (!rings) {
      return;
    }
    doorbells_due_ns_.erase(doorbells_due_ns_.begin());
    message_controller_.take_mails(stop_ns);
    offer_from_message_controller(stop_ns);
  }
}

void Cosimulation::deliver(const can::SimulatedBus::Delivery& delivery) {
  if (observer_ != nullptr) {
    observer_->on_frame(delivery);
  }
  report_bus_states();
  message_transmitter_.on_delivery(delivery);
  if (delivery.received_by(message_transmitter_.station())) {
    message_controller_.on_frame(delivery.frame, delivery.end_ns);
  } else if (delivery.sent_by(message_transmitter_.station())) {
    message_controller_.on_notice(
        {can::BusNotice::Kind::sent, {delivery.frame, delivery.start_ns, delivery.end_ns}});
  }
  for (int joint = 0; joint < joints_.size(); ++joint) {
    can::StationTransmitter& transmitter = joint_transmitters_[static_cast<std::size_t>(joint)];
    transmitter.on_delivery(delivery);
    if (delivery.received_by(transmitter.station())) {
      joints_.on_frame(joint, delivery.frame, delivery.end_ns);
    }
  }
  for (int joint = 0; joint < joints_.size(); ++joint) {
    offer_from_joint(joint, delivery.end_ns);  // an answer to a SYNC goes out at once
  }
  offer_from_message_controller(delivery.end_ns);
}

void Cosimulation::report_errors() {
  while (const auto error = bus_.next_error_frame()) {
    message_controller_.on_notice({can::BusNotice::Kind::error, {{}, error->error_ns, error->error_ns}});
  }
}

// A station that is off the bus keeps nothing for its return: it would be stale.
void Cosimulation::report_bus_states() {
  while (const auto change = bus_.next_state_change()) {
    if (change->station == message_transmitter_.station()) {
      if (change->state >= can::BusState::bus_off) {
        message_transmitter_.withdraw(bus_, message_controller_);
      }
      message_controller_.on_bus_state(change->state, change->counters, change->time_ns);
    } else if (change->state >= can::BusState::bus_off) {
      bus_.abort(change->station);
    }
  }
}

void Cosimulation::offer_from_message_controller(std::int64_t now_ns) {
  if (options_.message_port_takes_back ||
      (!message_transmitter_.pending() && message_controller_.next_finds_quiet_bus(now_ns))) {
    message_transmitter_.offer(bus_, message_controller_, now_ns);
  }
}

void Cosimulation::offer_from_joint(int joint, std::int64_t now_ns) {
  joints_.offer(joint, joint_transmitters_[static_cast<std::size_t>(joint)], bus_, now_ns);
}

void Cosimulation::finish_restarts() {
  const auto done = [this](const Restart& restart) {
    if (restart.until_ns > now_ns_) {
      return false;
    }
    joints_.power_on(restart.joint, sensor_faults_.told(plant_.sensors(), now_ns_));
    bus_.power_on(joint_transmitters_[static_cast<std::size_t>(restart.joint)].station(), now_ns_);
    return true;
  };
  restarts_.erase(std::remove_if(restarts_.begin(), restarts_.end(), done), restarts_.end());
  if (disturbed_until_ns_ != 0 && now_ns_ >= disturbed_until_ns_) {
    disturbed_until_ns_ = 0;
    bus_.set_random_faults({});
  }
}

void Cosimulation::hand_to_people() {
  walk_command_.reset();
  motion_command_.reset();
  walk_to_command_.reset();
  WalkCommand in_force = scenario_walk_;
  if (in_force.walk != 0) in_force.valid_until_ns = now_ns_ + kOrphanedWalk_ns;
  walk_requests_.emplace(behavior_client_, in_force);
  motion_requests_.emplace(behavior_client_, msgcontroller::Waiting::dropped);
  way_requests_.emplace(behavior_client_, msgcontroller::Waiting::dropped);
  options_.obey_walk_requests = true;
}

void Cosimulation::end_walk_requests() {
  if (walk_requests_) {
    walk_requests_->end(now_ns_);
    motion_requests_->end();
    way_requests_->end();
  }
}

}  // namespace gaitway::simulator
