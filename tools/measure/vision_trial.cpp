// A room with one box and one tag, and what the topics say against the plant's truth. Places told in odometry
// are compared where odometry was when the picture was taken, so that its drift does not count.
#include "tools/measure/vision_trial.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <stdexcept>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"

namespace gaitway::tools {
namespace {

constexpr double kSpeed_m_per_s = 0.2;
constexpr double kApproach_m = 0.9;  // walked before the range is reached
constexpr double kStand_s = 4.0;
constexpr double kWalksFrom_s = 0.5;
constexpr double kSettled_s = 1.5;
constexpr double kWithin_m = 0.15;
constexpr double kPhantom_m = 0.15;  // a box that is told further than this from anything is none
constexpr int kTagId = 23;
constexpr double kTagSize_m = 0.15;
const Eigen::Vector3d kBox_m(0.24, 0.34, 0.3);

Eigen::Isometry2d planar(double x_m, double y_m, double yaw_rad) {
  Eigen::Isometry2d pose = Eigen::Isometry2d::Identity();
  pose.linear() = Eigen::Rotation2Dd(yaw_rad).toRotationMatrix();
  pose.translation() = Eigen::Vector2d(x_m, y_m);
  return pose;
}

Eigen::Isometry2d on_ground(const Eigen::Isometry3d& pose) {
  return planar(pose.translation().x(), pose.translation().y(),
                std::atan2(pose.linear()(1, 0), pose.linear()(0, 0)));
}

// Of the left camera in the base, in the home posture.
Eigen::Isometry3d camera_in_base(const urdf::RobotModel& robot) {
  const std::optional<urdf::StereoCamera> camera = urdf::stereo_camera_of(robot);
  if (!camera) {
    throw std::invalid_argument("the robot '" + robot.name +
                                "' has no camera. Give it a camera.yaml (urdf/README.md)");
  }
  urdf::ForwardKinematics kinematics(robot);
  return kinematics.link_pose(robot.link_index(camera->link)) * camera->left_in_link;
}

struct Room {
  world::World world;
  Eigen::Isometry2d box = Eigen::Isometry2d::Identity();
  Eigen::Vector3d tag_m = Eigen::Vector3d::Zero();
};

Room room_of(const VisionTrial& trial, double camera_x_m) {
  std::mt19937_64 random(trial.seed * 7919 + (trial.walks ? 1 : 0));
  std::uniform_real_distribution<double> aside(-0.12, 0.12), turn(-0.15, 0.15);
  const double near_m = camera_x_m + trial.range_m + (trial.walks ? kApproach_m : 0.0);
  Room room;
  room.world.name = "range";
  room.world.surfaces = {{.kind = world::Surface::Kind::noise,
                          .colours = {{{0.2, 0.18, 0.15}, {0.8, 0.75, 0.7}}},
                          .repeat_m = 0.9,
                          .seed = trial.seed,
                          .image = {}},
                         {.kind = world::Surface::Kind::noise,
                          .colours = {{{0.1, 0.15, 0.2}, {0.9, 0.8, 0.6}}},
                          .repeat_m = 0.5,
                          .seed = trial.seed + 1000,
                          .image = {}}};
  world::Solid box;
  box.name = "box";
  box.size_m = kBox_m;
  box.surface = 1;
  const double yaw_rad = turn(random), y_m = aside(random);
  room.box = planar(near_m + 0.5 * kBox_m.x(), y_m, yaw_rad);
  box.pose.translation() = Eigen::Vector3d(near_m + 0.5 * kBox_m.x(), y_m, 0.5 * kBox_m.z());
  box.pose.linear() = Eigen::AngleAxisd(yaw_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix();
  room.world.solids.push_back(box);
  world::Tag tag{.id = kTagId, .size_m = kTagSize_m};
  room.tag_m = {near_m, y_m + 0.42, 0.62};
  tag.pose.linear().col(0) = -Eigen::Vector3d::UnitY();
  tag.pose.linear().col(1) = Eigen::Vector3d::UnitZ();
  tag.pose.linear().col(2) = -Eigen::Vector3d::UnitX();
  tag.pose.linear() = Eigen::AngleAxisd(turn(random) * 2.0, Eigen::Vector3d::UnitZ()) * tag.pose.linear();
  tag.pose.translation() = room.tag_m;
  room.world.tags.push_back(tag);
  return room;
}

// Poses of the last second, at each millisecond and at each slot.
class PoseLog {
 public:
  void add_truth(std::int64_t now_ns, const Eigen::Isometry3d& base) { truth_.emplace_back(now_ns, base); }
  void add_estimate(const Estimate& estimate) {
    // What it says holds at the edge of the slot in which the joints measured.
    const std::int64_t edge_ns = estimate.stamp_ns - estimate.stamp_ns % facts::kSlot_ns;
    if (!estimate_.empty() && estimate_.back().first >= edge_ns) return;
    estimate_.emplace_back(edge_ns, Eigen::Vector3d(estimate.odometry_base));
  }
  [[nodiscard]] const Eigen::Isometry3d& truth(std::int64_t at_ns) const {
    const auto later =
        std::ranges::lower_bound(truth_, at_ns, {}, [](const auto& entry) { return entry.first; });
    return later == truth_.end() ? truth_.back().second : later->second;
  }
  // Of odometry in the world.
  [[nodiscard]] std::optional<Eigen::Isometry2d> odometry(std::int64_t at_ns) const {
    const auto later =
        std::ranges::lower_bound(estimate_, at_ns, {}, [](const auto& entry) { return entry.first; });
    if (later == estimate_.begin() || later == estimate_.end()) return std::nullopt;
    const auto before = std::prev(later);
    const double share =
        static_cast<double>(at_ns - before->first) / static_cast<double>(later->first - before->first);
    const Eigen::Vector3d base = before->second + share * (later->second - before->second);
    return on_ground(truth(at_ns)) * planar(base.x(), base.y(), base.z()).inverse();
  }

 private:
  std::vector<std::pair<std::int64_t, Eigen::Isometry3d>> truth_;
  std::vector<std::pair<std::int64_t, Eigen::Vector3d>> estimate_;
};

// Middle of the side that looks most against `ahead`: of a told box that may be either.
Eigen::Vector2d near_side_m(const Eigen::Isometry2d& box, const Eigen::Vector2d& size_m,
                            const Eigen::Vector2d& ahead) {
  Eigen::Vector2d best = box.translation();
  double most = -2.0;
  for (int axis = 0; axis < 2; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Eigen::Vector2d normal = sign * box.linear().col(axis);
      if (-normal.dot(ahead) <= most) continue;
      most = -normal.dot(ahead);
      best = box.translation() + 0.5 * size_m[axis] * normal;
    }
  }
  return best;
}

class Judge {
 public:
  Judge(simulator::Cosimulation& run, const VisionTrial& trial, const Room& room,
        const Eigen::Isometry3d& camera)
      : run_(run),
        trial_(trial),
        room_(room),
        camera_(camera),
        estimate_(run.client().read<Estimate>("estimate")),
        obstacles_(run.client().read<Obstacles>("obstacles")),
        targets_(run.client().read<SeenTargets>("seen_targets")),
        state_(run.client().read<VisionState>("vision_state")) {}

