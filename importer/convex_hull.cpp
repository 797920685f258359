// Convex hulls with Qhull; large ones are thinned out to the points farthest in evenly spread directions.
#include <libqhull_r/qhull_ra.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>
#include <numbers>
#include <set>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {
namespace {

// One run of Qhull over points that must outlive it.
class QhullRun {
 public:
  explicit QhullRun(const std::vector<Eigen::Vector3d>& point_m) : messages_(std::fopen("/dev/null", "w")) {
    static_assert(sizeof(Eigen::Vector3d) == 3 * sizeof(coordT));
    if (!messages_) {
      throw std::system_error(errno, std::generic_category(), "/dev/null");
    }
    qh_zero(&qhull_, messages_.get());
    char options[] = "qhull Qt";                                // Qt: triangles
    auto* first = const_cast<coordT*>(point_m.front().data());  // is only read
    failure_ = qh_new_qhull(&qhull_, 3, static_cast<int>(point_m.size()), first, False, options, nullptr,
                            messages_.get());
  }
  ~QhullRun() {
    qh_freeqhull(&qhull_, qh_ALL);
    int held = 0, held_bytes = 0;
    qh_memfreeshort(&qhull_, &held, &held_bytes);
  }
  QhullRun(const QhullRun&) = delete;
  QhullRun& operator=(const QhullRun&) = delete;

  [[nodiscard]] bool has_failed() const { return failure_ != 0; }

  // Each facet's corners, as indices of the given points.
  [[nodiscard]] std::vector<std::array<int, 3>> triangles() {
    std::vector<std::array<int, 3>> result;
    for (const facetT* facet = qhull_.facet_list; facet && facet->next; facet = facet->next) {
      std::array<int, 3> corners{};
      for (std::size_t i = 0; i < corners.size(); ++i) {
        const auto* vertex = static_cast<const vertexT*>(facet->vertices->e[i].p);
        corners[i] = qh_pointid(&qhull_, vertex->point);
      }
      if ((facet->toporient != 0) == (qh_ORIENTclock == 0)) {
        std::swap(corners[1], corners[2]);
      }
      result.push_back(corners);
    }
    return result;
  }

 private:
  struct Close {
    void operator()(std::FILE* file) const { std::fclose(file); }
  };
  std::unique_ptr<std::FILE, Close> messages_;
  qhT qhull_{};
  int failure_ = 0;
};

// The hull of all points.
Surface whole_hull(const std::vector<Eigen::Vector3d>& point_m) {
  const bool has_all =
      std::all_of(point_m.begin(), point_m.end(), [](const auto& p) { return p.allFinite(); });
  if (point_m.size() < 4 || !has_all) {
    throw std::invalid_argument("a hull takes four points or more, all of them numbers");
  }
  QhullRun run(point_m);
  if (run.has_failed()) {
    throw std::invalid_argument("the points span no volume");
  }
  Surface hull;
  std::map<int, int> index;  // by the given points'
  for (std::array<int, 3> corners : run.triangles()) {
    for (int& corner : corners) {
      const auto [place, is_new] = index.emplace(corner, static_cast<int>(hull.point_m.size()));
      if (is_new) {
        hull.point_m.push_back(point_m.at(static_cast<std::size_t>(corner)));
      }
      corner = place->second;
    }
    hull.triangle.push_back(corners);
  }
  return hull;
}

// Directions that are spread evenly over the sphere, on a spiral of golden angles.
Eigen::Vector3d spread_direction(std::size_t index, std::size_t count) {
  const double z = 1.0 - (2.0 * static_cast<double>(index) + 1.0) / static_cast<double>(count);
  const double angle_rad = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(index);
  const double radius = std::sqrt(1.0 - z * z);
  return {radius * std::cos(angle_rad), radius * std::sin(angle_rad), z};
}

std::set<std::size_t> farthest_points(const std::vector<Eigen::Vector3d>& point_m, std::size_t directions) {
  std::set<std::size_t> result;
  for (std::size_t i = 0; i < directions; ++i) {
    const Eigen::Vector3d direction = spread_direction(i, directions);
    const auto farthest = std::max_element(
        point_m.begin(), point_m.end(),
        [&direction](const auto& a, const auto& b) { return direction.dot(a) < direction.dot(b); });
    result.insert(static_cast<std::size_t>(farthest - point_m.begin()));
  }
  return result;
}

}  // namespace

Surface convex_hull(const Surface& surface, std::size_t most_points) {
  if (most_points < 4) {
    throw std::invalid_argument("a hull has four points or more");
  }
  Surface hull = whole_hull(surface.point_m);
  if (hull.point_m.size() > most_points) {
    std::set<std::size_t> chosen = farthest_points(hull.point_m, most_points);
    // Several directions share a point: more directions fill the places that are left.
    for (std::size_t directions = 2 * most_points; directions <= 8 * most_points; directions *= 2) {
      std::set<std::size_t> more = farthest_points(hull.point_m, directions);
      if (more.size() > most_points) {
        break;
      }
      chosen = std::move(more);
    }
    std::vector<Eigen::Vector3d> point_m;
    for (const std::size_t index : chosen) {
      point_m.push_back(hull.point_m[index]);
    }
    hull = whole_hull(point_m);
  }
  hull.source = surface.source;
  return hull;
}

}  // namespace gaitway::importer
