// One finding after the other; what each joint carries decides which are held still.
#include "gaitway/importer/import.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cctype>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "gaitway/input/complaint.hpp"

namespace gaitway::importer {
namespace {

constexpr double kCarriedTurn_rad = std::numbers::pi - 1e-6;  // of a feedback frame, however it is rounded
constexpr double kLeastSole = 0.1;                            // of the legs' length
constexpr std::size_t kLegJoints = 12;

bool is_of_leg(const BodyPlan& plan, const std::string& joint) {
  return std::any_of(plan.legs.begin(), plan.legs.end(), [&](const LegChain& leg) {
    return std::find(leg.joints.begin(), leg.joints.end(), joint) != leg.joints.end();
  });
}

[[noreturn]] void refuse_limit(const MakerRobot& robot, const MakerJoint& joint, const std::string& value,
                               const std::string& rule) {
  input::refuse({robot.file, joint.line, fmt::format("joint '{}' limit", joint.name), value, rule,
                 "Write how far it turns: <limit lower=\"...\" upper=\"...\"/> in radians"});
}

// Joints of legs have limits that leave them room; of the others those that cannot move are held still, and
// what has no limits gets half a turn either way, which is what a feedback frame carries.
std::vector<std::string> settle_limits(MakerRobot& robot, const BodyPlan& plan,
                                       std::vector<std::string>& notes) {
  std::vector<std::string> immovable, endless, clipped;
  for (MakerJoint& joint : robot.joints) {
    const bool of_leg = is_of_leg(plan, joint.name);
    if (!joint.lower_rad || !joint.upper_rad) {
      if (of_leg && joint.is_continuous) {
        input::refuse({robot.file, joint.line, fmt::format("joint '{}' type", joint.name), "'continuous'",
                       "a leg's joint must have limits",
                       "Write type=\"revolute\", and how far it turns: <limit lower=\"...\" "
                       "upper=\"...\"/> in radians"});
      }
      if (of_leg) refuse_limit(robot, joint, "", "a leg's joint must have limits");
      endless.push_back(joint.name);
      joint.lower_rad = joint.lower_rad.value_or(-kCarriedTurn_rad);
      joint.upper_rad = joint.upper_rad.value_or(kCarriedTurn_rad);
    }
    if (std::max(-*joint.lower_rad, *joint.upper_rad) > kCarriedTurn_rad) {
      clipped.push_back(joint.name);
      joint.lower_rad = std::clamp(*joint.lower_rad, -kCarriedTurn_rad, kCarriedTurn_rad);
      joint.upper_rad = std::clamp(*joint.upper_rad, -kCarriedTurn_rad, kCarriedTurn_rad);
    }
    if (*joint.lower_rad < *joint.upper_rad) continue;
    if (of_leg) {
      refuse_limit(robot, joint, fmt::format("{:g}..{:g} rad", *joint.lower_rad, *joint.upper_rad),
                   "a leg's joint must be able to move");
    }
    immovable.push_back(joint.name);
  }
  if (!endless.empty()) {
    notes.push_back(fmt::format("without limits, so half a turn either way: {}", fmt::join(endless, ", ")));
  }
  if (!clipped.empty()) {
    notes.push_back(fmt::format("limits beyond half a turn, which is what the bus carries, cut: {}",
                                fmt::join(clipped, ", ")));
  }
  if (!immovable.empty()) {
    notes.push_back(
        fmt::format("held still, since their limits leave them no way: {}", fmt::join(immovable, ", ")));
  }
  return immovable;
}

// `angles`: of the joints that are held, in the robot's order.
MakerRobot without(const MakerRobot& robot, const std::vector<std::string>& names,
                   const std::vector<double>& angle_rad) {
  std::vector<std::optional<double>> held(robot.joints.size());
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (std::find(names.begin(), names.end(), robot.joints[i].name) != names.end()) held[i] = angle_rad[i];
  }
  return hold_still(robot, held);
}

[[noreturn]] void refuse_hold(const MakerRobot& robot, const std::string& name) {
  std::vector<std::string> movable;
  for (const MakerJoint& joint : robot.joints) movable.push_back(joint.name);
  throw std::invalid_argument(fmt::format(
      "{}: --hold '{}': no joint that turns by itself is called so (fixed, prismatic and mimicking "
      "ones are held still anyway). {}",
      robot.file.string(), name, input::suggest(name, movable)));
}

std::vector<double> neutral(const MakerRobot& robot) {
  std::vector<double> angle_rad;
  for (const MakerJoint& joint : robot.joints) angle_rad.push_back(neutral_rad(joint));
  return angle_rad;
}

// What no robot's folder may hold is refused here, where the maker's lines are known.
void require_reasonable(const MakerRobot& robot) {
  constexpr double kLargestMass_kg = 200.0, kLargestLength_m = 2.0;
  constexpr double kLeastEffort_Nm = 0.01, kLeastVelocity_rad_per_s = 0.1;
  const auto require = [&](bool holds, int line, const std::string& field, const std::string& value,
                           const std::string& rule, const std::string& remedy) {
    if (!holds) input::refuse({robot.file, line, field, value, rule, remedy});
  };
  for (const MakerLink& link : robot.links) {
    require(link.mass_kg <= kLargestMass_kg, link.line, fmt::format("link '{}' mass", link.name),
            fmt::format("{:g} kg", link.mass_kg),
            fmt::format("must be at most {:g} kg, with all that is fixed to it", kLargestMass_kg),
            "Write the mass in kilograms");
    require(link.com_m.norm() <= kLargestLength_m, link.line,
            fmt::format("link '{}' inertial origin", link.name),
            fmt::format("{:g} m from the link's origin", link.com_m.norm()),
            fmt::format("must be at most {:g} m, with all that is fixed to it", kLargestLength_m),
            "Write lengths in metres");
  }
  for (const MakerJoint& joint : robot.joints) {
    const auto field = [&](const char* name) { return fmt::format("joint '{}' {}", joint.name, name); };
    require(joint.origin.translation().norm() <= kLargestLength_m, joint.line, field("origin"),
            fmt::format("{:g} m", joint.origin.translation().norm()),
            fmt::format("must lie within {:g} m of the joint before it", kLargestLength_m),
            "Write lengths in metres");
    require(joint.effort_Nm.value_or(kLeastEffort_Nm) >= kLeastEffort_Nm, joint.line, field("limit effort"),
            fmt::format("{:g}", joint.effort_Nm.value_or(0.0)),
            fmt::format("must be at least {:g} N·m", kLeastEffort_Nm),
            "Write N·m, or 0 where it is not known");
    require(joint.velocity_rad_per_s.value_or(kLeastVelocity_rad_per_s) >= kLeastVelocity_rad_per_s,
            joint.line, field("limit velocity"), fmt::format("{:g}", joint.velocity_rad_per_s.value_or(0.0)),
            fmt::format("must be at least {:g} rad/s", kLeastVelocity_rad_per_s),
            "Write rad/s, or 0 where it is not known");
  }
}

void require_usual_size(const ImportedRobot& imported) {
  constexpr double kLowest_m = 0.02, kHighest_m = 2.0, kShortestSole_m = 0.001, kLongestSole_m = 1.0;
  const auto refuse = [&](const std::string& field, const std::string& value, double least, double most) {
    input::refuse({imported.robot.file, 0, field, value, fmt::format("must be {:g}..{:g} m", least, most),
                   "Write lengths in metres"});
  };
  const double height_m = imported.home.hip_height_m;
  if (height_m < kLowest_m || height_m > kHighest_m)
    refuse("hips above the soles", fmt::format("{:.4g} m", height_m), kLowest_m, kHighest_m);
  for (std::size_t side = 0; side < imported.soles.size(); ++side) {
    const Eigen::Vector2d& size_m = imported.soles[side].size_m;
    if (size_m.minCoeff() < kShortestSole_m || size_m.maxCoeff() > kLongestSole_m)
      refuse(fmt::format("link '{}' sole", imported.plan.legs[side].foot),
             fmt::format("{:.4g} x {:.4g} m", size_m.x(), size_m.y()), kShortestSole_m, kLongestSole_m);
  }
}

// A link must weigh something, and no body has a principal moment above the other two together.
void make_sound(MakerRobot& robot, std::vector<std::string>& notes) {
  constexpr double kDummy = 5e-4;                   // of the robot's mass
  constexpr double kDummyGyration_m_per_m3 = 0.25;  // of the edge of a cube of water of that mass
  constexpr double kLeastMoment = 1e-3;             // of the largest
  constexpr double kWaterDensity_kg_per_m3 = 1000.0;
  constexpr double kMargin = 1e-6;
  constexpr double kWorthTelling = 0.01;
  const double dummy_kg = kDummy * total_mass_kg(robot);
  std::vector<std::string> dummies, light, pointlike, unsound;
  double added_kg = 0.0;
  for (MakerLink& link : robot.links) {
    if (link.mass_kg < dummy_kg) {
      (link.mass_kg > 0.0 ? light : dummies).push_back(link.name);
      added_kg += link.mass_kg > 0.0 ? dummy_kg - link.mass_kg : 0.0;
      link.mass_kg = dummy_kg;
    }
    const double gyration_m = kDummyGyration_m_per_m3 * std::cbrt(link.mass_kg / kWaterDensity_kg_per_m3);
    const double least_kg_m2 = link.mass_kg * gyration_m * gyration_m;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(link.inertia_kg_m2);
    const Eigen::Vector3d found = solver.eigenvalues();  // ascending
    Eigen::Vector3d moment = found.cwiseMax(std::max(kLeastMoment * found[2], 0.1 * least_kg_m2));
    if (found[2] <= 0.0) {
      moment.setConstant(least_kg_m2);
      if (link.mass_kg > dummy_kg) pointlike.push_back(link.name);
    }
    // With a margin, since the numbers are rounded when they are written.
    const double missing = (1.0 + kMargin) * moment[2] - moment[0] - moment[1];
    if (missing > 0.0) moment.head<2>().array() += 0.5 * missing;
    if ((moment - found).maxCoeff() <= 0.0) continue;
    if (found[2] > 0.0 && (moment - found).maxCoeff() > kWorthTelling * moment[2])
      unsound.push_back(link.name);
    link.inertia_kg_m2 = solver.eigenvectors() * moment.asDiagonal() * solver.eigenvectors().transpose();
  }
  if (!dummies.empty()) {
    notes.push_back(
        fmt::format("links without mass got {:.3g} kg each (guess): {}", dummy_kg, fmt::join(dummies, ", ")));
  }
  if (!light.empty()) {
    notes.push_back(fmt::format("links lighter than {:.3g} kg were raised to it, {:.3g} kg more in all: {}",
                                dummy_kg, added_kg, fmt::join(light, ", ")));
  }
  if (!pointlike.empty()) {
    notes.push_back(fmt::format("links without inertia got that of a ball of water of their mass (guess): {}",
                                fmt::join(pointlike, ", ")));
  }
  if (!unsound.empty()) {
    notes.push_back(fmt::format("inertias that no body has were raised: {}", fmt::join(unsound, ", ")));
  }
}

const MakerJoint& joint_named(const MakerRobot& robot, const std::string& name) {
  return robot.joints[static_cast<std::size_t>(*robot.joint_index(name))];
}

Eigen::Vector3d ankle_in_foot(const MakerRobot& robot, const LegChain& leg) {
  // The last joint's frame is the foot link's; the pitch and roll axes of most ankles meet there.
  const MakerJoint& last = joint_named(robot, leg.joints[5]);
  const MakerJoint& before = joint_named(robot, leg.joints[4]);
  // The point of the last axis that lies nearest to the axis before.
  const Eigen::Isometry3d to_foot = last.origin.inverse();
  const Eigen::Vector3d point = to_foot.translation(), direction = to_foot.linear() * before.axis;
  const double across = last.axis.dot(direction);
  const double along =
      (last.axis.dot(point) - across * direction.dot(point)) / std::max(1.0 - across * across, 1e-6);
  return along * last.axis;
}

std::array<FoundSole, 2> find_soles(const MakerRobot& robot, const BodyPlan& plan,
                                    std::vector<std::string>& notes) {
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, neutral(robot));
  std::array<FoundSole, 2> soles;
  for (std::size_t side = 0; side < 2; ++side) {
    const LegChain& leg = plan.legs[side];
    double length_m = 0.0;
    for (std::size_t i = 1; i < leg.joints.size(); ++i) {
      length_m += joint_named(robot, leg.joints[i]).origin.translation().norm();
    }
    const auto link = static_cast<std::size_t>(joint_named(robot, leg.joints[5]).child_link);
    const MakerLink& foot = robot.links[link];
    const Eigen::Vector3d ankle_m = ankle_in_foot(robot, leg);
    try {
      soles[side] = find_sole(foot, poses[link], ankle_m, kLeastSole * length_m);
    } catch (const std::invalid_argument& lacking) {
      soles[side] = guess_sole(foot, poses[link], ankle_m, length_m);
      notes.push_back(fmt::format("guess: {}; it got one of {:.3f} by {:.3f} m, {:.3f} m below the ankle",
                                  lacking.what(), soles[side].size_m.x(), soles[side].size_m.y(),
                                  (ankle_m - soles[side].pose.translation()).norm()));
    }
  }
  return soles;
}

