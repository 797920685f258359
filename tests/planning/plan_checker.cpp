// Checks by distances of convex polygons, small pieces of each movement at a time.
#include "plan_checker.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace gaitway::planning {
namespace {

using Polygon = std::vector<Eigen::Vector2d>;
using Feet = std::array<Footstep, 2>;
constexpr double kCells_m = 0.75 * kCell_m;  // the middle of a cell to its corner
constexpr double kRounding_m = 1e-5;
constexpr int kPieces = 8;

Polygon placed(const Polygon& polygon, double x_m, double y_m, double yaw_rad) {
  const Eigen::Rotation2Dd turn(yaw_rad);
  Polygon result;
  for (const Eigen::Vector2d& corner : polygon) result.push_back(turn * corner + Eigen::Vector2d(x_m, y_m));
  return result;
}
Polygon rectangle(double length_m, double width_m, double forward_m) {
  const double x = 0.5 * length_m, y = 0.5 * width_m;
  return {{forward_m - x, -y}, {forward_m + x, -y}, {forward_m + x, y}, {forward_m - x, y}};
}

bool is_beyond(const Polygon& a, const Polygon& b) {  // an edge of a has all of b outside
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Eigen::Vector2d edge = a[(i + 1) % a.size()] - a[i];
    const auto outside = [&](const Eigen::Vector2d& p) {
      return edge.x() * (p.y() - a[i].y()) - edge.y() * (p.x() - a[i].x()) < 0.0;
    };
    if (std::ranges::all_of(b, outside)) return true;
  }
  return false;
}
double to_edge_m(const Eigen::Vector2d& p, const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  const double share = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - share * (b - a)).norm();
}
// 0: they overlap or touch.
double distance_m(const Polygon& a, const Polygon& b) {
  if (!is_beyond(a, b) && !is_beyond(b, a)) return 0.0;
  double least_m = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < a.size(); ++i) {
    for (std::size_t j = 0; j < b.size(); ++j) {
      least_m = std::min({least_m, to_edge_m(a[i], b[j], b[(j + 1) % b.size()]),
                          to_edge_m(b[j], a[i], a[(i + 1) % a.size()])});
    }
  }
  return least_m;
}

struct Block {
  world::Kind kind;
  Polygon outline;
  double bottom_m, top_m;
};

class Checker {
 public:
  Checker(const Scene& scene, const Request& request) : scene_(scene), limits_(small_humanoid()) {
    for (const world::Solid& solid : scene.world.all_solids(true)) {
      const double yaw_rad = std::atan2(solid.pose.linear()(1, 0), solid.pose.linear()(0, 0));
      const Eigen::Vector3d at = solid.pose.translation();
      blocks_.push_back({solid.kind,
                         placed(rectangle(solid.size_m.x(), solid.size_m.y(), 0.0), at.x(), at.y(), yaw_rad),
                         at.z() - 0.5 * solid.size_m.z(), at.z() + 0.5 * solid.size_m.z()});
    }
    feet_ = {Footstep{Side::left, request.left, ground_m(request.left)},
             Footstep{Side::right, request.right, ground_m(request.right)}};
    start_clearance_m_ = clearance_m(middle(feet_[0].pose, feet_[1].pose), ground_m(request.left));
  }