  void look() {
    const std::int64_t now_ns = run_.now_ns();
    log_.add_truth(now_ns, run_.plant().truth().base);
    Estimate estimate{};
    estimate_.read(estimate);
    if (estimate.stamp_ns > 0) log_.add_estimate(estimate);
    auto obstacles = std::make_unique<Obstacles>();
    obstacles_.read(*obstacles);
    if (obstacles->stamp_ns <= judged_ns_) return;
    const std::int64_t before_ns = judged_ns_;
    judged_ns_ = obstacles->stamp_ns;
    if (before_ns == 0 || judged_ns_ < static_cast<std::int64_t>(1e9 * kSettled_s)) return;
    judge(*obstacles, now_ns);
  }

  [[nodiscard]] VisionOutcome outcome() {
    VisionState state{};
    state_.read(state);
    outcome_.fault = reinterpret_cast<const char*>(state.text);
    return outcome_;
  }

 private:
  void judge(const Obstacles& obstacles, std::int64_t now_ns) {
    const std::optional<Eigen::Isometry2d> odometry = log_.odometry(judged_ns_);
    if (!odometry) return;
    const Eigen::Isometry3d eye = log_.truth(judged_ns_) * camera_;
    const Eigen::Vector2d eye_m = eye.translation().head<2>();
    const Eigen::Vector2d ahead = on_ground(log_.truth(judged_ns_)).linear().col(0);
    const Eigen::Vector2d truth_m = near_side_m(room_.box, kBox_m.head<2>(), ahead);
    outcome_.delay_s.push_back(1e-9 * static_cast<double>(now_ns - judged_ns_));
    if (std::abs((truth_m - eye_m).dot(ahead) - trial_.range_m) > kWithin_m) return;
    ++outcome_.pairs;
    judge_boxes(obstacles, *odometry, ahead, truth_m);
    judge_tag(*odometry, eye);
  }