bool contains_word(std::string text, const std::string& word) {
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text.find(word) != std::string::npos;
}

// A frame named after it on the base or on what the waist carries, the nearer to the base first; else the
// base.
ImuPlace find_imu(const MakerRobot& robot, const BodyPlan& plan) {
  const auto outside_legs_and_arms = [&](const MakerLink& link, const Eigen::Isometry3d& pose) {
    const bool of_leg = link.parent_joint >= 0 &&
                        is_of_leg(plan, robot.joints[static_cast<std::size_t>(link.parent_joint)].name);
    constexpr double kMiddle_m = 0.1;
    return !of_leg && std::abs(pose.translation().y()) < kMiddle_m;
  };
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, neutral(robot));
  constexpr double kTrunkShare = 0.1;  // of the mass: no head
  const double mass_kg = total_mass_kg(robot);
  for (std::size_t i = 0; i < robot.links.size(); ++i) {
    const MakerLink& link = robot.links[i];
    if (!outside_legs_and_arms(link, poses[i]) || link.mass_kg < kTrunkShare * mass_kg) continue;
    for (const auto& [name, pose] : link.frames) {
      if (contains_word(name, "imu") || contains_word(name, "gyro")) {
        return {link.name, pose, fmt::format("the frame '{}'", name)};
      }
    }
  }
  return {robot.links.front().name, Eigen::Isometry3d::Identity(),
          "guess: the URDF names none, so at the base's origin, along its axes"};
}

