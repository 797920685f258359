// One element of a maker's URDF and what is read of it; every complaint names file, line and element.
#pragma once

#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

class TiXmlElement;

namespace gaitway::importer {

class UrdfElement {
 public:
  // `where`: the elements around it, for complaints; empty for <robot>'s own children. File and element must
  // outlive this.
  UrdfElement(const std::filesystem::path& file, const TiXmlElement& xml, std::string where);

  [[nodiscard]] int line() const;
  [[nodiscard]] std::string tag() const;
  // "link 'pelvis' visual": how complaints and notes call it.
  [[nodiscard]] const std::string& title() const noexcept { return title_; }

  // Elements right below this one: the first with that tag, all with that tag, all.
  [[nodiscard]] std::optional<UrdfElement> child(const char* tag) const;
  [[nodiscard]] UrdfElement required_child(const char* tag) const;
  [[nodiscard]] std::vector<UrdfElement> children(const char* tag) const;
  [[nodiscard]] std::vector<UrdfElement> children() const;

  // Attributes. What is there must be what it should be; nothing (or a refusal) where it is missing. Numbers
  // lie within +-1e12, which leaves room to reckon with them; `limit` takes any.
  [[nodiscard]] std::optional<std::string> text(const char* attribute) const;
  [[nodiscard]] std::string required_text(const char* attribute) const;  // not empty either
  // What the written files and the terminal will show: nothing in it may end a line or be obeyed.
  [[nodiscard]] std::optional<std::string> name(const char* attribute) const;
  [[nodiscard]] std::string required_name(const char* attribute) const;
  [[nodiscard]] std::optional<double> number(const char* attribute) const;
  [[nodiscard]] std::optional<double> limit(const char* attribute) const;
  [[nodiscard]] double required_number(const char* attribute) const;
  [[nodiscard]] std::optional<Eigen::Vector3d> vector3(const char* attribute) const;
  [[nodiscard]] std::optional<Eigen::Vector4d> vector4(const char* attribute) const;

  // <origin> below this element; none: no offset.
  [[nodiscard]] Eigen::Isometry3d origin() const;

  // `attribute` is named with its value if it is given.
  [[noreturn]] void refuse(const char* attribute, const std::string& rule, const std::string& remedy) const;

  // Refuses what xacro would have replaced, in this element and below.
  void require_expanded() const;

 private:
  [[nodiscard]] UrdfElement below(const TiXmlElement& xml) const;
  template <int count>
  [[nodiscard]] std::optional<Eigen::Matrix<double, count, 1>> numbers(const char* attribute) const;
  template <int count>
  [[nodiscard]] std::optional<Eigen::Matrix<double, count, 1>> bounded(const char* attribute) const;
  [[nodiscard]] std::string xacro_remedy() const;

  const std::filesystem::path* file_;
  const TiXmlElement* xml_;
  std::string title_;
};

}  // namespace gaitway::importer
