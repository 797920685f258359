// Draws a plan's postures as the simulated robot's.
#include "tools/motion/motion_picture.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "gaitway/simulator/camera.hpp"

namespace gaitway::tools {
namespace {

constexpr int kPictureWidth_px = 300, kPictureHeight_px = 420, kColumns = 8;
constexpr std::ptrdiff_t kFreeJoint = 7;  // position and quaternion of the pelvis

std::vector<double> pose_of(const motion::MotionPlan& plan, std::size_t point) {
  const Eigen::Isometry3d& pelvis = plan.pelvis[point];
  const Eigen::Quaterniond turn(pelvis.linear());
  std::vector<double> pose{pelvis.translation().x(),
                           pelvis.translation().y(),
                           pelvis.translation().z(),
                           turn.w(),
                           turn.x(),
                           turn.y(),
                           turn.z()};
  const std::span<const double> joints = plan.point(point);
  pose.insert(pose.end(), joints.begin(), joints.end());
  return pose;
}

}  // namespace

void draw_motion(const urdf::RobotModel& robot, const motion::MotionPlan& plan, int pictures,
                 const std::filesystem::path& file) {
  if (std::find(plan.contact.begin(), plan.contact.end(), motion::Contact::none) != plan.contact.end()) {
    throw std::invalid_argument(
        fmt::format("motion '{}': parts of it have contact none, and its plan does not say where the robot "
                    "lies then. Only motions on "
                    "flat feet can be drawn",
                    plan.name));
  }
  const simulator::Plant plant(robot, {.mismatch = 0.0});
  simulator::Camera camera(plant, kPictureWidth_px, kPictureHeight_px);
  std::vector<simulator::Image> images;
  for (int i = 0; i < pictures; ++i) {
    const std::size_t point =
        (plan.point_count() - 1) * static_cast<std::size_t>(i) / static_cast<std::size_t>(pictures - 1);
    images.push_back(camera.render(pose_of(plan, point)));
  }
  simulator::write_film_strip(file.string(), images, std::min(pictures, kColumns));
}

}  // namespace gaitway::tools
