// From pairs of pictures to what the robot knows of what is around it: map, obstacles, targets, and how well
// its cameras see.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/camera_file.hpp"
#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/vision/camera_history.hpp"
#include "gaitway/vision/disparity.hpp"
#include "gaitway/vision/fault_watch.hpp"
#include "gaitway/vision/ground_observer.hpp"
#include "gaitway/vision/height_map.hpp"
#include "gaitway/vision/obstacle_boxes.hpp"
#include "gaitway/vision/pictures.hpp"
#include "gaitway/vision/stereo_rig.hpp"
#include "gaitway/vision/tag_finder.hpp"
#include "gaitway/vision/tag_pose.hpp"
#include "gaitway/vision/target_memory.hpp"

namespace gaitway::vision {

struct TagSize {
  int id = 0;
  double size_m = 0.0;
};

struct VisionParameters {
  double cell_m = 0.04;
  double map_ahead_m = 0.7;  // of the robot, where the map's middle is to be
  std::int64_t forget_after_ns = 30'000'000'000;
  std::int64_t late_after_ns = 150'000'000;
  std::int64_t missing_after_ns = 400'000'000;
  double tag_size_m = 0.15;  // of those that tag_sizes does not name
  std::vector<TagSize> tag_sizes;
  double corner_deviation_px = 0.2;  // of a tag's corner
  double most_corner_error_px = 1.5;
  // Of the camera's pose at the capture: along the ground, and its attitude.
  double pose_deviation_m = 0.005, attitude_deviation_rad = 0.008;
  GroundParameters ground;
  TagFinderParameters tags;
};

// Passive: it is told the time. `see` allocates and takes some twenty milliseconds; the others do not.
class Vision {
 public:
  // Throws urdf::RobotError if the camera's link is none of the robot's.
  Vision(const urdf::RobotModel& robot, const urdf::StereoCamera& camera, const VisionParameters& parameters);

  // At each tick. True: the robot is up again after it has lain, and what it saw before is forgotten.
  bool follow(const JointStates& joints, const Estimate& estimate);
  // At each tick with a new pair; and at each one without.
  void see(const PicturePair& pair, std::int64_t now_ns);
  void wait(std::int64_t now_ns) noexcept;

  [[nodiscard]] const HeightMap& map() const noexcept { return map_; }
  [[nodiscard]] const std::vector<Box>& obstacles() const noexcept { return obstacles_.boxes(); }
  [[nodiscard]] Fault fault() const noexcept { return fault_; }
  [[nodiscard]] const GroundObserver& ground() const noexcept { return ground_; }
  [[nodiscard]] std::int64_t mapped_ns() const noexcept {
    return mapped_ns_;
  }  // stamp of the newest pair in the map

  void write(SeenTargets& targets) const noexcept { targets_.write(targets, looked_ns_); }
  void write(GroundMap& map) const noexcept { map_.write(map, mapped_ns_); }
  void write(Obstacles& obstacles) const noexcept { obstacles_.write(obstacles, mapped_ns_); }
  void write(VisionState& state, std::int64_t now_ns, std::int64_t compute_ns) const noexcept;

  // What a successor goes on from: all but the last second's postures, which it gathers itself.
  template <class Archive>
  void save(Archive& archive) const {
    visit(*this, archive);
    map_.save(archive, mapped_ns_);
  }
  template <class Archive>
  void restore(Archive& archive) {
    visit(*this, archive);
    map_.restore(archive);
    obstacles_.renew(boxes_in(map_, eye_m_));
  }

 private:
  template <class Self, class Archive>
  static void visit(Self& self, Archive& archive) {
    archive(self.targets_, self.pictures_, self.alignment_, self.fault_, self.has_pose_, self.sees_one_,
            self.has_lain_, self.is_suspected_, self.first_wait_ns_, self.picture_ns_, self.arrived_ns_,
            self.looked_ns_, self.mapped_ns_, self.eye_m_, self.matched_share_, self.last_number_,
            self.pairs_, self.dropped_);
  }

  struct Seen {                      // of one pair
    bool left = true, right = true;  // the picture may be used
    ShutterPoses poses;
  };

  [[nodiscard]] std::optional<ShutterPoses> poses_of(const PicturePair& pair) const noexcept;
  [[nodiscard]] Fault use(const PicturePair& pair);
  void forget_places();
  [[nodiscard]] Fault map(const PicturePair& pair, const ShutterPoses& poses);
  void find_tags(const PicturePair& pair, const Seen& seen);
  [[nodiscard]] cv::Rect place_in_right(const FoundTag& tag) const;
  void remember(const FoundTag* left, const FoundTag* right, const Seen& seen, std::int64_t stamp_ns);
  [[nodiscard]] double size_of(int id) const noexcept;

  VisionParameters parameters_;
  int width_, height_;
  StereoRig rig_;
  CameraHistory history_;
  PictureCheck pictures_;
  AlignmentWatch alignment_;
  DisparityMatcher matcher_;
  GroundObserver ground_;
  HeightMap map_;
  ObstacleList obstacles_;
  TagFinder tags_;
  TargetMemory targets_;

  Fault fault_ = Fault::none;
  bool has_pose_ = true;       // of the camera, at the last pair's exposure
  bool sees_one_ = false;      // camera, at least
  bool has_lain_ = false;      // since it was upright
  bool is_suspected_ = false;  // that the cameras are turned, by the newest pair
  std::optional<std::int64_t> first_wait_ns_;
  std::int64_t picture_ns_ = 0, arrived_ns_ = 0, looked_ns_ = 0, mapped_ns_ = 0;
  Eigen::Vector2d eye_m_ = Eigen::Vector2d::Zero();  // in odometry, of the newest pair in the map
  double matched_share_ = 0.0;                       // of the newest pair that was matched
  std::uint64_t last_number_ = 0, pairs_ = 0, dropped_ = 0;
};

}  // namespace gaitway::vision
