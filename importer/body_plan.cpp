// Every pair of chains that part at one link is tried with every way up; the pair that reaches lowest has the
// feet.
#include "gaitway/importer/body_plan.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include "gaitway/input/complaint.hpp"

namespace gaitway::importer {
namespace {

constexpr double kLeastCosine = 0.643;  // of 50 deg: what the loader takes for a leg's joint
constexpr double kSameAxis = 0.985;     // cosine of 10 deg: meant to be the axis
constexpr double kAcross = 0.5;         // of a unit: an axis that is said is the one or the other, or neither
constexpr double kLeastDrop = 0.3;      // of the chain's length: a foot lies at least so far below its hip
constexpr double kClear = 0.05;         // of the foot's length: by how much it reaches farther to the front
constexpr double kReachesGround = 0.85;  // of the lowest foot's drop

using Chain = std::vector<int>;  // joints, from the root on

Chain chain_to(const MakerRobot& robot, int link) {
  Chain chain;
  while (robot.links[static_cast<std::size_t>(link)].parent_joint >= 0) {
    chain.push_back(robot.links[static_cast<std::size_t>(link)].parent_joint);
    link = robot.joints[static_cast<std::size_t>(chain.back())].parent_link;
  }
  std::reverse(chain.begin(), chain.end());
  return chain;
}

const MakerJoint& joint_at(const MakerRobot& robot, int index) {
  return robot.joints[static_cast<std::size_t>(index)];
}

// One chain to the end of each branch.
std::vector<Chain> all_chains(const MakerRobot& robot) {
  std::vector<bool> carries(robot.links.size(), false);
  for (const MakerJoint& joint : robot.joints) carries[static_cast<std::size_t>(joint.parent_link)] = true;
  std::vector<Chain> chains;
  for (std::size_t link = 1; link < robot.links.size(); ++link) {
    if (!carries[link]) chains.push_back(chain_to(robot, static_cast<int>(link)));
  }
  return chains;
}

// Where the joints are and turn at zero, in the root's frame.
struct ZeroPosture {
  explicit ZeroPosture(const MakerRobot& robot)
      : link(link_poses(robot, std::vector<double>(robot.joints.size(), 0.0))) {
    for (const MakerJoint& joint : robot.joints) {
      const Eigen::Isometry3d& child = link[static_cast<std::size_t>(joint.child_link)];
      axis.push_back(child.linear() * joint.axis);
      point_m.push_back(child.translation());
    }
  }
  std::vector<Eigen::Isometry3d> link;
  std::vector<Eigen::Vector3d> axis, point_m;
};

struct Candidate {
  std::array<std::array<int, 6>, 2> legs{};  // not yet known which is the left one
  Eigen::Vector3d up, left;                  // unit; left: from the second leg to the first
  double drop_m = 0.0;                       // of the feet below the hips
};

double turns_about(const ZeroPosture& zero, int joint, const Eigen::Vector3d& axis) {
  return std::abs(zero.axis[static_cast<std::size_t>(joint)].dot(axis));
}

// Empty, or what the chain lacks to be a leg.
std::string lack_of(const ZeroPosture& zero, const std::array<int, 6>& leg, const Eigen::Vector3d& up,
                    const Eigen::Vector3d& left) {
  const Eigen::Vector3d forward = left.cross(up);
  const auto first_three = [&](const Eigen::Vector3d& axis) {
    return std::max(
        {turns_about(zero, leg[0], axis), turns_about(zero, leg[1], axis), turns_about(zero, leg[2], axis)});
  };
  if (first_three(up) < kLeastCosine) return "hip yaw";
  if (first_three(forward) < kLeastCosine) return "hip roll";
  if (first_three(left) < kLeastCosine) return "hip pitch";
  if (turns_about(zero, leg[3], left) < kLeastCosine) return "knee";
  const auto ankle = [&](int pitch, int roll) {
    return std::min(turns_about(zero, pitch, left), turns_about(zero, roll, forward));
  };
  return std::max(ankle(leg[4], leg[5]), ankle(leg[5], leg[4])) < kLeastCosine ? "ankle pitch or roll" : "";
}

// The six joints behind the link where two chains part.
std::optional<std::array<int, 6>> six_from(const Chain& chain, std::size_t begin) {
  if (chain.size() < begin + 6) return std::nullopt;
  std::array<int, 6> six{};
  std::copy_n(chain.begin() + static_cast<std::ptrdiff_t>(begin), 6, six.begin());
  return six;
}

double length_of(const ZeroPosture& zero, const std::array<int, 6>& leg) {
  double length_m = 0.0;
  for (std::size_t i = 1; i < leg.size(); ++i) {
    length_m +=
        (zero.point_m[static_cast<std::size_t>(leg[i])] - zero.point_m[static_cast<std::size_t>(leg[i - 1])])
            .norm();
  }
  return length_m;
}

// An axis of the root's frame that was meant, if it is near to one.
Eigen::Vector3d rounded(const Eigen::Vector3d& direction) {
  Eigen::Index largest = 0;
  direction.cwiseAbs().maxCoeff(&largest);
  const Eigen::Vector3d axis = Eigen::Vector3d::Unit(largest) * (direction[largest] > 0.0 ? 1.0 : -1.0);
  return axis.dot(direction) > kSameAxis ? axis : direction;
}

const std::array<Eigen::Vector3d, 6>& ways_up() {
  static const std::array<Eigen::Vector3d, 6> ways{Eigen::Vector3d::UnitZ(),  Eigen::Vector3d::UnitY(),
                                                   Eigen::Vector3d::UnitX(),  -Eigen::Vector3d::UnitZ(),
                                                   -Eigen::Vector3d::UnitY(), -Eigen::Vector3d::UnitX()};
  return ways;
}

std::vector<Candidate> candidates_of(const MakerRobot& robot, const ZeroPosture& zero) {
  const std::vector<Chain> chains = all_chains(robot);
  std::set<std::pair<std::array<int, 6>, std::array<int, 6>>> seen;
  std::vector<Candidate> candidates;
  for (std::size_t a = 0; a < chains.size(); ++a) {
    for (std::size_t b = a + 1; b < chains.size(); ++b) {
      const auto parting =
          std::mismatch(chains[a].begin(), chains[a].end(), chains[b].begin(), chains[b].end());
      const auto shared = static_cast<std::size_t>(parting.first - chains[a].begin());
      const auto first = six_from(chains[a], shared), second = six_from(chains[b], shared);
      if (!first || !second || !seen.emplace(*first, *second).second) continue;
      const auto place = [&](const std::array<int, 6>& leg, std::size_t joint) {
        return zero.point_m[static_cast<std::size_t>(leg[joint])];
      };
      for (const Eigen::Vector3d& up : ways_up()) {
        const Eigen::Vector3d across = place(*first, 3) - place(*second, 3);
        const Eigen::Vector3d level = across - up * up.dot(across);
        if (level.norm() < 0.5 * across.norm() || level.norm() <= 0.0) continue;
        const Eigen::Vector3d left = rounded(level.normalized());
        if (!lack_of(zero, *first, up, left).empty() || !lack_of(zero, *second, up, left).empty()) continue;
        const double drop_m =
            0.5 * up.dot(place(*first, 0) + place(*second, 0) - place(*first, 5) - place(*second, 5));
        if (drop_m < kLeastDrop * length_of(zero, *first)) continue;
        candidates.push_back({{*first, *second}, up, left, drop_m});
        break;
      }
    }
  }
  std::stable_sort(candidates.begin(), candidates.end(), [&](const Candidate& a, const Candidate& b) {
    const auto foot = [&](const Candidate& c) {
      return c.up.dot(zero.point_m[static_cast<std::size_t>(c.legs[0][5])] +
                      zero.point_m[static_cast<std::size_t>(c.legs[1][5])]);
    };
    return foot(a) < foot(b);
  });
  return candidates;
}

[[noreturn]] void refuse(const MakerRobot& robot, int line, const std::string& field, const std::string& rule,
                         const std::string& remedy) {
  input::refuse({robot.file, line, field, "", rule, remedy});
}

// What the chain to the lowest link has and lacks.
[[noreturn]] void refuse_without_legs(const MakerRobot& robot, const ZeroPosture& zero) {
  const std::vector<Chain> chains = all_chains(robot);
  if (chains.empty()) {
    refuse(robot, 0, "robot", "nothing of it turns: a walking robot has two legs of six joints",
           "Check the types of the joints: 'revolute' ones turn");
  }
  const auto height = [&](const Chain& chain) {
    return zero.point_m[static_cast<std::size_t>(chain.back())].z();
  };
  const Chain& lowest = *std::min_element(
      chains.begin(), chains.end(), [&](const Chain& a, const Chain& b) { return height(a) < height(b); });
  std::vector<std::string> names;
  for (const int joint : lowest) names.push_back(joint_at(robot, joint).name);
  const MakerJoint& last = joint_at(robot, lowest.back());
  const std::string foot = robot.links[static_cast<std::size_t>(last.child_link)].name;
  const std::string remedy =
      "A leg that walks here has six turning joints: three of the hip (yaw, roll, pitch in any order), the "
      "knee, "
      "ankle pitch and roll";
  if (lowest.size() < 6) {
    refuse(robot, last.line, "legs",
           fmt::format("the chain to the lowest link '{}' has {} joint{} only: {}", foot, lowest.size(),
                       lowest.size() == 1 ? "" : "s", fmt::join(names, ", ")),
           remedy);
  }
  std::array<int, 6> six{};
  std::copy_n(lowest.end() - 6, 6, six.begin());
  const std::string lack = lack_of(zero, six, Eigen::Vector3d::UnitZ(), Eigen::Vector3d::UnitY());
  refuse(robot, last.line, "legs",
         fmt::format(
             "no two chains of six joints go down from one link like legs. The chain to the lowest link '{}' "
             "({}) {}",
             foot, fmt::join(names, ", "),
             lack.empty() ? "has no other like it" : "has no " + lack + " where one belongs"),
         remedy);
}

void refuse_more_legs(const MakerRobot& robot, const ZeroPosture& zero, const std::vector<Candidate>& all) {
  const Candidate& best = all.front();
  std::set<int> feet;
  const double ground = best.up.dot(zero.point_m[static_cast<std::size_t>(best.legs[0][5])]);
  for (const Candidate& candidate : all) {
    if (candidate.up != best.up) continue;
    for (const auto& leg : candidate.legs) {
      const double foot = best.up.dot(zero.point_m[static_cast<std::size_t>(leg[5])]);
      if (foot - ground < (1.0 - kReachesGround) * best.drop_m) feet.insert(leg[5]);
    }
  }
  if (feet.size() <= 2) return;
  std::vector<std::string> names;
  for (const int foot : feet) names.push_back(joint_at(robot, foot).name);
  refuse(
      robot, joint_at(robot, *feet.begin()).line, "legs",
      fmt::format("{} chains like legs reach the ground (they end with the joints {}); the gait is for two",
                  feet.size(), fmt::join(names, ", ")),
      "Bring a robot with two legs");
}

// Extent of a link's surfaces along a direction, against a point.
struct Extent {
  double ahead_m = 0.0, behind_m = 0.0;
};
Extent extent_of(const MakerLink& link, const Eigen::Isometry3d& pose, const Eigen::Vector3d& from_m,
                 const Eigen::Vector3d& direction) {
  Extent extent;
  const auto add = [&](const Surface& surface) {
    for (const Eigen::Vector3d& point : surface.point_m) {
      const double along_m = direction.dot(pose * point - from_m);
      extent.ahead_m = std::max(extent.ahead_m, along_m);
      extent.behind_m = std::max(extent.behind_m, -along_m);
    }
  };
  for (const VisualSurface& visual : link.visual) add(visual.surface);
  for (const Surface& surface : link.collision) add(surface);
  return extent;
}

// Above 0: what was taken for forward is. From the knees, which the gait bends forward; where they bend both
// ways, from the feet.
double forward_evidence(const MakerRobot& robot, const ZeroPosture& zero, const Candidate& candidate,
                        const Eigen::Vector3d& forward) {
  double feet = 0.0, knees = 0.0;
  for (const auto& leg : candidate.legs) {
    const MakerJoint& last = joint_at(robot, leg[5]);
    const auto foot = static_cast<std::size_t>(last.child_link);
    const Extent extent = extent_of(robot.links[foot], zero.link[foot],
                                    zero.point_m[static_cast<std::size_t>(leg[5])], forward);
    const double length_m = extent.ahead_m + extent.behind_m;
    if (length_m > 0.0) feet += (extent.ahead_m - extent.behind_m) / length_m / 2.0;
    // Bent by a positive angle about `axis`, the shin goes to axis x down.
    const MakerJoint& knee = joint_at(robot, leg[3]);
    const Eigen::Vector3d goes = zero.axis[static_cast<std::size_t>(leg[3])].cross(-candidate.up);
    knees -= goes.dot(forward) * (knee.upper_rad.value_or(0.0) + knee.lower_rad.value_or(0.0)) / 2.0;
  }
  constexpr double kClearKnee_rad = 0.1;
  if (std::abs(knees) > kClearKnee_rad) return knees;
  return std::abs(feet) > kClear ? feet : 0.0;
}

LegChain named(const MakerRobot& robot, const std::array<int, 6>& leg) {
  LegChain chain;
  for (std::size_t i = 0; i < leg.size(); ++i) chain.joints[i] = joint_at(robot, leg[i]).name;
  chain.foot = robot.links[static_cast<std::size_t>(joint_at(robot, leg[5]).child_link)].name;
  return chain;
}

void add_beyond(const MakerRobot& robot, const std::array<int, 6>& leg, std::vector<std::string>& names) {
  std::set<int> carried{joint_at(robot, leg[5]).child_link};
  for (const MakerJoint& joint : robot.joints) {  // parents come before children
    if (!carried.contains(joint.parent_link)) continue;
    carried.insert(joint.child_link);
    names.push_back(joint.name);
  }
}

std::string axis_name(const Eigen::Vector3d& direction) {
  for (int i = 0; i < 3; ++i) {
    if (std::abs(direction[i]) > kSameAxis) return fmt::format("{}{}", direction[i] > 0 ? "" : "-", "xyz"[i]);
  }
  return fmt::format("({:.3f}, {:.3f}, {:.3f})", direction.x(), direction.y(), direction.z());
}

}  // namespace

BodyPlan find_body_plan(const MakerRobot& robot, const PlanHints& hints) {
  const ZeroPosture zero(robot);
  const std::vector<Candidate> candidates = candidates_of(robot, zero);
  if (candidates.empty()) refuse_without_legs(robot, zero);
  refuse_more_legs(robot, zero, candidates);
  Candidate found = candidates.front();
  const MakerJoint& first = joint_at(robot, found.legs[0][0]);
  if (first.parent_link != 0) {
    refuse(robot, first.line, "legs",
           fmt::format("the legs hang on the link '{}', which is not the root '{}'",
                       robot.links[static_cast<std::size_t>(first.parent_link)].name, robot.links[0].name),
           "Make the link that carries both legs the root of the URDF");
  }
  Eigen::Vector3d forward = found.left.cross(found.up);
  const double evidence =
      hints.forward ? hints.forward->dot(forward) : forward_evidence(robot, zero, found, forward);
  if (hints.forward && std::abs(evidence) < kAcross) {
    refuse(robot, first.line, "forward",
           fmt::format("{} was said, but the robot looks along {} or {}", axis_name(*hints.forward),
                       axis_name(forward), axis_name(-forward)),
           "Say --forward " + axis_name(forward) + " or " + axis_name(-forward) + ", or leave it out");
  }
  if (evidence == 0.0) {
    refuse(robot, first.line, "forward",
           fmt::format("neither the feet nor the knees tell whether {} or {} is forward", axis_name(forward),
                       axis_name(-forward)),
           "Say it: --forward " + axis_name(forward) + " (an axis of the root link)");
  }
  if (evidence < 0.0) {
    forward = -forward;
    found.left = -found.left;
    std::swap(found.legs[0], found.legs[1]);
  }
  BodyPlan plan;
  plan.base_in_root.col(0) = forward;
  plan.base_in_root.col(1) = found.left;
  plan.base_in_root.col(2) = found.up;
  for (std::size_t side = 0; side < 2; ++side) {
    plan.legs[side] = named(robot, found.legs[side]);
    add_beyond(robot, found.legs[side], plan.beyond_feet);
  }
  if (!plan.base_in_root.isIdentity(1e-9)) {
    plan.notes.push_back(fmt::format("the base's frame is turned: forward is the root link's {}, up its {}",
                                     axis_name(forward), axis_name(found.up)));
  }
  return plan;
}

MakerRobot with_turned_frame(MakerRobot robot, std::size_t link, const Eigen::Matrix3d& new_in_old) {
  Eigen::Isometry3d turn = Eigen::Isometry3d::Identity();
  turn.linear() = new_in_old.transpose();
  MakerLink& turned = robot.links[link];
  turned.com_m = turn * turned.com_m;
  turned.inertia_kg_m2 = turn.linear() * turned.inertia_kg_m2 * turn.linear().transpose();
  const auto turn_surface = [&turn](Surface& surface) {
    for (Eigen::Vector3d& point : surface.point_m) point = turn * point;
  };
  for (VisualSurface& visual : turned.visual) turn_surface(visual.surface);
  for (Surface& surface : turned.collision) turn_surface(surface);
  for (auto& [name, pose] : turned.frames) pose = turn * pose;
  for (MakerJoint& joint : robot.joints) {
    if (joint.parent_link == static_cast<int>(link)) joint.origin = turn * joint.origin;
    if (joint.child_link != static_cast<int>(link)) continue;
    joint.origin = joint.origin * turn.inverse();
    joint.axis = turn * joint.axis;
  }
  return robot;
}

}  // namespace gaitway::importer
