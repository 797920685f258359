// Numbers with units, flags and texts.
#include "gaitway/instance/parameter_set.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "gaitway/input/complaint.hpp"
#include "gaitway/input/number.hpp"
#include "gaitway/instance/parameter_unit.hpp"

namespace gaitway::core {
namespace {

std::string_view plain(std::string_view unit) noexcept {
  return unit.empty() ? std::string_view("1") : unit;
}

}  // namespace

std::string_view parameter_kind_name(ParameterKind kind) noexcept {
  constexpr std::array<std::string_view, 4> kNames{"number", "integer", "flag", "text"};
  return kNames[static_cast<std::size_t>(kind)];
}

namespace {

// What a value in text form is refused with.
class Refusal {
 public:
  Refusal(const Parameter& parameter, const std::string& plugin, const std::string& text,
          const std::string& place)
      : head_(fmt::format("{}: parameter '{}' of '{}' = '{}'", place, parameter.name, plugin, text)) {}
  [[noreturn]] void operator()(const std::string& complaint) const {
    throw ConfigurationError(fmt::format("{}: {}", head_, complaint));
  }

 private:
  std::string head_;
};

std::string range_of(const Parameter& parameter) {
  const std::string unit = parameter.unit == "1" ? "" : " " + parameter.unit;
  if (std::isinf(parameter.lowest)) {
    return fmt::format("at most {}{}", parameter.highest, unit);
  }
  if (std::isinf(parameter.highest)) {
    return fmt::format("at least {}{}", parameter.lowest, unit);
  }
  return fmt::format("from {} to {}{}", parameter.lowest, parameter.highest, unit);
}

// converted: a value that was written in another unit.
void require_range(const Parameter& parameter, double value, bool converted, const Refusal& refuse) {
  if (value >= parameter.lowest && value <= parameter.highest) return;
  refuse(fmt::format("{}must be {}. The default is {}",
                     converted ? fmt::format("is {:.6g} {}, but ", value, parameter.unit) : "",
                     range_of(parameter), parameter.fallback));
}

template <class Number>
input::NumberAndUnit<Number> split(const Parameter& parameter, std::string_view text, const Refusal& refuse) {
  constexpr std::string_view kWanted = std::is_integral_v<Number> ? "a whole number" : "a finite number";
  const bool plain_number = parameter.unit == "1";
  try {
    return input::split_number<Number>(text);
  } catch (const input::ValueError& error) {
    refuse(error.remedy.empty()
               ? fmt::format("must be {} in {}. Write for example '{}{}{}'", kWanted, parameter.unit,
                             parameter.fallback, plain_number ? "" : " ", plain_number ? "" : parameter.unit)
               : error.what());
  }
}

[[noreturn]] void refuse_unit(const Parameter& parameter, std::string_view unit, std::string_view remedy,
                              const Refusal& refuse) {
  refuse(parameter.unit == "1"
             ? fmt::format("is in '{}', but must be a plain number without unit", unit)
             : fmt::format("is in '{}', but must be in '{}'{}", unit, parameter.unit, remedy));
}

std::int64_t read_integer(const Parameter& parameter, std::string_view text, const Refusal& refuse) {
  const auto given = split<std::int64_t>(parameter, text, refuse);
  if (!given.unit.empty() && given.unit != parameter.unit) {
    refuse_unit(parameter, given.unit, ". Convert it", refuse);
  }
  require_range(parameter, static_cast<double>(given.number), false, refuse);
  return given.number;
}

// How much of the parameter's unit one of `unit` is.
double size_of(std::string_view unit, const Parameter& parameter,
               const std::filesystem::path& robot_directory, const Refusal& refuse) {
  const std::optional<UnitMeasure> wanted = measure_of(parameter.unit, nullptr);
  const std::optional<UnitMeasure> kind = measure_of(unit, nullptr);
  if (!wanted) {
    refuse_unit(parameter, unit, ". Convert it", refuse);
  }
  const std::string remedy = fmt::format(
      ", in another unit of that kind, or in '{}' of the robot's body (h: hip height, T: "
      "sqrt(h/g), W: weight)",
      in_body_units(*wanted));
  if (!kind || !kind->is_like(*wanted)) {
    refuse_unit(parameter, unit, remedy, refuse);
  }
  if (!kind->of_body) {
    return kind->size / wanted->size;
  }
  if (robot_directory.empty()) {
    refuse(
        fmt::format("is in units of a body, but no robot is known here. Write it in '{}'", parameter.unit));
  }
  try {
    const BodyUnits body = body_units_of(robot_directory);
    return measure_of(unit, &body)->size / wanted->size;
  } catch (const input::InputError& error) {
    refuse(fmt::format("is in units of the body, but the robot cannot be read: {}", error.what()));
  }
}

double read_real(const Parameter& parameter, std::string_view text,
                 const std::filesystem::path& robot_directory, const Refusal& refuse) {
  const auto given = split<double>(parameter, text, refuse);
  const bool converted = !given.unit.empty() && given.unit != parameter.unit;
  const double value =
      converted ? given.number * size_of(given.unit, parameter, robot_directory, refuse) : given.number;
  if (!std::isfinite(value)) {
    refuse("is too large to be a number");
  }
  require_range(parameter, value, converted, refuse);
  return value;
}

}  // namespace

std::string value_text(const gaitway_value& value) {
  switch (value.kind) {
    case GAITWAY_NUMBER:
      return fmt::format("{}", value.number);
    case GAITWAY_INTEGER:
      return fmt::format("{}", value.integer);
    case GAITWAY_FLAG:
      return value.integer != 0 ? "true" : "false";
    default:
      return value.text;
  }
}

std::string ParameterSet::place_of(const ParameterEntry& entry) const {
  return entry.line > 0 ? fmt::format("{}:{}", file_.string(), entry.line) : file_.string();
}

const ParameterEntry* ParameterSet::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(entries_, name, &ParameterEntry::name);
  return found == entries_.end() ? nullptr : &*found;
}

