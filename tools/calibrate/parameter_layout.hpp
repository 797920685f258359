// The one vector that the estimate is made in: every deviation in units of its prior standard deviation, so
// that the prior is a unit normal distribution about 0.
#pragma once

#include <Eigen/Core>

#include "tools/calibrate/calibration_settings.hpp"
#include "tools/calibrate/standing_model.hpp"

namespace gaitway::calibration {

class ParameterLayout {
 public:
  // placements: where the feet are on the first look, each with both feet's place.
  ParameterLayout(const urdf::RobotModel& robot, const ManufacturingDeviations& deviations,
                  const StandingDeviations& standing, std::vector<Eigen::Vector3d> placements);

  [[nodiscard]] Eigen::Index size() const noexcept { return first_lasting() + lasting_; }
  [[nodiscard]] Eigen::Index placement_count() const noexcept {
    return static_cast<Eigen::Index>(placements_.size());
  }
  [[nodiscard]] Eigen::Index zero(std::size_t joint) const noexcept {
    return static_cast<Eigen::Index>(joint);
  }
  [[nodiscard]] Eigen::Index trunk_com(Eigen::Index axis) const noexcept { return joints_ + axis; }
  [[nodiscard]] Eigen::Index cell(std::size_t side, std::size_t cell) const noexcept {
    return joints_ + 3 + static_cast<Eigen::Index>(kCells * side + cell);
  }
  [[nodiscard]] const ManufacturingDeviations& deviations() const noexcept { return deviations_; }

  [[nodiscard]] RobotDeviations robot(const Eigen::VectorXd& parameters) const;
  // The same as it stands, where play lets links be off from their encoders for good.
  [[nodiscard]] RobotDeviations standing_robot(const Eigen::VectorXd& parameters) const;
  // index: of a placement; -1 where only one foot stands.
  [[nodiscard]] Ground ground(const Eigen::VectorXd& parameters, int index) const;

 private:
  [[nodiscard]] Eigen::Index first_cell() const noexcept { return joints_ + 3; }
  [[nodiscard]] Eigen::Index first_link() const noexcept {
    return first_cell() + 2 * static_cast<Eigen::Index>(kCells);
  }
  [[nodiscard]] Eigen::Index first_imu() const noexcept { return first_link() + links_; }
  [[nodiscard]] Eigen::Index floor() const noexcept { return first_imu() + kImuUnknowns; }
  [[nodiscard]] Eigen::Index first_compliance() const noexcept { return floor() + 2; }
  [[nodiscard]] Eigen::Index first_placement() const noexcept { return first_compliance() + 2; }
  [[nodiscard]] Eigen::Index first_lasting() const noexcept {
    return first_placement() + 3 * placement_count();
  }

  Eigen::Index joints_, links_, lasting_;
  ManufacturingDeviations deviations_;
  StandingDeviations standing_;
  std::vector<Eigen::Vector3d> placements_;
};

}  // namespace gaitway::calibration
