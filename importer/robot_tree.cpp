// Checks that links and joints are one tree, and puts parents before children.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "maker_tree.hpp"

namespace gaitway::importer {
namespace {

class Tree {
 public:
  explicit Tree(WrittenRobot& written) : written_(written) {}

  MakerRobot take() {
    index_links();
    connect_joints();
    const int root = the_root();
    MakerRobot robot{written_.file, written_.name, {}, {}, std::move(written_.notes)};
    std::vector<std::optional<Eigen::Isometry3d>> rigid;
    const std::vector<int> order = joints_from(root);
    robot.links.push_back(std::move(written_.links[index(root)]));
    std::map<int, int> new_index{{root, 0}};
    for (const int j : order) {
      WrittenJoint& joint = written_.joints[index(j)];
      const int child = joint.joint.child_link;
      new_index[child] = static_cast<int>(robot.links.size());
      joint.joint.parent_link = new_index.at(joint.joint.parent_link);
      joint.joint.child_link = new_index[child];
      robot.links.push_back(std::move(written_.links[index(child)]));
      robot.links.back().parent_joint = static_cast<int>(robot.joints.size());
      robot.joints.push_back(std::move(joint.joint));
      rigid.push_back(joint.rigid);
      carries_root_.push_back(joint.carries_root);
    }
    give_way(robot, rigid);
    return merge_rigid(std::move(robot), rigid);
  }

 private:
  static std::size_t index(int i) { return static_cast<std::size_t>(i); }

  [[noreturn]] void refuse(int line, const std::string& field, const std::string& rule,
                           const std::string& remedy) const {
    input::refuse({written_.file, line, field, "", rule, remedy});
  }

  void take_name(std::map<std::string, int>& taken, const std::string& name, int line,
                 const char* kind) const {
    const auto [place, is_new] = taken.emplace(name, line);
    if (!is_new) {
      refuse(line, fmt::format("{} '{}'", kind, name),
             fmt::format("the name is taken already in line {}", place->second),
             "Give each one a name of its own");
    }
  }

  void index_links() {
    std::map<std::string, int> lines;
    for (const MakerLink& link : written_.links) {
      take_name(lines, link.name, link.line, "link");
      link_index_[link.name] = static_cast<int>(link_index_.size());
    }
    if (written_.links.empty()) {
      refuse(written_.line, fmt::format("robot '{}'", written_.name), "there is no <link>",
             "A URDF holds links, and joints between them");
    }
  }

  int link_of(const WrittenJoint& joint, const std::string& name, const char* role) const {
    const auto found = link_index_.find(name);
    if (found == link_index_.end()) {
      std::vector<std::string> names;
      for (const MakerLink& link : written_.links) names.push_back(link.name);
      refuse(joint.joint.line, fmt::format("joint '{}' {} = '{}'", joint.joint.name, role, name),
             "there is no such link", input::suggest(name, names));
    }
    return found->second;
  }

  void connect_joints() {
    std::map<std::string, int> lines;
    carrier_.assign(written_.links.size(), -1);
    carried_.assign(written_.links.size(), {});
    for (std::size_t i = 0; i < written_.joints.size(); ++i) {
      WrittenJoint& joint = written_.joints[i];
      take_name(lines, joint.joint.name, joint.joint.line, "joint");
      joint.joint.parent_link = link_of(joint, joint.parent, "parent");
      joint.joint.child_link = link_of(joint, joint.child, "child");
      int& carrier = carrier_[index(joint.joint.child_link)];
      if (carrier >= 0) {
        refuse(
            joint.joint.line, fmt::format("joint '{}' child = '{}'", joint.joint.name, joint.child),
            fmt::format("joint '{}' carries that link already", written_.joints[index(carrier)].joint.name),
            "A URDF is a tree: cut the loop at one of the two joints");
      }
      carrier = static_cast<int>(i);
      carried_[index(joint.joint.parent_link)].push_back(static_cast<int>(i));
    }
  }

