// Applies what is expected, millisecond by millisecond.
#include "gaitway/timeline/replayed_run.hpp"

#include <utility>

namespace gaitway::timeline {
namespace {

simulator::CosimulationOptions with_block(simulator::CosimulationOptions options,
                                          msgclient::MemoryBlock& block) {
  options.memory_block = &block;
  return options;
}

}  // namespace

ReplayedRun::ReplayedRun(const urdf::RobotModel& robot, simulator::CosimulationOptions options)
    : run_(std::make_unique<simulator::Cosimulation>(robot, with_block(std::move(options), block_))) {
  run_->observe(this);
}

void ReplayedRun::expect(std::span<const TimedEvent> events) {
  expected_.insert(expected_.end(), events.begin(), events.end());
}

void ReplayedRun::apply_due() {
  for (; !expected_.empty() && expected_.front().at_ns <= run_->now_ns(); expected_.pop_front()) {
    run_->apply(scenario_event(expected_.front(), run_->robot()));
  }
}

void ReplayedRun::advance_to(std::int64_t to_ns) {
  while (run_->now_ns() < to_ns) {
    apply_due();
    run_->advance_millisecond();
  }
}

void ReplayedRun::on_frame(const can::SimulatedBus::Delivery& delivery) {
  digest_.add(delivery.frame, delivery.start_ns);
  if (further_ != nullptr) further_->on_frame(delivery);
}
void ReplayedRun::on_millisecond(std::int64_t now_ns) {
  digest_.add(run_->plant().positions());
  digest_.add(run_->plant().velocities());
  if (further_ != nullptr) further_->on_millisecond(now_ns);
}
void ReplayedRun::on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns) {
  if (further_ != nullptr) further_->on_orders(orders, now_ns);
}

}  // namespace gaitway::timeline
