// Decides whether a motion that is asked for may begin now, and says why not.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/motion_player.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::trajectory {

// How the robot is when the request is looked at.
struct MotionCircumstances {
  std::int64_t now_ns = 0;
  bool follows = true;                 // batches are played; not a safe tail, nor an emergency stop
  bool falls = false;                  // and its joints are busy with it
  bool stands = true;                  // at rest, and is not told to walk
  const Estimate* estimate = nullptr;  // nullptr: not known
  const JointStates* joints = nullptr;
};

struct MotionOrder {
  enum class Kind : std::uint8_t { none, play, leave };
  Kind kind = Kind::none;
  std::size_t motion = 0;  // of play
};

class MotionAdmission {
 public:
  MotionAdmission(const std::vector<MotionTable>& motions, const urdf::RobotModel& robot);

  // Answers a request that has not been answered yet, in `state`; nothing for one that has, or that is older
  // than kLifetime_ns: who asked has gone, or this plug-in has just begun. No allocation.
  [[nodiscard]] std::optional<MotionOrder> answer(const MotionRequest& request,
                                                  const MotionCircumstances& now, const MotionPlayer& player,
                                                  gaitway::MotionState& state) noexcept;

  // Where the references are, from the home angles; empty when that is not known. Until the next call.
  [[nodiscard]] std::span<const double> offsets(const MotionCircumstances& now) noexcept;

  static constexpr std::int64_t kLifetime_ns = 500'000'000;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.seen_);
  }

 private:
  // Why not; empty: it may.
  [[nodiscard]] std::string_view objection(const MotionTable& motion, const MotionCircumstances& now,
                                           const MotionPlayer& player) const noexcept;

  std::string known_;  // names, for who asks for another one
  std::vector<double> home_rad_, offset_rad_;
  std::uint32_t seen_ = 0;
};

}  // namespace gaitway::trajectory