  int the_root() const {
    std::vector<int> roots;
    std::vector<std::string> names;
    for (std::size_t i = 0; i < carrier_.size(); ++i) {
      if (carrier_[i] < 0) {
        roots.push_back(static_cast<int>(i));
        names.push_back(fmt::format("'{}'", written_.links[i].name));
      }
    }
    if (roots.empty()) {
      refuse_loop(0);
    }
    if (roots.size() > 1) {
      refuse(written_.links[index(roots[1])].line, fmt::format("link {}", names[1]),
             fmt::format("there must be one root, but no joint carries {}", fmt::join(names, ", ")),
             "Fasten all but one of them with a fixed joint, or remove them");
    }
    return roots[0];
  }

  // Joints whose links can be reached, parents before children, in the file's order otherwise.
  std::vector<int> joints_from(int root) const {
    std::vector<int> order;
    std::vector<int> open(carried_[index(root)].rbegin(), carried_[index(root)].rend());
    while (!open.empty()) {
      order.push_back(open.back());
      open.pop_back();
      const auto& next = carried_[index(written_.joints[index(order.back())].joint.child_link)];
      open.insert(open.end(), next.rbegin(), next.rend());
    }
    if (order.size() != written_.joints.size()) {
      std::vector<bool> is_reached(written_.joints.size());
      for (const int joint : order) is_reached[index(joint)] = true;
      const auto beyond = std::find(is_reached.begin(), is_reached.end(), false);
      refuse_loop(written_.joints[static_cast<std::size_t>(beyond - is_reached.begin())].joint.child_link);
    }
    return order;
  }

  // Every link above this one is carried by a joint: goes round until a link comes twice.
  [[noreturn]] void refuse_loop(int link) const {
    std::vector<bool> is_seen(written_.links.size());
    while (!is_seen[index(link)]) {
      is_seen[index(link)] = true;
      link = written_.joints[index(carrier_[index(link)])].joint.parent_link;
    }
    std::vector<std::string> names;
    const int start = link;
    do {
      const WrittenJoint& joint = written_.joints[index(carrier_[index(link)])];
      names.push_back(fmt::format("'{}'", joint.joint.name));
      link = joint.joint.parent_link;
    } while (link != start);
    const MakerJoint& joint = written_.joints[index(carrier_[index(start)])].joint;
    refuse(joint.line, fmt::format("joint '{}'", joint.name),
           fmt::format("joints must not be a loop, but {} are", fmt::join(names, ", ")),
           "A URDF is a tree: remove one of them");
  }

  // A root without mass that carries one link rigidly or lets it float is a place in the world or a mere
  // name: the link becomes the root. Nothing else may float.
  void give_way(MakerRobot& robot, std::vector<std::optional<Eigen::Isometry3d>>& rigid) {
    while (robot.links[0].mass_kg <= 0.0 && !robot.joints.empty() && (rigid[0] || carries_root_[0]) &&
           std::count_if(robot.joints.begin(), robot.joints.end(),
                         [](const MakerJoint& joint) { return joint.parent_link == 0; }) == 1) {
      robot.notes.push_back(fmt::format("The root '{}' has no mass and gives way to '{}', which it carries.",
                                        robot.links[0].name, robot.links[1].name));
      if (rigid[0]) {
        merge_link(robot.links[1], std::move(robot.links[0]), rigid[0]->inverse());
      }
      robot.links.erase(robot.links.begin());
      robot.joints.erase(robot.joints.begin());
      rigid.erase(rigid.begin());
      carries_root_.erase(carries_root_.begin());
      for (MakerJoint& joint : robot.joints) {
        --joint.parent_link;
        --joint.child_link;
      }
      for (MakerLink& link : robot.links) {
        --link.parent_joint;
      }
    }
    const auto floating = std::find(carries_root_.begin(), carries_root_.end(), true);
    if (floating != carries_root_.end()) {
      const MakerJoint& joint = robot.joints[static_cast<std::size_t>(floating - carries_root_.begin())];
      refuse(joint.line, fmt::format("joint '{}' type", joint.name),
             "a floating or planar joint must be the only one of a root without mass",
             "Make it fixed, or remove it with the link that carries it");
    }
  }

  WrittenRobot& written_;
  std::map<std::string, int> link_index_;
  std::vector<int> carrier_;               // of each link: the joint that carries it
  std::vector<std::vector<int>> carried_;  // of each link: the joints that it carries
  std::vector<bool> carries_root_;         // of each joint of the new robot
};

}  // namespace

MakerRobot tree_of(WrittenRobot written) {
  return Tree(written).take();
}

}  // namespace gaitway::importer
