// One foot carries the base, until the other one comes lower or it alone stands.
#include "gaitway/kinematic/standing.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace gaitway::kinematic {
namespace {

constexpr double kLower_m = 0.001;  // by which the other sole must be lower to take over

// The same place and heading, flat on the floor.
Eigen::Isometry3d flattened(const Eigen::Isometry3d& sole) {
  Eigen::Isometry3d flat = Eigen::Isometry3d::Identity();
  flat.linear() =
      Eigen::AngleAxisd(std::atan2(sole.linear()(1, 0), sole.linear()(0, 0)), Eigen::Vector3d::UnitZ())
          .toRotationMatrix();
  flat.translation() << sole.translation().head<2>(), 0.0;
  return flat;
}

class BasePlacer {
 public:
  BasePlacer(const urdf::RobotModel& robot, const Trajectory& trajectory, const SolePoses& sole_in_base)
      : robot_(robot), trajectory_(trajectory), sole_in_base_(sole_in_base) {
    carrier_ = stands(0, urdf::Side::left) ? urdf::Side::left : urdf::Side::right;
    const Eigen::Isometry3d to_carrier = in_base(carrier_, 0).inverse();
    Eigen::Isometry3d start = flattened(Eigen::Isometry3d::Identity());
    const Eigen::Vector3d other = (start * to_carrier * in_base(other_side(), 0)).translation();
    start.translation().head<2>() = -0.5 * other.head<2>();
    place_ = start;
  }

  Eigen::Isometry3d base(std::size_t row) {
    Eigen::Isometry3d base = place_ * in_base(carrier_, row).inverse();
    const Eigen::Isometry3d other = base * in_base(other_side(), row);
    if (takes_over(row, other)) {
      place_ = flattened(other);
      carrier_ = other_side();
      base = place_ * in_base(carrier_, row).inverse();
    }
    return base;
  }

 private:
  [[nodiscard]] urdf::Side other_side() const noexcept {
    return carrier_ == urdf::Side::left ? urdf::Side::right : urdf::Side::left;
  }
  [[nodiscard]] const Eigen::Isometry3d& in_base(urdf::Side side, std::size_t row) const {
    return sole_in_base_[urdf::index_of(side)][row];
  }
  [[nodiscard]] bool stands(std::size_t row, urdf::Side side) const {
    return trajectory_.contact.empty() || motion::stands_on(trajectory_.contact[row], side);
  }
  [[nodiscard]] bool takes_over(std::size_t row, const Eigen::Isometry3d& other) const {
    if (!trajectory_.contact.empty()) return !stands(row, carrier_) && stands(row, other_side());
    return lowest_m(robot_.feet[urdf::index_of(other_side())], other) < -kLower_m;
  }

  const urdf::RobotModel& robot_;
  const Trajectory& trajectory_;
  const SolePoses& sole_in_base_;
  urdf::Side carrier_ = urdf::Side::left;
  Eigen::Isometry3d place_ = Eigen::Isometry3d::Identity();  // of the carrier's sole
};

motion::Contact contact_of(bool left, bool right) {
  using motion::Contact;
  return left ? (right ? Contact::both : Contact::left) : (right ? Contact::right : Contact::none);
}

void count_standing(Standing& standing) {
  const std::size_t rows = standing.contact.size();
  for (const urdf::Side side : urdf::kSides) {
    std::vector<int>& since = standing.since[urdf::index_of(side)];
    std::vector<int>& yet = standing.yet[urdf::index_of(side)];
    since.assign(rows, 0);
    yet.assign(rows, 0);
    for (std::size_t row = 1; row < rows; ++row) {
      const bool stays = motion::stands_on(standing.contact[row], side) &&
                         motion::stands_on(standing.contact[row - 1], side);
      if (stays) since[row] = since[row - 1] + 1;
    }
    for (std::size_t row = rows - 1; row-- > 0;) {
      if (since[row + 1] > 0) yet[row] = yet[row + 1] + 1;
    }
  }
}

}  // namespace

double lowest_m(const urdf::Foot& foot, const Eigen::Isometry3d& sole) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector2d& corner : foot.corners_m())
    lowest = std::min(lowest, (sole * Eigen::Vector3d(corner.x(), corner.y(), 0.0)).z());
  return lowest;
}

Standing find_standing(const urdf::RobotModel& robot, const Trajectory& trajectory,
                       const SolePoses& sole_in_base, double touch_m) {
  Standing standing{trajectory.base, trajectory.contact, {}, {}};
  const std::size_t rows = trajectory.rows();
  if (standing.base.empty()) {
    BasePlacer placer(robot, trajectory, sole_in_base);
    for (std::size_t row = 0; row < rows; ++row) standing.base.push_back(placer.base(row));
  }
  if (standing.contact.empty()) {
    for (std::size_t row = 0; row < rows; ++row) {
      std::array<bool, 2> touches{};
      for (const urdf::Side side : urdf::kSides) {
        const auto s = urdf::index_of(side);
        touches[s] = lowest_m(robot.feet[s], standing.sole(sole_in_base, side, row)) < touch_m;
      }
      standing.contact.push_back(contact_of(touches[0], touches[1]));
    }
  }
  count_standing(standing);
  return standing;
}

}  // namespace gaitway::kinematic
