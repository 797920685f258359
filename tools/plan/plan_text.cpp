// A plan in lines and as JSON.
#include <fmt/format.h>

#include "gaitway/facts/facts.hpp"
#include "tools/plan/plan_report.hpp"

namespace gaitway::tools {
namespace {

const char* side_name(planning::Side side) {
  return side == planning::Side::left ? "left" : "right";
}

nlohmann::ordered_json json_of(const planning::Pose& pose) {
  return {{"x_m", pose.x_m}, {"y_m", pose.y_m}, {"yaw_deg", pose.yaw_rad * facts::kDegreePerRad}};
}

}  // namespace

std::string plan_text(const PlannedWay& way) {
  const planning::Plan& plan = way.plan;
  if (!plan.found()) return fmt::format("no way ({}): {}\n", planning::name(plan.reason), plan.explanation);
  if (plan.steps.empty()) return "the feet are there already\n";
  std::string text = fmt::format("{} steps, cost {:.2f}, proven to be at most {:.2f} times the least\n",
                                 plan.steps.size(), plan.cost, plan.bound);
  text += fmt::format("  {:>4} {:<5} {:>8} {:>8} {:>8} {:>9}\n", "step", "foot", "x m", "y m", "yaw deg",
                      "height mm");
  for (std::size_t i = 0; i < plan.steps.size(); ++i) {
    const planning::Footstep& step = plan.steps[i];
    text += fmt::format("  {:>4} {:<5} {:>8.3f} {:>8.3f} {:>8.1f} {:>9.0f}\n", i + 1, side_name(step.side),
                        step.pose.x_m, step.pose.y_m, step.pose.yaw_rad * facts::kDegreePerRad,
                        1000.0 * step.height_m);
  }
  return text;
}

nlohmann::ordered_json plan_json(const PlannedWay& way) {
  const planning::Plan& plan = way.plan;
  nlohmann::ordered_json json{{"world", way.world.name},
                              {"found", plan.found()},
                              {"reason", planning::name(plan.reason)},
                              {"explanation", plan.explanation},
                              {"left", json_of(way.request.left)},
                              {"right", json_of(way.request.right)},
                              {"goal", json_of(way.request.goal)}};
  json["expansions"] = plan.expansions;
  json["steps"] = nlohmann::ordered_json::array();
  if (!plan.found()) return json;
  json["cost"] = plan.cost;
  json["bound"] = plan.bound;
  for (const planning::Footstep& step : plan.steps) {
    nlohmann::ordered_json one = json_of(step.pose);
    one["foot"] = side_name(step.side);
    one["height_m"] = step.height_m;
    json["steps"].push_back(std::move(one));
  }
  return json;
}

}  // namespace gaitway::tools
