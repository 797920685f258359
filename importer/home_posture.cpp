// The knees are bent step by step, and at each step Newton's method finds the other joints of the legs.
#include "gaitway/importer/home_posture.hpp"

#include <fmt/format.h>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "gaitway/input/complaint.hpp"

namespace gaitway::importer {
namespace {

constexpr double kLeastBend_rad = 0.25;  // of the knee: the least that walks
constexpr double kBendStep_rad = 0.03;
constexpr double kRoom_rad = 0.30;        // from hip pitch, knee and ankle pitch to their limits, for steps
constexpr double kGap_m_per_m = 0.045;    // between the soles, of the hip height
constexpr double kWidest_m_per_m = 0.28;  // between their origins
constexpr double kHangs = 0.64;           // cosine of 50 deg
constexpr double kHalfTurn_rad = std::numbers::pi;

double lower_of(const MakerJoint& joint) {
  return joint.lower_rad.value_or(-kHalfTurn_rad);
}
double upper_of(const MakerJoint& joint) {
  return joint.upper_rad.value_or(kHalfTurn_rad);
}

// The robot at some joint angles.
class Posture {
 public:
  Posture(const MakerRobot& robot, const std::vector<double>& angle_rad)
      : robot_(robot), link_(link_poses(robot, angle_rad)) {}

  [[nodiscard]] const Eigen::Isometry3d& link(int index) const {
    return link_[static_cast<std::size_t>(index)];
  }
  [[nodiscard]] Eigen::Vector3d joint_m(int joint) const { return link(child(joint)).translation(); }
  [[nodiscard]] Eigen::Vector3d axis(int joint) const {
    return link(child(joint)).linear() * robot_.joints[static_cast<std::size_t>(joint)].axis;
  }
  [[nodiscard]] Eigen::Vector3d com_m() const {
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    double mass = 0.0;
    for (std::size_t i = 0; i < robot_.links.size(); ++i) {
      moment += robot_.links[i].mass_kg * (link_[i] * robot_.links[i].com_m);
      mass += robot_.links[i].mass_kg;
    }
    return mass > 0.0 ? Eigen::Vector3d(moment / mass) : moment;
  }

 private:
  [[nodiscard]] int child(int joint) const {
    return robot_.joints[static_cast<std::size_t>(joint)].child_link;
  }
  const MakerRobot& robot_;
  std::vector<Eigen::Isometry3d> link_;
};

// What a joint carries, and where that is.
struct Carried {
  std::vector<int> joints;  // the joint itself first
  double mass_kg = 0.0;
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
};

Carried carried_by(const MakerRobot& robot, const Posture& posture, int first) {
  Carried carried{.joints = {first}};
  std::vector<int> links{robot.joints[static_cast<std::size_t>(first)].child_link};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (std::find(links.begin(), links.end(), robot.joints[i].parent_link) == links.end()) continue;
    links.push_back(robot.joints[i].child_link);
    carried.joints.push_back(static_cast<int>(i));
  }
  for (const int link : links) {
    const MakerLink& body = robot.links[static_cast<std::size_t>(link)];
    carried.mass_kg += body.mass_kg;
    carried.com_m += body.mass_kg * (posture.link(link) * body.com_m);
  }
  if (carried.mass_kg > 0.0) carried.com_m /= carried.mass_kg;
  return carried;
}

struct LegInPlane {
  int hip_pitch = 0, knee = 0, ankle_pitch = 0;
};

class Stand {
 public:
  Stand(const MakerRobot& robot, const BodyPlan& plan, const std::array<FoundSole, 2>& soles,
        double most_bend_rad)
      : robot_(robot), soles_(soles), most_bend_rad_(most_bend_rad), angle_rad_(robot.joints.size(), 0.0) {
    for (std::size_t i = 0; i < robot.joints.size(); ++i) angle_rad_[i] = neutral_rad(robot.joints[i]);
    const Posture zero(robot, angle_rad_);
    for (std::size_t side = 0; side < 2; ++side) {
      for (const std::string& name : plan.legs[side].joints) legs_[side].push_back(*robot.joint_index(name));
      in_plane_[side] = pitch_joints(zero, legs_[side]);
      straight_rad_[side] = angle_rad_[static_cast<std::size_t>(in_plane_[side].knee)];
      foot_[side] = robot.joints[static_cast<std::size_t>(legs_[side].back())].child_link;
    }
  }

