// Takes out a lasting lean of the trunk, slowly, through the base attitude of the batches.
#pragma once

#include <array>

#include "gaitway/stability/balance_parameters.hpp"

namespace gaitway::stability {

class LeanIntegrator {
 public:
  explicit LeanIntegrator(const BalanceParameters& parameters) noexcept
      : gain_per_s_(parameters.lean_gain_per_s),
        limit_rad_(parameters.lean_limit_rad),
        reference_rad_(parameters.attitude_reference_rad) {}

  // One tick with the trunk's measured roll and pitch, rad.
  void update(double roll_rad, double pitch_rad) noexcept;
  // One tick without: what was learned fades away in some seconds.
  void fade() noexcept;

  // Roll, pitch to add to the base's attitude: against the lean.
  [[nodiscard]] const std::array<double, 2>& offset_rad() const noexcept { return offset_rad_; }

  // What a successor goes on from.
  template <class Self, class Archive>
  static void visit_state(Self& self, Archive& archive) {
    archive(self.offset_rad_);
  }

 private:
  double gain_per_s_, limit_rad_;
  std::array<double, 2> reference_rad_;
  std::array<double, 2> offset_rad_{};
};

}  // namespace gaitway::stability
