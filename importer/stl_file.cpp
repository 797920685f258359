// Writes surfaces as binary STL.
#include <array>
#include <cerrno>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <system_error>

#include "gaitway/importer/maker_robot.hpp"

namespace gaitway::importer {
namespace {

static_assert(std::endian::native == std::endian::little, "binary STL is little-endian");

// 12 floats (normal, corners) and 16 bits for attributes.
using StlTriangle = std::array<char, 50>;

StlTriangle stl_triangle(const Surface& surface, const std::array<int, 3>& corners) {
  std::array<Eigen::Vector3f, 4> rows;
  std::array<Eigen::Vector3d, 3> point_m;
  for (std::size_t i = 0; i < 3; ++i) {
    point_m[i] = surface.point_m.at(static_cast<std::size_t>(corners[i]));
    rows[i + 1] = point_m[i].cast<float>();
  }
  rows[0] = (point_m[1] - point_m[0]).cross(point_m[2] - point_m[0]).stableNormalized().cast<float>();
  StlTriangle bytes{};
  for (std::size_t i = 0; i < rows.size(); ++i) {
    std::memcpy(bytes.data() + i * 12, rows[i].data(), 12);
  }
  return bytes;
}

}  // namespace

void write_stl(const std::filesystem::path& file, const Surface& surface) {
  constexpr std::size_t kHeader_bytes = 80;
  std::string content(kHeader_bytes, '\0');
  const auto count = static_cast<std::uint32_t>(surface.triangle.size());
  content.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const std::array<int, 3>& corners : surface.triangle) {
    const StlTriangle bytes = stl_triangle(surface, corners);
    content.append(bytes.data(), bytes.size());
  }
  errno = 0;
  std::ofstream stream(file, std::ios::binary);
  stream.write(content.data(), static_cast<std::streamsize>(content.size())).flush();
  if (!stream) {
    throw std::system_error(errno != 0 ? errno : EIO, std::generic_category(),
                            "cannot write " + file.string());
  }
}

}  // namespace gaitway::importer
