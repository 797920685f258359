// The whole robot in virtual time, told what happens on the time line and when: the same gives the same to
// the bit, which its digest shows.
#pragma once

#include <cstdint>
#include <deque>
#include <memory>
#include <span>

#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/run_digest.hpp"
#include "gaitway/timeline/timed_event.hpp"

namespace gaitway::timeline {

class ReplayedRun final : public simulator::CosimulationObserver {
 public:
  // Throws what the co-simulation throws. `options.memory_block` is not used: the run has its own.
  ReplayedRun(const urdf::RobotModel& robot, simulator::CosimulationOptions options);
  ReplayedRun(const ReplayedRun&) = delete;
  ReplayedRun& operator=(const ReplayedRun&) = delete;

  // Further events, in order of time and not before now.
  void expect(std::span<const TimedEvent> events);
  // What is expected now, before the millisecond that comes next. Throws what an event throws that cannot be
  // applied.
  void apply_due();
  // With all that is expected before `to_ns`. Throws what an event throws that cannot be applied.
  void advance_to(std::int64_t to_ns);

  [[nodiscard]] simulator::Cosimulation& run() noexcept { return *run_; }
  [[nodiscard]] const simulator::Cosimulation& run() const noexcept { return *run_; }
  [[nodiscard]] msgclient::MemoryBlock& memory_block() noexcept { return block_; }
  // Of every frame and every state since the start.
  [[nodiscard]] std::uint64_t digest() const noexcept { return digest_.value(); }
  // Is told of everything, too; nullptr: nobody is.
  void observe(simulator::CosimulationObserver* observer) noexcept { further_ = observer; }

 private:
  void on_frame(const can::SimulatedBus::Delivery& delivery) override;
  void on_millisecond(std::int64_t now_ns) override;
  void on_orders(const msgcontroller::PassedOrders& orders, std::int64_t now_ns) override;

  msgclient::MemoryBlock block_;
  std::unique_ptr<simulator::Cosimulation> run_;
  std::deque<TimedEvent> expected_;
  simulator::RunDigest digest_;
  simulator::CosimulationObserver* further_ = nullptr;
};

}  // namespace gaitway::timeline
