// A robot that stands in a synthetic scene and takes pictures at its camera's rate, with vision at work.
#pragma once

#include <functional>
#include <memory>
#include <numbers>

#include "gaitway/plugin/state_archive.hpp"
#include "gaitway/vision/vision.hpp"
#include "standing_robot.hpp"
#include "synthetic_scene.hpp"

namespace gaitway::vision::testing {

// Upright, turned by `aside_rad` from facing against x.
inline SceneTag facing_tag(int id, const Eigen::Vector3d& middle_m, double aside_rad, double size_m = 0.15) {
  SceneTag tag{.id = id, .size_m = size_m};
  Eigen::Matrix3d facing;  // its x to odometry's -y... as one who looks along x reads it
  facing.col(0) = -Eigen::Vector3d::UnitY();
  facing.col(1) = Eigen::Vector3d::UnitZ();
  facing.col(2) = -Eigen::Vector3d::UnitX();
  tag.pose.linear() = Eigen::AngleAxisd(aside_rad, Eigen::Vector3d::UnitZ()).toRotationMatrix() * facing;
  tag.pose.translation() = middle_m;
  return tag;
}

class WatchingRobot {
 public:
  static constexpr std::int64_t kTick_ns = 10'000'000;
  static constexpr std::int64_t kBetweenPairs_ns = 80'000'000, kLatency_ns = 30'000'000;

  using Pictures = StandingRobot::Pictures;

  explicit WatchingRobot(const VisionParameters& parameters = {}, Pictures pictures = Pictures::small)
      : robot_(pictures),
        eyes_(robot_.camera()),
        vision_(std::make_unique<Vision>(robot_.model(), robot_.camera(), parameters)) {}

  Scene scene;
  Exposure exposure;
  std::function<void(TakenPair&)> spoil;  // what becomes of a pair before it is seen

  void head_pitch_rad(double pitch_rad) { robot_.head_pitch_rad = pitch_rad; }
  void speed(const Eigen::Vector3d& speed) { robot_.speed = speed; }
  void sway_m(double sway_m) { robot_.sway_m = sway_m; }
  void fallen(bool fallen) { robot_.fallen = fallen; }
  // What the camera file does not know; a rotation vector in its optical frame.
  void turn_right_camera(const Eigen::Vector3d& turn_deg) {
    urdf::StereoCamera turned = robot_.camera();
    turned.right_in_left.linear() *=
        Eigen::AngleAxisd(turn_deg.norm() * std::numbers::pi / 180.0, turn_deg.stableNormalized())
            .toRotationMatrix();
    eyes_ = SceneCamera(turned);
  }

  // So many pairs, each seen when it comes. The head must have stood for a while.
  void watch(int pairs) {
    for (int i = 0; i < pairs; ++i) {
      const std::int64_t taken_ns = now_ns_ + kBetweenPairs_ns - kLatency_ns;
      for (; now_ns_ < taken_ns + kLatency_ns;) tick();
      TakenPair taken = eyes_.take(
          scene, [this](std::int64_t at_ns) { return robot_.camera_pose(at_ns); }, taken_ns, ++number_,
          exposure);
      if (spoil) spoil(taken);
      vision_->see(taken.pair, now_ns_);
    }
  }
  // Without pictures.
  void wait(std::int64_t time_ns) {
    for (const std::int64_t end_ns = now_ns_ + time_ns; now_ns_ < end_ns;) tick();
  }

  [[nodiscard]] Vision& vision() noexcept { return *vision_; }
  [[nodiscard]] const urdf::RobotModel& model() const noexcept { return robot_.model(); }
  [[nodiscard]] const urdf::StereoCamera& camera() const noexcept { return robot_.camera(); }
  [[nodiscard]] Eigen::Vector2d camera_m() const {
    return robot_.camera_pose(now_ns_).translation().head<2>();
  }

 private:
  void tick() {
    vision_->follow(robot_.joints(now_ns_), robot_.estimate(now_ns_));
    vision_->wait(now_ns_);
    now_ns_ += kTick_ns;
  }

  StandingRobot robot_;
  SceneCamera eyes_;
  std::unique_ptr<Vision> vision_;
  std::int64_t now_ns_ = 1'000'000'000;
  std::uint64_t number_ = 0;
};

}  // namespace gaitway::vision::testing
