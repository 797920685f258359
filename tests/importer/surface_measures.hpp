// Measures of surfaces.
#pragma once

#include <Eigen/Geometry>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer::test {

inline Eigen::AlignedBox3d box_of(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : surface.point_m) {
    box.extend(point);
  }
  return box;
}

// Above zero where a closed surface's triangles face outwards.
inline double volume_m3(const Surface& surface) {
  double sum = 0.0;
  for (const auto& [a, b, c] : surface.triangle) {
    const auto point = [&](int i) { return surface.point_m.at(static_cast<std::size_t>(i)); };
    sum += point(a).dot(point(b).cross(point(c))) / 6.0;
  }
  return sum;
}

// Each edge of a closed surface belongs to two triangles, one in each direction.
inline bool is_closed(const Surface& surface) {
  std::map<std::pair<int, int>, int> count;
  for (const auto& corners : surface.triangle) {
    for (std::size_t i = 0; i < 3; ++i) {
      ++count[{corners[i], corners[(i + 1) % 3]}];
    }
  }
  for (const auto& [edge, times] : count) {
    const auto back = count.find({edge.second, edge.first});
    if (times != 1 || back == count.end() || back->second != 1) {
      return false;
    }
  }
  return !count.empty();
}

}  // namespace gaitway::importer::test
