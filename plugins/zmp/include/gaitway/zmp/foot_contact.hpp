// What the feet do on the ground: force and ZMP under each, which of them bear load, stand, or slide.
#pragma once

#include <Eigen/Core>
#include <array>
#include <span>

#include "gaitway/urdf/robot_model.hpp"
#include "gaitway/zmp/estimator_parameters.hpp"

namespace gaitway::zmp {

// Force and zero moment point (ZMP) under one foot, from its four force cells.
struct FootPressure {
  double force_N = 0.0;  // sum of the cells, as measured (noise can make it negative)
  Eigen::Vector2d zmp_m = Eigen::Vector2d::Zero();  // in the foot's sole frame
};

// The ZMP of cells that carry vertical force is the mean of their places, weighted by force (M. Vukobratovic,
// B. Borovac, "Zero-moment point - thirty-five years of its life", 2004). It may lie outside of the cells (a
// rigid sole on its edge loads the cells behind it with tension), but is limited to the sole, which noise
// alone can leave. Below `least_force_N` it says nothing and is the sole's centre.
[[nodiscard]] FootPressure foot_pressure(const urdf::Foot& foot, std::span<const double, 4> cell_force_N,
                                         double least_force_N) noexcept;

struct ContactThresholds {
  double on_N = 0.0;   // a foot is in contact from here
  double off_N = 0.0;  // and out of contact below
  double support_margin =
      0.0;  // the support changes when the other foot bears 0.5 + margin of the whole load
};

// Which feet bear load, and which of them is the support foot.
class ContactDetector {
 public:
  explicit ContactDetector(const ContactThresholds& thresholds) noexcept : thresholds_(thresholds) {}

  // force_N: measured, [Side]. A foot that alone is in contact is the support foot; in the air the last one
  // stays it.
  void update(const std::array<double, 2>& force_N) noexcept;

  [[nodiscard]] bool in_contact(urdf::Side side) const noexcept {
    return contact_[static_cast<std::size_t>(side)];
  }
  [[nodiscard]] urdf::Side support() const noexcept { return support_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.contact_, self.support_);
  }

 private:
  ContactThresholds thresholds_;
  std::array<bool, 2> contact_{};
  urdf::Side support_ = urdf::Side::left;
};

// Whether both feet stand on the ground so that the heading can be held by them, and how far they may creep.
// Feet that both bear load, and do not turn against each other, do not turn over the ground by much. They
// creep: while they settle, as long as play makes the load rattle between them, and when the legs are moved.
class PlantedFeet {
 public:
  PlantedFeet(const EstimatorParameters& parameters, double weight_N) noexcept
      : parameters_(parameters), weight_N_(weight_N) {}

  // force_N: on each foot. angle_rad: between the soles' headings. leg_rate: of the fastest leg joint, as
  // asked for.
  void update(const std::array<double, 2>& force_N, double angle_rad, double leg_rate_rad_per_s,
              double dt_s) noexcept;

  [[nodiscard]] bool planted() const noexcept { return planted_s_ >= parameters_.planted_time_s; }
  // Random walk of their heading, per square root of a second.
  [[nodiscard]] double creep_rad_rts() const noexcept;

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.last_force_N_, self.rattle_, self.leg_rate_rad_per_s_, self.planted_s_, self.angle_rad_);
  }

 private:
  EstimatorParameters parameters_;
  double weight_N_;
  std::array<double, 2> last_force_N_{};
  double rattle_ = 0.0;  // mean square of the load's change from sample to sample, as a share of the weight
  double leg_rate_rad_per_s_ = 0.0;
  double planted_s_ = 0.0;  // since both bear load; counted no further than it matters
  double angle_rad_ = 0.0;  // between the soles when they began
};

// How fast a foot that bears load slides over the ground.
// Joints do not tell the slip of the only foot on the ground; the accelerometer in its sole does. Its
// horizontal acceleration is integrated from touchdown on and leaks away with a time constant, as most feet
// stand most of the time; what stays while the foot stands is gravity on a sole whose tilt is not quite
// known, and is taken out. A slip shows at once, and one that lasts longer than the time constant shows
// smaller than it is.
class SlipObserver {
 public:
  explicit SlipObserver(const EstimatorParameters& parameters) noexcept;

  // acceleration: of the sole, horizontal, without gravity, mean over the last dt_s.
  void update(bool in_contact, const Eigen::Vector2d& acceleration_m_per_s2, double dt_s) noexcept;

  [[nodiscard]] double speed_m_per_s() const noexcept { return velocity_.norm(); }  // 0 without contact

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.velocity_, self.offset_, self.contact_s_);
  }

 private:
  double impact_s_, leak_s_, offset_time_s_;
  Eigen::Vector2d velocity_ = Eigen::Vector2d::Zero();
  Eigen::Vector2d offset_ = Eigen::Vector2d::Zero();
  double contact_s_ = 0.0;
};

}  // namespace gaitway::zmp
