// A URI part by part.
#include "spawnables.hpp"

#include <algorithm>
#include <charconv>

#include "client_message.hpp"

namespace gaitway::api {
namespace {

constexpr std::string_view kScheme = "gaitway:";
constexpr double kUsualSize_m = 0.1;

struct Shape {
  std::string_view name;
  std::array<double, 3> colour_rgb;
  std::string_view rule;  // of its size
  std::string_view doc;
};
constexpr std::array kShapes{
    Shape{"box", {0.75, 0.55, 0.35}, "three lengths", "A box. size: length along x, y and z [m]"},
    Shape{"cylinder",
          {0.35, 0.6, 0.75},
          "two equal diameters and a height",
          "A cylinder that stands. size: its diameter twice, and its height [m]"},
    Shape{"sphere",
          {0.8, 0.4, 0.4},
          "one diameter three times",
          "A sphere. size: its diameter three times [m]"},
};

[[noreturn]] void refuse(std::string_view part, std::string_view value, const std::string& rule) {
  throw SpawnableError(std::string(part) + " is " + shown(value) + ", but must be " + rule);
}

// What stands before the separator; takes it out of `text`, with the separator.
std::string_view take_until(std::string_view& text, char separator) {
  const std::string_view part = text.substr(0, text.find(separator));
  text.remove_prefix(std::min(text.size(), part.size() + 1));
  return part;
}

double number_of(std::string_view part, std::string_view text, double least, double most) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= least && value <= most)) {
    refuse(part, text, "a number from " + shown_json(least) + " to " + shown_json(most));
  }
  return value;
}

std::array<double, 3> three_of(std::string_view part, std::string_view text, double least, double most) {
  if (std::ranges::count(text, ',') != 2) {
    refuse(part, text, "three numbers with commas between them");
  }
  std::array<double, 3> numbers{};
  for (double& number : numbers) {
    number = number_of(part, take_until(text, ','), least, most);
  }
  return numbers;
}

bool fits(std::string_view shape, const std::array<double, 3>& size_m) {
  const bool round = size_m[0] == size_m[1];
  return shape == "box" || (round && (shape == "cylinder" || size_m[0] == size_m[2]));
}

}  // namespace

bool is_spawnable_uri(std::string_view uri) noexcept {
  return uri.starts_with(kScheme);
}

SpawnableBody spawnable_of(std::string_view uri) {
  std::string_view rest = uri.substr(is_spawnable_uri(uri) ? kScheme.size() : 0);
  const std::string_view name = take_until(rest, '?');
  const auto shape = std::ranges::find(kShapes, name, &Shape::name);
  if (shape == kShapes.end()) {
    refuse("shape", name, "box, cylinder or sphere");
  }
  SpawnableBody body{
      std::string(name), {kUsualSize_m, kUsualSize_m, kUsualSize_m}, std::nullopt, shape->colour_rgb};
  while (!rest.empty()) {
    std::string_view value = take_until(rest, '&');
    const std::string_view part = take_until(value, '=');
    if (part == "size") {
      body.size_m = three_of(part, value, kLeastSize_m, kLargestSize_m);
      if (!fits(name, body.size_m)) {
        refuse(part, value, "of a " + std::string(name) + " " + std::string(shape->rule));
      }
    } else if (part == "mass") {
      body.mass_kg = number_of(part, value, kLeastMass_kg, kLargestMass_kg);
    } else if (part == "colour") {
      body.colour_rgb = three_of(part, value, 0.0, 1.0);
    } else {
      refuse("a part of the URI", part, "size, mass or colour");
    }
  }
  return body;
}

std::vector<ros::simulation::Spawnable> spawnables() {
  using ros::simulation::Bounds;
  std::vector<ros::simulation::Spawnable> all;
  for (const Shape& shape : kShapes) {
    ros::simulation::Spawnable one;
    one.entity_resource.uri = std::string(kScheme) + std::string(shape.name) + "?size=0.1,0.1,0.1&mass=0.5";
    one.description = std::string(shape.doc) +
                      "; mass [kg]: without it, it stands fast; colour: red, green, blue from 0 to 1, e.g. "
                      "colour=0.8,0.2,0.1";
    one.spawn_bounds.type = Bounds::TYPE_BOX;
    constexpr double kHalf_m = kUsualSize_m / 2.0;
    one.spawn_bounds.points = {{kHalf_m, kHalf_m, kHalf_m}, {-kHalf_m, -kHalf_m, -kHalf_m}};
    all.push_back(std::move(one));
  }
  return all;
}

}  // namespace gaitway::api