  HomePosture find() {
    hang_arms();
    settle_width();
    HomePosture home;
    std::optional<std::vector<double>> chosen;
    double most_room = 0.0;
    bool bends_on = true, is_solved = false;
    constexpr double kStraight_rad = 0.05;  // there the height hardly depends on the bend
    for (double bend = std::max(kStraight_rad, bend_at(Posture(robot_, angle_rad_), 0)); bends_on;
         bend += kBendStep_rad) {
      bends_on = bend < most_bend_rad_;
      bend = std::min(bend, most_bend_rad_);
      // A nearly straight leg may be too long, or too short, for the other one's ground.
      const std::vector<double> before = angle_rad_;
      if (!solve(bend)) {
        if (is_solved) break;
        angle_rad_ = before;
        continue;
      }
      is_solved = true;
      // The deepest that leaves room enough; of those that leave less, the one that leaves most.
      const double room = std::min(least_room_rad(), kRoom_rad);
      if (room < 0.0 || room < most_room || (bend < kLeastBend_rad && bends_on)) continue;
      most_room = room;
      chosen = angle_rad_;
      home.knee_bend_rad = bend;
    }
    if (!chosen) refuse_stand();
    const std::string tightest = tightest_joint();
    home.angle_rad = *chosen;
    const Posture posture(robot_, home.angle_rad);
    home.hip_height_m = 0.5 * (hip_above_sole_m(posture, 0) + hip_above_sole_m(posture, 1));
    if (home.knee_bend_rad < most_bend_rad_ - kBendStep_rad) {
      home.notes.push_back(
          fmt::format("the knees stand bent by {:.0f} deg only: more would leave '{}' less than "
                      "{:.0f} deg to its limit",
                      degrees(home.knee_bend_rad), tightest, degrees(kRoom_rad)));
    }
    return home;
  }

 private:
  static double degrees(double angle_rad) { return angle_rad * 180.0 / std::numbers::pi; }

  [[nodiscard]] const MakerJoint& joint(int index) const {
    return robot_.joints[static_cast<std::size_t>(index)];
  }
  double& angle(int index) { return angle_rad_[static_cast<std::size_t>(index)]; }

  static LegInPlane pitch_joints(const Posture& zero, const std::vector<int>& leg) {
    const auto turns = [&](int joint) { return std::abs(zero.axis(joint).y()); };
    const auto most = [&](std::size_t from, std::size_t to) {
      return *std::max_element(leg.begin() + static_cast<std::ptrdiff_t>(from),
                               leg.begin() + static_cast<std::ptrdiff_t>(to),
                               [&](int a, int b) { return turns(a) < turns(b); });
    };
    return {most(0, 3), leg[3], most(4, 6)};
  }

  [[nodiscard]] Eigen::Isometry3d sole(const Posture& posture, std::size_t side) const {
    return posture.link(foot_[side]) * soles_[side].pose;
  }
  [[nodiscard]] double hip_above_sole_m(const Posture& posture, std::size_t side) const {
    return posture.joint_m(in_plane_[side].hip_pitch).z() - sole(posture, side).translation().z();
  }
  // Of shin against thigh, seen from the left; positive: the knee points forward.
  [[nodiscard]] double bend_at(const Posture& posture, std::size_t side) const {
    const LegInPlane& leg = in_plane_[side];
    const Eigen::Vector3d thigh = posture.joint_m(leg.knee) - posture.joint_m(leg.hip_pitch);
    const Eigen::Vector3d shin = posture.joint_m(leg.ankle_pitch) - posture.joint_m(leg.knee);
    return std::atan2(thigh.z() * shin.x() - thigh.x() * shin.z(),
                      thigh.x() * shin.x() + thigh.z() * shin.z());
  }

