// Reads elements and attributes of a maker's URDF, strict with what is there, lenient with what is missing.
#include "urdf_element.hpp"

#include <fmt/format.h>
#include <tinyxml.h>

#include <sstream>
#include <utility>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"
#include "gaitway/input/text.hpp"

namespace gaitway::importer {

UrdfElement::UrdfElement(const std::filesystem::path& file, const TiXmlElement& xml, std::string where)
    : file_(&file), xml_(&xml), title_(std::move(where)) {
  const char* name = xml.Attribute("name");
  title_ += title_.empty() ? "" : " ";
  title_ += name ? fmt::format("{} '{}'", xml.Value(), name) : std::string(xml.Value());
}

int UrdfElement::line() const {
  return xml_->Row();
}

std::string UrdfElement::tag() const {
  return xml_->ValueStr();
}

UrdfElement UrdfElement::below(const TiXmlElement& xml) const {
  return {*file_, xml, xml_->ValueStr() == "robot" ? "" : title_};
}

std::optional<UrdfElement> UrdfElement::child(const char* tag) const {
  const TiXmlElement* found = xml_->FirstChildElement(tag);
  return found ? std::optional(below(*found)) : std::nullopt;
}

UrdfElement UrdfElement::required_child(const char* tag) const {
  const auto found = child(tag);
  if (!found) {
    refuse(nullptr, fmt::format("the element <{}> is missing", tag), "Add it");
  }
  return *found;
}

std::vector<UrdfElement> UrdfElement::children(const char* tag) const {
  std::vector<UrdfElement> result;
  for (const TiXmlElement* xml = xml_->FirstChildElement(tag); xml; xml = xml->NextSiblingElement(tag)) {
    result.push_back(below(*xml));
  }
  return result;
}

std::vector<UrdfElement> UrdfElement::children() const {
  std::vector<UrdfElement> result;
  for (const TiXmlElement* xml = xml_->FirstChildElement(); xml; xml = xml->NextSiblingElement()) {
    result.push_back(below(*xml));
  }
  return result;
}

std::optional<std::string> UrdfElement::text(const char* attribute) const {
  const std::string* value = xml_->Attribute(std::string(attribute));
  if (!value) {
    return std::nullopt;
  }
  if (value->find("${") != value->npos || value->find("$(") != value->npos) {
    refuse(attribute, "must be a value, not an expression of xacro", xacro_remedy());
  }
  return *value;
}

std::optional<std::string> UrdfElement::name(const char* attribute) const {
  const auto value = text(attribute);
  if (value && (value->find_first_of("\n\t") != value->npos || input::terminal_text(*value) != *value)) {
    refuse(attribute, "must be one line of UTF-8 without control characters", "Give it another name");
  }
  return value;
}

std::string UrdfElement::required_name(const char* attribute) const {
  (void)name(attribute);
  return required_text(attribute);
}

std::string UrdfElement::required_text(const char* attribute) const {
  const auto value = text(attribute);
  if (!value || value->empty()) {
    refuse(nullptr, fmt::format("the attribute '{}' is missing{}", attribute, value ? " its value" : ""),
           "Add it");
  }
  return *value;
}

template <int count>
std::optional<Eigen::Matrix<double, count, 1>> UrdfElement::numbers(const char* attribute) const {
  const auto value = text(attribute);
  if (!value) {
    return std::nullopt;
  }
  constexpr const char* kRemedy = "Write plain numbers in SI units, with blanks between them";
  std::istringstream words(*value);
  Eigen::Matrix<double, count, 1> result;
  int read = 0;
  try {
    for (std::string word; words >> word; ++read) {
      const double number = input::plain_number<double>(word);
      if (read < count) {
        result[read] = number;
      }
    }
  } catch (const input::ValueError& error) {
    refuse(attribute,
           error.remedy.empty() && count > 1 ? fmt::format("must be {} numbers", count) : error.rule,
           kRemedy);
  }
  if (read != count) {
    refuse(attribute, count == 1 ? "must be a number" : fmt::format("must be {} numbers", count), kRemedy);
  }
  return result;
}

std::optional<double> UrdfElement::limit(const char* attribute) const {
  const auto value = numbers<1>(attribute);
  return value ? std::optional((*value)[0]) : std::nullopt;
}

template <int count>
std::optional<Eigen::Matrix<double, count, 1>> UrdfElement::bounded(const char* attribute) const {
  constexpr double kLargest = 1e12;
  const auto value = numbers<count>(attribute);
  if (value && value->cwiseAbs().maxCoeff() > kLargest) {
    refuse(attribute, fmt::format("must lie within +-{:g}", kLargest), "Correct it, in SI units");
  }
  return value;
}

std::optional<double> UrdfElement::number(const char* attribute) const {
  const auto value = bounded<1>(attribute);
  return value ? std::optional((*value)[0]) : std::nullopt;
}

double UrdfElement::required_number(const char* attribute) const {
  (void)required_text(attribute);
  return *number(attribute);
}

std::optional<Eigen::Vector3d> UrdfElement::vector3(const char* attribute) const {
  return bounded<3>(attribute);
}

std::optional<Eigen::Vector4d> UrdfElement::vector4(const char* attribute) const {
  return bounded<4>(attribute);
}

Eigen::Isometry3d UrdfElement::origin() const {
  Eigen::Isometry3d result = Eigen::Isometry3d::Identity();
  if (const auto origin = child("origin")) {
    const Eigen::Vector3d rpy_rad = origin->vector3("rpy").value_or(Eigen::Vector3d::Zero());
    result.linear() = (Eigen::AngleAxisd(rpy_rad.z(), Eigen::Vector3d::UnitZ()) *
                       Eigen::AngleAxisd(rpy_rad.y(), Eigen::Vector3d::UnitY()) *
                       Eigen::AngleAxisd(rpy_rad.x(), Eigen::Vector3d::UnitX()))
                          .toRotationMatrix();
    result.translation() = origin->vector3("xyz").value_or(Eigen::Vector3d::Zero());
  }
  return result;
}

void UrdfElement::refuse(const char* attribute, const std::string& rule, const std::string& remedy) const {
  const std::string* value = attribute ? xml_->Attribute(std::string(attribute)) : nullptr;
  input::refuse({*file_, line(), attribute ? fmt::format("{} {}", title_, attribute) : title_,
                 value ? fmt::format("'{}'", *value) : "", rule, remedy});
}

void UrdfElement::require_expanded() const {
  if (tag().starts_with("xacro:")) {
    refuse(nullptr, "must be expanded before it is read", xacro_remedy());
  }
  for (const UrdfElement& below : children()) {
    below.require_expanded();
  }
}

std::string UrdfElement::xacro_remedy() const {
  const std::string name = file_->filename().string();
  return fmt::format("Expand it: xacro {} > {}_expanded.urdf", name, name.substr(0, name.find('.')));
}

}  // namespace gaitway::importer
