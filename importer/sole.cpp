// The lowest face of the foot's hull gives the ground, the points on it an outline, the outline a rectangle.
#include "gaitway/importer/sole.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <vector>

#include "gaitway/geometry/convex_hull.hpp"

namespace gaitway::importer {
namespace {

constexpr double kLooksDown = 0.819;      // cosine of 35 deg
constexpr double kTouches = 0.01;         // of the foot's length above the ground
constexpr std::size_t kHullPoints = 400;  // of a foot
constexpr std::size_t kOutlinePoints = 2048;
constexpr int kGrid = 48;  // places along the sole at which an edge of the rectangle is tried
// Of the sole's length: the ends are tried so far inside, lest a rounded corner be taken for the whole edge.
constexpr double kInside = 1e-6;

using Outline = std::vector<Eigen::Vector2d>;  // convex, counter-clockwise

// Everything that the foot is made of, in one heap of points.
Surface gathered(const MakerLink& foot, bool collision) {
  Surface all;
  const auto add = [&all](const Surface& surface) {
    all.point_m.insert(all.point_m.end(), surface.point_m.begin(), surface.point_m.end());
  };
  if (collision) {
    for (const Surface& surface : foot.collision) add(surface);
  } else {
    for (const VisualSurface& visual : foot.visual) add(visual.surface);
  }
  return all;
}

double extent_m(const Surface& surface, const Eigen::Vector3d& direction) {
  double least = std::numeric_limits<double>::infinity(), most = -least;
  for (const Eigen::Vector3d& point : surface.point_m) {
    least = std::min(least, direction.dot(point));
    most = std::max(most, direction.dot(point));
  }
  return most - least;
}

double area_m2(const Outline& outline) {
  double twice = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    twice += a.x() * b.y() - a.y() * b.x();
  }
  return 0.5 * twice;
}

// The frame on a plane: z against `down`, x along the base's forward.
Eigen::Matrix3d level_frame(const Eigen::Vector3d& down, const Eigen::Vector3d& forward) {
  Eigen::Matrix3d frame;
  frame.col(2) = -down;
  frame.col(0) = (forward - down * down.dot(forward)).normalized();
  frame.col(1) = frame.col(2).cross(frame.col(0));
  return frame;
}

// Of the points that lie at most `thickness_m` above the lowest, seen along the frame's z axis.
Outline touching(const Surface& hull, const Eigen::Matrix3d& frame, double thickness_m) {
  double lowest = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : hull.point_m) lowest = std::min(lowest, frame.col(2).dot(point));
  std::vector<Eigen::Vector2d> points;
  for (const Eigen::Vector3d& point : hull.point_m) {
    if (frame.col(2).dot(point) - lowest <= thickness_m) {
      points.emplace_back(frame.col(0).dot(point), frame.col(1).dot(point));
    }
  }
  const geometry::ConvexHull<Eigen::Vector2d, kOutlinePoints> outline{
      std::span<const Eigen::Vector2d>(points)};
  return {outline.corners().begin(), outline.corners().end()};
}

// From right to left of a convex outline at one place along it.
struct Chord {
  double from = std::numeric_limits<double>::infinity(), to = -from;
};
Chord chord_at(const Outline& outline, double x) {
  Chord chord;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Eigen::Vector2d& a = outline[i];
    const Eigen::Vector2d& b = outline[(i + 1) % outline.size()];
    if (std::min(a.x(), b.x()) > x || std::max(a.x(), b.x()) < x) continue;
    const double share = a.x() == b.x() ? 0.0 : (x - a.x()) / (b.x() - a.x());
    const double y = std::lerp(a.y(), b.y(), share);
    chord.from = std::min({chord.from, y, a.x() == b.x() ? b.y() : y});
    chord.to = std::max({chord.to, y, a.x() == b.x() ? b.y() : y});
  }
  return chord;
}

struct Rectangle {
  Eigen::Vector2d size = Eigen::Vector2d::Zero(), centre = Eigen::Vector2d::Zero();
};

// The largest within a convex outline, edges along the axes: what lies between two chords lies inside.
Rectangle largest_rectangle(const Outline& outline) {
  const auto [least, most] = std::minmax_element(outline.begin(), outline.end(),
                                                 [](const auto& a, const auto& b) { return a.x() < b.x(); });
  std::vector<double> place;
  std::vector<Chord> chord;
  for (int i = 0; i <= kGrid; ++i) {
    place.push_back(
        std::lerp(least->x(), most->x(), std::clamp(static_cast<double>(i) / kGrid, kInside, 1.0 - kInside)));
    chord.push_back(chord_at(outline, place.back()));
  }
  Rectangle best;
  for (std::size_t i = 0; i < place.size(); ++i) {
    for (std::size_t j = i + 1; j < place.size(); ++j) {
      const double from = std::max(chord[i].from, chord[j].from), to = std::min(chord[i].to, chord[j].to);
      const Eigen::Vector2d size(place[j] - place[i], to - from);
      if (to > from && size.prod() > best.size.prod()) {
        best = {size, {0.5 * (place[i] + place[j]), 0.5 * (from + to)}};
      }
    }
  }
  return best;
}

