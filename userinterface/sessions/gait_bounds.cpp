// One order for each parameter: all of them the first time, later those alone that are wanted.
#include "gait_bounds.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/facts/parameter_line.hpp"
#include "service_desk.hpp"

namespace gaitway::api {
namespace {

constexpr std::uint32_t kMostParameters = 256;
constexpr std::int64_t kPatience_ns = 5 * facts::kSecond_ns;
constexpr std::uint64_t kNobody = 0;  // no client has this number

// Nothing: it is in another unit than the parameter's own.
std::optional<double> number_of(const facts::ParameterLine& parameter) noexcept {
  double number = 0.0;
  const char* const end = parameter.value.data() + parameter.value.size();
  const auto [rest, error] = std::from_chars(parameter.value.data(), end, number);
  std::string_view unit(rest, static_cast<std::size_t>(end - rest));
  unit.remove_prefix(std::min(unit.find_first_not_of(' '), unit.size()));
  const bool known =
      error == std::errc() && std::isfinite(number) && (unit.empty() || unit == parameter.unit);
  return known ? std::optional(number) : std::nullopt;
}

// For people: more digits mean nothing.
double rounded(double bound) noexcept {
  constexpr double kSteps = 1e4;
  return std::round(bound * kSteps) / kSteps;
}

// The number of them: none is.
template <class Optionals>
std::size_t first_missing(const Optionals& optionals) noexcept {
  const auto missing = std::ranges::find_if(optionals, [](const auto& optional) { return !optional; });
  return static_cast<std::size_t>(missing - optionals.begin());
}

}  // namespace

void GaitWatch::step(std::int64_t now_ns) {
  now_ns_ = now_ns;
  if (reads_ || now_ns < due_ns_ || !robot_.connected()) {
    return;
  }
  const auto plugins = robot_.plugins();
  if (std::ranges::find(plugins, kPlugin, &PluginStatus::name) == plugins.end()) {
    bounds_.reset();
    return end_reading(kRetry_ns);
  }
  reads_ = true;
  begin(indices_);
}

void GaitWatch::read_again(std::string_view plugin) noexcept {
  if (plugin == kPlugin) {
    end_reading(0);
  }
}

void GaitWatch::robot_lost() noexcept {
  bounds_.reset();
  end_reading(0);
}

void GaitWatch::end_reading(std::int64_t pause_ns) noexcept {
  ++reading_;
  reads_ = false;
  due_ns_ = now_ns_ + pause_ns;
}

void GaitWatch::ask(std::uint32_t index) {
  PluginOrder order;
  order.verb = PluginVerb::describe_parameter;
  order.plugin = kPlugin;
  order.index = index;
  const auto number = robot_.order(order);
  if (!number) {
    return end_reading(kRetry_ns);
  }
  orders_.wait(
      *number, kNobody, now_ns_ + kPatience_ns,
      [this, index, reading = reading_](const OrderResult* result) {
        if (reading == reading_) {
          take(index, result);
        }
      },
      false);
}

void GaitWatch::take(std::uint32_t index, const OrderResult* result) {
  if (result == nullptr) {
    return end_reading(kRetry_ns);
  }
  const auto parameter = result->done ? facts::read_parameter_line(result->text) : std::nullopt;
  if (!parameter || index + 1 >= kMostParameters) {  // there is none behind the last one
    indices_ = {};
    bounds_.reset();
    return end_reading(kPeriod_ns);
  }
  const auto place = static_cast<std::size_t>(std::ranges::find(kNames, parameter->name) - kNames.begin());
  if (place < kNames.size()) {
    indices_[place] = index;
    values_[place] = number_of(*parameter);
  }
  if (first_missing(values_) == values_.size()) {
    bounds_ = read_bounds();
    return end_reading(kPeriod_ns);
  }
  ask_next(index);
}

void GaitWatch::ask_next(std::uint32_t after) {
  const std::size_t missing = first_missing(values_);
  if (!by_index_) {
    ask(after + 1);
  } else if (indices_[missing] != after) {
    ask(*indices_[missing]);
  } else {  // another plug-in of this name: what was there is elsewhere, or nowhere
    begin({});
  }
}

// They are asked for one by one where it is known where all are.
void GaitWatch::begin(const Indices& indices) {
  indices_ = indices;
  values_ = {};
  by_index_ = first_missing(indices) == indices.size();
  ask(by_index_ ? *indices.front() : 0);
}

std::optional<GaitBounds> GaitWatch::read_bounds() const noexcept {
  const double time_s = *values_[step_time];
  const std::array bounds{*values_[step_forward] / time_s, *values_[step_backward] / time_s,
                          (*values_[most_spacing] - *values_[spacing]) / (2.0 * time_s),
                          *values_[step_turn] / time_s};
  const bool sound =
      std::ranges::all_of(bounds, [](double bound) { return std::isfinite(bound) && bound >= 0.0; });
  return sound ? std::optional(GaitBounds{rounded(bounds[0]), rounded(bounds[1]), rounded(bounds[2]),
                                          rounded(bounds[3])})
               : std::nullopt;
}

}  // namespace gaitway::api
