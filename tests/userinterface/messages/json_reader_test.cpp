// Messages out of JSON: what is written comes back, and what is wrong is named.
#include "gaitway/api/json_reader.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/service_types.hpp"
#include "random_message.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using ::testing::HasSubstr;
using testing_messages::EveryKind;
using testing_messages::RandomMessage;
using testing_messages::Text;

// Why it is refused; empty when it is not.
template <Message M>
std::string refusal(const json& value) {
  M message;
  try {
    from_json(value, message);
  } catch (const MessageError& error) {
    return error.what();
  }
  return {};
}
template <Message M>
std::string refusal(const char* text) {
  return refusal<M>(json::parse(text));
}

TEST(JsonReader, ReadsATwist) {
  ros::Twist twist;
  from_json(json::parse(R"({"linear": {"x": 0.2, "y": 0, "z": 0.0}, "angular": {"z": -1e-1}})"), twist);
  EXPECT_EQ(twist.linear.x, 0.2);
  EXPECT_EQ(twist.angular.z, -0.1);
}

TEST(JsonReader, FieldsThatAreMissingKeepTheirValues) {
  ros::Quaternion rotation;
  from_json(json::parse(R"({"x": 0.5})"), rotation);
  EXPECT_EQ(rotation.x, 0.5);
  EXPECT_EQ(rotation.w, 1.0);
  ros::SetBool::Request request{true};
  from_json(json::object(), request);
  EXPECT_TRUE(request.data);
}

template <class T>
void expect_same_value(const T& left, const T& right) {
  if constexpr (std::floating_point<T>) {
    EXPECT_EQ(left, std::isfinite(right) ? right : T{0});
  } else {
    EXPECT_EQ(left, right);
  }
}

// Numbers that are not finite are written as null, which is taken out here.
void remove_null(json& value) {
  for (auto& element : value) {
    if (element.is_null()) {
      element = 0.0;
    } else if (element.is_structured()) {
      remove_null(element);
    }
  }
}

TEST(JsonReader, ReadsWhatTheCodecWrites) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const auto message = RandomMessage(seed, Text::utf8).make<EveryKind>();
    std::string text;
    append_json(text, message);
    json written = json::parse(text);
    remove_null(written);
    EveryKind read;
    from_json(written, read);
    testing_messages::for_each_pair("", read, message,
                                    [](std::string_view name, const auto& left, const auto& right) {
                                      SCOPED_TRACE(name);
                                      expect_same_value(left, right);
                                    });
  }
}

TEST(JsonReader, NamesAnUnknownFieldAndThoseThatThereAre) {
  EXPECT_EQ(refusal<ros::Twist>(R"({"linear": {"q": 1}})"),
            "linear.q is not a field of geometry_msgs/msg/Vector3, which has x, y, z");
  EXPECT_EQ(refusal<ros::Twist>(R"({"x": 1})"),
            "x is not a field of geometry_msgs/msg/Twist, which has linear, angular");
  EXPECT_EQ(refusal<ros::Trigger::Request>(R"({"data": 1})"),
            "data is not a field of std_srvs/srv/Trigger_Request, which has none");
}

TEST(JsonReader, NamesAWrongTypeItsValueAndTheRule) {
  EXPECT_EQ(refusal<ros::Twist>(R"({"linear": {"x": "fast"}})"),
            R"(linear.x is "fast", but must be a finite number)");
  EXPECT_EQ(refusal<ros::Twist>(R"({"linear": {"x": null}})"),
            "linear.x is null, but must be a finite number");
  EXPECT_EQ(refusal<ros::Twist>(R"({"linear": [1, 2, 3]})"),
            "linear is an array of 3, but must be an object with the fields of geometry_msgs/msg/Vector3");
  EXPECT_EQ(refusal<ros::Twist>("[]"),
            "the message is an array of 0, but must be an object with the fields of geometry_msgs/msg/Twist");
  EXPECT_EQ(refusal<ros::SetBool::Request>(R"({"data": 1})"), "data is 1, but must be true or false");
  EXPECT_EQ(refusal<ros::Lease::Request>(R"({"lease": {"a": 1}})"),
            "lease is an object with 1 fields, but must be a string");
}