// The direction, in the foot's link, against which the largest face of the hull looks.
std::optional<Eigen::Vector3d> down_of_largest_face(const Surface& hull, const Eigen::Vector3d& down,
                                                    const Eigen::Vector3d& forward, double thickness_m) {
  std::optional<Eigen::Vector3d> best;
  double largest_m2 = 0.0;
  for (const std::array<int, 3>& triangle : hull.triangle) {
    const auto corner = [&](std::size_t i) { return hull.point_m[static_cast<std::size_t>(triangle[i])]; };
    const Eigen::Vector3d normal = (corner(1) - corner(0)).cross(corner(2) - corner(0));
    if (normal.norm() <= 0.0 || normal.normalized().dot(down) < kLooksDown) continue;
    const double m2 = area_m2(touching(hull, level_frame(normal.normalized(), forward), thickness_m));
    // Of faces of one size, the more level.
    if (m2 > largest_m2 * 1.02 ||
        (best && m2 > largest_m2 * 0.98 && normal.normalized().dot(down) > best->dot(down))) {
      largest_m2 = std::max(largest_m2, m2);
      best = normal.normalized();
    }
  }
  return best;
}

std::optional<FoundSole> sole_of(const Surface& surface, const Eigen::Matrix3d& base_to_foot,
                                 const Eigen::Vector3d& ankle_m) {
  if (surface.point_m.size() < 4) return std::nullopt;
  const Eigen::Vector3d down = -base_to_foot.transpose().col(2);
  const Eigen::Vector3d forward = base_to_foot.transpose().col(0);
  const double thickness_m = kTouches * extent_m(surface, forward);
  Surface hull;
  try {
    hull = convex_hull(surface, kHullPoints);
  } catch (const std::invalid_argument&) {
    return std::nullopt;  // flat: no body
  }
  const std::optional<Eigen::Vector3d> face = down_of_largest_face(hull, down, forward, thickness_m);
  if (!face) return std::nullopt;
  FoundSole sole;
  sole.pose.linear() = level_frame(*face, forward);
  const Outline outline = touching(hull, sole.pose.linear(), thickness_m);
  const Rectangle rectangle = largest_rectangle(outline);
  double ground = std::numeric_limits<double>::infinity();
  for (const Eigen::Vector3d& point : hull.point_m)
    ground = std::min(ground, sole.pose.linear().col(2).dot(point));
  const Eigen::Vector3d in_frame = sole.pose.linear().transpose() * ankle_m;
  sole.pose.translation() = sole.pose.linear() * Eigen::Vector3d(in_frame.x(), in_frame.y(), ground);
  sole.size_m = rectangle.size;
  sole.centre_m = rectangle.centre - in_frame.head<2>();
  return sole;
}

}  // namespace

FoundSole find_sole(const MakerLink& foot, const Eigen::Isometry3d& base_to_foot,
                    const Eigen::Vector3d& ankle_m, double least_m) {
  std::string tried;
  for (const bool collision : {true, false}) {
    const Surface surface = gathered(foot, collision);
    const char* kind = collision ? "collision" : "visual";
    if (surface.point_m.empty()) {
      tried += fmt::format("{}no {} geometry", tried.empty() ? "" : ", ", kind);
      continue;
    }
    if (auto sole = sole_of(surface, base_to_foot.linear(), ankle_m); sole) {
      if (sole->size_m.minCoeff() > 0.4 * least_m && sole->size_m.x() > least_m) {
        sole->source = fmt::format("the foot's {} geometry", kind);
        return *sole;
      }
      tried += fmt::format("{}a sole of {:.3f} by {:.3f} m by its {} geometry", tried.empty() ? "" : ", ",
                           sole->size_m.x(), sole->size_m.y(), kind);
    } else {
      tried += fmt::format("{}no face that looks down in its {} geometry", tried.empty() ? "" : ", ", kind);
    }
  }
  throw std::invalid_argument(fmt::format(
      "the foot '{}' has {}: it needs a level sole at least {:.3f} m long", foot.name, tried, least_m));
}

FoundSole guess_sole(const MakerLink& foot, const Eigen::Isometry3d& base_to_foot,
                     const Eigen::Vector3d& ankle_m, double leg_length_m) {
  constexpr double kLength = 0.28, kWidth = 0.13, kAhead = 0.03, kHeight = 0.1;  // of the leg's length
  const Eigen::Vector3d up = base_to_foot.linear().transpose().col(2);
  FoundSole sole;
  double below_m = kHeight * leg_length_m;
  sole.source = fmt::format("guess: the size of feet on legs of {:.2f} m", leg_length_m);
  for (const auto& [name, pose] : foot.frames) {
    const double depth_m = up.dot(ankle_m - pose.translation());
    if (name.find("sole") == std::string::npos || depth_m <= 0.0) continue;
    below_m = depth_m;
    sole.source += fmt::format(", as deep as the frame '{}'", name);
    break;
  }
  sole.pose.linear() = level_frame(-up, base_to_foot.linear().transpose().col(0));
  sole.pose.translation() = ankle_m - below_m * up;
  sole.size_m = Eigen::Vector2d(kLength, kWidth) * leg_length_m;
  sole.centre_m = Eigen::Vector2d(kAhead * leg_length_m, 0.0);
  return sole;
}

}  // namespace gaitway::importer
