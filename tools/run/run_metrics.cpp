// Means of the centre of pressure over time slots.
#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {

void CentreOfPressureMean::add(const simulator::GroundContact& contact) {
  open_.samples += 1.0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const double force = contact.normal_force_N[foot];
    if (force <= 0.0) {
      continue;
    }
    open_.force += force;
    open_.foot_force[foot] += force;
    for (std::size_t frame = 0; frame < 2; ++frame) {
      Eigen::Vector2d cop = contact.foot_cop_m[foot];
      if (frame != foot) {
        const Eigen::Vector3d in_world = contact.sole[foot] * Eigen::Vector3d(cop.x(), cop.y(), 0.0);
        cop = (contact.sole[frame].inverse() * in_world).head<2>();
      }
      open_.moment[frame] += force * cop;
    }
  }
}

void CentreOfPressureMean::close_slot() {
  closed_ = open_;
  open_ = Sum{};
}

bool CentreOfPressureMean::in_sole_frame(int side, Eigen::Vector2d& cop_m) const {
  if (closed_.force <= 0.0) {
    return false;
  }
  cop_m = closed_.moment[static_cast<std::size_t>(side)] / closed_.force;
  return true;
}

}  // namespace gaitway::tools
