// Meshes of robot.urdf: which file of the robot's folder is meant, whether the simulator can read it, and how
// large it is.
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <set>
#include <string_view>

#include "gaitway/input/complaint.hpp"
#include "robot_files.hpp"

namespace gaitway::urdf {
namespace {

// Binary STL: 80 bytes of anything, the number of triangles, and for each its normal, three corners and two
// bytes more. The limits are those of MuJoCo, which reads no other kind.
constexpr std::size_t kHeader_bytes = 84, kCountPlace_bytes = 80;
constexpr std::size_t kTriangle_bytes = 50, kVector_bytes = 12;
constexpr std::uint32_t kMostTriangles = 200'000;
constexpr float kLargestCoordinate = 1 << 30;
constexpr std::size_t kFewestPoints = 4;
// Of a hull's points around their middle, in the direction in which they spread least.
constexpr double kThinnestHull_m = 1e-5;
constexpr double kSmallestMesh_m = 1e-4;

using Corner = std::array<float, 3>;

// One <mesh> element and what is wrong with it.
class MeshElement {
 public:
  MeshElement(const std::filesystem::path& urdf, int line, std::string field, const std::string& filename)
      : urdf_(urdf), line_(line), field_(std::move(field)), filename_(filename) {}

  [[noreturn]] void refuse(const std::string& rule, const std::string& remedy) const {
    input::refuse({urdf_, line_, field_, "'" + filename_ + "'", rule, remedy});
  }

  // The file in the robot's folder.
  [[nodiscard]] std::filesystem::path file() const {
    if (filename_.find("://") != std::string::npos) {
      refuse("a robot's folder holds its meshes itself: there are no packages and no other places",
             "Copy the file into the folder and write its path from there, e.g. meshes/foot.stl");
    }
    std::error_code unknown;
    const std::filesystem::path folder = std::filesystem::absolute(urdf_).parent_path();
    const std::filesystem::path file = std::filesystem::weakly_canonical(folder / filename_, unknown);
    if (unknown) refuse_missing();
    const std::filesystem::path inside =
        file.lexically_relative(std::filesystem::weakly_canonical(folder, unknown));
    if (std::filesystem::path(filename_).is_absolute() || inside.empty() || *inside.begin() == "..") {
      refuse("leads out of the robot's folder",
             "Copy the file into the folder and write its path from there, e.g. meshes/foot.stl");
    }
    if (const std::string ending = file.extension(); ending != ".stl" && ending != ".STL") {
      refuse("must be a binary STL file, which ends in .stl", "Export the mesh as binary STL");
    }
    return folder / filename_;
  }

  [[nodiscard]] std::string content(const std::filesystem::path& file) const {
    std::ifstream stream(file, std::ios::binary);
    std::error_code unknown;
    if (!stream || !std::filesystem::is_regular_file(file, unknown)) refuse_missing();
    constexpr std::size_t kLargest_bytes = kHeader_bytes + kMostTriangles * kTriangle_bytes;
    std::string bytes(kLargest_bytes + 1, '\0');
    stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
    bytes.resize(static_cast<std::size_t>(stream.gcount()));
    if (bytes.size() > kLargest_bytes) {
      refuse(fmt::format("the file is larger than {} triangles are", kMostTriangles),
             "Simplify the mesh, or divide it among several elements");
    }
    return bytes;
  }

  // All corners of all triangles, as they stand in the file.
  [[nodiscard]] std::vector<Corner> corners(std::string_view bytes) const {
    const std::uint32_t triangles = count_triangles(bytes);
    std::vector<Corner> corners;
    for (std::size_t triangle = 0; triangle < triangles; ++triangle) {
      for (std::size_t i = 0; i < 3; ++i) {
        Corner corner{};
        std::memcpy(corner.data(),
                    &bytes[kHeader_bytes + kTriangle_bytes * triangle + kVector_bytes * (1 + i)],
                    sizeof corner);
        for (const float coordinate : corner) {
          if (!(std::abs(coordinate) <= kLargestCoordinate)) {
            refuse(fmt::format("triangle {} has a corner that is nowhere: {:g}", triangle + 1, coordinate),
                   "Export the mesh anew");
          }
        }
        corners.push_back(corner);
      }
    }
    return corners;
  }

