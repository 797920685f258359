// What was found of what the cameras look for: each where it was last seen, for as long as it may be of use.
#pragma once

#include <Eigen/Geometry>
#include <array>
#include <cstdint>

#include "gaitway/msgclient/topics.hpp"

namespace gaitway::vision {

// A tag in one pair of pictures, in odometry.
struct TagSighting {
  int id = 0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  Eigen::Quaterniond orientation = Eigen::Quaterniond::Identity();
  bool knows_orientation = true;  // false: one of two that suit the picture as well
  double size_m = 0.0;
};

// A Kalman filter a target, which may have been moved: a sighting that contradicts begins anew. A target is
// told from its second sighting within a second on.
class TargetMemory {
 public:
  explicit TargetMemory(std::int64_t forget_after_ns) : forget_after_ns_(forget_after_ns) {}

  // What is not finite, or has no covariance, is left out.
  void see(const TagSighting& sighting, std::int64_t stamp_ns) noexcept;
  void forget(std::int64_t now_ns) noexcept;
  void write(SeenTargets& targets, std::int64_t stamp_ns) const noexcept;

  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.known_, self.count_);
  }

 private:
  struct Target {
    std::int32_t id = 0;
    std::uint32_t sightings = 0;
    std::int64_t seen_ns = 0;
    std::array<double, 3> position_m{};
    std::array<double, 6> covariance_m2{};  // xx, xy, xz, yy, yz, zz
    std::array<double, 4> orientation{};    // w, x, y, z
    double size_m = 0.0;
  };

  [[nodiscard]] Target* find(int id) noexcept;
  [[nodiscard]] Target& place_for(int id) noexcept;

  std::int64_t forget_after_ns_;
  std::array<Target, kMaxTargets> known_{};
  std::uint32_t count_ = 0;
};

}  // namespace gaitway::vision
