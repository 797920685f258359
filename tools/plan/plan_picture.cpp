// Paints a plan over its map.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <vector>

#include "gaitway/planning/swept_body.hpp"
#include "gaitway/simulator/camera.hpp"
#include "tools/plan/plan_report.hpp"

namespace gaitway::tools {
namespace {

using planning::Pose;
using planning::Side;
using Points = std::vector<Eigen::Vector2d>;

struct Paint {
  std::array<double, 3> rgb;
  double cover = 1.0;  // 1: nothing below it is seen
};
constexpr Paint kFloor{{245, 245, 242}}, kHigh{{214, 196, 160}}, kLow{{225, 225, 230}}, kTall{{60, 62, 70}};
constexpr Paint kBody{{120, 150, 120}, 0.16}, kArms{{120, 150, 120}, 0.10};
constexpr Paint kLeft{{30, 100, 200}}, kRight{{205, 55, 45}}, kGoal{{20, 150, 60}}, kStart{{60, 60, 60}};
constexpr int kLongest_px = 1600;
constexpr double kView_m = 0.6;  // around start, goal and steps, at least

// The part of the map that is shown, as pixels.
class Canvas {
 public:
  Canvas(const Eigen::Vector2d& least_m, const Eigen::Vector2d& greatest_m) : least_m_(least_m) {
    const Eigen::Vector2d size_m = greatest_m - least_m;
    pixel_m_ = size_m.maxCoeff() / kLongest_px;
    image_.width_px = std::max(1, static_cast<int>(std::ceil(size_m.x() / pixel_m_)));
    image_.height_px = std::max(1, static_cast<int>(std::ceil(size_m.y() / pixel_m_)));
    image_.rgb.assign(
        static_cast<std::size_t>(image_.width_px) * static_cast<std::size_t>(image_.height_px) * 3, 255);
  }

  [[nodiscard]] Eigen::Vector2d place_m(int column, int row) const {
    return least_m_ + pixel_m_ * Eigen::Vector2d(column + 0.5, image_.height_px - row - 0.5);
  }
  [[nodiscard]] double pixel_m() const { return pixel_m_; }
  [[nodiscard]] const simulator::Image& image() const { return image_; }

  void put(int column, int row, const Paint& paint) {
    const std::size_t at = (static_cast<std::size_t>(row) * static_cast<std::size_t>(image_.width_px) +
                            static_cast<std::size_t>(column)) *
                           3;
    for (std::size_t i = 0; i < 3; ++i) {
      const double mixed = paint.cover * paint.rgb[i] + (1.0 - paint.cover) * image_.rgb[at + i];
      image_.rgb[at + i] = static_cast<std::uint8_t>(std::lround(std::clamp(mixed, 0.0, 255.0)));
    }
  }
  template <class PaintAt>
  void cover(const PaintAt& paint_at) {
    for (int row = 0; row < image_.height_px; ++row) {
      for (int column = 0; column < image_.width_px; ++column)
        put(column, row, paint_at(place_m(column, row)));
    }
  }

  // A convex outline, counter-clockwise; `edge_m`: only so much along its edge.
  void fill(const Points& outline_m, const Paint& paint, double edge_m = 0.0) {
    Eigen::Vector2d least = outline_m[0], greatest = outline_m[0];
    for (const Eigen::Vector2d& corner : outline_m) {
      least = least.cwiseMin(corner);
      greatest = greatest.cwiseMax(corner);
    }
    const auto column = [this](double x) {
      return static_cast<int>(std::floor((x - least_m_.x()) / pixel_m_));
    };
    const auto row = [this](double y) {
      return image_.height_px - 1 - static_cast<int>(std::floor((y - least_m_.y()) / pixel_m_));
    };
    for (int r = std::max(row(greatest.y()), 0); r <= std::min(row(least.y()), image_.height_px - 1); ++r) {
      for (int c = std::max(column(least.x()), 0); c <= std::min(column(greatest.x()), image_.width_px - 1);
           ++c) {
        const double inside_m = depth_m(outline_m, place_m(c, r));
        if (inside_m >= 0.0 && (edge_m == 0.0 || inside_m <= edge_m)) put(c, r, paint);
      }
    }
  }

  void line(const Eigen::Vector2d& from, const Eigen::Vector2d& to, double width_m, const Paint& paint) {
    const Eigen::Vector2d along = (to - from).normalized() * 0.5 * width_m, left(-along.y(), along.x());
    fill({from - along - left, to + along - left, to + along + left, from - along + left}, paint);
  }

 private:
  static double depth_m(const Points& outline_m, const Eigen::Vector2d& at) {
    double least_m = 1e9;
    for (std::size_t i = 0; i < outline_m.size(); ++i) {
      const Eigen::Vector2d edge = outline_m[(i + 1) % outline_m.size()] - outline_m[i];
      const Eigen::Vector2d to = at - outline_m[i];
      least_m = std::min(least_m, (edge.x() * to.y() - edge.y() * to.x()) / edge.norm());
    }
    return least_m;
  }

