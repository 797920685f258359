// Judges the batches that the main controller hands over, and gives those that can be played to the joints.
#pragma once

#include <cstdint>
#include <memory>
#include <span>

#include "gaitway/msgclient/emi_adapter.hpp"
#include "gaitway/msgclient/hand_over.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"
#include "gaitway/msgcontroller/hand_movement.hpp"
#include "gaitway/msgcontroller/joint_supervision.hpp"
#include "gaitway/msgcontroller/playback.hpp"

namespace gaitway::msgcontroller {

class BatchIntake {
 public:
  // All references outlive it.
  BatchIntake(const urdf::RobotModel& robot, BusLink& link, Playback& playback, JointSupervision& supervision,
              HandMovement& hand, msgclient::EmiMessage& adapter);

  // Takes the hand-over that has come, if any, and answers it. `stopping`: a stop was asked for, and its tail
  // plays first. The trim gains of the batch that was accepted now; null: none was.
  const msgclient::TrimGains* take(std::int64_t now_ns, bool stopping, bool on_their_own) noexcept;

  // Latest hand-over, before its cycle begins: the trajectory frames must have arrived by then.
  [[nodiscard]] std::int64_t lead_ns() const noexcept { return lead_ns_; }
  // Hand-overs that were refused for no other reason than that a stop was under way.
  [[nodiscard]] std::uint64_t refused_by_a_stop() const noexcept { return refused_by_a_stop_; }

 private:
  void judge(std::int64_t now_ns, bool stopping, bool on_their_own, msgclient::Answer& answer) noexcept;
  [[nodiscard]] msgclient::Reason untimely(std::int64_t now_ns) const noexcept;
  [[nodiscard]] CountPlanProblem motion_without_node(std::span<const std::int32_t> start) const noexcept;

  BusLink& link_;
  Playback& playback_;
  JointSupervision& supervision_;
  HandMovement& hand_;
  msgclient::EmiMessage& adapter_;
  std::int64_t lead_ns_;
  std::uint64_t refused_by_a_stop_ = 0;
  std::unique_ptr<msgclient::HandOver> hand_over_;  // large: kept off the stack
  std::unique_ptr<CountPlan> plan_;
};

}  // namespace gaitway::msgcontroller
