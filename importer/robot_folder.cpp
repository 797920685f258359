// Writes a robot's folder: its URDF with the meshes that it names, and the network file beside it.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cerrno>
#include <cmath>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "gaitway/importer/import.hpp"
#include "robot_text.hpp"

namespace gaitway::importer {
namespace {

constexpr std::size_t kCollisionPoints = 48, kVisualPoints = 160;
constexpr double kSmallest_m = 0.004;  // a surface that is no longer is left out
constexpr double kLeastVolume_m3 = 1e-8;

std::string numbers(const Eigen::Vector3d& v) {
  const auto clean = [](double value) { return std::abs(value) < 1e-12 ? 0.0 : value; };
  return fmt::format("{:.12g} {:.12g} {:.12g}", clean(v.x()), clean(v.y()), clean(v.z()));
}

std::string origin(const Eigen::Isometry3d& pose) {
  return fmt::format("<origin xyz=\"{}\" rpy=\"{}\"/>", numbers(pose.translation()),
                     numbers(rpy_of(pose.linear())));
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') {
      result += "&amp;";
    } else if (c == '<') {
      result += "&lt;";
    } else if (c == '"') {
      result += "&quot;";
    } else {
      result += c;
    }
  }
  return result;
}

void write_text(const std::filesystem::path& file, const std::string& text) {
  std::ofstream stream(file, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream) throw std::system_error(errno, std::generic_category(), file.string());
}

// Names come from strangers: what is no letter or digit stays out, and the link's number keeps apart what is
// then alike.
std::string file_name(std::size_t index, const std::string& link, const char* kind, std::size_t number) {
  std::string name;
  for (const char c : link) name += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  constexpr std::size_t kLongest = 60;
  name.resize(std::min(name.size(), kLongest));
  return fmt::format("{:02}_{}_{}_{}.stl", index, name, kind, number);
}

double volume_m3(const Surface& hull) {
  double six = 0.0;
  const Eigen::Vector3d& from = hull.point_m.front();
  for (const std::array<int, 3>& triangle : hull.triangle) {
    const auto corner = [&](std::size_t i) {
      return Eigen::Vector3d(hull.point_m[static_cast<std::size_t>(triangle[i])] - from);
    };
    six += corner(0).dot(corner(1).cross(corner(2)));
  }
  return six / 6.0;
}

class UrdfText {
 public:
  UrdfText(const ImportedRobot& imported, const std::filesystem::path& folder)
      : imported_(imported), robot_(imported.robot), folder_(folder) {}

  std::string write() {
    text_ = fmt::format(
        "<?xml version=\"1.0\"?>\n<!-- Made from {}: fixed joints merged, shapes as their convex hulls. -->\n"
        "<robot name=\"{}\">\n",
        in_comment(robot_.file), escaped(robot_.name));
    for (std::size_t i = 0; i < robot_.links.size(); ++i) add_link(i);
    for (std::size_t i = 0; i < robot_.joints.size(); ++i) add_joint(i);
    return text_ + "</robot>\n";
  }

 private:
  void add_link(std::size_t index) {
    const MakerLink& link = robot_.links[index];
    const Eigen::Matrix3d& i = link.inertia_kg_m2;
    text_ += fmt::format(
        "  <link name=\"{}\">\n    <inertial>\n      <origin xyz=\"{}\"/>\n      <mass value=\"{:.12g}\"/>\n"
        "      <inertia ixx=\"{:.12g}\" ixy=\"{:.12g}\" ixz=\"{:.12g}\" iyy=\"{:.12g}\" iyz=\"{:.12g}\" "
        "izz=\"{:.12g}\"/>\n"
        "    </inertial>\n",
        escaped(link.name), numbers(link.com_m), link.mass_kg, i(0, 0), i(0, 1), i(0, 2), i(1, 1), i(1, 2),
        i(2, 2));
    std::size_t number = 0;
    for (const VisualSurface& visual : link.visual) {
      const Eigen::Vector4d colour = visual.rgba.cwiseMax(0.0).cwiseMin(1.0);
      if (const std::string mesh =
              hull_file(visual.surface, index, link.name, "visual", number, kVisualPoints);
          !mesh.empty()) {
        text_ += fmt::format(
            "    <visual><geometry>{}</geometry><material name=\"{}_{}\"><color rgba=\"{:.3g} {:.3g} {:.3g} "
            "{:.3g}\"/></material></visual>\n",
            mesh, escaped(link.name), number, colour[0], colour[1], colour[2], colour[3]);
        ++number;
      }
    }
    if (!add_sole(link)) add_collision(index, link);
    text_ += "  </link>\n";
  }

