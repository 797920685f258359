// Where the feet and the base are in a frame that is fixed to the ground: the foot that bears the load stays
// where it is, and the kinematics says where all else is from there.
#pragma once

#include <Eigen/Core>
#include <array>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/support_kinematics.hpp"

namespace gaitway::zmp {

class FootOdometry {
 public:
  struct Pose {
    Eigen::Vector2d place_m = Eigen::Vector2d::Zero();
    double yaw_rad = 0.0;  // not wrapped
    template <class Self, class Archive>
    static void visit_state(Self& self, Archive& archive) {
      archive(self.place_m, self.yaw_rad);
    }
  };

  // Every 10 ms, with fresh kinematics. The first time, the frame's origin lies midway between the soles, and
  // its x axis along their mean heading. `support`: the foot that bears the load.
  void update(const SupportKinematics& kinematics, urdf::Side support) noexcept;

  [[nodiscard]] const Pose& foot(urdf::Side side) const noexcept {
    return foot_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] const Pose& base() const noexcept { return base_; }

  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.started_, self.support_, self.first_heading_rad_, self.foot_[0], self.foot_[1], self.base_);
  }

 private:
  void turn(const SupportKinematics& kinematics) noexcept;
  void place_others(const SupportKinematics& kinematics) noexcept;

  bool started_ = false;
  urdf::Side support_ = urdf::Side::left;
  double first_heading_rad_ = 0.0;  // by the attitude filter, of the frame's x axis
  std::array<Pose, 2> foot_;
  Pose base_;
};

}  // namespace gaitway::zmp
