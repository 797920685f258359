// Merges links that do not move against each other; poses of links.
#include <fmt/format.h>

#include <stdexcept>
#include <utility>

#include "maker_tree.hpp"
#include "surfaces.hpp"

namespace gaitway::importer {
namespace {

// Inertia of a mass about a point that lies `offset_m` from its centre.
Eigen::Matrix3d steiner(double mass_kg, const Eigen::Vector3d& offset_m) {
  return mass_kg * (offset_m.squaredNorm() * Eigen::Matrix3d::Identity() - offset_m * offset_m.transpose());
}

void merge_mass(MakerLink& whole, const MakerLink& part, const Eigen::Isometry3d& pose) {
  const double mass_kg = whole.mass_kg + part.mass_kg;
  const Eigen::Vector3d part_com_m = pose * part.com_m;
  Eigen::Vector3d com_m = whole.com_m;
  if (mass_kg > 0.0) {
    com_m = (whole.mass_kg * whole.com_m + part.mass_kg * part_com_m) / mass_kg;
  }
  whole.inertia_kg_m2 += steiner(whole.mass_kg, whole.com_m - com_m) +
                         pose.linear() * part.inertia_kg_m2 * pose.linear().transpose() +
                         steiner(part.mass_kg, part_com_m - com_m);
  whole.mass_kg = mass_kg;
  whole.com_m = com_m;
}

void require_one_each(const MakerRobot& robot, std::size_t given) {
  if (given != robot.joints.size()) {
    throw std::invalid_argument(fmt::format("{} joints, but {} values for them", robot.joints.size(), given));
  }
}

Eigen::Isometry3d pose_at(const MakerJoint& joint, double angle_rad) {
  return joint.origin * Eigen::AngleAxisd(angle_rad, joint.axis);
}

}  // namespace

void merge_link(MakerLink& whole, MakerLink part, const Eigen::Isometry3d& pose) {
  merge_mass(whole, part, pose);
  for (VisualSurface& visual : part.visual) {
    move_surface(visual.surface, Eigen::Affine3d(pose));
    whole.visual.push_back(std::move(visual));
  }
  for (Surface& collision : part.collision) {
    move_surface(collision, Eigen::Affine3d(pose));
    whole.collision.push_back(std::move(collision));
  }
  whole.frames.emplace(part.name, pose);
  for (const auto& [name, frame] : part.frames) {
    whole.frames.emplace(name, pose * frame);
  }
}

MakerRobot merge_rigid(MakerRobot robot, const std::vector<std::optional<Eigen::Isometry3d>>& rigid) {
  struct Place {
    int link;  // that it has become a piece of
    Eigen::Isometry3d pose;
  };
  std::vector<Place> places{{0, Eigen::Isometry3d::Identity()}};
  std::vector<MakerLink> links;
  std::vector<MakerJoint> joints;
  links.push_back(std::move(robot.links.at(0)));
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    MakerJoint& joint = robot.joints[i];
    const Place parent = places.at(static_cast<std::size_t>(joint.parent_link));
    MakerLink& link = robot.links.at(i + 1);
    if (rigid[i]) {
      places.push_back({parent.link, parent.pose * *rigid[i]});
      merge_link(links[static_cast<std::size_t>(parent.link)], std::move(link), places.back().pose);
      continue;
    }
    places.push_back({static_cast<int>(links.size()), Eigen::Isometry3d::Identity()});
    joint.parent_link = parent.link;
    joint.child_link = places.back().link;
    joint.origin = parent.pose * joint.origin;
    link.parent_joint = static_cast<int>(joints.size());
    joints.push_back(std::move(joint));
    links.push_back(std::move(link));
  }
  robot.links = std::move(links);
  robot.joints = std::move(joints);
  return robot;
}

MakerRobot hold_still(const MakerRobot& robot, const std::vector<std::optional<double>>& held) {
  require_one_each(robot, held.size());
  std::vector<std::optional<Eigen::Isometry3d>> rigid(held.size());
  for (std::size_t i = 0; i < held.size(); ++i) {
    if (held[i]) {
      rigid[i] = pose_at(robot.joints[i], *held[i]);
    }
  }
  return merge_rigid(robot, rigid);
}

std::vector<Eigen::Isometry3d> link_poses(const MakerRobot& robot, const std::vector<double>& angle_rad) {
  require_one_each(robot, angle_rad.size());
  std::vector<Eigen::Isometry3d> result{Eigen::Isometry3d::Identity()};
  for (std::size_t i = 0; i < robot.joints.size(); ++i) {
    const MakerJoint& joint = robot.joints[i];
    result.push_back(result.at(static_cast<std::size_t>(joint.parent_link)) * pose_at(joint, angle_rad[i]));
  }
  return result;
}

std::optional<int> MakerRobot::joint_index(const std::string& joint_name) const noexcept {
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (joints[i].name == joint_name) {
      return static_cast<int>(i);
    }
  }
  return std::nullopt;
}

}  // namespace gaitway::importer