  // Half the distance of the soles' origins, from the zero posture: not overlapping, not straddling.
  void settle_width() {
    const Posture zero(robot_, angle_rad_);
    const double height_m = 0.5 * (hip_above_sole_m(zero, 0) + hip_above_sole_m(zero, 1));
    const double gap_m = kGap_m_per_m * height_m;
    const double inward_m = std::max(0.5 * soles_[0].size_m.y() - soles_[0].centre_m.y(),
                                     0.5 * soles_[1].size_m.y() + soles_[1].centre_m.y());
    const double found_m = 0.5 * (sole(zero, 0).translation().y() - sole(zero, 1).translation().y());
    half_width_m_ = std::max(inward_m + 0.5 * gap_m, std::min(found_m, 0.5 * kWidest_m_per_m * height_m));
    middle_m_ = 0.5 * (sole(zero, 0).translation().y() + sole(zero, 1).translation().y());
  }

  // What is to be zero: both soles level and straight ahead, beside each other, the CoM over their middle,
  // both on one ground, the left knee bent as wanted.
  [[nodiscard]] Eigen::Matrix<double, 12, 1> error(double bend_rad, bool one_ground) const {
    const Posture posture(robot_, angle_rad_);
    const Eigen::Vector3d com = posture.com_m();
    Eigen::Matrix<double, 12, 1> error;
    for (std::size_t side = 0; side < 2; ++side) {
      const Eigen::Isometry3d pose = sole(posture, side);
      const Eigen::Matrix3d& r = pose.linear();
      const Eigen::Index at = static_cast<Eigen::Index>(side) * 5;
      error[at] = r(2, 0);      // pitch
      error[at + 1] = r(2, 1);  // roll
      error[at + 2] = r(1, 0);  // yaw
      error[at + 3] = pose.translation().x() + soles_[side].centre_m.x() - com.x();
      error[at + 4] = pose.translation().y() - middle_m_ - (side == 0 ? half_width_m_ : -half_width_m_);
    }
    error[10] = bend_at(posture, 0) - bend_rad;
    // Of nearly straight legs the height does not tell which way the knee is bent.
    error[11] = one_ground ? hip_above_sole_m(posture, 0) - hip_above_sole_m(posture, 1)
                           : bend_at(posture, 1) - bend_rad;
    return error;
  }

  // Newton's method with a numerical Jacobian, from the posture as it is.
  bool solve(double bend_rad) { return solve(bend_rad, false) && solve(bend_rad, true); }
  bool solve(double bend_rad, bool one_ground) {
    constexpr double kStep = 1e-6, kExact = 1e-9, kLargest_rad = 0.3;
    constexpr int kMost = 40;
    for (int i = 0; i < kMost; ++i) {
      const Eigen::Matrix<double, 12, 1> now = error(bend_rad, one_ground);
      if (now.cwiseAbs().maxCoeff() < kExact) return true;
      Eigen::Matrix<double, 12, 12> jacobian;
      for (Eigen::Index column = 0; column < 12; ++column) {
        double& turned =
            angle(legs_[static_cast<std::size_t>(column / 6)][static_cast<std::size_t>(column % 6)]);
        const double before = turned;
        turned += kStep;
        jacobian.col(column) = (error(bend_rad, one_ground) - now) / kStep;
        turned = before;
      }
      Eigen::Matrix<double, 12, 1> change =
          (jacobian.transpose() * jacobian + 1e-10 * Eigen::Matrix<double, 12, 12>::Identity())
              .ldlt()
              .solve(-jacobian.transpose() * now);
      change *= std::min(1.0, kLargest_rad / std::max(change.cwiseAbs().maxCoeff(), 1e-12));
      for (Eigen::Index column = 0; column < 12; ++column) {
        angle(legs_[static_cast<std::size_t>(column / 6)][static_cast<std::size_t>(column % 6)]) +=
            change[column];
      }
    }
    return false;
  }

