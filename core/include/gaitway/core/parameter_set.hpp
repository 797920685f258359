// A plug-in's parameters: what the configuration says, read as the plug-in declares it.
#pragma once

#include <cstdint>
#include <deque>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/core/configuration.hpp"

namespace gaitway::core {

enum class ParameterKind : std::uint8_t { number, integer, flag, text };
[[nodiscard]] std::string_view parameter_kind_name(ParameterKind kind) noexcept;

struct Parameter {  // as declared, with the value in use
  std::string name;
  ParameterKind kind = ParameterKind::number;
  std::string unit;      // "1": a plain number; empty for flags and texts
  std::string fallback;  // the default, as text
  std::string value;     // as text
};

// Values are looked up by declaring them. All members throw ConfigurationError with file, line, value, rule
// and remedy.
class ParameterSet {
 public:
  ParameterSet(std::filesystem::path file, std::string plugin, std::vector<ParameterEntry> entries)
      : file_(std::move(file)), plugin_(std::move(plugin)), entries_(std::move(entries)) {}

  // A number may carry its unit ("0.4 s"); without one it is taken in `unit`, another one is refused.
  double number(std::string_view name, double fallback, std::string_view unit);
  std::int64_t integer(std::string_view name, std::int64_t fallback, std::string_view unit);
  bool flag(std::string_view name, bool fallback);  // true or false
  // The reference stays valid for the set's life.
  const std::string& text(std::string_view name, std::string_view fallback);

  // Complains about an entry that nobody asked for, and names the nearest parameter.
  void require_all_declared() const;
  [[nodiscard]] const std::deque<Parameter>& declared() const noexcept { return declared_; }

 private:
  Parameter& declare(std::string_view name, ParameterKind kind, std::string_view unit,
                     const std::string& fallback);
  [[nodiscard]] const ParameterEntry* find(std::string_view name) const noexcept;
  template <class Number>
  Number numeric(std::string_view name, Number fallback, std::string_view unit, ParameterKind kind);
  [[noreturn]] void refuse(const ParameterEntry& entry, const std::string& complaint) const;

  std::filesystem::path file_;
  std::string plugin_;
  std::vector<ParameterEntry> entries_;
  std::deque<Parameter> declared_;
};

}  // namespace gaitway::core