  void judge_boxes(const Obstacles& obstacles, const Eigen::Isometry2d& odometry,
                   const Eigen::Vector2d& ahead, const Eigen::Vector2d& truth_m) {
    double nearest_m = 1e9;
    for (std::uint32_t i = 0; i < obstacles.count; ++i) {
      const Eigen::Isometry2d box =
          odometry * planar(obstacles.place[i][0], obstacles.place[i][1], obstacles.place[i][2]);
      const Eigen::Vector2d side_m = near_side_m(box, {obstacles.size[i][0], obstacles.size[i][1]}, ahead);
      nearest_m = std::min(nearest_m, (side_m - truth_m).norm());
      const Eigen::Vector2d off =
          ((room_.box.inverse() * box.translation()).cwiseAbs() - 0.5 * kBox_m.head<2>()).cwiseMax(0.0);
      const double from_tag_m = (box.translation() - room_.tag_m.head<2>()).norm();
      if (off.norm() > kPhantom_m && from_tag_m > kPhantom_m + kTagSize_m) ++outcome_.phantoms;
    }
    if (nearest_m < 1e9)
      outcome_.obstacle_error_m.push_back(nearest_m);
    else
      ++outcome_.without_obstacle;
  }

  void judge_tag(const Eigen::Isometry2d& odometry, const Eigen::Isometry3d& eye) {
    SeenTargets targets{};
    targets_.read(targets);
    bool found = false;
    for (std::uint32_t i = 0; i < targets.count; ++i) {
      if (targets.id[i] != static_cast<std::uint32_t>(kTagId)) {
        ++outcome_.false_tags;
        continue;
      }
      if (targets.seen_ns[i] != judged_ns_) continue;
      found = true;
      const Eigen::Vector2d place =
          odometry * Eigen::Vector2d(targets.position[i][0], targets.position[i][1]);
      const Eigen::Vector3d seen_m(place.x(), place.y(), targets.position[i][2]);
      const double range_m = (room_.tag_m - eye.translation()).norm();
      outcome_.tag_range_error.push_back(((seen_m - eye.translation()).norm() - range_m) / range_m);
      outcome_.tag_place_error_m.push_back((seen_m - room_.tag_m).norm());
    }
    if (!found) ++outcome_.without_tag;
  }

  simulator::Cosimulation& run_;
  VisionTrial trial_;
  const Room& room_;
  Eigen::Isometry3d camera_;
  PoseLog log_;
  msgclient::Reader<Estimate> estimate_;
  msgclient::Reader<Obstacles> obstacles_;
  msgclient::Reader<SeenTargets> targets_;
  msgclient::Reader<VisionState> state_;
  std::int64_t judged_ns_ = 0;  // stamp of the newest pair
  VisionOutcome outcome_;
};

}  // namespace

VisionOutcome run_vision_trial(const VisionRobot& robot, const VisionTrial& trial) {
  const Eigen::Isometry3d camera = camera_in_base(robot.model);
  const Room room = room_of(trial, camera.translation().x());
  simulator::CosimulationOptions options;
  options.plant.seed = trial.seed;
  options.plant.world = room.world;
  options.main_controller.configuration = robot.plugins.file;
  options.main_controller.plugins = robot.plugins;
  simulator::Cosimulation run(robot.model, options);
  Judge judge(run, trial, room, camera);
  double seconds = kStand_s;
  if (trial.walks) {
    seconds = kWalksFrom_s + (kApproach_m + 2.0 * kWithin_m) / kSpeed_m_per_s + 1.0;
  }
  const auto walks_ns = static_cast<std::int64_t>(1e9 * kWalksFrom_s);
  while (run.now_ns() < static_cast<std::int64_t>(1e9 * seconds)) {
    if (trial.walks && run.now_ns() == walks_ns) {
      run.apply({kWalksFrom_s, simulator::WalkEvent{.velocity_m_per_s = {kSpeed_m_per_s, 0.0}}});
    }
    run.advance_millisecond();
    judge.look();
  }
  return judge.outcome();
}

}  // namespace gaitway::tools