TEST(JsonReader, NamesTheElementOfAnArray) {
  EXPECT_EQ(refusal<ros::PoseArray>(R"({"poses": [{}, {"position": {"y": true}}]})"),
            "poses[1].position.y is true, but must be a finite number");
  EXPECT_EQ(refusal<EveryKind>(R"({"three": [1, 2]})"),
            "three is an array of 2, but must be an array of 3 elements");
  EXPECT_EQ(refusal<EveryKind>(R"({"texts": "a"})"), R"(texts is "a", but must be an array)");
}

TEST(JsonReader, RefusesNumbersThatAreNoneOrTooLarge) {
  EXPECT_EQ(refusal<ros::Vector3>(json{{"x", NAN}}), "x is nan, but must be a finite number");
  EXPECT_EQ(refusal<ros::Vector3>(json{{"x", -INFINITY}}), "x is -inf, but must be a finite number");
  EXPECT_THAT(refusal<EveryKind>(R"({"f32": 1e39})"),
              HasSubstr("f32 is 1e+39, but must be a number of at most"));
}

TEST(JsonReader, RefusesIntegersOutOfRange) {
  EXPECT_EQ(refusal<EveryKind>(R"({"i8": 128})"), "i8 is 128, but must be a whole number from -128 to 127");
  EXPECT_EQ(refusal<EveryKind>(R"({"i8": -129})"), "i8 is -129, but must be a whole number from -128 to 127");
  EXPECT_EQ(refusal<EveryKind>(R"({"u16": -1})"), "u16 is -1, but must be a whole number from 0 to 65535");
  EXPECT_EQ(refusal<EveryKind>(R"({"u16": 65536})"),
            "u16 is 65536, but must be a whole number from 0 to 65535");
  EXPECT_EQ(refusal<EveryKind>(R"({"i32": 1.5})"),
            "i32 is 1.5, but must be a whole number from -2147483648 to 2147483647");
  EXPECT_EQ(refusal<EveryKind>(R"({"u64": 1e300})"),
            "u64 is 1e+300, but must be a whole number from 0 to 18446744073709551615");
  EXPECT_THAT(refusal<EveryKind>(R"({"i64": 9223372036854775808})"), HasSubstr("but must be a whole number"));
}

TEST(JsonReader, TakesWholeNumbersAtTheirLimitsAndWithAFractionOfZero) {
  EveryKind message;
  from_json(json::parse(R"({"i8": -128, "i64": -9223372036854775808, "u64": 18446744073709551615, "u8": 3.0,
                            "i16": -2.0})"),
            message);
  EXPECT_EQ(message.i8, -128);
  EXPECT_EQ(message.i64, std::numeric_limits<std::int64_t>::min());
  EXPECT_EQ(message.u64, std::numeric_limits<std::uint64_t>::max());
  EXPECT_EQ(message.u8, 3);
  EXPECT_EQ(message.i16, -2);
}

TEST(JsonReader, ShowsOnlyTheStartOfALongValueAndNoControlCharacters) {
  const std::string error = refusal<ros::Twist>(json{{"linear", "\x1b[2J" + std::string(10000, 'x')}});
  EXPECT_LT(error.size(), 200U);
  EXPECT_EQ(error.find('\x1b'), std::string::npos);
  const std::string name = refusal<ros::Twist>(json{{"\x1b[2J\n" + std::string(10000, 'x'), 1}});
  EXPECT_LT(name.size(), 200U);
  EXPECT_EQ(name.find('\x1b'), std::string::npos);
}

}  // namespace
}  // namespace gaitway::api
