// Checked access to YAML.
#include "gaitway/input/yaml_value.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

#include "gaitway/input/nearest_name.hpp"

namespace gaitway::input {
namespace {

std::string kind_of(const YAML::Node& node) {
  switch (node.Type()) {
    case YAML::NodeType::Scalar:
      return "'" + node.Scalar() + "'";
    case YAML::NodeType::Sequence:
      return fmt::format("a list of {}", node.size());
    case YAML::NodeType::Map:
      return "";  // says nothing of use
    default:
      return "nothing";
  }
}

}  // namespace

YamlValue YamlValue::read(const std::filesystem::path& file) {
  std::ifstream stream(file);
  std::error_code unknown;
  if (!stream || std::filesystem::is_directory(file, unknown)) {
    input::refuse({file, 0, "", "", "the file is missing or cannot be read",
                   "Check the path and the file's permissions"});
  }
  std::ostringstream text;
  text << stream.rdbuf();
  return parse(text.str(), file);
}

YamlValue YamlValue::parse(const std::string& text, const std::filesystem::path& file) {
  try {
    return YamlValue(YAML::Load(text), file, "");
  } catch (const YAML::Exception& error) {
    input::refuse({file, error.mark.line + 1, fmt::format("column {}", error.mark.column + 1), "",
                   "malformed YAML: " + error.msg, "Check indentation, brackets and quotes there and above"});
  }
}

std::vector<std::pair<std::string, YamlValue>> YamlValue::entries() const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", "Write 'key: value', one a line");
  }
  std::vector<std::pair<std::string, YamlValue>> result;
  for (const auto& entry : node_) {
    const YamlValue key = key_of(entry.first);
    const std::string name = key.text();
    const auto same = [&name](const auto& other) { return other.first == name; };
    if (std::any_of(result.begin(), result.end(), same)) {
      key.refuse("the key stands here twice", "Remove one of the two");
    }
    result.emplace_back(name, YamlValue(entry.second, file_, child_path(name)));
  }
  return result;
}

void YamlValue::require_map(std::span<const std::string_view> keys) const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", fmt::format("Give it the keys {}", fmt::join(keys, ", ")));
  }
  for (const auto& entry : node_) {
    const YamlValue key = key_of(entry.first);
    if (std::find(keys.begin(), keys.end(), key.text()) == keys.end()) {
      const std::vector<std::string> known(keys.begin(), keys.end());
      key.refuse("there is no such key", suggest(key.text(), known));
    }
  }
  (void)entries();  // each once
}

YamlValue YamlValue::key_of(const YAML::Node& key) const {
  return {key, file_, path_.empty() ? "key" : path_ + " key"};
}

std::string YamlValue::child_path(std::string_view key) const {
  return path_.empty() ? std::string(key) : fmt::format("{}.{}", path_, key);
}

YamlValue YamlValue::at(std::string_view key) const {
  if (auto value = find(key)) {
    return *std::move(value);
  }
  refuse(fmt::format("the key '{}' is missing", key), fmt::format("Add '{}: ...'", key));
}

std::optional<YamlValue> YamlValue::find(std::string_view key) const {
  if (!node_.IsMap()) {
    refuse("must be a map of keys and values", fmt::format("Give it the key '{}'", key));
  }
  const YAML::Node child = node_[std::string(key)];
  if (!child.IsDefined()) {
    return std::nullopt;
  }
  return YamlValue(child, file_, child_path(key));
}

std::vector<YamlValue> YamlValue::items() const {
  if (!node_.IsSequence()) {
    refuse("must be a list", "Write [a, b, ...] or one '- ...' a line");
  }
  std::vector<YamlValue> result;
  for (std::size_t i = 0; i < node_.size(); ++i) {
    result.push_back(YamlValue(node_[i], file_, fmt::format("{}[{}]", path_, i)));
  }
  return result;
}

std::vector<YamlValue> YamlValue::items(std::size_t count) const {
  std::vector<YamlValue> result = items();
  if (result.size() != count) {
    refuse(fmt::format("must be a list of {}", count), "Add or remove entries");
  }
  return result;
}

double YamlValue::number(const Range& range) const {
  double value = 0.0;
  if (!node_.IsScalar() || !YAML::convert<double>::decode(node_, value) || !std::isfinite(value)) {
    refuse("must be a number", "Write a plain number; its unit is part of the key");
  }
  if (value < range.lowest || value > range.highest) {
    refuse(fmt::format("must be {:g}..{:g}{}{}", range.lowest, range.highest, range.unit.empty() ? "" : " ",
                       range.unit),
           "Check the unit: it is part of the key");
  }
  return value;
}

int YamlValue::integer(int lowest, int highest) const {
  int value = 0;
  if (!node_.IsScalar() || !YAML::convert<int>::decode(node_, value)) {
    refuse("must be a whole number", "Write a plain whole number");
  }
  if (value < lowest || value > highest) {
    refuse(fmt::format("must be {}..{}", lowest, highest), "Choose a number in this range");
  }
  return value;
}

std::string YamlValue::text() const {
  if (!node_.IsScalar()) {
    refuse("must be a plain text", "Write a word or a number, no list and no map");
  }
  return node_.Scalar();
}

void YamlValue::refuse(const std::string& rule, const std::string& remedy) const {
  input::refuse({file_, line(), path_.empty() ? "the file" : path_, kind_of(node_), rule, remedy});
}

int YamlValue::line() const {
  const YAML::Mark mark = node_.Mark();
  return mark.is_null() ? 0 : mark.line + 1;
}

}  // namespace gaitway::input