  [[nodiscard]] double room_rad(int index) const {
    const double at = angle_rad_[static_cast<std::size_t>(index)];
    return std::min(at - lower_of(joint(index)), upper_of(joint(index)) - at);
  }
  [[nodiscard]] double least_room_rad() const { return room_of(*robot_.joint_index(tightest_joint())); }
  // What a joint of the legs has left for steps: of the knee where it bends on; of joints that a walk turns
  // little, a part of that is enough.
  [[nodiscard]] double room_of(int index) const {
    constexpr double kLittle = 0.3;
    const double room = room_rad(index);
    if (room < 0.0) return room;
    for (std::size_t side = 0; side < 2; ++side) {
      const LegInPlane& leg = in_plane_[side];
      if (index == leg.hip_pitch || index == leg.ankle_pitch) return room;
      if (index != leg.knee) continue;
      const double at = angle_rad_[static_cast<std::size_t>(index)];
      return at > straight_rad_[side] ? upper_of(joint(index)) - at : at - lower_of(joint(index));
    }
    return room / kLittle;
  }
  [[nodiscard]] std::string tightest_joint() const {
    int tightest = legs_[0][0];
    for (const auto& leg : legs_) {
      for (const int index : leg) {
        if (room_of(index) < room_of(tightest)) tightest = index;
      }
    }
    return joint(tightest).name;
  }
  // The joint of the legs that has least room as they stand.
  [[nodiscard]] std::string nearest_to_limit() const {
    int nearest = legs_[0][0];
    for (const auto& leg : legs_) {
      for (const int index : leg) {
        if (room_rad(index) < room_rad(nearest)) nearest = index;
      }
    }
    return joint(nearest).name;
  }
  [[noreturn]] void refuse_stand() const {
    const std::string name = nearest_to_limit();
    const int index = *robot_.joint_index(name);
    const MakerJoint& limited = joint(index);
    if (room_rad(index) >= 0.0) {
      const MakerJoint& knee = joint(in_plane_[1].knee);
      input::refuse({robot_.file, knee.line, "legs", "",
                     fmt::format("the robot cannot stand with both soles level on one ground and the left "
                                 "knee bent by at most {:.0f} deg",
                                 degrees(most_bend_rad_)),
                     "Compare the legs' lengths, the joints' origins and axes, and where the soles lie"});
    }
    input::refuse(
        {robot_.file, limited.line, fmt::format("joint '{}' limit", name),
         fmt::format("{:g}..{:g} rad", lower_of(limited), upper_of(limited)),
         fmt::format("the robot cannot stand on level soles with its knees bent forward by {:.0f} deg: "
                     "this joint would have to be at {:.3f} rad",
                     degrees(kLeastBend_rad), angle_rad_[static_cast<std::size_t>(index)]),
         "Widen the limit, or correct the axis' sign"});
  }

  // Joints of branches that lie on one side of the body and are no legs, the first ones of each.
  [[nodiscard]] std::vector<int> shoulders() const;
  void hang_arms();
  void hang(const Carried& arm);
  void leave_room_to_swing(const Carried& arm);

