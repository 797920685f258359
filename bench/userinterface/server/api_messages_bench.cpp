// What it costs to write /joint_states of 22 joints, envelope included. The limit is 20 us in JSON. The
// general library's way to the same text stands beside it.
#include <benchmark/benchmark.h>

#include <nlohmann/json.hpp>
#include <random>
#include <string>

#include "gaitway/api/cbor_codec.hpp"
#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/ros_messages.hpp"

namespace {

using namespace gaitway::api;

// Angles of the size that walking has, with all the digits that a measurement has.
ros::JointState joint_states() {
  constexpr int kJoints = 22;
  ros::JointState message;
  message.header = {{1234, 567890123}, ""};
  std::mt19937 random(1);
  std::uniform_real_distribution<double> angle(-1.5, 1.5), speed(-4.0, 4.0), torque(-10.0, 10.0);
  for (int joint = 0; joint < kJoints; ++joint) {
    message.name.push_back("left_shoulder_pitch_" + std::to_string(joint));
    message.position.push_back(angle(random));
    message.velocity.push_back(speed(random));
    message.effort.push_back(torque(random));
  }
  return message;
}

template <class Encode>
void encode(benchmark::State& state, const Encode& encode_one) {
  const ros::JointState message = joint_states();
  std::string out;
  for ([[maybe_unused]] const auto iteration : state) {
    out.clear();
    encode_one(out, message);
    benchmark::DoNotOptimize(out.data());
  }
  state.counters["bytes"] = static_cast<double>(out.size());
}

void json_of_joint_states(benchmark::State& state) {
  encode(state, [](std::string& out, const ros::JointState& message) {
    append_publish_json(out, "/joint_states", message);
  });
}

void cbor_of_joint_states(benchmark::State& state) {
  encode(state, [](std::string& out, const ros::JointState& message) {
    append_publish_cbor(out, "/joint_states", message);
  });
}

void json_of_joint_states_by_nlohmann(benchmark::State& state) {
  encode(state, [](std::string& out, const ros::JointState& message) {
    const ros::Time& stamp = message.header.stamp;
    out = nlohmann::json{{"op", "publish"},
                         {"topic", "/joint_states"},
                         {"msg",
                          {{"header",
                            {{"stamp", {{"sec", stamp.sec}, {"nanosec", stamp.nanosec}}},
                             {"frame_id", message.header.frame_id}}},
                           {"name", message.name},
                           {"position", message.position},
                           {"velocity", message.velocity},
                           {"effort", message.effort}}}}
              .dump();
  });
}

void twist_from_json(benchmark::State& state) {
  const std::string text = R"({"linear":{"x":0.2,"y":0,"z":0},"angular":{"x":0,"y":0,"z":0.1}})";
  for ([[maybe_unused]] const auto iteration : state) {
    ros::Twist twist;
    from_json(nlohmann::json::parse(text), twist);
    benchmark::DoNotOptimize(twist);
  }
}

BENCHMARK(json_of_joint_states);
BENCHMARK(json_of_joint_states_by_nlohmann);
BENCHMARK(cbor_of_joint_states);
BENCHMARK(twist_from_json);

}  // namespace
