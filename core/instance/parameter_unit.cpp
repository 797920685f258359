// One pass over the text, by recursive descent.
#include "gaitway/instance/parameter_unit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

#include "gaitway/facts/facts.hpp"

namespace gaitway::core {
namespace {

struct NamedUnit {
  std::string_view name;
  UnitMeasure measure;
};
constexpr std::array<NamedUnit, 13> kUnits{{{"1", {}},
                                            {"m", {.metres = 1.0}},
                                            {"cm", {.size = 1e-2, .metres = 1.0}},
                                            {"mm", {.size = 1e-3, .metres = 1.0}},
                                            {"s", {.seconds = 1.0}},
                                            {"ms", {.size = 1e-3, .seconds = 1.0}},
                                            {"us", {.size = 1e-6, .seconds = 1.0}},
                                            {"kg", {.kilograms = 1.0}},
                                            {"N", {.metres = 1.0, .seconds = -2.0, .kilograms = 1.0}},
                                            {"Nm", {.metres = 2.0, .seconds = -2.0, .kilograms = 1.0}},
                                            {"rad", {.radians = 1.0}},
                                            {"mrad", {.size = 1e-3, .radians = 1.0}},
                                            {"deg", {.size = std::numbers::pi / 180.0, .radians = 1.0}}}};
constexpr double kSamePower = 1e-9;
constexpr int kMostBrackets = 8;

class UnitReader {
 public:
  UnitReader(std::string_view text, const BodyUnits* body) : rest_(text), body_(body) {}

  std::optional<UnitMeasure> read() {
    const std::optional<UnitMeasure> whole = product(kMostBrackets);
    return whole && next() == '\0' ? whole : std::nullopt;
  }

 private:
  char next() noexcept {
    rest_.remove_prefix(std::min(rest_.find_first_not_of(' '), rest_.size()));
    return rest_.empty() ? '\0' : rest_.front();
  }

  std::optional<UnitMeasure> product(int brackets_left) {
    std::optional<UnitMeasure> result = factor(brackets_left);
    while (result && (next() == '*' || next() == '/')) {
      const double sign = next() == '/' ? -1.0 : 1.0;
      rest_.remove_prefix(1);
      const std::optional<UnitMeasure> by = factor(brackets_left);
      if (!by) return std::nullopt;
      multiply(*result, *by, sign);
    }
    return result;
  }

  std::optional<UnitMeasure> factor(int brackets_left) {
    std::optional<UnitMeasure> base;
    if (next() == '(') {
      if (brackets_left == 0) return std::nullopt;
      rest_.remove_prefix(1);
      base = product(brackets_left - 1);
      if (!base || next() != ')') return std::nullopt;
      rest_.remove_prefix(1);
    } else {
      base = named();
    }
    if (!base || next() != '^') return base;
    rest_.remove_prefix(1);
    next();
    double power = 1.0;
    const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), power);
    if (error != std::errc{} || !(std::abs(power) <= 9.0)) return std::nullopt;
    rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
    UnitMeasure result;
    multiply(result, *base, power);
    return result;
  }

  std::optional<UnitMeasure> named() {
    next();
    const std::size_t length = std::min(rest_.find_first_of("*/^() "), rest_.size());
    const std::string_view name = rest_.substr(0, length);
    rest_.remove_prefix(length);
    for (const NamedUnit& unit : kUnits) {
      if (unit.name == name) return unit.measure;
    }
    const BodyUnits& body = body_ == nullptr ? kNoBody : *body_;
    if (name == "h") return UnitMeasure{.size = body.hip_height_m, .metres = 1.0, .of_body = true};
    if (name == "T") return UnitMeasure{.size = body.time_s(), .seconds = 1.0, .of_body = true};
    if (name == "W") {
      return UnitMeasure{
          .size = body.weight_N(), .metres = 1.0, .seconds = -2.0, .kilograms = 1.0, .of_body = true};
    }
    return std::nullopt;
  }

  static void multiply(UnitMeasure& to, const UnitMeasure& by, double power) {
    to.size *= std::pow(by.size, power);
    to.metres += power * by.metres;
    to.seconds += power * by.seconds;
    to.kilograms += power * by.kilograms;
    to.radians += power * by.radians;
    to.of_body = to.of_body || by.of_body;
  }

  static constexpr BodyUnits kNoBody{1.0, 1.0};
  std::string_view rest_;
  const BodyUnits* body_;
};

void append(std::string& to, std::string_view name, double power) {
  if (std::abs(power) < kSamePower) return;
  if (!to.empty()) to += '*';
  to += std::abs(power - 1.0) < kSamePower ? std::string(name) : fmt::format("{}^{:g}", name, power);
}

}  // namespace

double BodyUnits::time_s() const noexcept {
  return std::sqrt(hip_height_m / facts::kGravity_m_per_s2);
}

double BodyUnits::weight_N() const noexcept {
  return mass_kg * facts::kGravity_m_per_s2;
}

bool UnitMeasure::is_like(const UnitMeasure& other) const noexcept {
  const auto same = [](double a, double b) { return std::abs(a - b) < kSamePower; };
  return same(metres, other.metres) && same(seconds, other.seconds) && same(kilograms, other.kilograms) &&
         same(radians, other.radians);
}

std::optional<UnitMeasure> measure_of(std::string_view unit, const BodyUnits* body) {
  return UnitReader(unit, body).read();
}

// A kilogram is W / (h / T^2).
std::string in_body_units(const UnitMeasure& measure) {
  std::string text;
  append(text, "W", measure.kilograms);
  append(text, "h", measure.metres - measure.kilograms);
  append(text, "T", measure.seconds + 2.0 * measure.kilograms);
  append(text, "rad", measure.radians);
  return text.empty() ? "1" : text;
}

}  // namespace gaitway::core
