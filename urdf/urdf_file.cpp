// Reads robot.urdf through urdfdom and turns it into Eigen data.
#include "robot_files.hpp"

#include <console_bridge/console.h>
#include <fmt/format.h>
#include <urdf_parser/urdf_parser.h>

#include <mutex>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/text.hpp"

namespace gaitway::urdf {
namespace {

// Takes what urdfdom would log to the terminal while this object lives. urdfdom's log is global to the
// process, so only one may exist at a time.
class CapturedLog final : public console_bridge::OutputHandler {
 public:
  CapturedLog() : lock_(mutex()) { console_bridge::useOutputHandler(this); }
  ~CapturedLog() override { console_bridge::restorePreviousOutputHandler(); }
  CapturedLog(const CapturedLog&) = delete;
  CapturedLog& operator=(const CapturedLog&) = delete;

  void log(const std::string& text, console_bridge::LogLevel level, const char*, int) override {
    if (level >= console_bridge::CONSOLE_BRIDGE_LOG_ERROR) {
      text_ += (text_.empty() ? "" : "; ") + text;
    }
  }
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  static std::mutex& mutex() {
    static std::mutex instance;
    return instance;
  }
  std::scoped_lock<std::mutex> lock_;
  std::string text_;
};

Eigen::Vector3d vector_of(const ::urdf::Vector3& v) {
  return {v.x, v.y, v.z};
}

Eigen::Isometry3d pose_of(const ::urdf::Pose& pose) {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  const ::urdf::Rotation& q = pose.rotation;
  result.linear() = Eigen::Quaterniond(q.w, q.x, q.y, q.z).normalized().toRotationMatrix();
  result.translation() = vector_of(pose.position);
  return result;
}

Shape read_shape(const ::urdf::Geometry* geometry, const ::urdf::Pose& origin, MeshUse use,
                 const std::string& link, std::size_t index, const UrdfFile& urdf) {
  Shape shape;
  shape.pose = pose_of(origin);
  if (const auto* box = dynamic_cast<const ::urdf::Box*>(geometry)) {
    shape.size_m = vector_of(box->dim);
  } else if (const auto* cylinder = dynamic_cast<const ::urdf::Cylinder*>(geometry)) {
    shape.kind = Shape::Kind::cylinder;
    shape.size_m = {2.0 * cylinder->radius, 2.0 * cylinder->radius, cylinder->length};
  } else if (const auto* sphere = dynamic_cast<const ::urdf::Sphere*>(geometry)) {
    shape.kind = Shape::Kind::sphere;
    shape.size_m.setConstant(2.0 * sphere->radius);
  } else if (const auto* mesh = dynamic_cast<const ::urdf::Mesh*>(geometry)) {
    shape.kind = Shape::Kind::mesh;
    shape.mesh.scale = vector_of(mesh->scale);
    const bool touches = use == MeshUse::collision;
    read_mesh(urdf.file, (touches ? urdf.lines.collision : urdf.lines.visual).at(link).at(index),
              fmt::format("link '{}' {}", link, touches ? "collision" : "visual"), mesh->filename, use,
              shape);
  }
  return shape;
}

void read_inertial(const ::urdf::Inertial& inertial, Link& link) {
  const Eigen::Isometry3d pose = pose_of(inertial.origin);
  Eigen::Matrix3d inertia;
  inertia << inertial.ixx, inertial.ixy, inertial.ixz,  //
      inertial.ixy, inertial.iyy, inertial.iyz,         //
      inertial.ixz, inertial.iyz, inertial.izz;
  link.mass_kg = inertial.mass;
  link.com_m = pose.translation();
  link.inertia_kg_m2 = pose.linear() * inertia * pose.linear().transpose();
}

Link read_link(const ::urdf::Link& source, const UrdfFile& urdf) {
  Link link;
  link.name = source.name;
  read_inertial(*source.inertial, link);
  for (const auto& visual : source.visual_array) {
    link.visual.push_back(read_shape(visual->geometry.get(), visual->origin, MeshUse::visual, link.name,
                                     link.visual.size(), urdf));
    if (visual->material) {
      const ::urdf::Color& colour = visual->material->color;
      link.visual.back().rgba = Eigen::Vector4f(colour.r, colour.g, colour.b, colour.a).cast<double>();
    }
  }
  for (const auto& collision : source.collision_array) {
    link.collision.push_back(read_shape(collision->geometry.get(), collision->origin, MeshUse::collision,
                                        link.name, link.collision.size(), urdf));
  }
  return link;
}

UrdfJoint read_joint(const ::urdf::Joint& source, const UrdfFile& urdf) {
  UrdfJoint result;
  result.line = urdf.lines.joint.at(source.name);
  if (source.type != ::urdf::Joint::REVOLUTE) {
    input::refuse({urdf.file, result.line, fmt::format("joint '{}' type", source.name), "",
                   "must be 'revolute'",
                   "Every joint has a motor and limits; merge the link of a fixed joint into its parent"});
  }
  result.joint.name = source.name;
  result.joint.origin = pose_of(source.parent_to_joint_origin_transform);
  result.joint.axis = vector_of(source.axis);
  result.joint.lower_rad = source.limits->lower;
  result.joint.upper_rad = source.limits->upper;
  result.joint.velocity_limit_rad_per_s = source.limits->velocity;
  result.effort_limit_Nm = source.limits->effort;
  result.parent_link = source.parent_link_name;
  result.child_link = source.child_link_name;
  return result;
}

::urdf::ModelInterfaceSharedPtr parse(const std::filesystem::path& file, const std::string& text) {
  const CapturedLog log;
  ::urdf::ModelInterfaceSharedPtr model = ::urdf::parseURDF(text);
  if (!model || !log.text().empty()) {
    input::refuse({file, 0, "", "",
                   "not a valid URDF: " + (log.text().empty() ? "unknown reason" : log.text()),
                   "Correct what is named there"});
  }
  return model;
}

}  // namespace

UrdfFile read_urdf_file(const std::filesystem::path& file) {
  const std::string text = input::read_text_file(file, "A robot's folder holds robot.urdf and robot.yaml");
  UrdfFile urdf;
  urdf.file = file;
  urdf.lines = check_urdf_syntax(file, text);
  const ::urdf::ModelInterfaceSharedPtr model = parse(file, text);
  urdf.name = model->getName();
  urdf.base_link = model->getRoot()->name;
  for (const auto& [name, link] : model->links_) {
    urdf.links.push_back(read_link(*link, urdf));
    check_link(urdf, urdf.links.back());
  }
  for (const auto& [name, joint] : model->joints_) {
    urdf.joints.push_back(read_joint(*joint, urdf));
    check_geometry(urdf, urdf.joints.back());
  }
  return urdf;
}

}  // namespace gaitway::urdf
