// The choice between the closed form and the general solvers.
#include "gaitway/kinematics/leg_solver.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace gaitway::kinematics {
namespace {

std::variant<ClosedFormLeg, GeneralLeg, KdlLeg> make_leg(const urdf::RobotModel& model, urdf::Side side,
                                                         SolverChoice choice, std::string& reason) {
  if (choice == SolverChoice::kdl) return KdlLeg(model, side);
  LegRecognition recognition = recognise_leg(model, side);
  if (recognition.geometry) return ClosedFormLeg(*recognition.geometry);
  if (choice == SolverChoice::closed_form) {
    throw urdf::RobotError(
        fmt::format("{}: the {} leg has no closed-form inverse kinematics: {}; choose solver 'auto' "
                    "or 'kdl'",
                    model.name, side == urdf::Side::left ? "left" : "right", recognition.reason));
  }
  reason = std::move(recognition.reason);
  return GeneralLeg(model, side);
}

}  // namespace

SolverChoice solver_choice(const std::string& name) {
  if (name == "auto") return SolverChoice::automatic;
  if (name == "closed_form") return SolverChoice::closed_form;
  if (name == "kdl") return SolverChoice::kdl;
  throw std::invalid_argument(fmt::format("solver: '{}' is none of 'auto', 'closed_form', 'kdl'", name));
}

LegSolver::LegSolver(const urdf::RobotModel& model, urdf::Side side, SolverChoice choice)
    : leg_(make_leg(model, side, choice, reason_)) {}

}  // namespace gaitway::kinematics
