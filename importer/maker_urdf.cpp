// Reads a maker's URDF: links with mass, joints of every type, and what is noted about them.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <tinyxml.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/text.hpp"
#include "gaitway/input/written_text.hpp"
#include "gaitway/urdf/urdf_xml.hpp"
#include "link_surfaces.hpp"
#include "maker_tree.hpp"
#include "urdf_element.hpp"

namespace gaitway::importer {
namespace {

constexpr std::size_t kMostLinks = 1000;
// Beyond these, a number stands for "no limit".
constexpr double kLargestAngle_rad = 1e3, kLargestVelocity_rad_per_s = 1e3, kLargestEffort_Nm = 1e5;

class MakerFile {
 public:
  MakerFile(const std::filesystem::path& file, const ReadOptions& options, const TiXmlElement& xml, YUp y_up)
      : robot_(file, xml, ""), surfaces_(file, options, y_up) {
    written_.file = file;
    written_.line = robot_.line();
    written_.name = robot_.name("name").value_or("");
    if (written_.name.empty()) {
      written_.name = input::one_line(file.stem().string());
    }
  }

  WrittenRobot read() {
    robot_.require_expanded();
    surfaces_.note_materials(robot_.children("material"));
    const std::vector<UrdfElement> links = robot_.children("link"), joints = robot_.children("joint");
    if (std::max(links.size(), joints.size()) > kMostLinks) {
      robot_.refuse(nullptr, fmt::format("there are more than {} links or joints", kMostLinks),
                    "Check that it is one robot, and leave out what is not needed");
    }
    for (const UrdfElement& link : links) {
      written_.links.push_back(read_link(link));
    }
    for (const UrdfElement& joint : joints) {
      written_.joints.push_back(read_joint(joint));
    }
    note_joints();
    for (std::string& note : surfaces_.notes()) {
      written_.notes.push_back(std::move(note));
    }
    for (std::string& note : written_.notes) {
      note = input::one_line(note);
    }
    return std::move(written_);
  }

  [[nodiscard]] bool has_y_up() const noexcept { return surfaces_.has_y_up(); }

 private:
  MakerLink read_link(const UrdfElement& element) {
    MakerLink link;
    link.name = element.required_name("name");
    link.line = element.line();
    if (const auto inertial = element.child("inertial")) {
      read_inertial(*inertial, link);
    }
    surfaces_.read(element, link);
    return link;
  }

  static void read_inertial(const UrdfElement& inertial, MakerLink& link) {
    const Eigen::Isometry3d pose = inertial.origin();
    link.com_m = pose.translation();
    if (const auto mass = inertial.child("mass")) {
      link.mass_kg = mass->required_number("value");
      if (link.mass_kg < 0.0) {
        mass->refuse("value", "must not be negative", "Correct the mass");
      }
    }
    if (const auto inertia = inertial.child("inertia")) {
      const auto value = [&](const char* attribute) { return inertia->number(attribute).value_or(0.0); };
      // Read before the matrix is filled: Eigen minds what is thrown half-way.
      const double ixx = value("ixx"), ixy = value("ixy"), ixz = value("ixz");
      const double iyy = value("iyy"), iyz = value("iyz"), izz = value("izz");
      Eigen::Matrix3d matrix;
      matrix << ixx, ixy, ixz, ixy, iyy, iyz, ixz, iyz, izz;
      link.inertia_kg_m2 = pose.linear() * matrix * pose.linear().transpose();
    }
  }

  WrittenJoint read_joint(const UrdfElement& element) {
    static const std::vector<std::string> kTypes{"revolute",  "continuous", "fixed",
                                                 "prismatic", "floating",   "planar"};
    WrittenJoint result;
    MakerJoint& joint = result.joint;
    joint.name = element.required_name("name");
    joint.line = element.line();
    joint.origin = element.origin();
    result.parent = element.required_child("parent").required_name("link");
    result.child = element.required_child("child").required_name("link");
    const std::string type = element.required_text("type");
    if (std::find(kTypes.begin(), kTypes.end(), type) == kTypes.end()) {
      element.refuse("type", "there is no such type of joint", input::suggest(type, kTypes));
    }
    if (type == "floating" || type == "planar") {
      result.carries_root = true;
    } else if (type == "fixed") {
      result.rigid = joint.origin;
    } else {
      joint.axis = axis_of(element);
      read_dynamics(element, joint);
      read_limits(element, type, joint);
      hold_what_does_not_turn(element, type, result);
    }
    return result;
  }

  static Eigen::Vector3d axis_of(const UrdfElement& joint) {
    const auto axis = joint.child("axis");
    const Eigen::Vector3d direction =
        (axis ? axis->vector3("xyz") : std::nullopt).value_or(Eigen::Vector3d::UnitX());
    if (direction.stableNorm() < 1e-9) {
      axis->refuse("xyz", "the axis must not be zero", "Write a direction, like '0 1 0'");
    }
    return direction.stableNormalized();
  }

  static void read_dynamics(const UrdfElement& element, MakerJoint& joint) {
    if (const auto dynamics = element.child("dynamics")) {
      const auto above_zero = [&](const char* attribute) {
        const auto value = dynamics->limit(attribute);
        return value && *value > 0.0 ? value : std::nullopt;
      };
      joint.damping_Nms_per_rad = above_zero("damping");
      joint.friction_Nm = above_zero("friction");
    }
  }

