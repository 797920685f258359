// Pinocchio's leg: the loop of its manual ("Inverse kinematics (clik)") on the leg's chain alone.
#include <Eigen/Cholesky>
#include <cmath>
#include <pinocchio/algorithm/jacobian.hpp>
#include <pinocchio/algorithm/joint-configuration.hpp>
#include <pinocchio/algorithm/kinematics.hpp>
#include <pinocchio/multibody.hpp>
#include <pinocchio/spatial.hpp>
#include <utility>

#include "leg_rival.hpp"

namespace gaitway::peers {
namespace {

pinocchio::SE3 se3(const Eigen::Isometry3d& pose) {
  return {pose.linear(), pose.translation()};
}

class PinocchioLeg final : public LegRival {
 public:
  PinocchioLeg(const urdf::RobotModel& robot, urdf::Side side, double step)
      : LegRival(step < 1.0 ? "Pinocchio CLIK, step " + std::to_string(step).substr(0, 3) : "Pinocchio CLIK"),
        step_(step) {
    pinocchio::JointIndex last = 0;
    for (const int index : robot.legs[static_cast<std::size_t>(side)].joints) {
      const urdf::Joint& joint = robot.joints.at(static_cast<std::size_t>(index));
      last = add(last, joint);
    }
    last_ = last;
    sole_ = se3(robot.feet[static_cast<std::size_t>(side)].sole);
    data_ = pinocchio::Data(model_);
    jacobian_.setZero();
  }
  void set_goals(const std::vector<Eigen::Isometry3d>& soles) override {
    goals_.clear();
    for (const Eigen::Isometry3d& sole : soles) goals_.push_back(se3(sole) * sole_.inverse());  // of the foot
  }
  bool solve(std::size_t goal, const LegAngles& start_rad, LegAngles& angle_rad) override {
    angle_ = Eigen::Map<const Vector6>(start_rad.data());
    const bool solved = iterate(goals_[goal]);
    for (std::size_t i = 0; i < 6; ++i) {
      angle_rad[i] = std::remainder(angle_[static_cast<Eigen::Index>(i)], 2.0 * M_PI);
    }
    return solved;
  }

 private:
  using Vector6 = Eigen::Matrix<double, 6, 1>;
  using Matrix6 = Eigen::Matrix<double, 6, 6>;
  static constexpr double kDamping = 1e-12;  // the manual's

  // About a coordinate axis where it is one, as Pinocchio's own reader of URDF does: that is quicker.
  pinocchio::JointIndex add(pinocchio::JointIndex parent, const urdf::Joint& joint) {
    const pinocchio::SE3 placement = se3(joint.origin);
    const Eigen::Vector3d axis = joint.axis;
    if (axis == Eigen::Vector3d::UnitX()) {
      return model_.addJoint(parent, pinocchio::JointModelRX(), placement, joint.name);
    }
    if (axis == Eigen::Vector3d::UnitY()) {
      return model_.addJoint(parent, pinocchio::JointModelRY(), placement, joint.name);
    }
    if (axis == Eigen::Vector3d::UnitZ()) {
      return model_.addJoint(parent, pinocchio::JointModelRZ(), placement, joint.name);
    }
    return model_.addJoint(parent, pinocchio::JointModelRevoluteUnaligned(axis), placement, joint.name);
  }

  bool iterate(const pinocchio::SE3& goal) {
    for (int i = 0; i < kMostIterations; ++i) {
      pinocchio::forwardKinematics(model_, data_, angle_);
      const pinocchio::SE3 left = data_.oMi[last_].actInv(goal);
      const Vector6 error = pinocchio::log6(left).toVector();
      if (error.norm() < kTolerance) return true;
      pinocchio::computeJointJacobian(model_, data_, angle_, last_, jacobian_);
      Matrix6 of_log;
      pinocchio::Jlog6(left.inverse(), of_log);
      const Matrix6 towards = -of_log * jacobian_;
      Matrix6 normal = towards * towards.transpose();
      normal.diagonal().array() += kDamping;
      const Vector6 velocity = -towards.transpose() * normal.ldlt().solve(error);
      angle_ = pinocchio::integrate(model_, angle_, velocity * step_);
    }
    return false;
  }

  double step_;
  pinocchio::Model model_;
  pinocchio::Data data_;
  pinocchio::JointIndex last_ = 0;
  pinocchio::SE3 sole_ = pinocchio::SE3::Identity();
  std::vector<pinocchio::SE3> goals_;
  Eigen::VectorXd angle_{6};
  pinocchio::Data::Matrix6x jacobian_{6, 6};
};

}  // namespace

std::unique_ptr<LegRival> pinocchio_leg(const urdf::RobotModel& robot, urdf::Side side, double step) {
  return std::make_unique<PinocchioLeg>(robot, side, step);
}

}  // namespace gaitway::peers
