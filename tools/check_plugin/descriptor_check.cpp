// Check `descriptor`: what the plug-in says about itself, its parameters and its topics.
#include <fmt/format.h>

#include <cmath>
#include <regex>

#include "gaitway/msgclient/topics.hpp"
#include "tools/check_plugin/check_run.hpp"

namespace gaitway::plugin_check {
namespace {

void check_texts(CheckRun& run, const gaitway_plugin& entry) {
  static const std::regex name_rule("[a-z][a-z0-9_]*");
  static const std::regex version_rule(R"((0|[1-9]\d*)\.(0|[1-9]\d*)\.(0|[1-9]\d*)([-+][0-9A-Za-z.+-]+)?)");
  if (!std::regex_match(entry.name, name_rule)) {
    run.finding(fmt::format("the name '{}' is not of small letters, digits and underscores", entry.name),
                "name", "choose one like 'ankle_trim': configurations and topics use it");
  }
  if (!std::regex_match(entry.version, version_rule)) {
    run.finding(fmt::format("the version '{}' is no semantic version", entry.version), "version",
                "write three numbers, for example 1.0.0 (semver.org)");
  }
  if (entry.description[0] == '\0') {
    run.finding("the description is empty", "description", "say in one line what the plug-in does");
  }
}

void check_parameter(CheckRun& run, const core::Parameter& parameter) {
  const bool numeric =
      parameter.kind == core::ParameterKind::number || parameter.kind == core::ParameterKind::integer;
  if (!numeric) {
    return;
  }
  const double fallback = std::stod(parameter.fallback);
  const std::string where = fmt::format("parameter '{}'", parameter.name);
  if (std::isnan(parameter.lowest) || std::isnan(parameter.highest) || parameter.lowest > parameter.highest) {
    run.finding(fmt::format("its range from {} to {} is empty", parameter.lowest, parameter.highest), where,
                "exchange or correct lowest and highest");
  } else if (!(fallback >= parameter.lowest && fallback <= parameter.highest)) {
    run.finding(fmt::format("its default {} lies outside of its range from {} to {}", parameter.fallback,
                            parameter.lowest, parameter.highest),
                where, "correct the default or the range");
  }
}

bool has_float(const TypeDescriptor& type) {
  return std::ranges::any_of(type.fields, [](const FieldDescriptor& field) {
    return field.type == ScalarType::float32_value || field.type == ScalarType::float64_value;
  });
}

void check_topics(CheckRun& run, Specimen& specimen) {
  if (specimen.host().ports().empty()) {
    run.finding("declares no topic", "",
                "a plug-in without inputs and outputs does nothing: declare them in "
                "the constructor");
  }
  for (const Port& port : specimen.host().ports()) {
    const auto same = [&port](const StandardTopic& topic) { return topic.name == port.topic; };
    const auto* const standard = std::ranges::find_if(kStandardTopics, same);
    if (standard != kStandardTopics.end() && standard->type->hash != port.type_hash) {
      run.finding(fmt::format("opens the standard topic '{}' with another type than {}", port.topic,
                              standard->type->name),
                  fmt::format("topic '{}'", port.topic),
                  "build against this version's topics.hpp, or give a topic of your own another name");
    }
    if (port.is_output() && port.float_fields.empty() && port.standard_type != nullptr &&
        has_float(*port.standard_type)) {
      run.finding(
          "names none of its floating-point fields, so that the host cannot refuse what is not finite",
          fmt::format("topic '{}'", port.topic), "give the field table of the type (float_fields)");
    }
  }
}

nlohmann::ordered_json summary(Specimen& specimen) {
  nlohmann::ordered_json topics = nlohmann::ordered_json::array();
  for (const Port& port : specimen.host().ports()) {
    topics.push_back({{"topic", port.topic}, {"type", port.type_name}, {"writes", port.is_output()}});
  }
  return topics;
}

}  // namespace

void check_descriptor(CheckRun& run) {
  const SpecimenLibrary library(run.job().plugin, run.board());
  check_texts(run, library.entry());
  Specimen specimen(library, run.job(), &run.record());
  if (!specimen.create()) {
    run.not_usable(fmt::format(
        "create fails with {}: {}",
        run.job().parameters.empty() ? "all parameters at their defaults" : "the given parameters",
        specimen.error().empty() ? "(no text)" : specimen.error()));
    return;
  }
  for (const core::Parameter& parameter : specimen.host().parameters().declared()) {
    check_parameter(run, parameter);
  }
  for (const std::string& complaint : specimen.host().complaints()) {
    run.finding(complaint, "parameters", "name its SI unit, or \"1\" for a plain number");
  }
  try {
    specimen.host().parameters().require_all_declared();
  } catch (const core::ConfigurationError& error) {
    run.not_usable(error.what());
  }
  check_topics(run, specimen);
  run.figure("period", specimen.host().period() == Period::batch ? "batch" : "tick");
  run.figure("topics", summary(specimen));
  run.remark(fmt::format("{} parameters, {} topics", specimen.host().parameters().declared().size(),
                         specimen.host().ports().size()));
  specimen.abandon();  // destroying it without activation is for the check `life_cycle`
}

}  // namespace gaitway::plugin_check
