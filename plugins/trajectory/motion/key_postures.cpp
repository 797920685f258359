// Solves each key for a whole posture, and checks it while there is still a key to complain about.
#include "gaitway/motion/motion_path.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematics/leg_geometry.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::motion {
namespace {

using facts::kRadPerDegree;
constexpr double kPlaceTolerance_m = 0.0005;
constexpr double kTiltTolerance_rad = 0.2 * kRadPerDegree;
constexpr double kComTolerance_m = 1e-6;
constexpr int kComIterations = 30;

using Soles = std::array<Eigen::Isometry3d, 2>;

Soles soles_of(const Eigen::VectorXd& stance) {
  return {pose_at(stance, StanceMap::kSole[0]), pose_at(stance, StanceMap::kSole[1])};
}

// By how much two poses differ: metres, and metres that a turn makes at a sole's far end.
double pose_distance_m(const Eigen::Isometry3d& a, const Eigen::Isometry3d& b) {
  constexpr double kLever_m = kPlaceTolerance_m / kTiltTolerance_rad;
  const Eigen::AngleAxisd turn(a.linear().transpose() * b.linear());
  return std::max((a.translation() - b.translation()).norm(), kLever_m * std::abs(turn.angle()));
}

class KeySolver {
 public:
  KeySolver(const urdf::RobotModel& robot, const MotionLimits& limits)
      : robot_(robot),
        limits_(limits),
        joint_limits_(robot, limits),
        map_(robot),
        kinematics_(robot),
        loads_(robot) {
    hip_middle_m_ = 0.5 * (kinematics::hip_centre(robot, urdf::Side::left) +
                           kinematics::hip_centre(robot, urdf::Side::right));
    home_.joint_rad.resize(static_cast<Eigen::Index>(robot.joints.size()));
    for (std::size_t j = 0; j < robot.joints.size(); ++j) {
      home_.joint_rad[static_cast<Eigen::Index>(j)] = robot.joints[j].home_rad;
    }
    home_.stance = stance_of(home_.joint_rad);
    if (!home_.stance) {
      throw MotionError(
          fmt::format("robot '{}': its home posture does not stand on two flat soles, but motions "
                      "start and end there. Correct home_deg in its network file",
                      robot.name));
    }
  }

  [[nodiscard]] const KeyPosture& home() const { return home_; }
  KeyPosture solve(const Key& key, const KeyPosture& before);
  // The CoM above what stands on the way to the key, and on the way from it.
  void check_balance(const Key& key, Contact contact, const KeyPosture& posture);

 private:
  std::optional<Eigen::VectorXd> stance_of(const Eigen::VectorXd& joint_rad);
  void follow_joints(const Key& key, const KeyPosture& before, KeyPosture& posture);
  void follow_pelvis(const Key& key, const Eigen::Vector2d& com_before_m, KeyPosture& posture);
  Eigen::Vector2d wanted_com_m(const Key& key, const Soles& sole, const Eigen::Vector2d& before_m) const;
  void place_com(const Key& key, const Eigen::Vector2d& wanted_m, Eigen::VectorXd& stance,
                 Eigen::VectorXd& joints);
  Eigen::Vector2d com_m(const Eigen::VectorXd& stance, const Eigen::VectorXd& joint_rad);
  void check_joints(const Key& key, const KeyPosture& posture) const;
  void check_torques(const Key& key, const KeyPosture& posture);
  void check_feet(const Key& key, const KeyPosture& before, const KeyPosture& posture) const;

