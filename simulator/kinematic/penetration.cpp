// Two bodies meet where the origin lies in the difference of their points. First a tetrahedron of that
// difference around the origin is looked for; from there a polytope grows outwards, until its face that is
// nearest to the origin lies on the difference's own surface: that face's distance is the depth.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "gaitway/kinematic/convex_shape.hpp"

namespace gaitway::kinematic {
namespace {

constexpr int kMostSteps = 96;
constexpr double kDepthAccuracy_m = 1e-6;
constexpr double kTouching_m = 1e-9;

using Point = Eigen::Vector3d;

// Of the difference of both bodies' points.
class Difference {
 public:
  Difference(const PlacedShape& one, const PlacedShape& other) : one_(one), other_(other) {}
  [[nodiscard]] Point furthest_m(const Point& direction) const noexcept {
    return one_.furthest_m(direction) - other_.furthest_m(-direction);
  }
  // From the other's middle to the one's; anything where they coincide.
  [[nodiscard]] Point inside_m() const noexcept {
    const Point between = one_.pose.translation() - other_.pose.translation();
    return between.norm() > kTouching_m ? between : Point(1.0, 0.0, 0.0);
  }

 private:
  const PlacedShape& one_;
  const PlacedShape& other_;
};

Point perpendicular(const Point& line) noexcept {
  return line.cross(std::abs(line.x()) < 0.6 * line.norm() ? Point::UnitX() : Point::UnitY());
}

// Points of the difference, the newest last, that come to surround the origin.
class Simplex {
 public:
  void add(const Point& point) noexcept { corner_[count_++] = point; }
  [[nodiscard]] const std::array<Point, 4>& corners() const noexcept { return corner_; }

  // Keeps what lies nearest to the origin, and says where to look next; true: the origin is inside.
  bool surrounds(Point& direction) noexcept {
    if (count_ == 1) {
      direction = -corner_[0];
      return false;
    }
    if (count_ == 2) return line(direction);
    if (count_ == 3) return triangle(direction);
    return tetrahedron(direction);
  }

 private:
  void keep(std::initializer_list<Point> points) noexcept {
    count_ = 0;
    for (const Point& point : points) add(point);
  }
  bool line(Point& direction) noexcept {
    const Point a = corner_[1], b = corner_[0], along = b - a;
    if (along.dot(-a) <= 0.0) {
      keep({a});
      direction = -a;
      return false;
    }
    direction = along.cross(-a).cross(along);
    if (direction.norm() < kTouching_m * along.norm()) direction = perpendicular(along);
    return false;
  }
  bool triangle(Point& direction) noexcept {
    const Point a = corner_[2], b = corner_[1], c = corner_[0];
    const Point normal = (b - a).cross(c - a);
    if (normal.cross(c - a).dot(-a) > 0.0) return edge(a, c, b, direction);
    if ((b - a).cross(normal).dot(-a) > 0.0) return edge(a, b, c, direction);
    if (normal.dot(-a) >= 0.0) {
      direction = normal;
    } else {
      keep({b, c, a});
      direction = -normal;
    }
    return false;
  }
  // Beyond the edge a-b of a triangle.
  bool edge(const Point& a, const Point& b, const Point&, Point& direction) noexcept {
    keep({b, a});
    return line(direction);
  }
  bool tetrahedron(Point& direction) noexcept {
    const Point a = corner_[3];
    const std::array<Point, 3> base{corner_[2], corner_[1], corner_[0]};
    for (std::size_t i = 0; i < 3; ++i) {
      const Point &b = base[i], &c = base[(i + 1) % 3], &opposite = base[(i + 2) % 3];
      Point normal = (b - a).cross(c - a);
      if (normal.dot(opposite - a) > 0.0) normal = -normal;
      if (normal.dot(-a) > kTouching_m * normal.norm()) {
        keep({c, b, a});
        return triangle(direction);
      }
    }
    return true;
  }

  std::array<Point, 4> corner_;
  std::size_t count_ = 0;
};

// Grows from a tetrahedron that holds the origin.
class Polytope {
 public:
  explicit Polytope(const std::array<Point, 4>& corners)
      : points_(corners.begin(), corners.end()),
        inside_(0.25 * (corners[0] + corners[1] + corners[2] + corners[3])) {
    for (const std::array<int, 3>& face :
         {std::array{0, 1, 2}, std::array{0, 1, 3}, std::array{0, 2, 3}, std::array{1, 2, 3}}) {
      add_face(face);
    }
  }

  [[nodiscard]] double depth_m(const Difference& difference) {
    double depth_m = 0.0;
    for (int step = 0; step < kMostSteps; ++step) {
      const auto nearest = std::ranges::min_element(faces_, {}, &Face::distance_m);
      if (nearest == faces_.end()) break;
      depth_m = std::max(0.0, nearest->distance_m);
      const Point point = difference.furthest_m(nearest->normal);
      if (nearest->normal.dot(point) - nearest->distance_m < kDepthAccuracy_m) break;
      grow_to(point);
    }
    return depth_m;
  }

 private:
  struct Face {
    std::array<int, 3> corner;
    Point normal;  // outwards
    double distance_m;
  };
  [[nodiscard]] const Point& at(int index) const { return points_[static_cast<std::size_t>(index)]; }

  void add_face(const std::array<int, 3>& corner) {
    Point normal = (at(corner[1]) - at(corner[0])).cross(at(corner[2]) - at(corner[0]));
    const double size = normal.norm();
    if (size < 1e-14) return;  // a sliver hides nothing
    normal /= size;
    if (normal.dot(at(corner[0]) - inside_) < 0.0) normal = -normal;
    faces_.push_back({corner, normal, normal.dot(at(corner[0]))});
  }
  // The faces that see the point give way to those between it and their rim.
  void grow_to(const Point& point) {
    std::vector<std::pair<int, int>> rim;
    const auto toggle = [&rim](int a, int b) {
      const std::pair<int, int> edge = std::minmax(a, b);
      const auto found = std::ranges::find(rim, edge);
      if (found == rim.end()) {
        rim.push_back(edge);
      } else {
        rim.erase(found);
      }
    };
    std::erase_if(faces_, [&](const Face& face) {
      if (face.normal.dot(point) - face.distance_m <= 1e-12) return false;
      for (std::size_t i = 0; i < 3; ++i) toggle(face.corner[i], face.corner[(i + 1) % 3]);
      return true;
    });
    points_.push_back(point);
    const int newest = static_cast<int>(points_.size()) - 1;
    for (const auto& [a, b] : rim) add_face({a, b, newest});
  }

  std::vector<Point> points_;
  Point inside_;
  std::vector<Face> faces_;
};

}  // namespace

double penetration_m(const PlacedShape& one, const PlacedShape& other) {
  const Difference difference(one, other);
  Simplex simplex;
  Point direction = -difference.inside_m();
  for (int step = 0; step < kMostSteps; ++step) {
    const double size = direction.norm();
    if (size < kTouching_m) return 0.0;  // the origin is a corner of the difference
    const Point point = difference.furthest_m(direction);
    if (point.dot(direction) <= kTouching_m * size) return 0.0;
    simplex.add(point);
    if (simplex.surrounds(direction)) return Polytope(simplex.corners()).depth_m(difference);
  }
  return 0.0;
}

}  // namespace gaitway::kinematic
