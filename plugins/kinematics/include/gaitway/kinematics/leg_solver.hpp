// The inverse kinematics of one leg, closed form or general, behind one call.
#pragma once

#include <Eigen/Geometry>
#include <string>
#include <variant>

#include "gaitway/kinematics/closed_form_leg.hpp"
#include "gaitway/kinematics/kdl_leg.hpp"

namespace gaitway::kinematics {

enum class SolverChoice { automatic, closed_form, kdl };

// "auto", "closed_form" or "kdl"; anything else throws std::invalid_argument with these names.
[[nodiscard]] SolverChoice solver_choice(const std::string& name);

class LegSolver {
 public:
  // automatic: closed form where the leg has one. closed_form: throws urdf::RobotError with the reason if
  // not.
  LegSolver(const urdf::RobotModel& model, urdf::Side side, SolverChoice choice);

  [[nodiscard]] LegSolution solve(const Eigen::Isometry3d& base_from_sole) {
    if (const auto* closed_form = std::get_if<ClosedFormLeg>(&leg_))
      return closed_form->solve(base_from_sole);
    return std::get<KdlLeg>(leg_).solve(base_from_sole);
  }

  [[nodiscard]] bool closed_form() const noexcept { return std::holds_alternative<ClosedFormLeg>(leg_); }
  // Why an automatic choice fell on the general solver; else empty.
  [[nodiscard]] const std::string& reason() const noexcept { return reason_; }

 private:
  std::string reason_;
  std::variant<ClosedFormLeg, KdlLeg> leg_;
};

}  // namespace gaitway::kinematics
