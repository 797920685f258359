// Numbers with units, flags and texts.
#include "gaitway/core/parameter_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <type_traits>

#include "gaitway/urdf/nearest_name.hpp"

namespace gaitway::core {
namespace {

std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t begin = std::min(text.find_first_not_of(" \t"), text.size());
  text.remove_prefix(begin);
  return text.substr(0, text.find_last_not_of(" \t") + 1);
}

std::string_view plain(std::string_view unit) noexcept {
  return unit.empty() ? std::string_view("1") : unit;
}

}  // namespace

std::string_view parameter_kind_name(ParameterKind kind) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"number", "integer", "flag", "text"};
  return kNames[static_cast<std::size_t>(kind)];
}

void ParameterSet::refuse(const ParameterEntry& entry, const std::string& complaint) const {
  throw ConfigurationError(fmt::format("{}:{}: parameter '{}' of '{}' = '{}': {}", file_.string(), entry.line,
                                       entry.name, plugin_, entry.text, complaint));
}

const ParameterEntry* ParameterSet::find(std::string_view name) const noexcept {
  const auto found = std::find_if(entries_.begin(), entries_.end(),
                                  [name](const ParameterEntry& entry) { return entry.name == name; });
  return found == entries_.end() ? nullptr : &*found;
}

Parameter& ParameterSet::declare(std::string_view name, ParameterKind kind, std::string_view unit,
                                 const std::string& fallback) {
  const auto same = [name](const Parameter& other) { return other.name == name; };
  const auto before = std::find_if(declared_.begin(), declared_.end(), same);
  if (before != declared_.end()) {
    if (before->kind != kind || before->unit != unit) {
      throw ConfigurationError(fmt::format(
          "plug-in '{}' declares its parameter '{}' once as {} [{}] and once as {} [{}]. "
          "Correct the plug-in",
          plugin_, name, parameter_kind_name(before->kind), before->unit, parameter_kind_name(kind), unit));
    }
    return *before;
  }
  declared_.push_back({std::string(name), kind, std::string(unit), fallback, fallback});
  return declared_.back();
}

template <class Number>
Number ParameterSet::numeric(std::string_view name, Number fallback, std::string_view unit,
                             ParameterKind kind) {
  constexpr std::string_view kWanted = std::is_integral_v<Number> ? "a whole number" : "a finite number";
  unit = plain(unit);
  Parameter& parameter = declare(name, kind, unit, fmt::format("{}", fallback));
  const ParameterEntry* const entry = find(name);
  if (entry == nullptr) {
    return fallback;
  }
  std::string_view rest = trimmed(entry->text);
  rest.remove_prefix(rest.starts_with('+') && rest.size() > 1 && rest[1] != '-' ? 1 : 0);
  Number value{};
  const auto [end, error] = std::from_chars(rest.data(), rest.data() + rest.size(), value);
  const bool is_number = error == std::errc{} && std::isfinite(static_cast<double>(value));
  rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
  // What follows a whole number is its unit, not the rest of "1.5" or "1e3".
  const bool cut_off = std::is_integral_v<Number> && (rest.starts_with('.') || rest.starts_with('e'));
  if (!is_number || cut_off) {
    refuse(*entry, fmt::format("must be {} in {}. Write for example '{}{}{}'", kWanted, unit, fallback,
                               unit == "1" ? "" : " ", unit == "1" ? "" : unit));
  }
  const std::string_view given = trimmed(rest);
  if (!given.empty() && given != unit) {
    refuse(*entry, unit == "1" ? fmt::format("is in '{}', but must be a plain number without unit", given)
                               : fmt::format("is in '{}', but must be in '{}'. Convert it", given, unit));
  }
  parameter.value = fmt::format("{}", value);
  return value;
}

double ParameterSet::number(std::string_view name, double fallback, std::string_view unit) {
  return numeric<double>(name, fallback, unit, ParameterKind::number);
}

std::int64_t ParameterSet::integer(std::string_view name, std::int64_t fallback, std::string_view unit) {
  return numeric<std::int64_t>(name, fallback, unit, ParameterKind::integer);
}

bool ParameterSet::flag(std::string_view name, bool fallback) {
  Parameter& parameter = declare(name, ParameterKind::flag, "", fallback ? "true" : "false");
  const ParameterEntry* const entry = find(name);
  if (entry == nullptr) {
    return fallback;
  }
  if (entry->text != "true" && entry->text != "false") {
    refuse(*entry, "must be true or false");
  }
  parameter.value = entry->text;
  return entry->text == "true";
}

const std::string& ParameterSet::text(std::string_view name, std::string_view fallback) {
  Parameter& parameter = declare(name, ParameterKind::text, "", std::string(fallback));
  if (const ParameterEntry* const entry = find(name)) {
    parameter.value = entry->text;
  }
  return parameter.value;
}

void ParameterSet::require_all_declared() const {
  std::vector<std::string> known;
  for (const Parameter& parameter : declared_) {
    known.push_back(parameter.name);
  }
  for (const ParameterEntry& entry : entries_) {
    if (std::find(known.begin(), known.end(), entry.name) == known.end()) {
      throw ConfigurationError(fmt::format("{}:{}: plug-in '{}' has no parameter '{}'. {}", file_.string(),
                                           entry.line, plugin_, entry.name,
                                           urdf::suggest(entry.name, known)));
    }
  }
}

}  // namespace gaitway::core
