// Plays prepared motions, batch by batch, each with a safe tail that leaves the motion from there.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/trajectory/footstep_planner.hpp"
#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::trajectory {

// Where the robot stands before and after a motion.
struct Stand {
  Pose2 middle;  // between the sole origins
  double com_forward_m = 0.0, hip_height_m = 0.0, foot_spacing_m = 0.0;

  [[nodiscard]] Eigen::Vector2d com_m() const noexcept { return middle.transform(com_forward_m, 0.0); }
  [[nodiscard]] Eigen::Vector2d foot_m(std::size_t side) const noexcept {
    return middle.transform(0.0, (side == 0 ? 0.5 : -0.5) * foot_spacing_m);
  }
};

// Values of MotionState::state and MotionState::result.
enum class MotionStage : std::uint32_t { none = 0, approach = 1, path = 2, leaving = 3 };
enum class MotionResult : std::uint32_t { none = 0, finished = 1, left = 2, broken_off = 3 };

// No allocation, no exception after construction.
class MotionPlayer {
 public:
  explicit MotionPlayer(std::vector<MotionTable> motions) : motions_(std::move(motions)) {}

  [[nodiscard]] const std::vector<MotionTable>& motions() const noexcept { return motions_; }
  [[nodiscard]] std::optional<std::size_t> find(std::string_view name) const noexcept;

  // The next batch begins it. from_rad: of a motion on the ground: where the references are, from the home
  // angles, in the joints' order; the robot goes from there to the first posture.
  void start(std::size_t motion, const Stand& stand, std::span<const double> from_rad) noexcept;
  // From the next batch on, by the way that the tail would have taken.
  void leave() noexcept;
  // It is over: somebody else moves the joints.
  void break_off() noexcept;

  [[nodiscard]] bool plays() const noexcept { return state_.stage != MotionStage::none; }
  // Rests on the ground since a motion there was left or broken off: no stand may be planned.
  [[nodiscard]] bool lies() const noexcept { return state_.lies; }

  // The next batch and its tail. Only while it plays.
  void plan(std::uint32_t sequence, std::int64_t start_ns, MotionPlan& plan, PosturePlan& posture) noexcept;

  // All but the answers to requests.
  void tell(gaitway::MotionState& state) const noexcept;

  // What a successor goes on from; one that has not this motion breaks it off.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.state_);
    if constexpr (!std::is_const_v<Self>) self.resume();
  }

 private:
  // A point of the motion: of a way, or between the start of the approach and its end.
  struct Place {
    const MotionWay* way = nullptr;
    std::size_t point = 0;
    double approach_share = 1.0;
  };
  struct State {
    MotionStage stage = MotionStage::none;
    MotionResult result = MotionResult::none;
    std::uint32_t motion = 0, ended = 0;
    std::uint32_t batches = 0;          // of the path; while leaving: after which the exit was taken
    std::uint32_t points = 0;           // of the approach or of the exit, that are played
    std::uint32_t approach_points = 0;  // whole batches
    bool lies = false;
    Stand stand;
    std::array<std::uint8_t, 48> name{};
    std::array<float, kMaxJoints> from_rad{};
  };

  void resume() noexcept;
  void end(MotionResult result) noexcept;
  void advance() noexcept;
  [[nodiscard]] const MotionTable& table() const noexcept { return motions_[state_.motion]; }
  [[nodiscard]] Place place_in(MotionStage stage, std::size_t batches, std::size_t point) const noexcept;
  void write(const Place& place, std::size_t index, MotionPlan& plan, PosturePlan& posture) const noexcept;

  std::vector<MotionTable> motions_;
  State state_;
};

}  // namespace gaitway::trajectory
