// Mass matrix from the links' velocities, exact discretisation, eigenvalues of one slot.
#include "gaitway/stability/trim_loop.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <unsupported/Eigen/MatrixFunctions>
#include <vector>

#include "gaitway/facts/facts.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "gaitway/urdf/leg_joints.hpp"

namespace gaitway::stability {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::RowVectorXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

constexpr double kSyncToTrim_s = 0.001;  // from a SYNC to the trims' broadcast frame
constexpr Index kTrims = 2;              // ankle pitch, hip pitch
constexpr double kMostLeft = 0.96;       // of what is slowest to fade, after a slot

// Coordinates of the model. The first turn everything above them about +y.
enum PitchPair : Index { kAnkles, kKnees, kHips, kPitchPairs };
constexpr std::array kPairs{urdf::LegJoint::ankle_pitch, urdf::LegJoint::knee, urdf::LegJoint::hip_pitch};

// Where a link belongs: how far along a leg, or to the trunk.
struct Place {
  std::optional<urdf::Side> side;
  int along = -1;  // of the leg's joints, the one that carries it
};

// Springs, dampers and masses on fixed soles: M q'' + D q' + K q = what the trims pull.
class StandingBody {
 public:
  explicit StandingBody(const urdf::RobotModel& robot) : robot_(robot), home_(robot) {
    find_places();
    const Index count = kPitchPairs + static_cast<Index>(held_.size());
    mass_ = MatrixXd::Zero(count, count);
    stiffness_ = servo_damping_ = damping_ = VectorXd::Zero(count);
    for (const urdf::Side side : urdf::kSides) {
      const urdf::LegJoints joints(robot, home_, side);
      for (Index pair = 0; pair < kPitchPairs; ++pair) {
        const int index = joints[kPairs[static_cast<std::size_t>(pair)]];
        pairs_[urdf::index_of(side)][static_cast<std::size_t>(pair)] = index;
        add_servo(pair, index);
      }
    }
    for (std::size_t i = 0; i < held_.size(); ++i) add_servo(kPitchPairs + static_cast<Index>(i), held_[i]);
    for (std::size_t link = 0; link < robot.links.size(); ++link) add_link(link);
    trunk_pitch_ = turning(static_cast<std::size_t>(robot.imu.link)).row(1);
  }

  [[nodiscard]] Index count() const noexcept { return mass_.rows(); }
  [[nodiscard]] const MatrixXd& mass() const noexcept { return mass_; }
  [[nodiscard]] const VectorXd& stiffness() const noexcept { return stiffness_; }
  [[nodiscard]] const VectorXd& servo_damping() const noexcept { return servo_damping_; }
  [[nodiscard]] const VectorXd& damping() const noexcept { return damping_; }             // the motor's, too
  [[nodiscard]] const RowVectorXd& trunk_pitch() const noexcept { return trunk_pitch_; }  // per coordinate

 private:
  void find_places() {
    places_.resize(robot_.links.size());
    for (const urdf::Side side : urdf::kSides) {
      const urdf::Leg& leg = robot_.legs[urdf::index_of(side)];
      for (std::size_t i = 0; i < leg.joints.size(); ++i) {
        places_[child_of(leg.joints[i])] = {side, static_cast<int>(i)};
      }
    }
    for (std::size_t j = 0; j < robot_.joints.size(); ++j) {  // parents before children
      const std::size_t child = child_of(static_cast<int>(j));
      const Place& parent = places_[static_cast<std::size_t>(robot_.joints[j].parent_link)];
      if (places_[child].side) continue;
      if (parent.side) {
        places_[child] = parent;  // a toe goes with its foot
      } else {
        held_.push_back(static_cast<int>(j));
      }
    }
  }
  [[nodiscard]] std::size_t child_of(int joint) const noexcept {
    return static_cast<std::size_t>(robot_.joints[static_cast<std::size_t>(joint)].child_link);
  }
  [[nodiscard]] Vector3d place_m(int joint) const noexcept {
    return home_.link_position_m(static_cast<int>(child_of(joint)));
  }

