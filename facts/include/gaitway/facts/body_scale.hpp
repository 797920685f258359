// How much larger a body is than the one with which the shipped numbers were found, and what that makes of a
// length, a time, a force.
#pragma once

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::facts {

// A body against that with which the shipped plug-ins' defaults were found: humanoid22.
class BodyScale {
 public:
  BodyScale() = default;
  BodyScale(double hip_height_m, double mass_kg)
      : length_(ratio(hip_height_m, 0.36)), mass_(ratio(mass_kg, 6.84)) {}

  // By how much a number of this unit is larger on a body that moves in the same way (equal Froude number,
  // same gravity): lengths grow with the hip height, times with its root, forces with the weight, angles not.
  // Units are made of m, s, kg, N, rad and 1 with *, /, ^ and brackets: "rad/(m*s)". Throws
  // std::invalid_argument for any other.
  [[nodiscard]] double factor(std::string_view unit) const {
    double length = 0.0, mass = 0.0, sign = 1.0;
    bool divided_group = false;
    for (std::size_t at = 0; at < unit.size();) {
      const std::size_t end = std::min(unit.find_first_of("*/()", at), unit.size());
      add(unit.substr(at, end - at), divided_group ? -1.0 : sign, length, mass);
      if (end == unit.size()) break;
      if (unit[end] == '(') divided_group = sign < 0.0;
      if (unit[end] == ')') divided_group = false;
      if (unit[end] != '(') sign = unit[end] == '/' ? -1.0 : 1.0;
      at = end + 1;
    }
    return std::pow(length_, length) * std::pow(mass_, mass);
  }

 private:
  // To six digits: the body of the defaults is exactly 1.
  static double ratio(double value, double reference) { return std::round(value / reference * 1e6) * 1e-6; }

  // One unit with its power, "s^0.5".
  static void add(std::string_view part, double sign, double& length, double& mass) {
    const std::size_t hat = part.find('^');
    const std::string_view name = part.substr(0, hat);
    double power = 1.0;
    if (hat != std::string_view::npos) {
      const std::string_view digits = part.substr(hat + 1);
      std::from_chars(digits.data(), digits.data() + digits.size(), power);
    }
    power *= sign;
    if (name == "m") {
      length += power;
    } else if (name == "s") {
      length += 0.5 * power;
    } else if (name == "N" || name == "kg") {
      mass += power;
    } else if (!name.empty() && name != "rad" && name != "1") {
      throw std::invalid_argument(std::string("no unit that scales with a body: '").append(name).append("'"));
    }
  }

  double length_ = 1.0, mass_ = 1.0;
};

}  // namespace gaitway::facts