  const urdf::RobotModel& robot_;
  MotionLimits limits_;
  JointLimits joint_limits_;
  StanceMap map_;
  urdf::ForwardKinematics kinematics_;
  BodyLoadCalculator loads_;
  Eigen::Vector3d hip_middle_m_;
  KeyPosture home_;
};

// Coordinates of a posture whose soles are in one plane, which is then the ground.
std::optional<Eigen::VectorXd> KeySolver::stance_of(const Eigen::VectorXd& joint_rad) {
  kinematics_.compute({joint_rad.data(), static_cast<std::size_t>(joint_rad.size())});
  const Eigen::Isometry3d left = kinematics_.sole_pose(urdf::Side::left);
  const Eigen::Isometry3d right = kinematics_.sole_pose(urdf::Side::right);
  const Eigen::Isometry3d between = left.inverse() * right;
  const Eigen::Vector3d turn = attitude_of(between.linear());
  const bool coplanar = std::abs(between.translation().z()) < kPlaceTolerance_m &&
                        turn.head<2>().cwiseAbs().maxCoeff() < kTiltTolerance_rad;
  if (!coplanar) return std::nullopt;
  Eigen::Isometry3d frame = left;  // in the pelvis frame: in the middle, turned half-way
  frame.linear() = left.linear() * rotation_of({0.0, 0.0, 0.5 * turn.z()});
  frame.translation() = 0.5 * (left.translation() + right.translation());
  const Eigen::Isometry3d ground = frame.inverse();
  Soles sole{ground * left, ground * right};
  for (Eigen::Isometry3d& pose : sole) {  // flat to the last digit: what is left is far below the tolerance
    const double yaw = attitude_of(pose.linear()).z();
    pose.linear() = rotation_of({0.0, 0.0, yaw});
    pose.translation().z() = 0.0;
  }
  return map_.coordinates(ground, sole, joint_rad);
}

Eigen::Vector2d KeySolver::com_m(const Eigen::VectorXd& stance, const Eigen::VectorXd& joint_rad) {
  kinematics_.compute({joint_rad.data(), static_cast<std::size_t>(joint_rad.size())});
  return (pose_at(stance, StanceMap::kPelvis) * kinematics_.com_m()).head<2>();
}

KeyPosture KeySolver::solve(const Key& key, const KeyPosture& before) {
  KeyPosture posture = key.from_home ? home_ : before;
  for (const JointAngle& angle : key.joints) {
    posture.joint_rad[angle.joint] = angle.angle_rad;
  }
  if (key.contact == Contact::none) {
    posture.stance = stance_of(posture.joint_rad);
    check_joints(key, posture);
    return posture;
  }
  if (!before.stance) {
    throw MotionError(
        fmt::format("{}: contact is {}, but at the key before the soles are not in one plane. Let the key "
                    "before put both feet flat beside each other",
                    key.where, name_of(key.contact)));
  }
  const bool legs_given = std::ranges::any_of(key.joints, [this](const JointAngle& angle) {
    const std::vector<int>& others = map_.other_joints();
    return std::ranges::find(others, angle.joint) == others.end();
  });
  if (legs_given) {
    follow_joints(key, before, posture);
  } else {
    const KeyPosture& source = key.from_home ? home_ : before;
    follow_pelvis(key, com_m(*source.stance, source.joint_rad), posture);
  }
  check_joints(key, posture);
  check_feet(key, before, posture);
  check_balance(key, key.contact, posture);
  check_torques(key, posture);
  return posture;
}

// The legs' angles are given: the pelvis is where the foot on the ground has it.
void KeySolver::follow_joints(const Key& key, const KeyPosture& before, KeyPosture& posture) {
  const Soles standing = soles_of(*before.stance);
  const urdf::Side anchor = key.contact == Contact::right ? urdf::Side::right : urdf::Side::left;
  const urdf::Side other = anchor == urdf::Side::left ? urdf::Side::right : urdf::Side::left;
  kinematics_.compute({posture.joint_rad.data(), static_cast<std::size_t>(posture.joint_rad.size())});
  const Eigen::Isometry3d pelvis =
      standing[static_cast<std::size_t>(anchor)] * kinematics_.sole_pose(anchor).inverse();
  Soles sole = standing;
  Eigen::Isometry3d& reached = sole[static_cast<std::size_t>(other)];
  const Eigen::Isometry3d place = reached;
  reached = pelvis * kinematics_.sole_pose(other);
  if (key.contact == Contact::both) {
    const double off_m = pose_distance_m(reached, place);
    if (off_m > kPlaceTolerance_m) {
      throw MotionError(fmt::format(
          "{}: with these leg angles the right sole is {:.1f} mm and {:.1f} deg away from its place on the "
          "ground, "
          "beside the left one; 0.5 mm and 0.2 deg are allowed. Give the pelvis instead, and the legs follow",
          key.where, 1000.0 * (reached.translation() - place.translation()).norm(),
          Eigen::AngleAxisd(place.linear().transpose() * reached.linear()).angle() / kRadPerDegree));
    }
    reached = place;
  }
  posture.stance = map_.coordinates(pelvis, sole, posture.joint_rad);
}

void KeySolver::follow_pelvis(const Key& key, const Eigen::Vector2d& com_before_m, KeyPosture& posture) {
  const PelvisWish wish = key.pelvis.value_or(PelvisWish{});
  Eigen::VectorXd stance = *posture.stance;
  for (std::size_t i = 0; i < map_.other_joints().size(); ++i) {
    stance[StanceMap::kOthers + static_cast<Eigen::Index>(i)] = posture.joint_rad[map_.other_joints()[i]];
  }
  const Soles home = soles_of(*home_.stance);
  for (std::size_t side = 0; side < 2; ++side) {
    if (!key.foot[side]) continue;
    const FootWish& foot = *key.foot[side];
    stance.segment<3>(StanceMap::kSole[side]) = home[side].translation() + foot.position_m;
    stance.segment<3>(StanceMap::kSole[side] + 3) = attitude_of(home[side].linear()) + foot.attitude_rad;
  }
  const double hip_height_m =
      wish.hip_height_m.value_or((pose_at(stance, StanceMap::kPelvis) * hip_middle_m_).z());
  for (std::size_t axis = 0; axis < 3; ++axis) {
    double& angle = stance[StanceMap::kPelvis + 3 + static_cast<Eigen::Index>(axis)];
    angle = wish.attitude_rad[axis].value_or(angle);
  }
  const Eigen::Matrix3d attitude = rotation_of(stance.segment<3>(StanceMap::kPelvis + 3));
  stance[StanceMap::kPelvis + 2] = hip_height_m - (attitude * hip_middle_m_).z();
  place_com(key, wanted_com_m(key, soles_of(stance), com_before_m), stance, posture.joint_rad);
  posture.stance = stance;
}

Eigen::Vector2d KeySolver::wanted_com_m(const Key& key, const Soles& sole,
                                        const Eigen::Vector2d& before_m) const {
  const PelvisWish wish = key.pelvis.value_or(PelvisWish{});
  const bool given = wish.over || wish.com_offset_m[0] || wish.com_offset_m[1];
  if (!given) return before_m;
  const Eigen::Vector2d left = sole_centre(robot_.feet[0], sole[0]),
                        right = sole_centre(robot_.feet[1], sole[1]);
  const Over over = wish.over.value_or(Over::both);
  const Eigen::Vector2d middle = over == Over::left    ? left
                                 : over == Over::right ? right
                                                       : Eigen::Vector2d(0.5 * (left + right));
  return middle + Eigen::Vector2d(wish.com_offset_m[0].value_or(0.0), wish.com_offset_m[1].value_or(0.0));
}

// Newton's iteration: where the pelvis must be so that the CoM is there, with the feet in their places.
void KeySolver::place_com(const Key& key, const Eigen::Vector2d& wanted_m, Eigen::VectorXd& stance,
                          Eigen::VectorXd& joints) {
  constexpr double kStep_m = 1e-5;
  double out_of_reach_m = 0.0;
  for (int i = 0; i < kComIterations; ++i) {
    out_of_reach_m = map_.joints(stance, joints);
    const Eigen::Vector2d error = com_m(stance, joints) - wanted_m;
    if (out_of_reach_m == 0.0 && error.norm() < kComTolerance_m) return;
    Eigen::Matrix2d sensitivity;
    for (Eigen::Index axis = 0; axis < 2; ++axis) {
      Eigen::VectorXd moved = stance, moved_joints = joints;
      moved[StanceMap::kPelvis + axis] += kStep_m;
      map_.joints(moved, moved_joints);
      sensitivity.col(axis) = (com_m(moved, moved_joints) - wanted_m - error) / kStep_m;
    }
    stance.segment<2>(StanceMap::kPelvis) -= sensitivity.partialPivLu().solve(error);
  }
  throw MotionError(
      fmt::format("{}: no posture has its hips at {:.3f} m, its feet in place and its centre of mass {:.3f} "
                  "m forward, {:.3f} m "
                  "left of the standing place: a leg is out of reach by {:.1f} mm. Choose a lower "
                  "hip_height_m or a smaller shift",
                  key.where, (pose_at(stance, StanceMap::kPelvis) * hip_middle_m_).z(), wanted_m.x(),
                  wanted_m.y(), 1000.0 * out_of_reach_m));
}

void KeySolver::check_joints(const Key& key, const KeyPosture& posture) const {
  for (Eigen::Index j = 0; j < posture.joint_rad.size(); ++j) {
    const double angle = posture.joint_rad[j];
    const double lower = joint_limits_.lower_rad[j], upper = joint_limits_.upper_rad[j];
    if (!(angle >= lower && angle <= upper)) {
      throw MotionError(
          fmt::format("{}: {} would be at {:.1f} deg; planned motions keep it within {:.1f} to {:.1f} deg. "
                      "Choose another posture",
                      key.where, robot_.joints[static_cast<std::size_t>(j)].name, angle / kRadPerDegree,
                      lower / kRadPerDegree, upper / kRadPerDegree));
    }
  }
}

// Of holding still there: what no slowness makes less.
void KeySolver::check_torques(const Key& key, const KeyPosture& posture) {
  const BodyPosture still{posture.joint_rad, pose_at(*posture.stance, StanceMap::kPelvis)};
  const BodyLoad& load =
      loads_.compute({still, still, still}, facts::kSlot_s, key.contact, soles_of(*posture.stance));
  for (Eigen::Index j = 0; j < posture.joint_rad.size(); ++j) {
    const double torque_Nm = std::abs(load.torque_Nm[j]), limit_Nm = joint_limits_.standstill_torque_Nm[j];
    if (torque_Nm > limit_Nm) {
      throw MotionError(
          fmt::format("{}: {} needs {:.2f} N·m to hold still there; {:.2f} N·m are allowed. Choose a posture "
                      "with shorter levers, such as less bent",
                      key.where, robot_.joints[static_cast<std::size_t>(j)].name, torque_Nm, limit_Nm));
    }
  }
}

void KeySolver::check_feet(const Key& key, const KeyPosture& before, const KeyPosture& posture) const {
  const Soles was = soles_of(*before.stance), is = soles_of(*posture.stance);
  for (const urdf::Side side : urdf::kSides) {
    if (!stands_on(key.contact, side)) continue;
    const std::size_t i = static_cast<std::size_t>(side);
    const std::string_view foot = side == urdf::Side::left ? "left" : "right";
    Eigen::Isometry3d flat = was[i];
    flat.translation().z() = 0.0;
    flat.linear() = rotation_of({0.0, 0.0, attitude_of(was[i].linear()).z()});
    if (pose_distance_m(was[i], flat) > kPlaceTolerance_m) {
      throw MotionError(
          fmt::format("{}: contact is {}, but at the key before the {} sole is not flat on the ground: it is "
                      "{:.1f} mm up. Put it down first, in a key with the other foot's contact",
                      key.where, name_of(key.contact), foot, 1000.0 * was[i].translation().z()));
    }
    if (pose_distance_m(was[i], is[i]) > kPlaceTolerance_m) {
      throw MotionError(fmt::format(
          "{}: contact is {}, but the {} foot would move by {:.1f} mm. Leave it where it is, or let "
          "the robot stand on the other one meanwhile",
          key.where, name_of(key.contact), foot,
          1000.0 * (was[i].translation() - is[i].translation()).norm()));
    }
  }
}

void KeySolver::check_balance(const Key& key, Contact contact, const KeyPosture& posture) {
  if (contact == Contact::none || !posture.stance) return;
  const SupportArea area = support_area(robot_, contact, soles_of(*posture.stance));
  const double margin_m = area.margin_m(com_m(*posture.stance, posture.joint_rad));
  if (margin_m < limits_.zmp_margin_m) {
    throw MotionError(fmt::format(
        "{}: standing on {} there, the centre of mass is {:.1f} mm {} the edge of the support; it must be "
        "{:.1f} mm "
        "inside. Shift the pelvis with over, forward_m or left_m",
        key.where, contact == Contact::both ? "both feet" : fmt::format("the {} foot", name_of(contact)),
        1000.0 * std::abs(margin_m), margin_m < 0.0 ? "outside" : "inside", 1000.0 * limits_.zmp_margin_m));
  }
}

}  // namespace

std::vector<KeyPosture> key_postures(const urdf::RobotModel& robot, const Motion& motion,
                                     const MotionLimits& limits) {
  KeySolver solver(robot, limits);
  std::vector<KeyPosture> postures;
  if (!motion.starts_at_first_key) postures.push_back(solver.home());
  for (std::size_t i = 0; i < motion.keys.size(); ++i) {
    postures.push_back(solver.solve(motion.keys[i], postures.empty() ? solver.home() : postures.back()));
    if (i + 1 < motion.keys.size()) {
      solver.check_balance(motion.keys[i], motion.keys[i + 1].contact, postures.back());
    }
  }
  return postures;
}

}  // namespace gaitway::motion
