// A plug-in's parameters: what the configuration says, read as the plug-in declares it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/plugin/abi.h"

namespace gaitway::core {

enum class ParameterKind : std::uint8_t {  // same numbers as in the ABI
  number = GAITWAY_NUMBER,
  integer = GAITWAY_INTEGER,
  flag = GAITWAY_FLAG,
  text = GAITWAY_TEXT
};
[[nodiscard]] std::string_view parameter_kind_name(ParameterKind kind) noexcept;
[[nodiscard]] std::string value_text(const gaitway_value& value);  // as people write it

struct Parameter {  // as declared, with the value in use
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string unit;  // "1": a plain number; empty for flags and texts
  std::string doc;
  std::string fallback;  // the default, as text
  std::string value;     // as text
  double lowest = 0.0;   // of numbers
  double highest = 0.0;
  bool live = false;  // may be changed while the plug-in runs
};

// Values are looked up by declaring them. All members throw ConfigurationError with file, line, value, rule
// and remedy.
class ParameterSet {
 public:
  // robot_directory: of the robot in whose body's units numbers may be written; empty: there is none.
  ParameterSet(std::filesystem::path file, std::string plugin, std::vector<ParameterEntry> entries,
               std::filesystem::path robot_directory = {})
      : file_(std::move(file)),
        plugin_(std::move(plugin)),
        entries_(std::move(entries)),
        robot_directory_(std::move(robot_directory)) {}

  // The configuration's value, or the default. A number may carry a unit of the parameter's kind ("0.4 s",
  // "25 mm", "1.1 h/T": parameter_unit.hpp); without one it is taken in the parameter's. A unit of another
  // kind is refused; so is what lies out of range. A text stays valid for the set's life.
  gaitway_value declare(const gaitway_parameter& parameter);
  // The same again, by a new instance of the plug-in: gives the value in use.
  gaitway_value redeclare(const gaitway_parameter& parameter);
  // Reads `text` as the new value of a live parameter. Does not change what is in use: keep() does. A text
  // stays valid for the set's life. By one thread at a time.
  [[nodiscard]] gaitway_value read_change(std::string_view name, const std::string& text);
  // With the value's text, which is swapped in: no allocation.
  void keep(std::string_view name, std::string& text) noexcept;

  // Complains about an entry that nobody asked for, and names the nearest parameter.
  void require_all_declared() const;
  [[nodiscard]] const std::deque<Parameter>& declared() const noexcept { return declared_; }

 private:
  [[nodiscard]] Parameter* find_declared(std::string_view name) noexcept;
  Parameter& remember(const gaitway_parameter& parameter);
  [[nodiscard]] const ParameterEntry* find(std::string_view name) const noexcept;
  [[nodiscard]] gaitway_value read(const Parameter& parameter, const std::string& text,
                                   const std::string& place) const;
  [[nodiscard]] std::string place_of(const ParameterEntry& entry) const;

  std::filesystem::path file_;
  std::string plugin_;
  std::vector<ParameterEntry> entries_;
  std::filesystem::path robot_directory_;
  std::deque<Parameter> declared_;  // stable addresses: texts are given out
  std::set<std::string> live_texts_;
};

// A parameter as a line (facts/parameter_line.hpp), for those who are not in this process. At most
// `most_bytes`: its doc is shortened, and then its value. Throws PluginError where that is not enough.
[[nodiscard]] std::string parameter_line(const Parameter& parameter, std::size_t most_bytes);

}  // namespace gaitway::core
