// The weighted mean of the cells' places.
#include "gaitway/zmp/foot_pressure.hpp"

namespace gaitway::zmp {

FootPressure foot_pressure(const urdf::Foot& foot, std::span<const double, 4> cell_force_N,
                           double least_force_N) noexcept {
  FootPressure pressure;
  Eigen::Vector2d moment = Eigen::Vector2d::Zero();
  for (std::size_t cell = 0; cell < cell_force_N.size(); ++cell) {
    pressure.force_N += cell_force_N[cell];
    moment += cell_force_N[cell] * foot.cell_m[cell];
  }
  pressure.zmp_m = foot.centre_m;
  if (pressure.force_N >= least_force_N && pressure.force_N > 0.0) {
    pressure.zmp_m = (moment / pressure.force_N)
                         .cwiseMax(foot.centre_m - 0.5 * foot.size_m)
                         .cwiseMin(foot.centre_m + 0.5 * foot.size_m);
  }
  return pressure;
}

}  // namespace gaitway::zmp
