// The surfaces that a maker's URDF names: shapes, and meshes read once each.
#pragma once

#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "mesh_places.hpp"
#include "surfaces.hpp"
#include "urdf_element.hpp"

namespace gaitway::importer {

class LinkSurfaces {
 public:
  LinkSurfaces(const std::filesystem::path& urdf, const ReadOptions& options, YUp y_up);

  // <material> elements of the whole robot.
  void note_materials(const std::vector<UrdfElement>& materials);

  // The link's <visual> and <collision> elements.
  void read(const UrdfElement& element, MakerLink& link);

  // Whether some mesh says that its y axis is up.
  [[nodiscard]] bool has_y_up() const noexcept { return has_y_up_; }

  // What was left out, a sentence a reason.
  [[nodiscard]] std::vector<std::string> notes() const;

 private:
  // Of a <visual> or <collision>, in the link's frame; nothing for what is noted.
  std::optional<Mesh> surface_of(const UrdfElement& element);
  std::optional<Mesh> mesh_of(const UrdfElement& mesh);
  std::optional<Mesh> leave_out(const std::string& reason, const std::string& what);
  [[nodiscard]] std::optional<Eigen::Vector4d> colour_of(const UrdfElement& visual) const;

  MeshPlaces places_;
  std::map<std::string, Eigen::Vector4d> material_rgba_;
  std::map<std::string, std::optional<Mesh>> meshes_;         // by URI; none: not to be had
  std::map<std::string, std::vector<std::string>> left_out_;  // reason -> what
  YUp y_up_;
  bool has_y_up_ = false;
  std::size_t points_ = 0;
};

}  // namespace gaitway::importer