  void add_servo(Index coordinate, int index) {
    const urdf::Joint& joint = robot_.joints[static_cast<std::size_t>(index)];
    stiffness_[coordinate] += joint.servo.stiffness_Nm_per_rad;
    servo_damping_[coordinate] += joint.servo.damping_Nms_per_rad;
    damping_[coordinate] += joint.servo.damping_Nms_per_rad + joint.motor.damping_Nms_per_rad;
    mass_(coordinate, coordinate) += joint.motor.armature_kg_m2;
  }

  // Whether a pair of pitch joints moves that link: it is above them.
  [[nodiscard]] bool is_above(std::size_t link, Index pair) const noexcept {
    const Place& place = places_[link];
    if (!place.side) return true;
    const urdf::Leg& leg = robot_.legs[urdf::index_of(*place.side)];
    const int turning = pairs_[urdf::index_of(*place.side)][static_cast<std::size_t>(pair)];
    return place.along < std::ranges::find(leg.joints, turning) - leg.joints.begin();
  }
  [[nodiscard]] Vector3d centre_of_pair_m(std::size_t link, Index pair) const noexcept {
    const auto p = static_cast<std::size_t>(pair);
    const Place& place = places_[link];
    return place.side ? place_m(pairs_[urdf::index_of(*place.side)][p])
                      : Vector3d(0.5 * (place_m(pairs_[0][p]) + place_m(pairs_[1][p])));
  }
  [[nodiscard]] bool carries(int joint, std::size_t link) const noexcept {
    const std::size_t top = child_of(joint);
    while (link != top && link != 0) {
      link = static_cast<std::size_t>(
          std::ranges::find(robot_.joints, static_cast<int>(link), &urdf::Joint::child_link)->parent_link);
    }
    return link == top;
  }

  // Angular velocity of a link for each coordinate's.
  [[nodiscard]] Eigen::Matrix3Xd turning(std::size_t link) const {
    Eigen::Matrix3Xd result = Eigen::Matrix3Xd::Zero(3, count());
    for (Index pair = 0; pair < kPitchPairs; ++pair) {
      if (is_above(link, pair)) result.col(pair) = Vector3d::UnitY();
    }
    for (std::size_t i = 0; i < held_.size(); ++i) {
      if (carries(held_[i], link)) {
        result.col(kPitchPairs + static_cast<Index>(i)) = home_.joint_axis(robot_, held_[i]);
      }
    }
    return result;
  }

  void add_link(std::size_t index) {
    const urdf::Link& link = robot_.links[index];
    const Eigen::Isometry3d pose = home_.link_pose(static_cast<int>(index));
    const Vector3d com_m = pose * link.com_m;
    const Eigen::Matrix3Xd turns = turning(index);
    Eigen::Matrix3Xd moves(3, count());
    for (Index c = 0; c < count(); ++c) {
      const Vector3d centre_m = c < kPitchPairs ? centre_of_pair_m(index, c)
                                                : place_m(held_[static_cast<std::size_t>(c - kPitchPairs)]);
      moves.col(c) = Vector3d(turns.col(c)).cross(com_m - centre_m);
    }
    const Eigen::Matrix3d inertia_kg_m2 = pose.linear() * link.inertia_kg_m2 * pose.linear().transpose();
    mass_ += link.mass_kg * moves.transpose() * moves + turns.transpose() * inertia_kg_m2 * turns;
  }

