// A value of a YAML file that knows where it stands, so that whatever is wrong with it can be said precisely.
#pragma once

#include <yaml-cpp/yaml.h>

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"

namespace gaitway::input {

// Inclusive bounds of a number and why they are there.
struct Range {
  double lowest = 0.0;
  double highest = 0.0;
  std::string_view unit;
};

// All members throw InputError with file, line, field, value, rule and remedy.
class YamlValue {
 public:
  // Reads a whole file; complains about a missing file and, with line and column, about malformed YAML.
  static YamlValue read(const std::filesystem::path& file);
  // The same of a text; `file` is what complaints call it.
  static YamlValue parse(const std::string& text, const std::filesystem::path& file);

  // The value is a map with these keys only, each once; complains about an unknown one and names the nearest.
  void require_map(std::span<const std::string_view> keys) const;

  [[nodiscard]] YamlValue at(std::string_view key) const;  // must be there
  [[nodiscard]] std::optional<YamlValue> find(std::string_view key) const;
  // Of a map with any keys, each once, in the file's order.
  [[nodiscard]] std::vector<std::pair<std::string, YamlValue>> entries() const;
  [[nodiscard]] std::vector<YamlValue> items() const;  // of a list
  [[nodiscard]] std::vector<YamlValue> items(std::size_t count) const;

  [[nodiscard]] bool is_empty() const { return node_.IsNull(); }  // a key with nothing behind it
  [[nodiscard]] double number(const Range& range) const;
  [[nodiscard]] int integer(int lowest, int highest) const;
  // A number with one of these units, in what their factors count.
  [[nodiscard]] std::int64_t number_with_unit(std::span<const Unit> units, std::int64_t lowest,
                                              std::int64_t highest) const;
  [[nodiscard]] std::string text() const;
  template <std::size_t count>
  [[nodiscard]] std::array<double, count> numbers(const Range& range) const {
    const std::vector<YamlValue> values = items(count);
    std::array<double, count> result{};
    for (std::size_t i = 0; i < count; ++i) {
      result[i] = values[i].number(range);
    }
    return result;
  }

  [[noreturn]] void refuse(const std::string& rule, const std::string& remedy) const;
  [[nodiscard]] int line() const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }

 private:
  YamlValue(const YAML::Node& node, std::filesystem::path file, std::string path)
      : node_(node), file_(std::move(file)), path_(std::move(path)) {}

  template <class Number>
  [[nodiscard]] Number read_number(const char* remedy) const;
  [[nodiscard]] YamlValue key_of(const YAML::Node& key) const;
  [[nodiscard]] std::string child_path(std::string_view key) const;

  YAML::Node node_;
  std::filesystem::path file_;
  std::string path_;  // e.g. "joints[3].node"; empty at the top
};

}  // namespace gaitway::input