 private:
  [[noreturn]] void refuse_missing() const {
    refuse("the file is missing or cannot be read",
           "Put it into the robot's folder: the path counts from there");
  }

  [[nodiscard]] std::uint32_t count_triangles(std::string_view bytes) const {
    const std::string anew = "Export the mesh as binary STL";
    std::uint32_t triangles = 0;
    if (bytes.size() >= kHeader_bytes) std::memcpy(&triangles, &bytes[kCountPlace_bytes], sizeof triangles);
    if (bytes.size() == kHeader_bytes + kTriangle_bytes * triangles && triangles > 0) return triangles;
    if (bytes.starts_with("solid") && bytes.find("facet") != std::string_view::npos) {
      refuse("is an STL file in text form: only the binary one can be read", anew);
    }
    if (bytes.size() < kHeader_bytes || triangles == 0 || triangles > kMostTriangles) {
      refuse(fmt::format("is no binary STL file of 1 to {} triangles", kMostTriangles), anew);
    }
    refuse(fmt::format("is cut off or no binary STL file: {} triangles take {} bytes, it has {}", triangles,
                       kHeader_bytes + kTriangle_bytes * triangles, bytes.size()),
           anew);
  }

  const std::filesystem::path& urdf_;
  int line_;
  std::string field_;
  const std::string& filename_;
};

// The smallest standard deviation of the points around their middle, in any direction.
double thickness_m(const std::vector<Eigen::Vector3d>& points_m) {
  Eigen::Vector3d middle_m = Eigen::Vector3d::Zero();
  for (const Eigen::Vector3d& point : points_m) middle_m += point / static_cast<double>(points_m.size());
  Eigen::Matrix3d spread_m2 = Eigen::Matrix3d::Zero();
  for (const Eigen::Vector3d& point : points_m) {
    spread_m2 += (point - middle_m) * (point - middle_m).transpose() / static_cast<double>(points_m.size());
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(spread_m2, Eigen::EigenvaluesOnly);
  return std::sqrt(std::max(0.0, solver.eigenvalues()[0]));
}

}  // namespace

void read_mesh(const std::filesystem::path& urdf, int line, const std::string& field,
               const std::string& filename, MeshUse use, Shape& shape) {
  const MeshElement element(urdf, line, field + " mesh", filename);
  Mesh& mesh = shape.mesh;
  if (!(mesh.scale.cwiseAbs().minCoeff() > 0.0)) {
    element.refuse("none of the three numbers of its scale may be 0",
                   "Write scale=\"0.001 0.001 0.001\" for a file in millimetres");
  }
  mesh.file = element.file();
  const std::vector<Corner> corners = element.corners(element.content(mesh.file));
  const std::set<Corner> distinct(corners.begin(), corners.end());
  std::vector<Eigen::Vector3d> points_m;
  Eigen::AlignedBox3d bounds;
  for (const Corner& corner : distinct) {
    points_m.emplace_back(mesh.scale.cwiseProduct(Eigen::Vector3f(corner.data()).cast<double>()));
    bounds.extend(points_m.back());
  }
  if (distinct.size() < kFewestPoints) {
    element.refuse(
        fmt::format("its triangles have {} different corners: {} are needed", distinct.size(), kFewestPoints),
        "Export the mesh anew");
  }
  if (bounds.sizes().maxCoeff() < kSmallestMesh_m) {
    element.refuse(
        fmt::format("is smaller than {:g} mm: its scale cannot be right", 1000.0 * kSmallestMesh_m),
        "Choose the scale so that lengths are in metres");
  }
  if (use == MeshUse::collision && thickness_m(points_m) < kThinnestHull_m) {
    element.refuse("its points lie in a plane: what touches the ground is the mesh's convex hull, a body",
                   "Use a thin box for a plate, or a mesh with a thickness");
  }
  mesh.centre_m = bounds.center();
  shape.size_m = bounds.sizes();
  shape.pose.translate(mesh.centre_m);
}

}  // namespace gaitway::urdf
