// The JSON schemas say what the codec writes and what the reader takes.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <random>
#include <vector>

#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/message_definition.hpp"
#include "gaitway/api/service_types.hpp"
#include "random_message.hpp"
#include "schema_check.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using testing_messages::RandomMessage;
using testing_messages::SchemaCheck;
using testing_messages::Text;

TEST(JsonSchema, OfWhatAClientSendsAllowsNumbersAndKnownFieldsOnly) {
  EXPECT_EQ(json::parse(json_schema("geometry_msgs/Twist", Sender::client)), json::parse(R"({
    "$schema": "https://json-schema.org/draft/2020-12/schema",
    "title": "geometry_msgs/msg/Twist",
    "type": "object",
    "properties": {"linear": {"$ref": "#/$defs/geometry_msgs~1msg~1Vector3"},
                   "angular": {"$ref": "#/$defs/geometry_msgs~1msg~1Vector3"}},
    "additionalProperties": false,
    "$defs": {"geometry_msgs/msg/Vector3": {
      "type": "object",
      "properties": {"x": {"type": "number"}, "y": {"type": "number"}, "z": {"type": "number"}},
      "additionalProperties": false}}})"));
}

TEST(JsonSchema, OfWhatTheRobotSendsNeedsEveryField) {
  const json schema = json::parse(json_schema("nav_msgs/Odometry", Sender::robot));
  EXPECT_EQ(schema.at("required"), json({"header", "child_frame_id", "pose", "twist"}));
  const json& covariance =
      schema.at("$defs").at("geometry_msgs/msg/PoseWithCovariance").at("properties").at("covariance");
  EXPECT_EQ(covariance, json::parse(R"({"type": "array", "items": {"type": ["number", "null"]},
                                        "minItems": 36, "maxItems": 36})"));
  EXPECT_EQ(schema.at("$defs").at("builtin_interfaces/msg/Time").at("properties").at("nanosec"),
            json::parse(R"({"type": "integer", "minimum": 0, "maximum": 4294967295})"));
}

template <Message M>
void expect_written_messages_satisfy_their_schema() {
  const SchemaCheck check(json::parse(json_schema(M::kName, Sender::robot)));
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    std::string text;
    append_json(text, RandomMessage(seed, Text::any_bytes).make<M>());
    EXPECT_TRUE(check.accepts(json::parse(text))) << M::kName << ", seed " << seed;
  }
}

TEST(JsonSchema, AcceptsWhateverTheCodecWrites) {
  expect_written_messages_satisfy_their_schema<ros::Odometry>();
  expect_written_messages_satisfy_their_schema<ros::JointState>();
  expect_written_messages_satisfy_their_schema<ros::DiagnosticArray>();
  expect_written_messages_satisfy_their_schema<ros::Log>();
  expect_written_messages_satisfy_their_schema<ros::ListPlugins::Response>();
  expect_written_messages_satisfy_their_schema<ros::GetParameters::Response>();
  expect_written_messages_satisfy_their_schema<ros::TypeDef>();
}

// A value by chance that often fits.
json random_value(std::mt19937_64& random, int depth) {
  const std::vector<json> plain{
      0,     1,       -7,   0.5,  3.0,         127, 300, -2147483648LL, 4294967296LL,
      true,  nullptr, "x",  "",   1e300,       255, -1,  json::array(), json::object(),
      65535, 2.5e9,   -0.0, 1e10, 4294967295LL};
  static const std::vector<std::string> names{
      "linear", "angular", "x",     "y",    "z",   "header",   "poses",    "stamp",       "sec",
      "name",   "nanosec", "level", "line", "msg", "frame_id", "position", "orientation", "file"};
  if (depth == 0 || random() % 4 == 0) {
    return plain[random() % plain.size()];
  }
  json value = random() % 4 == 0 ? json::array() : json::object();
  for (std::size_t left = random() % 4; left > 0; --left) {
    const json element = random_value(random, depth - 1);
    if (value.is_array()) {
      value.push_back(element);
    } else {
      value[names[random() % names.size()]] = element;
    }
  }
  return value;
}

template <Message M>
bool is_read(const json& value) {
  M message;
  try {
    from_json(value, message);
    return true;
  } catch (const MessageError&) {
    return false;
  }
}

template <Message M>
void expect_reader_and_schema_agree() {
  const SchemaCheck check(json::parse(json_schema(M::kName, Sender::client)));
  std::mt19937_64 random(1);
  int accepted = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    const json value = random_value(random, 3);
    const bool accepts = check.accepts(value);
    ++(accepts ? accepted : refused);
    ASSERT_EQ(is_read<M>(value), accepts) << M::kName << " " << value;
  }
  EXPECT_GT(accepted, 20);
  EXPECT_GT(refused, 20);
}

TEST(JsonSchema, AcceptsWhatTheReaderTakesAndNothingElse) {
  expect_reader_and_schema_agree<ros::Twist>();
  expect_reader_and_schema_agree<ros::Vector3>();
  expect_reader_and_schema_agree<ros::Time>();
  expect_reader_and_schema_agree<ros::Header>();
  expect_reader_and_schema_agree<ros::Log>();
  expect_reader_and_schema_agree<ros::Pose>();
}

}  // namespace
}  // namespace gaitway::api