  void read_limits(const UrdfElement& element, const std::string& type, MakerJoint& joint) {
    const auto limit = element.child("limit");
    if (!limit || type == "prismatic") {
      return;
    }
    joint.is_continuous = type == "continuous";
    joint.velocity_rad_per_s = believed(*limit, "velocity", kLargestVelocity_rad_per_s, joint);
    joint.effort_Nm = believed(*limit, "effort", kLargestEffort_Nm, joint);
    const auto lower = limit->limit("lower"), upper = limit->limit("upper");
    if (joint.is_continuous || (lower.value_or(0.0) == 0.0 && upper.value_or(0.0) == 0.0)) {
      return;
    }
    if (lower.value_or(0.0) > upper.value_or(0.0)) {
      limit->refuse("lower", fmt::format("must not lie above upper, {:g}", upper.value_or(0.0)),
                    "Exchange the two, or correct one of them");
    }
    joint.lower_rad = within("lower", lower.value_or(0.0), kLargestAngle_rad, joint);
    joint.upper_rad = within("upper", upper.value_or(0.0), kLargestAngle_rad, joint);
  }

  std::optional<double> believed(const UrdfElement& limit, const char* attribute, double largest,
                                 const MakerJoint& joint) {
    const auto value = limit.limit(attribute);
    return value && *value > 0.0 ? within(attribute, *value, largest, joint) : std::nullopt;
  }

  std::optional<double> within(const char* what, double value, double largest, const MakerJoint& joint) {
    if (std::abs(value) <= largest) {
      return value;
    }
    unbelieved_.push_back(fmt::format("{} {} {:g}", joint.name, what, value));
    return std::nullopt;
  }

  void hold_what_does_not_turn(const UrdfElement& element, const std::string& type, WrittenJoint& result) {
    const auto mimic = element.child("mimic");
    const double offset = mimic ? mimic->number("offset").value_or(0.0) : 0.0;
    if (type == "prismatic") {
      const double place_m = mimic ? offset : nearest_to_zero_m(element);
      result.rigid = result.joint.origin * Eigen::Translation3d(place_m * result.joint.axis);
      (place_m == offset ? prismatic_ : off_zero_)
          .push_back(place_m == offset ? result.joint.name
                                       : fmt::format("{} at {:g} m", result.joint.name, place_m));
    } else if (mimic) {
      result.rigid = result.joint.origin * Eigen::AngleAxisd(offset, result.joint.axis);
      mimicking_.push_back(result.joint.name);
    }
  }

  // Where a joint that slides comes nearest to zero.
  static double nearest_to_zero_m(const UrdfElement& joint) {
    const auto limit = joint.child("limit");
    const double lower_m = limit ? limit->number("lower").value_or(0.0) : 0.0;
    const double upper_m = limit ? limit->number("upper").value_or(0.0) : 0.0;
    return lower_m <= upper_m ? std::clamp(0.0, lower_m, upper_m) : 0.0;
  }

  void note_joints() {
    const auto note = [this](const char* what, const std::vector<std::string>& names) {
      if (!names.empty()) {
        written_.notes.push_back(fmt::format("{}: {}.", what, fmt::join(names, ", ")));
      }
    };
    note("Prismatic joints are held still at zero", prismatic_);
    note("Prismatic joints whose limits leave out zero are held still at the nearer limit", off_zero_);
    note("Joints that mimic others are held still, where they are when those stand at zero", mimicking_);
    note("Limits that no joint has are taken for none", unbelieved_);
  }

  UrdfElement robot_;
  LinkSurfaces surfaces_;
  WrittenRobot written_;
  std::vector<std::string> prismatic_, off_zero_, mimicking_, unbelieved_;
};

// How far the links' surfaces lie from their centres of mass, weighted by mass.
double misplaced_kg_m(const WrittenRobot& robot) {
  double sum = 0.0;
  for (const MakerLink& link : robot.links) {
    Eigen::AlignedBox3d box;
    for (const VisualSurface& visual : link.visual) {
      for (const Eigen::Vector3d& point : visual.surface.point_m) box.extend(point);
    }
    if (!box.isEmpty()) sum += link.mass_kg * (box.center() - link.com_m).norm();
  }
  return sum;
}

}  // namespace

MakerRobot read_maker_urdf(const std::filesystem::path& file, const ReadOptions& options) {
  const std::string text = input::read_text_file(
      file, "Name the URDF that the robot's maker publishes, expanded if it is a xacro");
  TiXmlDocument document;
  const TiXmlElement& robot = urdf::parse_urdf_xml(file, text, document);
  MakerFile as_it_is(file, options, robot, YUp::as_it_is);
  WrittenRobot written = as_it_is.read();
  if (as_it_is.has_y_up()) {
    WrittenRobot turned = MakerFile(file, options, robot, YUp::turned).read();
    if (misplaced_kg_m(turned) < misplaced_kg_m(written)) {
      written = std::move(turned);
      written.notes.emplace_back(
          "DAE meshes that name y as their up-axis are turned: so they lie where the masses do.");
    }
  }
  return tree_of(std::move(written));
}

}  // namespace gaitway::importer