  Eigen::Vector2d least_m_;
  double pixel_m_ = 0.0;
  simulator::Image image_;
};

Paint between(const Paint& a, const Paint& b, double share) {
  Paint mixed = a;
  for (std::size_t i = 0; i < 3; ++i) mixed.rgb[i] += std::clamp(share, 0.0, 1.0) * (b.rgb[i] - a.rgb[i]);
  return mixed;
}

// Ground from light to brown as it rises, obstacles from pale to dark, what hangs with a tint.
Paint ground_at(const PlannedWay& way, const Eigen::Vector2d& at_m) {
  const world::Grid& grid = way.map.grid;
  const auto column = static_cast<int>(std::floor((at_m.x() - grid.origin_m.x()) / grid.cell_m));
  const auto row = static_cast<int>(std::floor((at_m.y() - grid.origin_m.y()) / grid.cell_m));
  if (column < 0 || row < 0 || column >= grid.columns || row >= grid.rows) return {{255, 255, 255}};
  const std::size_t cell = static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                           static_cast<std::size_t>(column);
  const double height_m = way.map.surface_m[cell];
  if (way.map.is_ground[cell] != 0)
    return between(kFloor, kHigh, height_m / (6.0 * way.limits.max_step_height_m + 1e-9));
  return between(kLow, kTall, height_m / (0.4 * way.limits.height_m));
}

Points sole_at(const planning::Limits& limits, const Pose& foot) {
  const double toe_m = limits.sole.centre_forward_m + 0.5 * limits.sole.length_m;
  const double heel_m = limits.sole.centre_forward_m - 0.5 * limits.sole.length_m,
               side_m = 0.5 * limits.sole.width_m;
  return {foot.point({heel_m, -side_m}), foot.point({toe_m, -side_m}), foot.point({toe_m, side_m}),
          foot.point({heel_m, side_m})};
}

// A foot with its toes' side filled.
void draw_foot(Canvas& canvas, const planning::Limits& limits, const Pose& foot, const Paint& paint) {
  const Points sole = sole_at(limits, foot);
  Paint inside = paint;
  inside.cover = 0.35;
  canvas.fill(sole, inside);
  canvas.fill(sole, paint, 3.0 * canvas.pixel_m());
  const Eigen::Vector2d ahead = 0.75 * (sole[1] - sole[0]);
  canvas.fill({sole[0] + ahead, sole[1], sole[2], sole[3] + ahead}, paint);
}

void draw_pose(Canvas& canvas, const planning::Limits& limits, const Pose& middle, const Paint& paint) {
  const double long_m = 1.6 * limits.sole.length_m, width_m = 5.0 * canvas.pixel_m();
  const Eigen::Vector2d tip = middle.point({long_m, 0.0});
  canvas.line(middle.point({0.0, 0.0}), tip, width_m, paint);
  for (const double side : {-1.0, 1.0})
    canvas.line(middle.point({0.7 * long_m, 0.25 * side * long_m}), tip, width_m, paint);
}

void draw_sweep(Canvas& canvas, const PlannedWay& way) {
  const std::size_t top = way.limits.bands.size() - 1;
  std::array<Pose, 2> feet{way.request.left, way.request.right};
  for (const planning::Footstep& step : way.plan.steps) {
    const Side stance = planning::other(step.side);
    const Pose& foot = feet[static_cast<std::size_t>(stance)];
    canvas.fill(planning::swept_body(way.limits, top, foot, stance, step.pose), kArms);
    if (top > 0) canvas.fill(planning::swept_body(way.limits, 0, foot, stance, step.pose), kBody);
    feet[static_cast<std::size_t>(step.side)] = step.pose;
  }
}

}  // namespace

void draw_plan(const std::filesystem::path& file, const PlannedWay& way) {
  const world::Grid& grid = way.map.grid;
  const Eigen::Vector2d end_m = grid.origin_m + grid.cell_m * Eigen::Vector2d(grid.columns, grid.rows);
  const Eigen::Vector2d start(way.request.left.x_m, way.request.left.y_m),
      goal(way.request.goal.x_m, way.request.goal.y_m);
  Eigen::Vector2d least = start.cwiseMin(goal), greatest = start.cwiseMax(goal);
  for (const planning::Footstep& step : way.plan.steps) {
    least = least.cwiseMin(Eigen::Vector2d(step.pose.x_m, step.pose.y_m));
    greatest = greatest.cwiseMax(Eigen::Vector2d(step.pose.x_m, step.pose.y_m));
  }
  const Eigen::Vector2d around = Eigen::Vector2d::Constant(kView_m);
  least = (least - around).cwiseMax(grid.origin_m);
  greatest = (greatest + around).cwiseMin(end_m);
  if ((greatest - least).minCoeff() < 2.0 * grid.cell_m) {  // neither is on the map
    least = grid.origin_m;
    greatest = end_m;
  }
  Canvas canvas(least, greatest);
  canvas.cover([&](const Eigen::Vector2d& at_m) { return ground_at(way, at_m); });
  draw_sweep(canvas, way);
  draw_foot(canvas, way.limits, way.limits.foot_of(way.request.goal, Side::left), kGoal);
  draw_foot(canvas, way.limits, way.limits.foot_of(way.request.goal, Side::right), kGoal);
  draw_foot(canvas, way.limits, way.request.left, kStart);
  draw_foot(canvas, way.limits, way.request.right, kStart);
  for (const planning::Footstep& step : way.plan.steps) {
    draw_foot(canvas, way.limits, step.pose, step.side == Side::left ? kLeft : kRight);
  }
  draw_pose(canvas, way.limits, planning::middle_of(way.request.left, way.request.right), kStart);
  draw_pose(canvas, way.limits, way.request.goal, kGoal);
  simulator::write_film_strip(file.string(), std::array{canvas.image()}, 1);
}

}  // namespace gaitway::tools
