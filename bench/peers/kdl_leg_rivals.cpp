// Our leg and KDL's.
#include <cmath>
#include <kdl/chain.hpp>
#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainiksolverpos_lma.hpp>
#include <kdl/chainiksolverpos_nr_jl.hpp>
#include <kdl/chainiksolvervel_pinv.hpp>
#include <optional>
#include <utility>

#include "gaitway/kinematics/leg_solver.hpp"
#include "leg_rival.hpp"

namespace gaitway::peers {
namespace {

KDL::Frame kdl_frame(const Eigen::Isometry3d& pose) {
  const Eigen::Matrix3d r = pose.linear();
  const Eigen::Vector3d p = pose.translation();
  return {KDL::Rotation(r(0, 0), r(0, 1), r(0, 2), r(1, 0), r(1, 1), r(1, 2), r(2, 0), r(2, 1), r(2, 2)),
          KDL::Vector(p.x(), p.y(), p.z())};
}

class OurLeg final : public LegRival {
 public:
  OurLeg(const urdf::RobotModel& robot, urdf::Side side)
      : LegRival("gaitway"), leg_(robot, side, kinematics::SolverChoice::automatic) {}
  void set_goals(const std::vector<Eigen::Isometry3d>& soles) override { goals_ = soles; }
  bool solve(std::size_t goal, const LegAngles& start_rad, LegAngles& angle_rad) override {
    const kinematics::LegSolution solution = leg_.solve(goals_[goal], start_rad);
    angle_rad = solution.angle_rad;
    return solution.reached();
  }

 private:
  kinematics::LegSolver leg_;
  std::vector<Eigen::Isometry3d> goals_;
};

// What both of KDL's have in common.
class KdlRival : public LegRival {
 public:
  KdlRival(std::string name, const urdf::RobotModel& robot, urdf::Side side) : LegRival(std::move(name)) {
    const urdf::Foot& foot = robot.feet[static_cast<std::size_t>(side)];
    if (!robot.tree.getChain(robot.links.at(0).name, robot.links.at(static_cast<std::size_t>(foot.link)).name,
                             chain_)) {
      throw urdf::RobotError(robot.name + ": no chain from the base to the foot");
    }
    chain_.addSegment(KDL::Segment(KDL::Joint(KDL::Joint::None), kdl_frame(foot.sole)));
    const kinematics::LegLimits limits = kinematics::leg_limits(robot, side);
    for (unsigned i = 0; i < 6; ++i) {
      lower_(i) = limits.lower_rad[i];
      upper_(i) = limits.upper_rad[i];
    }
  }
  void set_goals(const std::vector<Eigen::Isometry3d>& soles) override {
    goals_.clear();
    for (const Eigen::Isometry3d& sole : soles) goals_.push_back(kdl_frame(sole));
  }
  bool solve(std::size_t goal, const LegAngles& start_rad, LegAngles& angle_rad) override {
    for (unsigned i = 0; i < 6; ++i) start_(i) = start_rad[i];
    const bool solved = ask(start_, goals_[goal], angle_) >= 0;
    for (unsigned i = 0; i < 6; ++i) angle_rad[i] = std::remainder(angle_(i), 2.0 * M_PI);
    return solved;
  }

 protected:
  virtual int ask(const KDL::JntArray& start, const KDL::Frame& goal, KDL::JntArray& angle) = 0;
  KDL::Chain chain_;
  KDL::JntArray lower_{6}, upper_{6};

 private:
  std::vector<KDL::Frame> goals_;
  KDL::JntArray start_{6}, angle_{6};
};

class KdlLma final : public KdlRival {
 public:
  KdlLma(const urdf::RobotModel& robot, urdf::Side side) : KdlRival("KDL LMA", robot, side) {
    // A weight of 1 for each: its own 0.01 for angles would stop at another tolerance.
    solver_.emplace(chain_, Eigen::Matrix<double, 6, 1>::Ones(), kTolerance, kMostIterations);
  }

 private:
  int ask(const KDL::JntArray& start, const KDL::Frame& goal, KDL::JntArray& angle) override {
    return solver_->CartToJnt(start, goal, angle);
  }
  std::optional<KDL::ChainIkSolverPos_LMA> solver_;
};

class KdlNewton final : public KdlRival {
 public:
  KdlNewton(const urdf::RobotModel& robot, urdf::Side side) : KdlRival("KDL NR_JL", robot, side) {
    forward_.emplace(chain_);
    velocity_.emplace(chain_);
    solver_.emplace(chain_, lower_, upper_, *forward_, *velocity_, kMostIterations, kTolerance);
  }

 private:
  int ask(const KDL::JntArray& start, const KDL::Frame& goal, KDL::JntArray& angle) override {
    return solver_->CartToJnt(start, goal, angle);
  }
  std::optional<KDL::ChainFkSolverPos_recursive> forward_;
  std::optional<KDL::ChainIkSolverVel_pinv> velocity_;
  std::optional<KDL::ChainIkSolverPos_NR_JL> solver_;
};

}  // namespace

std::unique_ptr<LegRival> our_leg(const urdf::RobotModel& robot, urdf::Side side) {
  return std::make_unique<OurLeg>(robot, side);
}
std::unique_ptr<LegRival> kdl_leg_lma(const urdf::RobotModel& robot, urdf::Side side) {
  return std::make_unique<KdlLma>(robot, side);
}
std::unique_ptr<LegRival> kdl_leg_nr_jl(const urdf::RobotModel& robot, urdf::Side side) {
  return std::make_unique<KdlNewton>(robot, side);
}

}  // namespace gaitway::peers
