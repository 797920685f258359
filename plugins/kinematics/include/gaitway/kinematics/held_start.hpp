// Leads the joints from where they are held to a plan that begins elsewhere.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

// A plan of a robot that holds still begins with a jump if whoever made it takes the joints to be elsewhere:
// such a batch would be refused, and so would the next one. Here each joint sets out from where it is held,
// and what it is beside the plan goes smoothly to zero over this batch and as many as it takes: slowly, since
// the body is to follow without being thrown. No allocation, no exception after construction.
class HeldStart {
 public:
  explicit HeldStart(const urdf::RobotModel& model);

  // What is changed in a plan, for an event.
  struct Detour {
    std::size_t joint = 0;  // that has the longest way
    double way_rad = 0.0;
    double time_s = 0.0;
  };

  // Once for each batch, after it is solved. held_rad: the joints' references, in the model's order, of a
  // robot that holds them, so that the batch begins there; empty: the batch goes on from the one before,
  // which played. Returns whether a new detour begins, and fills `detour` then.
  bool apply(std::span<const double> held_rad, JointPlan& plan, Detour& detour) noexcept;
  // Before a batch that sets out by itself from where the last one has come to.
  void forget() noexcept { way_.points = 0; }
  // The last batch was refused, or is solved once more.
  void take_back() noexcept { way_ = way_before_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.way_.points, self.way_.played, self.way_.beside_rad);
  }

 private:
  struct Way {
    std::uint32_t points = 0;  // 0: none
    std::uint32_t played = 0;  // before the next batch
    std::array<double, kMaxJoints> beside_rad{};
  };
  [[nodiscard]] Way begin(std::span<const double> held_rad, const JointPlan& plan,
                          Detour& detour) const noexcept;

  std::vector<double> most_rad_per_s_, noticeable_rad_;  // of each joint
  Way way_, way_before_;
};

}  // namespace gaitway::kinematics