  std::vector<std::string> check(const Plan& plan, const Pose& goal) {
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
      const Footstep& step = plan.steps[i];
      number_ = i;
      if (i > 0 && plan.steps[i - 1].side == step.side) fault("the same foot twice");
      check_reach(step);
      check_ground(step);
      check_swing(step);
      check_body(step);
      feet_[step.side == Side::left ? 0 : 1] = step;
    }
    check_goal(goal);
    return faults_;
  }

 private:
  template <class... Parts>
  void fault(fmt::format_string<Parts...> text, Parts&&... parts) {
    faults_.push_back(fmt::format("step {}: ", number_) + fmt::format(text, std::forward<Parts>(parts)...));
  }
  [[nodiscard]] Polygon sole(const Pose& foot) const {
    return placed(rectangle(limits_.sole.length_m, limits_.sole.width_m, limits_.sole.centre_forward_m),
                  foot.x_m, foot.y_m, foot.yaw_rad);
  }
  [[nodiscard]] static Pose middle(const Pose& a, const Pose& b) {
    return {0.5 * (a.x_m + b.x_m), 0.5 * (a.y_m + b.y_m),
            a.yaw_rad + 0.5 * std::remainder(b.yaw_rad - a.yaw_rad, 2.0 * std::numbers::pi)};
  }
  [[nodiscard]] Pose over(const Footstep& stance) const {
    const double inward_m = (stance.side == Side::left ? -0.5 : 0.5) * limits_.foot_spacing_m;
    return {stance.pose.x_m - std::sin(stance.pose.yaw_rad) * inward_m,
            stance.pose.y_m + std::cos(stance.pose.yaw_rad) * inward_m, stance.pose.yaw_rad};
  }
  [[nodiscard]] double ground_m(const Pose& foot) const {
    const Eigen::Vector2d at =
        placed({{limits_.sole.centre_forward_m, 0.0}}, foot.x_m, foot.y_m, foot.yaw_rad)[0];
    double top_m = 0.0;
    for (const Block& block : blocks_) {
      if (world::is_ground(block.kind) &&
          distance_m({at, at + Eigen::Vector2d(1e-4, 0.0), at + Eigen::Vector2d(0.0, 1e-4)}, block.outline) ==
              0.0) {
        top_m = std::max(top_m, block.top_m);
      }
    }
    return top_m;
  }

  void check_reach(const Footstep& step) {
    const Pose& stance = feet_[step.side == Side::left ? 1 : 0].pose;
    const double side = step.side == Side::left ? 1.0 : -1.0;
    const Eigen::Vector2d way = Eigen::Rotation2Dd(-stance.yaw_rad) *
                                Eigen::Vector2d(step.pose.x_m - stance.x_m, step.pose.y_m - stance.y_m);
    const double turn_rad = std::remainder(step.pose.yaw_rad - stance.yaw_rad, 2.0 * std::numbers::pi);
    constexpr double kNear = 1e-8;
    if (way.x() > limits_.max_step_forward_m + kNear || way.x() < -limits_.max_step_backward_m - kNear) {
      fault("{:.4f} m ahead", way.x());
    }
    if (side * way.y() > limits_.max_foot_spacing_m + kNear) fault("feet {:.4f} m apart", side * way.y());
    if (std::abs(turn_rad) > limits_.max_step_turn_rad + kNear) fault("turned by {:.4f} rad", turn_rad);
    // All at once no more than an ellipsoid of the three.
    const double ahead = way.x() / (way.x() > 0.0 ? limits_.max_step_forward_m : limits_.max_step_backward_m);
    const double turn = turn_rad / limits_.max_step_turn_rad;
    if (ahead * ahead + turn * turn > 1.0 + kNear) fault("too long a step for its turn");
    const double gap_m = distance_m(sole(stance), sole(step.pose));
    if (gap_m < limits_.min_sole_gap_m - kNear) fault("soles {:.4f} m apart", gap_m);
    if (side * way.y() <= 0.0) fault("the feet cross");
  }

  // All of the sole on ground that is level, of the told height, and in reach of the other foot.
  void check_ground(const Footstep& step) {
    const Polygon corners = sole(step.pose);
    double lowest_m = std::numeric_limits<double>::infinity(), highest_m = -lowest_m;
    std::vector<world::Solid> ground, all = scene_.world.all_solids(true);
    for (const world::Solid& solid : all) {
      if (world::is_ground(solid.kind)) ground.push_back(solid);
    }
    constexpr int kPlaces = 14;
    for (int i = 0; i <= kPlaces; ++i) {
      for (int j = 0; j <= kPlaces; ++j) {
        const double u = static_cast<double>(i) / kPlaces, v = static_cast<double>(j) / kPlaces;
        const Eigen::Vector2d at = corners[0] + u * (corners[1] - corners[0]) + v * (corners[3] - corners[0]);
        const double top_m = world::height_at(all, at.x(), at.y(), limits_.height_m).surface_m;
        if (top_m > world::height_at(ground, at.x(), at.y()).surface_m) {
          fault("the sole is on an obstacle");
          return;
        }
        lowest_m = std::min(lowest_m, top_m);
        highest_m = std::max(highest_m, top_m);
      }
    }
    if (highest_m - lowest_m > limits_.sole_unevenness_m + kRounding_m) {
      fault("the ground differs by {:.4f} m", highest_m - lowest_m);
    }
    if (std::abs(step.height_m - highest_m) > limits_.sole_unevenness_m)
      fault("height {:.4f} m, not {:.4f} m", step.height_m, highest_m);
    const double stance_m = feet_[step.side == Side::left ? 1 : 0].height_m;
    if (std::abs(step.height_m - stance_m) > limits_.max_step_height_m + kRounding_m) {
      fault("{:.4f} m up or down", step.height_m - stance_m);
    }
  }

  // The sole in the air, below which everything must be lower.
  void check_swing(const Footstep& step) {
    const Footstep& from = feet_[step.side == Side::left ? 0 : 1];
    for (int i = 1; i < 4 * kPieces; ++i) {
      const double t = i / (4.0 * kPieces), way = t * t * t * (10.0 - 15.0 * t + 6.0 * t * t);
      const Pose at{from.pose.x_m + way * (step.pose.x_m - from.pose.x_m),
                    from.pose.y_m + way * (step.pose.y_m - from.pose.y_m),
                    from.pose.yaw_rad +
                        way * std::remainder(step.pose.yaw_rad - from.pose.yaw_rad, 2.0 * std::numbers::pi)};
      const double sole_m = from.height_m + way * (step.height_m - from.height_m) +
                            limits_.lift_m * 64.0 * std::pow(t * (1.0 - t), 3.0);
      for (const Block& block : blocks_) {
        if (block.top_m <= sole_m + limits_.sole_unevenness_m + kRounding_m || block.bottom_m > sole_m + 0.1)
          continue;
        if (distance_m(sole(at), block.outline) > 0.0) continue;
        fault("the swing foot meets something {:.3f} m high at {:.2f} of its way", block.top_m, t);
        return;
      }
    }
  }

  [[nodiscard]] double clearance_m(const Pose& body, double ground_m) const {
    double least_m = std::numeric_limits<double>::infinity();
    for (std::size_t band = 0; band < limits_.bands.size(); ++band) {
      const Polygon outline = placed(limits_.bands[band].outline_m, body.x_m, body.y_m, body.yaw_rad);
      for (const Block& block : blocks_) {
        if (block.top_m <= ground_m + limits_.bands[band].from_m ||
            block.bottom_m >= ground_m + limits_.height_m)
          continue;
        if ((block.outline[0] - outline[0]).norm() > 1.5) continue;
        least_m = std::min(least_m, distance_m(outline, block.outline));
      }
    }
    return least_m;
  }

  // Between the feet, over the stance foot, between the feet again.
  void check_body(const Footstep& step) {
    const Footstep& stance = feet_[step.side == Side::left ? 1 : 0];
    const std::array places{middle(feet_[0].pose, feet_[1].pose), over(stance),
                            middle(stance.pose, step.pose)};
    const double ground_m = std::min(stance.height_m, step.height_m);
    const auto is_near = [this](const Footstep& foot) {
      return std::hypot(foot.pose.x_m - scene_.start.x_m, foot.pose.y_m - scene_.start.y_m) < 0.55;
    };
    const bool near = is_near(step) || is_near(feet_[0]) || is_near(feet_[1]);
    const double wanted_m =
        near && start_clearance_m_ < limits_.clearance_m + kCells_m ? 1e-4 : limits_.clearance_m - kCells_m;
    for (std::size_t part = number_ == 0 ? 1 : 0; part + 1 < places.size(); ++part) {
      for (int i = 0; i <= kPieces; ++i) {
        const double share = static_cast<double>(i) / kPieces;
        const Pose &a = places[part], &b = places[part + 1];
        const double turn_rad = std::remainder(b.yaw_rad - a.yaw_rad, 2.0 * std::numbers::pi);
        const double clear_m = clearance_m(
            {a.x_m + share * (b.x_m - a.x_m), a.y_m + share * (b.y_m - a.y_m), a.yaw_rad + share * turn_rad},
            ground_m);
        if (clear_m >= wanted_m) continue;
        fault("the body comes {:.4f} m near, {:.4f} m is the least", clear_m, wanted_m);
        return;
      }
    }
  }

  void check_goal(const Pose& goal) {
    for (const Footstep& foot : feet_) {
      const double left_m = (foot.side == Side::left ? 0.5 : -0.5) * limits_.foot_spacing_m;
      if (std::hypot(foot.pose.x_m - goal.x_m + std::sin(goal.yaw_rad) * left_m,
                     foot.pose.y_m - goal.y_m - std::cos(goal.yaw_rad) * left_m) > 1e-6 ||
          std::abs(std::remainder(foot.pose.yaw_rad - goal.yaw_rad, 2.0 * std::numbers::pi)) > 1e-6) {
        fault("the {} foot does not stand at the goal", foot.side == Side::left ? "left" : "right");
      }
    }
  }

  const Scene& scene_;
  Limits limits_;
  std::vector<Block> blocks_;
  Feet feet_;
  double start_clearance_m_ = 0.0;
  std::size_t number_ = 0;
  std::vector<std::string> faults_;
};

}  // namespace

std::vector<std::string> faults_of(const Plan& plan, const Scene& scene, const Request& request) {
  return Checker(scene, request).check(plan, request.goal);
}

}  // namespace gaitway::planning
