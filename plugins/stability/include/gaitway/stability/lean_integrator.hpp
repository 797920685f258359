// Takes out a lasting lean of the trunk (a slope, joint zeros), slowly, through the batches: the base is
// turned back upright, and the CoM goes where it would be if the whole body had been turned about the ground
// below it.
#pragma once

#include <array>
#include <cmath>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

class LeanIntegrator {
 public:
  // com_height_m: of the CoM above the ground.
  LeanIntegrator(const BalanceParameters& parameters, double com_height_m) noexcept
      : parameters_(parameters), com_height_m_(com_height_m) {}

  // One tick with the trunk's measured roll and pitch, rad.
  void update(double roll_rad, double pitch_rad, bool walking) noexcept;
  // One tick without: what was learned fades away in some seconds.
  void fade() noexcept;

  // Roll, pitch to add to the base's attitude: against the lean.
  [[nodiscard]] const std::array<double, 2>& offset_rad() const noexcept { return offset_rad_; }

  // To add to the planned CoM, base axes: plans place it along the ground's normal above the feet, balance
  // asks for the vertical.
  [[nodiscard]] std::array<double, 2> com_offset_m() const noexcept {
    return {com_height_m_ * std::sin(offset_rad_[1]), -com_height_m_ * std::sin(offset_rad_[0])};
  }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_rad_);
  }

 private:
  const BalanceParameters& parameters_;
  double com_height_m_;
  std::array<double, 2> offset_rad_{};
};

}  // namespace gaitway::stability
