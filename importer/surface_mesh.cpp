// Reads meshes of STL, OBJ and DAE with assimp.
#include <assimp/config.h>
#include <assimp/material.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include <algorithm>
#include <assimp/Importer.hpp>
#include <bit>
#include <cctype>
#include <cstdint>
#include <fstream>
#include <numbers>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>

#include "dae_outline.hpp"
#include "mesh_files.hpp"
#include "surfaces.hpp"

namespace gaitway::importer {
namespace {

constexpr std::uintmax_t kLargestMesh_bytes = std::uintmax_t{128} << 20U;

std::string lower_case_extension(const std::filesystem::path& file) {
  std::string extension = file.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char letter) { return static_cast<char>(std::tolower(letter)); });
  return extension;
}

struct PointHash {
  std::size_t operator()(const Eigen::Vector3d& point) const {
    std::uint64_t hash = 0;
    for (const double coordinate : point) {
      hash = (hash ^ std::bit_cast<std::uint64_t>(coordinate + 0.0)) * 0x9E3779B97F4A7C15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
};

// Triangles of a scene's meshes, equal points once.
class Collection {
 public:
  void add(const aiScene& scene) {
    struct Place {
      const aiNode* node;
      aiMatrix4x4 pose;
    };
    std::vector<Place> open{{scene.mRootNode, scene.mRootNode->mTransformation}};
    while (!open.empty()) {
      const Place place = open.back();
      open.pop_back();
      for (unsigned i = 0; i < place.node->mNumMeshes; ++i) {
        const aiMesh& mesh = *scene.mMeshes[place.node->mMeshes[i]];
        add(mesh, place.pose);
        triangles_of_material_[mesh.mMaterialIndex] += mesh.mNumFaces;
      }
      for (unsigned i = 0; i < place.node->mNumChildren; ++i) {
        const aiNode* child = place.node->mChildren[i];
        open.push_back({child, place.pose * child->mTransformation});
      }
    }
  }
  Surface take_surface() { return std::move(surface_); }

  // The material of most triangles.
  [[nodiscard]] unsigned main_material() const {
    const auto most = std::max_element(triangles_of_material_.begin(), triangles_of_material_.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
    return most == triangles_of_material_.end() ? 0 : most->first;
  }

 private:
  void add(const aiMesh& mesh, const aiMatrix4x4& pose) {
    Surface part;
    std::vector<int> index(mesh.mNumVertices);
    for (unsigned i = 0; i < mesh.mNumVertices; ++i) {
      const aiVector3D point = pose * mesh.mVertices[i];
      index[i] = index_of({point.x, point.y, point.z});
    }
    const bool is_mirrored = pose.Determinant() < 0.0F;
    for (unsigned i = 0; i < mesh.mNumFaces; ++i) {
      const aiFace& face = mesh.mFaces[i];
      if (face.mNumIndices == 3) {
        const auto corner = [&](int k) { return index[face.mIndices[k]]; };
        surface_.triangle.push_back({corner(0), corner(is_mirrored ? 2 : 1), corner(is_mirrored ? 1 : 2)});
      }
    }
    if (surface_.triangle.size() > kMostMeshPoints) {
      throw std::runtime_error(fmt::format("it has more than {} triangles", kMostMeshPoints));
    }
  }
  int index_of(const Eigen::Vector3d& point) {
    if (!point.allFinite()) {
      throw std::runtime_error("a point's coordinate is no number");
    }
    const auto [place, is_new] = index_.emplace(point, static_cast<int>(surface_.point_m.size()));
    if (is_new) {
      surface_.point_m.push_back(point);
      if (surface_.point_m.size() > kMostMeshPoints) {
        throw std::runtime_error(fmt::format("it has more than {} points", kMostMeshPoints));
      }
    }
    return place->second;
  }

  Surface surface_;
  std::unordered_map<Eigen::Vector3d, int, PointHash> index_;
  std::map<unsigned, std::size_t> triangles_of_material_;
};

// Whether a DAE that may be read says that its y axis is up.
bool look_over_dae(const std::filesystem::path& file) {
  constexpr std::size_t kHead_bytes = 65536;  // <asset> stands before everything else
  std::string text(std::filesystem::file_size(file), '\0');
  std::ifstream stream(file, std::ios::binary);
  stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  text.resize(static_cast<std::size_t>(stream.gcount()));
  check_dae(text);
  return std::string_view(text).substr(0, kHead_bytes).find("<up_axis>Y_UP") != std::string_view::npos;
}

}  // namespace

Mesh read_mesh(const std::filesystem::path& file, YUp y_up) {
  const std::string extension = lower_case_extension(file);
  if (extension != ".stl" && extension != ".obj" && extension != ".dae") {
    throw std::runtime_error("meshes are read from STL, OBJ and DAE files");
  }
  if (std::filesystem::file_size(file) > kLargestMesh_bytes) {
    throw std::runtime_error(fmt::format("the file is larger than {} MiB", kLargestMesh_bytes >> 20U));
  }
  const bool says_y_up = extension == ".dae" && look_over_dae(file);
  Assimp::Importer importer;
  importer.SetIOHandler(new MeshFiles(file));  // the importer owns it
  importer.SetPropertyBool(AI_CONFIG_IMPORT_COLLADA_IGNORE_UP_DIRECTION, true);
  const aiScene* scene = importer.ReadFile(file.string(), aiProcess_Triangulate);
  if (!scene || !scene->mRootNode) {
    throw std::runtime_error(importer.GetErrorString());
  }
  Collection collection;
  collection.add(*scene);
  Mesh mesh;
  aiColor4D colour;
  if (extension != ".stl" && collection.main_material() < scene->mNumMaterials &&
      scene->mMaterials[collection.main_material()]->Get(AI_MATKEY_COLOR_DIFFUSE, colour) == AI_SUCCESS) {
    mesh.rgba = Eigen::Vector4f(colour.r, colour.g, colour.b, colour.a).cast<double>();
  }
  mesh.surface = collection.take_surface();
  mesh.surface.source = file.string();
  mesh.says_y_up = says_y_up;
  if (mesh.says_y_up && y_up == YUp::turned) {
    move_surface(mesh.surface,
                 Eigen::Affine3d(Eigen::AngleAxisd(0.5 * std::numbers::pi, Eigen::Vector3d::UnitX())));
  }
  if (mesh.surface.triangle.empty()) {
    throw std::runtime_error("it has no triangles");
  }
  return mesh;
}

}  // namespace gaitway::importer
