// Binary STL files for tests: a body from its triangles, and a robot whose shapes are other ones.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace gaitway::test {

using Triangle = std::array<std::array<float, 3>, 3>;

// Of a box with these edges whose middle is `centre`; all triangles face outwards.
inline std::vector<Triangle> box_triangles(const std::array<float, 3>& size,
                                           const std::array<float, 3>& centre = {}) {
  const auto corner = [&](unsigned bits) {
    std::array<float, 3> point{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      point[axis] = centre[axis] + ((bits >> axis & 1U) != 0 ? 0.5F : -0.5F) * size[axis];
    }
    return point;
  };
  std::vector<Triangle> triangles;
  for (const std::array<unsigned, 4>& side : std::array<std::array<unsigned, 4>, 6>{
           {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}}}) {
    triangles.push_back({corner(side[0]), corner(side[1]), corner(side[2])});
    triangles.push_back({corner(side[0]), corner(side[2]), corner(side[3])});
  }
  return triangles;
}

inline std::string stl_bytes(const std::vector<Triangle>& triangles) {
  std::string bytes(80, ' ');
  const auto count = static_cast<std::uint32_t>(triangles.size());
  bytes.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const Triangle& triangle : triangles) {
    bytes.append(12, '\0');  // the normal
    bytes.append(reinterpret_cast<const char*>(triangle.data()), sizeof triangle);
    bytes.append(2, '\0');
  }
  return bytes;
}

inline void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << bytes;
}

}  // namespace gaitway::test
