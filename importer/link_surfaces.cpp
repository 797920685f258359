// Reads <visual> and <collision> elements of links.
#include "link_surfaces.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <exception>
#include <utility>

namespace gaitway::importer {
namespace {

constexpr std::size_t kMostPoints = 10'000'000;  // of a whole robot: some hundreds of MiB

constexpr double kLongestSurface_m = 2.0;  // that a robot's folder may hold

double longest_edge_m(const Surface& surface) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : surface.point_m) box.extend(point);
  return box.isEmpty() ? 0.0 : box.sizes().maxCoeff();
}

}  // namespace

LinkSurfaces::LinkSurfaces(const std::filesystem::path& urdf, const ReadOptions& options, YUp y_up)
    : places_(urdf, options), y_up_(y_up) {}

void LinkSurfaces::note_materials(const std::vector<UrdfElement>& materials) {
  for (const UrdfElement& material : materials) {
    const auto name = material.text("name");
    const auto colour = material.child("color");
    const auto rgba = colour ? colour->vector4("rgba") : std::nullopt;
    if (name && rgba) {
      material_rgba_.emplace(*name, *rgba);
    }
  }
}

void LinkSurfaces::read(const UrdfElement& element, MakerLink& link) {
  for (const UrdfElement& visual : element.children("visual")) {
    note_materials(visual.children("material"));  // one that is spelt out there may be named elsewhere
    if (auto mesh = surface_of(visual)) {
      VisualSurface result{std::move(mesh->surface)};
      const auto rgba = colour_of(visual);
      result.rgba = (rgba ? rgba : mesh->rgba).value_or(result.rgba);
      link.visual.push_back(std::move(result));
    }
  }
  for (const UrdfElement& collision : element.children("collision")) {
    if (auto mesh = surface_of(collision)) {
      link.collision.push_back(std::move(mesh->surface));
    }
  }
}

std::optional<Mesh> LinkSurfaces::leave_out(const std::string& reason, const std::string& what) {
  std::vector<std::string>& list = left_out_[reason];
  if (std::find(list.begin(), list.end(), what) == list.end()) {
    list.push_back(what);
  }
  return std::nullopt;
}

std::optional<Mesh> LinkSurfaces::surface_of(const UrdfElement& element) {
  const auto geometry = element.child("geometry");
  const auto shapes = geometry ? geometry->children() : std::vector<UrdfElement>{};
  if (shapes.empty()) {
    return leave_out("have no geometry", element.title());
  }
  const UrdfElement& shape = shapes.front();
  const auto sized = [&](const char* attribute) { return shape.required_number(attribute); };
  std::optional<Mesh> result;
  bool has_extent = true;
  if (shape.tag() == "box") {
    (void)shape.required_text("size");
    const Eigen::Vector3d size_m = *shape.vector3("size");
    has_extent = size_m.minCoeff() > 0.0;
    result = Mesh{box_surface(size_m), std::nullopt};
  } else if (shape.tag() == "sphere") {
    has_extent = sized("radius") > 0.0;
    result = Mesh{sphere_surface(sized("radius")), std::nullopt};
  } else if (shape.tag() == "cylinder" || shape.tag() == "capsule") {
    has_extent = sized("radius") > 0.0 && sized("length") > 0.0;
    const auto surface = shape.tag() == "capsule" ? capsule_surface : cylinder_surface;
    result = Mesh{surface(sized("radius"), sized("length")), std::nullopt};
  } else if (shape.tag() == "mesh") {
    result = mesh_of(shape);
  } else {
    return leave_out("are of a kind that is not known", shape.title());
  }
  if (!has_extent) {
    return leave_out("have no extent", shape.title());
  }
  if (result) {
    move_surface(result->surface, Eigen::Affine3d(element.origin()));
    if (const double edge_m = longest_edge_m(result->surface); edge_m > kLongestSurface_m) {
      const bool in_millimetres = shape.tag() == "mesh" && edge_m <= 1000.0 * kLongestSurface_m;
      return leave_out(fmt::format("are larger than {:g} m", kLongestSurface_m),
                       fmt::format("line {}, {}, {:.3g} m long{}", shape.line(), shape.title(), edge_m,
                                   in_millimetres ? " (for a file in millimetres write scale=\"0.001 0.001 "
                                                    "0.001\")"
                                                  : ""));
    }
    points_ += result->surface.point_m.size() + result->surface.triangle.size();
    if (points_ > kMostPoints) {
      element.refuse(nullptr,
                     fmt::format("the robot's surfaces have more than {} points and triangles", kMostPoints),
                     "Simplify the meshes");
    }
  }
  return result;
}

std::optional<Mesh> LinkSurfaces::mesh_of(const UrdfElement& mesh) {
  const std::string uri = mesh.required_text("filename");
  const Eigen::Vector3d scale = mesh.vector3("scale").value_or(Eigen::Vector3d::Ones());
  if (scale.cwiseAbs().minCoeff() <= 0.0) {
    return leave_out("have no extent", mesh.title());
  }
  auto known = meshes_.find(uri);
  if (known == meshes_.end()) {
    known = meshes_.emplace(uri, std::nullopt).first;
    if (const auto file = places_.find(uri); !file) {
      leave_out("name a mesh that was not found", uri);
    } else {
      try {
        known->second = read_mesh(*file, y_up_);
        has_y_up_ = has_y_up_ || known->second->says_y_up;
      } catch (const std::exception& error) {
        leave_out("name a mesh that cannot be read", fmt::format("{} ({})", uri, error.what()));
      }
    }
  }
  std::optional<Mesh> result = known->second;
  if (result) {
    move_surface(result->surface, Eigen::Affine3d(Eigen::Scaling(scale)));
  }
  return result;
}

std::optional<Eigen::Vector4d> LinkSurfaces::colour_of(const UrdfElement& visual) const {
  const auto material = visual.child("material");
  if (!material) {
    return std::nullopt;
  }
  if (const auto colour = material->child("color")) {
    return colour->vector4("rgba");
  }
  const auto known = material_rgba_.find(material->text("name").value_or(""));
  return known == material_rgba_.end() ? std::nullopt : std::optional(known->second);
}

std::vector<std::string> LinkSurfaces::notes() const {
  std::vector<std::string> result;
  for (const auto& [reason, list] : left_out_) {
    result.push_back(fmt::format("Surfaces that {} are left out: {}.", reason, fmt::join(list, ", ")));
  }
  return result;
}

}  // namespace gaitway::importer