Parameter* ParameterSet::find_declared(std::string_view name) noexcept {
  const auto found = std::ranges::find(declared_, name, &Parameter::name);
  return found == declared_.end() ? nullptr : &*found;
}

Parameter& ParameterSet::remember(const gaitway_parameter& wanted) {
  const auto kind = static_cast<ParameterKind>(wanted.fallback.kind);
  const bool numeric = kind == ParameterKind::number || kind == ParameterKind::integer;
  const std::string unit(!numeric ? std::string_view() : plain(wanted.unit == nullptr ? "" : wanted.unit));
  if (Parameter* const before = find_declared(wanted.name)) {
    if (before->kind != kind || before->unit != unit) {
      throw ConfigurationError(
          fmt::format("plug-in '{}' declares its parameter '{}' once as {} [{}] and once as {} [{}]. "
                      "Correct the plug-in",
                      plugin_, wanted.name, parameter_kind_name(before->kind), before->unit,
                      parameter_kind_name(kind), unit));
    }
    return *before;
  }
  const std::string fallback = value_text(wanted.fallback);
  declared_.push_back({.name = wanted.name,
                       .kind = kind,
                       .unit = unit,
                       .doc = wanted.doc == nullptr ? "" : wanted.doc,
                       .fallback = fallback,
                       .value = fallback,
                       .lowest = wanted.lowest,
                       .highest = wanted.highest,
                       .live = wanted.live != 0});
  return declared_.back();
}

gaitway_value ParameterSet::read(const Parameter& parameter, const std::string& text,
                                 const std::string& place) const {
  const Refusal refuse(parameter, plugin_, text, place);
  gaitway_value value{static_cast<gaitway_kind>(parameter.kind), 0, 0.0, 0, nullptr};
  switch (parameter.kind) {
    case ParameterKind::number:
      value.number = read_real(parameter, text, robot_directory_, refuse);
      break;
    case ParameterKind::integer:
      value.integer = read_integer(parameter, text, refuse);
      break;
    case ParameterKind::flag:
      if (text != "true" && text != "false") {
        refuse("must be true or false");
      }
      value.integer = text == "true" ? 1 : 0;
      break;
    case ParameterKind::text:
      value.text = text.c_str();
      break;
  }
  return value;
}

gaitway_value ParameterSet::declare(const gaitway_parameter& wanted) {
  Parameter& parameter = remember(wanted);
  gaitway_value value = wanted.fallback;
  value.text = parameter.kind == ParameterKind::text ? parameter.fallback.c_str() : nullptr;
  if (const ParameterEntry* const entry = find(wanted.name)) {
    value = read(parameter, entry->text, place_of(*entry));
  }
  parameter.value = value_text(value);
  return value;
}

gaitway_value ParameterSet::redeclare(const gaitway_parameter& wanted) {
  const Parameter& parameter = remember(wanted);
  return read(parameter, parameter.value, "value in use");
}

gaitway_value ParameterSet::read_change(std::string_view name, const std::string& text) {
  const Parameter* const found = find_declared(name);
  std::vector<std::string> live;
  for (const Parameter& parameter : declared_) {
    if (parameter.live) {
      live.push_back(parameter.name);
    }
  }
  if (found == nullptr) {
    throw ConfigurationError(fmt::format("plug-in '{}' has no parameter '{}'. {}", plugin_, name,
                                         live.empty() ? "None of its parameters may change while it runs"
                                                      : input::suggest(std::string(name), live)));
  }
  if (!found->live) {
    throw ConfigurationError(fmt::format(
        "parameter '{}' of plug-in '{}' does not change while the plug-in runs ({}). Change it in the "
        "configuration and start anew, or declare it with live_parameter()",
        name, plugin_,
        live.empty() ? "none of its parameters does" : fmt::format("{} may", fmt::join(live, ", "))));
  }
  gaitway_value value = read(*found, text, "change at run time");
  if (value.text != nullptr) {
    value.text = live_texts_.insert(text).first->c_str();
  }
  return value;
}

void ParameterSet::keep(std::string_view name, std::string& text) noexcept {
  if (Parameter* const found = find_declared(name)) {
    found->value.swap(text);
  }
}

void ParameterSet::require_all_declared() const {
  std::vector<std::string> known;
  for (const Parameter& parameter : declared_) {
    known.push_back(parameter.name);
  }
  for (const ParameterEntry& entry : entries_) {
    if (std::ranges::find(known, entry.name) == known.end()) {
      throw ConfigurationError(fmt::format("{}: plug-in '{}' has no parameter '{}'. {}", place_of(entry),
                                           plugin_, entry.name, input::suggest(entry.name, known)));
    }
  }
}

}  // namespace gaitway::core
