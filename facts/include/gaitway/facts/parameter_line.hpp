// A plug-in's parameter as one line of text, as the main controller tells it to other processes: fields with
// tabs between them, so that it needs no JSON.
#pragma once

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>

namespace gaitway::facts {

struct ParameterLine {
  std::string_view name, value, unit;
  bool live = false;  // may be changed while the plug-in works
  std::string_view doc;
};

// Control characters become spaces.
[[nodiscard]] inline std::string write_parameter_line(const ParameterLine& parameter) {
  std::string line;
  const auto add = [&line](std::string_view text, std::string_view end) {
    const auto at = static_cast<std::ptrdiff_t>(line.size());
    line += text;
    std::replace_if(
        line.begin() + at, line.end(),
        [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; }, ' ');
    line += end;
  };
  add(parameter.name, "\t");
  add(parameter.value, "\t");
  add(parameter.unit, "\t");
  add(parameter.live ? "live" : "", "\t");
  add(parameter.doc, "");
  return line;
}

// Its texts point into `line`. Nothing: this is no such line.
[[nodiscard]] inline std::optional<ParameterLine> read_parameter_line(std::string_view line) {
  std::array<std::string_view, 5> fields;
  for (std::size_t i = 0; i + 1 < fields.size(); ++i) {
    const std::size_t end = line.find('\t');
    if (end == std::string_view::npos) {
      return std::nullopt;
    }
    fields[i] = line.substr(0, end);
    line.remove_prefix(end + 1);
  }
  fields.back() = line;
  const bool live = fields[3] == "live";
  if (fields[0].empty() || (!live && !fields[3].empty()) || line.find('\t') != std::string_view::npos) {
    return std::nullopt;
  }
  return ParameterLine{fields[0], fields[1], fields[2], live, fields[4]};
}

}  // namespace gaitway::facts
