// Bounding balls first, then the shapes themselves.
#include "gaitway/kinematic/self_collision.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::kinematic {
namespace {

// The links between two of them in the tree, both ends left out.
std::vector<int> links_between(const urdf::RobotModel& robot, int one, int other) {
  const auto to_base = [&robot](int link) {
    std::vector<int> way{link};
    while (robot.links[static_cast<std::size_t>(link)].parent_joint >= 0) {
      const int joint = robot.links[static_cast<std::size_t>(link)].parent_joint;
      link = robot.joints[static_cast<std::size_t>(joint)].parent_link;
      way.push_back(link);
    }
    return way;
  };
  std::vector<int> first = to_base(one), second = to_base(other);
  int common = 0;
  while (!first.empty() && !second.empty() && first.back() == second.back()) {
    common = first.back();
    first.pop_back();
    second.pop_back();
  }
  first.insert(first.end(), second.begin(), second.end());
  first.push_back(common);
  std::erase_if(first, [one, other](int link) { return link == one || link == other; });
  return first;
}

// One hangs on the other by at most two joints: their boxes overlap where the limb bends.
bool on_one_limb(const urdf::RobotModel& robot, int above, int below) {
  for (int joints = 0; joints < 2; ++joints) {
    const int joint = robot.links[static_cast<std::size_t>(below)].parent_joint;
    if (joint < 0) return false;
    below = robot.joints[static_cast<std::size_t>(joint)].parent_link;
    if (below == above) return true;
  }
  return false;
}

}  // namespace

SelfCollision::SelfCollision(const urdf::RobotModel& robot) {
  for (std::size_t link = 0; link < robot.links.size(); ++link) {
    const std::vector<urdf::Shape>& shapes = robot.links[link].collision;
    if (shapes.empty()) continue;
    Body body{static_cast<int>(link), {}, {}, std::vector<Eigen::Isometry3d>(shapes.size())};
    for (const urdf::Shape& shape : shapes) {
      body.shapes.emplace_back(shape);
      body.in_link.push_back(shape.pose);
    }
    bodies_.push_back(std::move(body));
  }
  place(urdf::ForwardKinematics(robot));
  for (std::size_t i = 0; i < bodies_.size(); ++i) {
    for (std::size_t j = i + 1; j < bodies_.size(); ++j) {
      const std::vector<int> between = links_between(robot, bodies_[i].link, bodies_[j].link);
      const bool neighbours = std::ranges::none_of(between, [&robot](int link) {
        return !robot.links[static_cast<std::size_t>(link)].collision.empty();
      });
      // Parents come before children.
      if (neighbours || on_one_limb(robot, bodies_[i].link, bodies_[j].link)) continue;
      if (depth_m(bodies_[i], bodies_[j]) > 0.0) {
        at_home_.emplace_back(bodies_[i].link, bodies_[j].link);
      } else {
        pairs_.emplace_back(i, j);
      }
    }
  }
}

void SelfCollision::place(const urdf::ForwardKinematics& kinematics) noexcept {
  for (Body& body : bodies_) {
    const Eigen::Isometry3d link = kinematics.link_pose(body.link);
    for (std::size_t i = 0; i < body.shapes.size(); ++i) body.poses[i] = link * body.in_link[i];
  }
}

double SelfCollision::depth_m(const Body& one, const Body& other) {
  double deepest_m = 0.0;
  for (std::size_t i = 0; i < one.shapes.size(); ++i) {
    for (std::size_t j = 0; j < other.shapes.size(); ++j) {
      const double reach_m = one.shapes[i].radius_m() + other.shapes[j].radius_m();
      const Eigen::Vector3d between_m = one.poses[i].translation() - other.poses[j].translation();
      if (between_m.squaredNorm() >= reach_m * reach_m) continue;
      deepest_m = std::max(deepest_m,
                           penetration_m({&one.shapes[i], one.poses[i]}, {&other.shapes[j], other.poses[j]}));
    }
  }
  return deepest_m;
}

const std::vector<LinkContact>& SelfCollision::find(const urdf::ForwardKinematics& kinematics) {
  place(kinematics);
  found_.clear();
  for (const auto& [i, j] : pairs_) {
    if (const double deep_m = depth_m(bodies_[i], bodies_[j]); deep_m > 0.0)
      found_.push_back({bodies_[i].link, bodies_[j].link, deep_m});
  }
  return found_;
}

}  // namespace gaitway::kinematic
