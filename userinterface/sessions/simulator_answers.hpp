// What a simulator answers to orders, as structs that are read like messages: a field that is missing, or is
// something else, is refused by its name.
#pragma once

#include <array>
#include <concepts>
#include <cstdint>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/message_fields.hpp"
#include "gaitway/api/robot_port.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "gaitway/api/simulation_types.hpp"

namespace gaitway::api {

// Of the simulator's world: x, y, z [m], and a quaternion x, y, z, w.
using PoseNumbers = std::array<double, 7>;
// x [m], y [m], yaw [rad].
using PlaceNumbers = std::array<double, 3>;

struct ThingAnswer {
  std::string name;
  PoseNumbers pose{};
  GAITWAY_ROS_MESSAGE("a thing in the simulator's state", name, pose);
};
struct EventAnswer {
  double at_s = 0.0;
  std::string text;
  GAITWAY_ROS_MESSAGE("an event in the simulator's state", at_s, text);
};
struct MarkAnswer {
  double at_s = 0.0;
  std::string kind;
  GAITWAY_ROS_MESSAGE("a mark in the simulator's state", at_s, kind);
};
struct StateAnswer {
  double time_s = 0.0, recorded_s = 0.0;
  std::string state, text;
  double speed = 1.0, pace = 0.0;
  std::string world;
  std::uint32_t geometry = 0, run = 0;
  bool fallen = false;
  std::array<double, 4> odometry{};  // of the frame odom: x, y, z [m], yaw [rad]
  PoseNumbers base{};
  std::vector<ThingAnswer> things;
  std::vector<std::string> spawned;
  std::vector<EventAnswer> events;
  std::vector<MarkAnswer> marks;
  GAITWAY_ROS_MESSAGE("the simulator's state", time_s, recorded_s, state, text, speed, pace, world, geometry,
                      run, fallen, odometry, base, things, spawned, events, marks);
};

struct SolidAnswer {
  std::string name, kind, shape;
  std::array<double, 3> size{};
  PoseNumbers pose{};
  std::array<double, 3> colour{};
  bool movable = false;
  GAITWAY_ROS_MESSAGE("a solid in the simulator's geometry", name, kind, shape, size, pose, colour, movable);
};
struct GeometryAnswer {
  std::uint32_t geometry = 0;
  std::string world;
  std::uint32_t total = 0;
  std::array<double, 3> floor_colour{};
  PlaceNumbers start{};  // of the robot
  std::vector<SolidAnswer> solids;
  GAITWAY_ROS_MESSAGE("the simulator's geometry", geometry, world, total, floor_colour, start, solids);
};

struct StepAnswer {
  std::uint8_t side = 0;
  PlaceNumbers pose{};
  GAITWAY_ROS_MESSAGE("a step in the simulator's plan", side, pose);
};
struct PlanAnswer {
  std::vector<StepAnswer> steps;
  std::array<PlaceNumbers, 2> feet{};
  double seconds = 0.0;
  GAITWAY_ROS_MESSAGE("the simulator's plan", steps, feet, seconds);
};

struct PictureAnswer {
  std::uint32_t total = 0;
  std::string data;
  GAITWAY_ROS_MESSAGE("the simulator's picture", total, data);
};

struct TimeAnswer {
  double time_s = 0.0;
  GAITWAY_ROS_MESSAGE("the simulator's answer", time_s);
};

// The JSON of an answer. A number that the simulator does not know (null) reads as 0, as `pace` is before it
// has been measured. Throws MessageError when it is no JSON object.
[[nodiscard]] nlohmann::json answer_json(std::string_view text);
// Throws MessageError: `field` is missing in what stands at `path`.
[[noreturn]] void refuse_missing(const FieldPath& path, std::string_view answer, std::string_view field);

template <class T>
void read_answer_part(const nlohmann::json& part, T& value, const FieldPath& path) {
  if constexpr (Message<T>) {
    if (!part.is_object()) {
      refuse_value(path, part, "an object");
    }
    value.fields([&](std::string_view name, auto& member) {
      const auto found = part.find(name);
      if (found == part.end()) {
        refuse_missing(path, T::kName, name);
      }
      read_answer_part(*found, member, FieldPath(path, name));
    });
  } else if constexpr (Vector<T>) {
    check_array(part, path, kAnyLength);
    value.resize(part.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      read_answer_part(part[i], value[i], FieldPath(path, i));
    }
  } else {
    if constexpr (std::floating_point<T>) {
      if (part.is_null()) {
        value = std::numeric_limits<T>::quiet_NaN();
        return;
      }
    }
    read_value(part, value, path);
  }
}

// Every field must be there; what a newer simulator tells beside them is left alone. Throws MessageError.
template <Message Answer>
[[nodiscard]] Answer read_answer(std::string_view text) {
  Answer answer;
  read_answer_part(answer_json(text), answer, FieldPath());
  return answer;
}

// Of the order `twin`, whose answer has the message's own fields; NaN for null.
[[nodiscard]] ros::TwinState twin_state_of(std::string_view text);

[[nodiscard]] ros::Pose pose_of(const PoseNumbers& pose);
[[nodiscard]] ros::SimulationState message_of(const StateAnswer& state);
[[nodiscard]] ros::GetGeometry::Response response_of(const GeometryAnswer& geometry);
[[nodiscard]] ros::PlanFootsteps::Response response_of(const PlanAnswer& plan);

}  // namespace gaitway::api
