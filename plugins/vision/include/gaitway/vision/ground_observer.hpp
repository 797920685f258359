// What one pair of pictures says of the ground: distances become points in odometry, the ground among them is
// found, and each cell of the map learns what was seen in it.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <opencv2/core.hpp>
#include <vector>

#include "gaitway/vision/disparity.hpp"
#include "gaitway/vision/height_map.hpp"
#include "gaitway/vision/stereo_rig.hpp"

namespace gaitway::vision {

struct GroundParameters {
  double disparity_deviation_px = 0.25;  // of a match
  double least_height_m = 0.03;          // of an obstacle; further away it must be higher
  double highest_m = 0.9;                // what lies higher is in nobody's way
  double own_radius_m = 0.22;            // around the base: the robot's own arms and feet
  double farthest_m = 2.6;               // from the camera, along the ground
};

// Poses of the left camera in odometry: of the first and of the last row of a rolling shutter.
struct ShutterPoses {
  Eigen::Isometry3d first = Eigen::Isometry3d::Identity(), last = Eigen::Isometry3d::Identity();
  Eigen::Vector2d base_m = Eigen::Vector2d::Zero();
};

// The ground in the heights that the poses give: height = offset + slope · (place below the camera to there).
struct GroundPlane {
  double offset_m = 0.0;
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();
  int points = 0;  // that agree with it
};

// By how much the matches of what should be ground are off together: what a turned camera does.
struct GroundShift {
  double median_px = 0.0, spread_px = 0.0;  // spread: median of the distances from the median
  int points = 0;
};

class GroundObserver {
 public:
  GroundObserver(const RectifiedGeometry& geometry, const GroundParameters& parameters);

  // Of the disparities of a pair. Then the others may be asked, until the next call.
  void look(const DisparityMatcher& matcher, const ShutterPoses& poses);

  [[nodiscard]] const GroundPlane& ground() const noexcept { return ground_; }
  [[nodiscard]] const GroundShift& shift() const noexcept { return shift_; }

  // Tells the map what was seen in each of its cells.
  void tell(HeightMap& map, std::int64_t stamp_ns);

 private:
  struct Point {
    Eigen::Vector3d place_m;   // in odometry
    double distance_m = 0.0;   // from the camera, along the ground
    double deviation_m = 0.0;  // of its height
    double shift_px = 0.0;     // disparity beyond that of level ground at its pixel
  };
  struct Tally {
    int ground = 0, obstacle = 0;
    double ground_m = 0.0, top_m = 0.0, second_m = 0.0;  // sum of heights; highest, second highest
    // Of the obstacle's points: places from the cell's middle, their products.
    Eigen::Vector2d sum_m = Eigen::Vector2d::Zero();
    Eigen::Vector3d squares_m2 = Eigen::Vector3d::Zero();
  };

  void collect(const DisparityMatcher& matcher, const ShutterPoses& poses);
  void fit_ground();
  void find_shift();
  [[nodiscard]] double above_ground_m(const Point& point) const noexcept;
  void count(const HeightMap& map);
  enum class Sight { nothing, nearer, about_there, farther };
  // What the picture shows where a place would be.
  [[nodiscard]] Sight sight_of(const Eigen::Vector3d& place_m, double cell_m) const;
  [[nodiscard]] bool is_gone(const HeightMap& map, int cell, bool shows_ground) const;

  RectifiedGeometry geometry_;  // of the matched size
  GroundParameters parameters_;
  cv::Mat disparity_;
  Eigen::Isometry3d camera_ = Eigen::Isometry3d::Identity();  // of the middle row
  Eigen::Vector2d base_m_ = Eigen::Vector2d::Zero();
  std::vector<Point> points_;
  std::vector<double> shifts_;
  std::vector<Tally> tallies_;  // of each cell
  std::vector<int> touched_;    // cells with a tally
  GroundPlane ground_;
  GroundShift shift_;
};

}  // namespace gaitway::vision
