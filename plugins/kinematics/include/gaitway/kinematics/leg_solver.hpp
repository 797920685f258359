// The inverse kinematics of one leg, whichever way it is solved.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <string>
#include <variant>

#include "gaitway/kinematics/closed_form_leg.hpp"
#include "gaitway/kinematics/general_leg.hpp"
#include "gaitway/kinematics/kdl_leg.hpp"
#include "gaitway/kinematics/leg_solution.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::kinematics {

enum class SolverChoice { automatic, closed_form, kdl };

// "auto", "closed_form" or "kdl"; anything else throws std::invalid_argument with these names.
[[nodiscard]] SolverChoice solver_choice(const std::string& name);

// Any of them, behind one call.
class LegSolver {
 public:
  // automatic: closed form where the leg has one, else the general solver. closed_form: throws
  // urdf::RobotError with the reason if it has none.
  LegSolver(const urdf::RobotModel& model, urdf::Side side, SolverChoice choice);

  // base_from_sole: pose of the sole frame in the base frame. No allocation.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole) {
    if (const auto* closed_form = std::get_if<ClosedFormLeg>(&leg_))
      return closed_form->solve(base_from_sole);
    if (const auto* general = std::get_if<GeneralLeg>(&leg_)) return general->solve(base_from_sole);
    return std::get<KdlLeg>(leg_).solve(base_from_sole);
  }
  // The same from a posture near by, which saves the general solver iterations; the others do not look at it.
  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole,
                                  const std::array<double, 6>& start_rad) {
    if (const auto* general = std::get_if<GeneralLeg>(&leg_))
      return general->solve(base_from_sole, start_rad);
    return solve(base_from_sole);
  }
  [[nodiscard]] bool wants_start() const noexcept { return std::holds_alternative<GeneralLeg>(leg_); }

  [[nodiscard]] bool closed_form() const noexcept { return std::holds_alternative<ClosedFormLeg>(leg_); }
  // Why an automatic choice fell on the general solver; else empty.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string reason_;
  std::variant<ClosedFormLeg, GeneralLeg, KdlLeg> leg_;
};

}  // namespace gaitway::kinematics
