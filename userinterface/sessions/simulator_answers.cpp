// Answers of a simulator to messages for clients, field by field.
#include "simulator_answers.hpp"

#include <nlohmann/json.hpp>

namespace gaitway::api {
namespace {

template <class Numbers>
std::vector<double> list_of(const Numbers& numbers) {
  return {numbers.begin(), numbers.end()};
}

nlohmann::json answer_object(std::string_view text) {
  nlohmann::json answer = nlohmann::json::parse(text, nullptr, false);
  if (!answer.is_object()) {
    throw MessageError("the simulator's answer of " + std::to_string(text.size()) +
                       " bytes is no JSON object: run both from the same release");
  }
  return answer;
}

}  // namespace

nlohmann::json answer_json(std::string_view text) {
  nlohmann::json answer = answer_object(text);
  for (auto& value : answer) {
    if (value.is_null()) {
      value = 0;
    }
  }
  return answer;
}

void refuse_missing(const FieldPath& path, std::string_view answer, std::string_view field) {
  throw MessageError(path.text() + " has no field \"" + std::string(field) + "\", which " +
                     std::string(answer) + " must have: run both from the same release");
}

ros::TwinState twin_state_of(std::string_view text) {
  ros::TwinState state;
  read_answer_part(answer_object(text), state, FieldPath());
  return state;
}

ros::Pose pose_of(const PoseNumbers& pose) {
  return {{pose[0], pose[1], pose[2]}, {pose[3], pose[4], pose[5], pose[6]}};
}

ros::SimulationState message_of(const StateAnswer& state) {
  ros::SimulationState message;
  message.time = state.time_s;
  message.recorded = state.recorded_s;
  message.state = state.state;
  message.text = state.text;
  message.speed = state.speed;
  message.pace = state.pace;
  message.world = state.world;
  message.geometry = state.geometry;
  message.run = state.run;
  message.fallen = state.fallen;
  message.odometry = list_of(state.odometry);
  message.base = list_of(state.base);
  for (const ThingAnswer& thing : state.things) {
    message.thing_names.push_back(thing.name);
    message.thing_poses.push_back(pose_of(thing.pose));
  }
  for (const MarkAnswer& mark : state.marks) {
    message.mark_times.push_back(mark.at_s);
    message.mark_kinds.push_back(mark.kind);
  }
  for (const EventAnswer& event : state.events) {
    message.event_times.push_back(event.at_s);
    message.event_texts.push_back(event.text);
  }
  return message;
}

ros::GetGeometry::Response response_of(const GeometryAnswer& geometry) {
  ros::GetGeometry::Response response;
  response.success = true;
  response.geometry = geometry.geometry;
  response.world = geometry.world;
  response.total = geometry.total;
  response.floor_colour = list_of(geometry.floor_colour);
  for (const SolidAnswer& solid : geometry.solids) {
    response.solids.push_back({solid.name,
                               solid.kind,
                               solid.shape,
                               {solid.size[0], solid.size[1], solid.size[2]},
                               pose_of(solid.pose),
                               list_of(solid.colour),
                               solid.movable});
  }
  return response;
}

ros::PlanFootsteps::Response response_of(const PlanAnswer& plan) {
  ros::PlanFootsteps::Response response;
  response.success = true;
  for (const StepAnswer& step : plan.steps) {
    response.sides.push_back(step.side);
    response.steps.insert(response.steps.end(), step.pose.begin(), step.pose.end());
  }
  for (const PlaceNumbers& foot : plan.feet) {
    response.feet.insert(response.feet.end(), foot.begin(), foot.end());
  }
  response.duration = plan.seconds;
  return response;
}

}  // namespace gaitway::api
