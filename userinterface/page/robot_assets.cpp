// Links, joints and shapes into JSON, meshes as they are.
#include "gaitway/page/robot_assets.hpp"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "gaitway/page/view_layout.hpp"

namespace gaitway::page {
namespace {

using Json = nlohmann::ordered_json;

template <class Vector>
Json list_of(const Vector& vector) {
  Json list = Json::array();
  for (const double value : vector) {
    list.push_back(value);
  }
  return list;
}

Json pose_of(const Eigen::Isometry3d& pose) {
  const Eigen::Quaterniond turn(pose.linear());
  return {{"place", list_of(Eigen::Vector3d(pose.translation()))}, {"turn", list_of(turn.coeffs())}};
}

// Meshes that have a place in the table: file -> path there.
class MeshShelf {
 public:
  MeshShelf(AssetTable& table, const urdf::RobotModel& robot) {
    std::size_t bytes = 0;
    for (const std::filesystem::path& file : robot.mesh_files()) {
      std::error_code unknown;
      const std::uintmax_t size = std::filesystem::file_size(file, unknown);
      if (unknown || size > kMostMeshBytes - bytes) {
        continue;
      }
      bytes += size;
      std::ifstream stream(file, std::ios::binary);
      std::string text{std::istreambuf_iterator<char>(stream), {}};
      const std::string path = "/mesh/" + std::to_string(paths_.size()) + ".stl";
      table.add(path, "model/stl", std::move(text), true);
      paths_[file] = path;
    }
  }
  [[nodiscard]] const std::string* path_of(const std::filesystem::path& file) const {
    const auto known = paths_.find(file);
    return known == paths_.end() ? nullptr : &known->second;
  }

 private:
  std::map<std::filesystem::path, std::string> paths_;
};

Json shape_of(const urdf::Shape& shape, const MeshShelf& shelf) {
  static constexpr std::array<const char*, 4> kKinds{"box", "cylinder", "sphere", "mesh"};
  Json json = pose_of(shape.pose);
  json["size"] = list_of(shape.size_m);
  json["rgba"] = list_of(shape.rgba);
  json["kind"] = kKinds[static_cast<std::size_t>(shape.kind)];
  if (shape.kind == urdf::Shape::Kind::mesh) {
    if (const std::string* const path = shelf.path_of(shape.mesh.file)) {
      json["mesh"] = *path;
      json["scale"] = list_of(shape.mesh.scale);
      json["centre"] = list_of(shape.mesh.centre_m);
    } else {
      json["kind"] = "box";
    }
  }
  return json;
}

Json link_of(const urdf::Link& link, const MeshShelf& shelf) {
  Json shapes = Json::array();
  for (const urdf::Shape& shape : link.visual.empty() ? link.collision : link.visual) {
    shapes.push_back(shape_of(shape, shelf));
  }
  return {{"name", link.name}, {"shapes", std::move(shapes)}};
}

Json joint_of(const urdf::Joint& joint) {
  Json json = pose_of(joint.origin);
  json["name"] = joint.name;
  json["parent"] = joint.parent_link;
  json["child"] = joint.child_link;
  json["axis"] = list_of(joint.axis);
  json["lower"] = joint.lower_rad;
  json["upper"] = joint.upper_rad;
  json["home"] = joint.home_rad;
  json["torque"] = joint.motor.torque_limit_Nm;
  return json;
}

Json sole_of(const urdf::Foot& foot) {
  Json json = pose_of(foot.sole);
  json["link"] = foot.link;
  json["size"] = list_of(foot.size_m);
  json["centre"] = list_of(foot.centre_m);
  return json;
}

std::vector<std::string> motions_of(const urdf::RobotModel& robot) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(robot.directory / "motions", none)) {
    if (entry.path().extension() == ".yaml") {
      names.push_back(entry.path().stem().string());
    }
  }
  std::ranges::sort(names);
  return names;
}

}  // namespace

void add_robot(AssetTable& table, const urdf::RobotModel& robot, const CommandBounds& bounds) {
  const MeshShelf shelf(table, robot);
  Json json{{"name", robot.name}, {"view_version", kViewVersion}, {"hip_height", robot.hip_height_m}};
  for (const urdf::Link& link : robot.links) {
    json["links"].push_back(link_of(link, shelf));
  }
  for (const urdf::Joint& joint : robot.joints) {
    json["joints"].push_back(joint_of(joint));
  }
  for (const urdf::Foot& foot : robot.feet) {
    json["soles"].push_back(sole_of(foot));
  }
  json["motions"] = motions_of(robot);
  json["bounds"] = {{"forward", bounds.forward_m_per_s},
                    {"turn", bounds.turn_rad_per_s},
                    {"velocity_holds", bounds.velocity_holds_s},
                    {"lease", bounds.lease_s}};
  if (const auto& push = bounds.push) {
    json["bounds"]["push"] = {{"least", push->least_N},
                              {"most", push->most_N},
                              {"usual", push->usual_N},
                              {"shortest", push->shortest_s},
                              {"longest", push->longest_s}};
  }
  table.add("/robot.json", "application/json", json.dump(), true);
}

}  // namespace gaitway::page