  // A foot touches the ground with its sole alone: a box from there to half the height of the ankle.
  bool add_sole(const MakerLink& link) {
    for (std::size_t side = 0; side < 2; ++side) {
      if (imported_.plan.legs[side].foot != link.name) continue;
      const FoundSole& sole = imported_.soles[side];
      const double thickness_m = std::max(
          0.1 * sole.size_m.y(), -0.5 * (sole.pose.linear().transpose() * sole.pose.translation()).z());
      const Eigen::Isometry3d box =
          sole.pose * Eigen::Translation3d(sole.centre_m.x(), sole.centre_m.y(), 0.5 * thickness_m);
      text_ += fmt::format("    <collision>{}<geometry><box size=\"{}\"/></geometry></collision>\n",
                           origin(box), numbers({sole.size_m.x(), sole.size_m.y(), thickness_m}));
      return true;
    }
    return false;
  }

  void add_collision(std::size_t index, const MakerLink& link) {
    std::size_t number = 0;
    const auto add = [&](const Surface& surface) {
      if (const std::string mesh =
              hull_file(surface, index, link.name, "collision", number, kCollisionPoints);
          !mesh.empty()) {
        text_ += fmt::format("    <collision><geometry>{}</geometry></collision>\n", mesh);
        ++number;
      }
    };
    for (const Surface& surface : link.collision) add(surface);
    if (!link.collision.empty()) return;
    for (const VisualSurface& visual : link.visual) add(visual.surface);
  }

  // Empty for what is too small or flat to be a body.
  std::string hull_file(const Surface& surface, std::size_t index, const std::string& link, const char* kind,
                        std::size_t number, std::size_t most_points) {
    if (surface.point_m.size() < 4) return "";
    Eigen::Vector3d least = surface.point_m.front(), most = least;
    for (const Eigen::Vector3d& point : surface.point_m) {
      least = least.cwiseMin(point);
      most = most.cwiseMax(point);
    }
    if ((most - least).maxCoeff() < kSmallest_m) return "";
    Surface hull;
    try {
      hull = convex_hull(surface, most_points);
    } catch (const std::invalid_argument&) {
      return "";
    }
    if (volume_m3(hull) < kLeastVolume_m3) return "";
    const std::filesystem::path file = std::filesystem::path("meshes") / file_name(index, link, kind, number);
    std::filesystem::create_directories(folder_ / "meshes");
    write_stl(folder_ / file, hull);
    return fmt::format("<mesh filename=\"{}\"/>", file.string());
  }

  void add_joint(std::size_t index) {
    const MakerJoint& joint = robot_.joints[index];
    const DriveFigures& drive = imported_.drives[index];
    text_ += fmt::format(
        "  <joint name=\"{}\" type=\"revolute\">\n    <parent link=\"{}\"/>\n    <child link=\"{}\"/>\n    "
        "{}\n"
        "    <axis xyz=\"{}\"/>\n    <limit lower=\"{:.12g}\" upper=\"{:.12g}\" effort=\"{:.12g}\" "
        "velocity=\"{:.12g}\"/>\n"
        "  </joint>\n",
        escaped(joint.name), escaped(robot_.links[static_cast<std::size_t>(joint.parent_link)].name),
        escaped(robot_.links[static_cast<std::size_t>(joint.child_link)].name), origin(joint.origin),
        numbers(joint.axis), *joint.lower_rad, *joint.upper_rad, drive.torque_Nm,
        drive.reference_speed_rad_per_s);
  }

  const ImportedRobot& imported_;
  const MakerRobot& robot_;
  const std::filesystem::path& folder_;
  std::string text_;
};

}  // namespace

void write_robot_folder(const ImportedRobot& imported, const std::filesystem::path& folder) {
  std::filesystem::create_directories(folder);
  write_text(folder / "robot.urdf", UrdfText(imported, folder).write());
  write_text(folder / "robot.yaml", network_text(imported));
}

}  // namespace gaitway::importer