  const MakerRobot& robot_;
  const std::array<FoundSole, 2>& soles_;
  double most_bend_rad_;
  std::vector<double> angle_rad_;
  std::array<std::vector<int>, 2> legs_;
  std::array<LegInPlane, 2> in_plane_;
  std::array<int, 2> foot_{};
  std::array<double, 2> straight_rad_{};  // of the knees, at zero
  double half_width_m_ = 0.0, middle_m_ = 0.0;
};

std::vector<int> Stand::shoulders() const {
  constexpr double kAside = 0.5;  // of the hips' distance from the middle
  const Posture posture(robot_, angle_rad_);
  const double hip_m =
      std::abs(posture.joint_m(in_plane_[0].hip_pitch).y() - posture.joint_m(in_plane_[1].hip_pitch).y()) /
      2.0;
  std::vector<bool> inside(robot_.links.size(), false);  // links of legs, and of arms found
  for (std::size_t side = 0; side < 2; ++side) {
    for (const int index : legs_[side]) inside[static_cast<std::size_t>(joint(index).child_link)] = true;
  }
  std::vector<int> found;
  for (std::size_t i = 0; i < robot_.joints.size(); ++i) {
    const auto parent = static_cast<std::size_t>(robot_.joints[i].parent_link);
    const auto child = static_cast<std::size_t>(robot_.joints[i].child_link);
    if (inside[parent] || inside[child]) {
      inside[child] = true;
      continue;
    }
    const Carried arm = carried_by(robot_, posture, static_cast<int>(i));
    if (arm.mass_kg > 0.0 && std::abs(arm.com_m.y()) > kAside * hip_m) {
      found.push_back(static_cast<int>(i));
      inside[child] = true;
    }
  }
  return found;
}

void Stand::hang_arms() {
  for (const int shoulder : shoulders()) {
    const Posture posture(robot_, angle_rad_);
    const Carried arm = carried_by(robot_, posture, shoulder);
    const Eigen::Vector3d hangs = (arm.com_m - posture.joint_m(shoulder)).normalized();
    if (-hangs.z() <= kHangs) hang(arm);
    leave_room_to_swing(arm);
  }
}

// An arm that does not hang in the zero posture is turned, joint by joint, to where it lies lowest.
void Stand::hang(const Carried& arm) {
  constexpr int kSweeps = 6, kPlaces = 48;
  constexpr double kFromLimit_rad = 0.1;
  const int shoulder = arm.joints.front();
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (const int index : arm.joints) {
      const double from = lower_of(joint(index)) + kFromLimit_rad,
                   to = upper_of(joint(index)) - kFromLimit_rad;
      if (!(from < to)) continue;
      const double lightly = 1e-3 * arm.mass_kg;  // rather near zero, where it makes no difference
      double best = std::clamp(angle(index), from, to), lowest = std::numeric_limits<double>::infinity();
      for (int place = 0; place <= kPlaces; ++place) {
        angle(index) = std::lerp(from, to, static_cast<double>(place) / kPlaces);
        const double height =
            carried_by(robot_, Posture(robot_, angle_rad_), shoulder).com_m.z() * arm.mass_kg +
            lightly * angle(index) * angle(index);
        if (height < lowest) {
          lowest = height;
          best = angle(index);
        }
      }
      angle(index) = best;
    }
  }
}

// Ahead and back, in a walk: an arm whose shoulder hardly goes back hangs a little ahead.
void Stand::leave_room_to_swing(const Carried& arm) {
  constexpr double kRoomToSwing_rad = 0.7, kPitches = 0.7;
  const Posture posture(robot_, angle_rad_);
  const auto pitch = std::ranges::find_if(
      arm.joints, [&](int index) { return std::abs(posture.axis(index).y()) > kPitches; });
  if (pitch == arm.joints.end()) return;
  const double from = lower_of(joint(*pitch)) + kRoomToSwing_rad,
               to = upper_of(joint(*pitch)) - kRoomToSwing_rad;
  if (from < to) angle(*pitch) = std::clamp(angle(*pitch), from, to);
}

}  // namespace

double neutral_rad(const MakerJoint& joint) noexcept {
  constexpr double kLeeway_rad = 0.02;
  const double leeway = std::max(0.0, std::min(kLeeway_rad, 0.5 * (upper_of(joint) - lower_of(joint))));
  return std::min(std::max(0.0, lower_of(joint) + leeway), upper_of(joint) - leeway);
}

HomePosture find_home_posture(const MakerRobot& robot, const BodyPlan& plan,
                              const std::array<FoundSole, 2>& soles, double most_bend_rad) {
  return Stand(robot, plan, soles, most_bend_rad).find();
}

}  // namespace gaitway::importer
