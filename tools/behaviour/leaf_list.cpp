// What is known of each leaf: kind, meaning, and of its ports the direction, type, unit, range and standard.
#include "tools/behaviour/leaf_list.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

namespace gaitway::tools {
namespace {

const char* kind_of(const behaviour::Registry::Leaf& leaf) {
  return std::holds_alternative<behaviour::ActionMaker>(leaf.maker) ? "action" : "condition";
}

const char* name_of(behaviour::PortDirection direction) {
  switch (direction) {
    case behaviour::PortDirection::input:
      return "input";
    case behaviour::PortDirection::output:
      return "output";
    case behaviour::PortDirection::inout:
      return "inout";
  }
  return "";
}

// "number in m, 0 to 5".
std::string type_of(const behaviour::ValueType& type) {
  const bool least = std::isfinite(type.lowest), most = std::isfinite(type.highest);
  std::string text = behaviour::describe(type);
  if (least && most) return text + fmt::format(", {:g} to {:g}", type.lowest, type.highest);
  if (least) text += fmt::format(", from {:g}", type.lowest);
  if (most) text += fmt::format(", up to {:g}", type.highest);
  return text;
}

// "=3 s" with a standard, "must be given", or that it is an output.
std::string standard_of(const behaviour::PortSpec& port) {
  if (port.direction != behaviour::PortDirection::input) return name_of(port.direction);
  return port.standard ? "= " + *port.standard : "must be given";
}

}  // namespace

std::string leaves_text(const behaviour::Registry& registry) {
  std::size_t name = 0, type = 0, standard = 0;
  for (const auto& [id, leaf] : registry.leaves()) {
    for (const behaviour::PortSpec& port : leaf.spec.ports) {
      name = std::max(name, port.name.size());
      type = std::max(type, type_of(port.type).size());
      standard = std::max(standard, standard_of(port).size());
    }
  }
  std::string text;
  for (const auto& [id, leaf] : registry.leaves()) {
    text += fmt::format("{}{} ({}){}{}\n", text.empty() ? "" : "\n", id, kind_of(leaf),
                        leaf.spec.meaning.empty() ? "" : ": ", leaf.spec.meaning);
    for (const behaviour::PortSpec& port : leaf.spec.ports) {
      std::string line = fmt::format("  {:<{}}  {:<{}}  {:<{}}  {}", port.name, name, type_of(port.type),
                                     type, standard_of(port), standard, port.meaning);
      line.erase(line.find_last_not_of(' ') + 1);
      text += line + "\n";
    }
  }
  return text;
}

nlohmann::json leaves_json(const behaviour::Registry& registry) {
  nlohmann::json list = nlohmann::json::array();
  for (const auto& [id, leaf] : registry.leaves()) {
    nlohmann::json ports = nlohmann::json::array();
    for (const behaviour::PortSpec& port : leaf.spec.ports) {
      nlohmann::json row{{"name", port.name},
                         {"direction", name_of(port.direction)},
                         {"type", behaviour::name(port.type.kind)},
                         {"meaning", port.meaning}};
      if (!port.type.unit.empty()) row["unit"] = port.type.unit;
      if (!port.type.choices.empty()) row["choices"] = port.type.choices;
      if (std::isfinite(port.type.lowest)) row["lowest"] = port.type.lowest;
      if (std::isfinite(port.type.highest)) row["highest"] = port.type.highest;
      if (port.standard) row["standard"] = *port.standard;
      ports.push_back(std::move(row));
    }
    list.push_back(
        {{"id", id}, {"kind", kind_of(leaf)}, {"meaning", leaf.spec.meaning}, {"ports", std::move(ports)}});
  }
  return list;
}

}  // namespace gaitway::tools