// The link that carries the IMU is what attitude is told of: in the home posture its axes are the base's.
void place_imu(ImportedRobot& imported) {
  imported.imu = find_imu(imported.robot, imported.plan);
  std::size_t link = 0;
  while (imported.robot.links[link].name != imported.imu.link) ++link;
  const Eigen::Matrix3d base_in_link =
      link_poses(imported.robot, imported.home.angle_rad)[link].linear().transpose();
  imported.robot = with_turned_frame(std::move(imported.robot), link, base_in_link);
  imported.imu.pose = Eigen::Isometry3d(base_in_link.transpose()) * imported.imu.pose;
}

}  // namespace

ImportedRobot import_robot(const std::filesystem::path& file, const ImportOptions& options) {
  ImportedRobot result;
  const MakerRobot read = read_maker_urdf(file, options.read);
  result.plan = find_body_plan(read, options.plan);
  result.notes = read.notes;
  result.robot = with_turned_frame(read, 0, result.plan.base_in_root);
  result.held_still = options.held_still;
  for (const std::string& name : options.held_still) {
    if (!result.robot.joint_index(name)) {
      refuse_hold(result.robot, name);
    }
    if (is_of_leg(result.plan, name)) {
      throw std::invalid_argument(fmt::format("'{}' is a leg's joint: it can't be held still", name));
    }
  }
  const std::vector<std::string> immovable = settle_limits(result.robot, result.plan, result.notes);
  std::vector<std::string> merged = immovable;
  merged.insert(merged.end(), options.held_still.begin(), options.held_still.end());
  merged.insert(merged.end(), result.plan.beyond_feet.begin(), result.plan.beyond_feet.end());
  if (!result.plan.beyond_feet.empty()) {
    result.notes.push_back(fmt::format("toes, held still: {}", fmt::join(result.plan.beyond_feet, ", ")));
    result.held_still.insert(result.held_still.end(), result.plan.beyond_feet.begin(),
                             result.plan.beyond_feet.end());
  }
  result.robot = without(result.robot, merged, neutral(result.robot));
  if (!(total_mass_kg(result.robot) > 0.0)) {
    input::refuse({file, 0, "robot", "", "no link has a mass", "Give the links <inertial> elements"});
  }
  require_reasonable(result.robot);
  make_sound(result.robot, result.notes);
  result.soles = find_soles(result.robot, result.plan, result.notes);
  result.home = find_home_posture(result.robot, result.plan, result.soles);
  require_usual_size(result);
  place_imu(result);
  result.drives = drive_figures(result.robot, result.plan, result.home.hip_height_m);
  const auto add = [&result](const std::vector<std::string>& notes) {
    result.notes.insert(result.notes.end(), notes.begin(), notes.end());
  };
  add(result.plan.notes);
  add(result.home.notes);
  return result;
}

