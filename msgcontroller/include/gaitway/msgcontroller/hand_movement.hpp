// Single joints that people move while the robot stands.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/msgclient/mails.hpp"
#include "gaitway/msgcontroller/bus_link.hpp"
#include "gaitway/msgcontroller/joint_supervision.hpp"
#include "gaitway/msgcontroller/playback.hpp"

namespace gaitway::msgcontroller {

// A robot stands when nothing is left to play, or when all that is left, down to the end of its tail, keeps
// every joint within this of where its reference is now. A robot that keeps its balance never repeats its
// counts: the plans of the shipped one move its ankles by up to 0.012 rad, which is half of it. What a plan
// that is dropped leaves undone is no more than this, which a stand bears; a step or a motion leads further.
inline constexpr double kStandingSway_rad = 0.025;

class HandMovement {
 public:
  HandMovement(const urdf::RobotModel& robot, BusLink& link, Playback& playback,
               JointSupervision& supervision);

  // A joint is to move; it does so at once, or as soon as the running batch, which moves it still, is over.
  msgclient::Reason move(const msgclient::UserCommandMail& mail, std::int64_t now_ns) noexcept;
  void enter_slot() noexcept;
  // A stop: what waits for the end of the running batch is not begun.
  void stop() noexcept { waiting_.reset(); }
  // Whether a joint will still be moving so many slots from now.
  [[nodiscard]] bool moves_in(std::uint32_t slots) const noexcept {
    return moving_until_ > link_.slots_since_start + slots;
  }
  // Whoever moved a joint brings it back before batches go on: none pulls it back, be it in a time
  // slot or little by little.
  [[nodiscard]] CountPlanProblem pulled_back_by(const CountPlan& plan,
                                                std::span<const std::int32_t> start) const noexcept;
  // A batch was accepted, or every reference is new: no joint moves or is away any more.
  void forget() noexcept;

 private:
  [[nodiscard]] bool stands() const noexcept;
  [[nodiscard]] bool rests(std::uint32_t joint) const noexcept;
  void begin(const can::UserCommand& command, std::uint32_t joint) noexcept;

  BusLink& link_;
  Playback& playback_;
  JointSupervision& supervision_;
  std::array<std::int32_t, kMaxJoints> sway_counts_{};
  struct Waiting {
    can::UserCommand command;
    std::uint32_t joint;
  };
  std::optional<Waiting> waiting_;
  std::uint32_t moving_until_ = 0;  // slot since start at which the last movement has ended
  std::int64_t next_ns_ = 0;        // not before: user commands keep their period
  std::array<bool, kMaxJoints> moved_{};
};

}  // namespace gaitway::msgcontroller