  const urdf::RobotModel& robot_;
  urdf::ForwardKinematics home_;
  std::vector<Place> places_;  // of the links
  std::vector<int> held_;      // joints that are not a leg's
  std::array<std::array<int, kPitchPairs>, 2> pairs_{};
  MatrixXd mass_;
  VectorXd stiffness_, servo_damping_, damping_;
  RowVectorXd trunk_pitch_;
};

// Of the state: positions, velocities, trims, the trims' rates, what was sampled last and the slot before.
struct Layout {
  Index body, trims, rates, sampled, waiting, size;
  explicit Layout(Index coordinates)
      : body(coordinates),
        trims(2 * coordinates),
        rates(trims + kTrims),
        sampled(rates + kTrims),
        waiting(sampled + kTrims),
        size(waiting + kTrims) {}
};

MatrixXd motion_over(const StandingBody& body, const Layout& at, double time_s) {
  const Index n = body.count();
  const Eigen::LDLT<MatrixXd> mass(body.mass());
  MatrixXd rate = MatrixXd::Zero(at.size, at.size);
  rate.block(0, n, n, n).setIdentity();
  rate.block(n, 0, n, n) = -mass.solve(MatrixXd(body.stiffness().asDiagonal()));
  rate.block(n, n, n, n) = -mass.solve(MatrixXd(body.damping().asDiagonal()));
  constexpr std::array kTrimmed{kAnkles, kHips};
  for (Index k = 0; k < kTrims; ++k) {
    const Index joint = kTrimmed[static_cast<std::size_t>(k)];
    const VectorXd answer = mass.solve(VectorXd(VectorXd::Unit(n, joint)));
    rate.block(n, at.trims + k, n, 1) = body.stiffness()[joint] * answer;
    rate.block(n, at.rates + k, n, 1) = body.servo_damping()[joint] * answer;
    rate(at.trims + k, at.rates + k) = 1.0;
  }
  return (rate * time_s).exp();
}

}  // namespace

TrimLoop::TrimLoop(const urdf::RobotModel& robot) {
  const StandingBody body(robot);
  const Layout at(body.count());
  pitch_ = pitch_rate_ = RowVectorXd::Zero(at.size);
  pitch_.head(at.body) = body.trunk_pitch();
  pitch_rate_.segment(at.body, at.body) = body.trunk_pitch();
  before_frame_ = motion_over(body, at, kSyncToTrim_s);
  // With the frame, the trims head for what was sampled a slot ago.
  MatrixXd frame = MatrixXd::Identity(at.size, at.size);
  for (Index k = 0; k < kTrims; ++k) {
    frame.row(at.rates + k).setZero();
    frame(at.rates + k, at.waiting + k) = 1.0 / facts::kSlot_s;
    frame(at.rates + k, at.trims + k) = -1.0 / facts::kSlot_s;
  }
  after_frame_ = motion_over(body, at, facts::kSlot_s - kSyncToTrim_s) * frame;
}

double TrimLoop::left_after_slot(const BalanceParameters& parameters) const {
  const Index size = pitch_.size();
  const Index sampled = size - 2 * kTrims, waiting = size - kTrims;
  MatrixXd sample = MatrixXd::Identity(size, size);
  const std::array gains{&parameters.ankle_pitch, &parameters.hip_pitch};
  for (Index k = 0; k < kTrims; ++k) {
    const JointGain& gain = *gains[static_cast<std::size_t>(k)];
    sample.row(waiting + k).setZero();
    sample(waiting + k, sampled + k) = 1.0;
    sample.row(sampled + k) = -gain.angle_rad_per_rad * pitch_ - gain.rate_rad_per_rad_per_s * pitch_rate_;
  }
  const MatrixXd slot = after_frame_ * before_frame_ * sample;
  return Eigen::EigenSolver<MatrixXd>(slot, false).eigenvalues().cwiseAbs().maxCoeff();
}

// The hips answer a light trunk's rate within the slot; ankles, which move all of the body, steady that.
BalanceParameters balance_of(const urdf::RobotModel& robot) {
  constexpr int kShares = 20;
  BalanceParameters balance;
  scale_to_body(balance.numbers(), robot.body_scale());
  const TrimLoop loop(robot);
  double least_left = loop.left_after_slot(balance);
  if (least_left <= kMostLeft) return balance;
  double& rate_s = balance.hip_pitch.rate_rad_per_rad_per_s;
  const double whole_s = rate_s;
  double best_s = whole_s;
  for (int i = kShares - 1; i >= 0; --i) {
    rate_s = whole_s * i / kShares;
    const double left = loop.left_after_slot(balance);
    if (left >= least_left) continue;
    least_left = left;
    best_s = rate_s;
  }
  rate_s = best_s;
  return balance;
}

}  // namespace gaitway::stability
