// The whole chain in virtual time: moves physics, joints, bus and controllers on in lock-step, and does to
// them what a scenario asks.
#include "gaitway/simulator/cosimulation.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

using facts::kMillisecond_ns;

// How long a walk goes on whose commander has gone.
constexpr std::int64_t kOrphanedWalk_ns = 500 * kMillisecond_ns;
// From a fresh message controller to the first tick of the main controller that is started with it.
constexpr std::int64_t kMainControllerStarts_ns = 200 * kMillisecond_ns;

}  // namespace

Cosimulation::Cosimulation(const urdf::RobotModel& robot, const CosimulationOptions& options)
    : robot_(robot),
      options_(options),
      own_block_(options.memory_block == nullptr ? std::optional<msgclient::MemoryBlock>(std::in_place)
                                                 : std::nullopt),
      memory_block_(own_block_ ? *own_block_ : *options.memory_block),
      adapter_(memory_block_),
      message_client_(memory_block_.local_client("message_controller")),
      arbiter_client_(memory_block_.local_client("arbiter")),
      observer_client_(memory_block_.local_client("observer")),
      main_client_(memory_block_.local_client("main_controller")),
      localization_client_(memory_block_.local_client("localization")),
      camera_client_(memory_block_.local_client("camera")),
      plant_(robot_, options.plant),
      joints_(robot_, options.plant.seed, options.largest_clock_drift_ppm, options.plant.mismatch),
      sensor_faults_(robot_, options.plant.seed),
      message_transmitter_(bus_.attach()),
      fault_random_(options.plant.seed ^ 0xFA17'0000'0000'0001ULL) {
  for (int joint = 0; joint < joints_.size(); ++joint) {
    joint_transmitters_.emplace_back(bus_.attach());
  }
  foreign_station_ = bus_.attach();
  start_message_controller();
  if (options_.localization.is_there) {
    localization_.emplace(localization_client_, options_.localization, options_.plant.seed);
  }
  if (const auto camera = urdf::stereo_camera_of(robot_)) {
    camera_ =
        std::make_unique<StereoCamera>(camera_client_, robot_, *camera, options_.camera, options_.plant);
  }
  options_.main_controller.injected_faults = &plugin_faults_;
  options_.main_controller.simulated = true;
  start_main_controller();
}

Cosimulation::~Cosimulation() = default;

void Cosimulation::start_message_controller() {
  message_controller_.reset();
  arbiter_.reset();
  arbiter_.emplace(arbiter_client_);
  message_controller_.emplace(robot_, message_client_, adapter_.message());
  message_controller_->tell_commands(&*arbiter_);
}

void Cosimulation::start_main_controller() {
  main_controller_.reset();
  main_controller_ =
      std::make_unique<core::MainController>(robot_, main_client_, adapter_.host(), options_.main_controller);
}

void Cosimulation::inject(const MessageControllerSilentFault& fault) {
  silent_since_ns_ = now_ns_;
  message_silent_until_ns_ = fault.duration_s > 0.0
                                 ? now_ns_ + static_cast<std::int64_t>(std::llround(fault.duration_s * 1e9))
                                 : std::numeric_limits<std::int64_t>::max();
  message_controller_restarts_ = fault.restarts;
}

void Cosimulation::finish_silence() {
  if (message_silent_until_ns_ == 0 || now_ns_ < message_silent_until_ns_) {
    return;
  }
  message_silent_until_ns_ = 0;
  if (message_controller_restarts_) {
    start_message_controller();
    start_main_controller();
    main_controller_->plugins().events().add(
        core::tick_at(now_ns_), core::EventKind::info, "main_controller",
        fmt::format("message controller is back after {:.2f} s, as a new process; so is the main controller",
                    static_cast<double>(now_ns_ - silent_since_ns_) * 1e-9));
    silent_until_ns_ = std::max(silent_until_ns_, now_ns_ + kMainControllerStarts_ns);
  }
}

void Cosimulation::advance_millisecond() {
  finish_restarts();
  finish_silence();
  if (message_controller_works()) {
    memory_block_.beat(now_ns_);
    const msgcontroller::PassedOrders orders =
        arbiter_->step(now_ns_, message_controller_->mode() == msgcontroller::Mode::emergency_stop);
    if (observer_ != nullptr) observer_->on_orders(orders, now_ns_);
  }
  if (localization_) {
    localization_->step(now_ns_, plant_);
  }
  if (camera_) {
    camera_->step(now_ns_, plant_, main_controller_->plugins().plugins().uses(camera_->topic()));
  }
  joints_.step(now_ns_, sensor_faults_.told(plant_.sensors(), now_ns_));
  if (message_controller_works()) {
    message_controller_->step(now_ns_);
    memory_block_.beat(now_ns_);
  }
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
    if (message_controller_works()) {
      message_controller_->take_mails(stop_ns);
    }
    offer_from_message_controller(stop_ns);
  }
}

void Cosimulation::deliver(const can::SimulatedBus::Delivery& delivery) {
  if (observer_ != nullptr) {
    observer_->on_frame(delivery);
  }
  report_bus_states();
  message_transmitter_.on_delivery(delivery);
  if (!message_controller_works()) {
    // nobody is there to hear it
  } else if (delivery.received_by(message_transmitter_.station())) {
    message_controller_->on_frame(delivery.frame, delivery.end_ns);
  } else if (delivery.sent_by(message_transmitter_.station())) {
    message_controller_->on_notice(
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
    if (message_controller_works())
      message_controller_->on_notice({can::BusNotice::Kind::error, {{}, error->error_ns, error->error_ns}});
  }
}

// A station that is off the bus keeps nothing for its return: it would be stale.
void Cosimulation::report_bus_states() {
  while (const auto change = bus_.next_state_change()) {
    if (change->station == message_transmitter_.station()) {
      if (change->state >= can::BusState::bus_off) {
        message_transmitter_.withdraw(bus_, *message_controller_);
      }
      message_controller_->on_bus_state(change->state, change->counters, change->time_ns);
    } else if (change->state >= can::BusState::bus_off) {
      bus_.abort(change->station);
    }
  }
}

void Cosimulation::offer_from_message_controller(std::int64_t now_ns) {
  if (!message_controller_works()) {
    return;
  }
  if (options_.message_port_takes_back ||
      (!message_transmitter_.pending() && message_controller_->next_finds_quiet_bus(now_ns))) {
    message_transmitter_.offer(bus_, *message_controller_, now_ns);
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
  arbiter_->begin_anew_with_people(now_ns_ + kOrphanedWalk_ns);
  options_.people_outside = true;
}

}  // namespace gaitway::simulator
