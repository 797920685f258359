// What a vertical line meets of a solid, and the room that it takes.
#include <algorithm>
#include <cmath>
#include <limits>

#include "gaitway/world/world.hpp"

namespace gaitway::world {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Of a line's parameter; empty where `to` < `from`.
struct Stretch {
  double from = -kInfinity, to = kInfinity;

  void empty() {
    from = kInfinity;
    to = -kInfinity;
  }
  void narrow(double first, double last) {
    from = std::max(from, first);
    to = std::min(to, last);
  }
  // Where |point + t · along| <= half.
  void keep_within(double point, double along, double half) {
    if (along == 0.0) {
      if (std::abs(point) > half) empty();
      return;
    }
    const double first = (-half - point) / along, last = (half - point) / along;
    narrow(std::min(first, last), std::max(first, last));
  }
  // Where the squares of `point + t · along` add up to at most radius².
  template <class Vector>
  void keep_round(const Vector& point, const Vector& along, double radius) {
    const double a = along.squaredNorm(), b = point.dot(along), c = point.squaredNorm() - radius * radius;
    if (a == 0.0) {
      if (c > 0.0) empty();
      return;
    }
    const double discriminant = b * b - a * c;
    if (discriminant < 0.0) {
      empty();
      return;
    }
    const double root = std::sqrt(discriminant);
    narrow((-b - root) / a, (-b + root) / a);
  }
};

}  // namespace

const char* name(Kind kind) noexcept {
  constexpr std::array kNames{"floor", "box", "step", "slope", "tile", "wall", "thing"};
  return kNames[static_cast<std::size_t>(kind)];
}

std::optional<Interval> Solid::on_vertical(double x_m, double y_m) const noexcept {
  const Eigen::Matrix3d turn = pose.linear().transpose();
  const Eigen::Vector3d point = turn * (Eigen::Vector3d(x_m, y_m, 0.0) - pose.translation());
  const Eigen::Vector3d up = turn.col(2);
  const Eigen::Vector3d half = size_m / 2.0;
  Stretch inside;
  switch (shape) {
    case Shape::box:
      for (Eigen::Index axis = 0; axis < 3; ++axis) inside.keep_within(point[axis], up[axis], half[axis]);
      break;
    case Shape::cylinder:
      inside.keep_round<Eigen::Vector2d>(point.head<2>(), up.head<2>(), half.x());
      inside.keep_within(point.z(), up.z(), half.z());
      break;
    case Shape::sphere:
      inside.keep_round<Eigen::Vector3d>(point, up, half.x());
      break;
  }
  if (!(inside.from <= inside.to)) return std::nullopt;
  return Interval{inside.from, inside.to};
}

std::pair<Eigen::Vector3d, Eigen::Vector3d> Solid::bounds_m() const noexcept {
  const Eigen::Vector3d half = size_m / 2.0;
  Eigen::Vector3d reach;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d row = pose.linear().row(axis).transpose();
    if (shape == Shape::sphere) {
      reach[axis] = half.x();
    } else if (shape == Shape::cylinder) {
      reach[axis] = half.x() * row.head<2>().norm() + half.z() * std::abs(row.z());
    } else {
      reach[axis] = row.cwiseAbs().dot(half);
    }
  }
  return {pose.translation() - reach, pose.translation() + reach};
}

std::vector<Solid> World::all_solids(bool with_things) const {
  std::vector<Solid> all = solids;
  for (std::size_t i = 0; with_things && i < things.size(); ++i) all.push_back(things[i].solid);
  return all;
}

int World::index_of(std::string_view solid) const {
  const std::vector<Solid> all = all_solids(true);
  const auto found = std::ranges::find(all, solid, &Solid::name);
  return found == all.end() ? -1 : static_cast<int>(found - all.begin());
}

}  // namespace gaitway::world