ImportedRobot with_knees_bent(const ImportedRobot& imported, double most_bend_rad) {
  ImportedRobot result = imported;
  result.home = find_home_posture(result.robot, result.plan, result.soles, most_bend_rad);
  place_imu(result);
  result.drives = drive_figures(result.robot, result.plan, result.home.hip_height_m);
  return result;
}

ImportedRobot with_fewer_joints(const ImportedRobot& imported, std::size_t most) {
  if (most < kLegJoints) throw std::invalid_argument("the legs alone have twelve joints");
  const MakerRobot& robot = imported.robot;
  if (robot.joints.size() <= most) return imported;
  // The first moment of what each joint carries says how much a body misses it.
  const std::vector<Eigen::Isometry3d> poses = link_poses(robot, imported.home.angle_rad);
  std::vector<double> missed(robot.joints.size(), 0.0);
  for (std::size_t link = 1; link < robot.links.size(); ++link) {
    const Eigen::Vector3d com_m = poses[link] * robot.links[link].com_m;
    for (int at = static_cast<int>(link); robot.links[static_cast<std::size_t>(at)].parent_joint >= 0;) {
      const auto joint = static_cast<std::size_t>(robot.links[static_cast<std::size_t>(at)].parent_joint);
      const Eigen::Vector3d from_m =
          poses[static_cast<std::size_t>(robot.joints[joint].child_link)].translation();
      missed[joint] += robot.links[link].mass_kg * (com_m - from_m).norm();
      at = robot.joints[joint].parent_link;
    }
  }
  std::vector<std::size_t> order;
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    if (!is_of_leg(imported.plan, robot.joints[i].name)) order.push_back(i);
  }
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return missed[a] < missed[b]; });
  // What mirrors the last one that goes, goes with it.
  constexpr double kAlike = 0.03;
  std::size_t going = robot.joints.size() - most;
  while (going > 0 && going < order.size() &&
         missed[order[going]] < missed[order[going - 1]] * (1.0 + kAlike))
    ++going;
  order.resize(going);
  std::vector<std::string> names;
  for (const std::size_t i : order) names.push_back(robot.joints[i].name);
  ImportedRobot result = imported;
  result.robot = without(robot, names, imported.home.angle_rad);
  result.home.angle_rad.clear();
  result.drives.clear();
  for (const MakerJoint& joint : result.robot.joints) {
    const auto before = static_cast<std::size_t>(*robot.joint_index(joint.name));
    result.home.angle_rad.push_back(imported.home.angle_rad[before]);
    result.drives.push_back(imported.drives[before]);
  }
  result.held_still.insert(result.held_still.end(), names.begin(), names.end());
  result.notes.push_back(fmt::format("held still, since one bus does not carry more than {} joints: {}", most,
                                     fmt::join(names, ", ")));
  place_imu(result);
  return result;
}

}  // namespace gaitway::importer
