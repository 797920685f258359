// A plan as it is told: lines, JSON, and a picture from above.
#pragma once

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "gaitway/planning/planner.hpp"

namespace gaitway::tools {

struct PlannedWay {
  const world::World& world;
  const planning::Limits& limits;
  const planning::GroundMap& map;
  const planning::Request& request;
  const planning::Plan& plan;
};

[[nodiscard]] std::string plan_text(const PlannedWay& way);
[[nodiscard]] nlohmann::ordered_json plan_json(const PlannedWay& way);

// x to the right, y up: the ground's heights and obstacles, the swept body, left footsteps blue and right
// ones red, the goal green. Throws std::runtime_error naming the file.
void draw_plan(const std::filesystem::path& file, const PlannedWay& way);

}  // namespace gaitway::tools
