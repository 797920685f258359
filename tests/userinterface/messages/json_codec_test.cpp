// JSON of messages: what any JSON parser reads out of it is what the message holds.
#include "gaitway/api/json_codec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "gaitway/api/service_types.hpp"
#include "random_message.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using testing_messages::EveryKind;
using testing_messages::RandomMessage;
using testing_messages::Text;

template <Message M>
std::string text_of(const M& message) {
  std::string text;
  append_json(text, message);
  return text;
}

std::string string_text(std::string_view value) {
  std::string text;
  append_json_string(text, value);
  return text;
}

// What the library that others trust makes of the same bytes.
std::string replaced(const std::string& text) {
  return json::parse(json(text).dump(-1, ' ', false, json::error_handler_t::replace)).get<std::string>();
}

template <class T>
void expect_same(const json& parsed, const T& value) {
  if constexpr (Message<T>) {
    std::size_t fields = 0;
    value.fields([&](std::string_view name, const auto& field) {
      ++fields;
      SCOPED_TRACE(name);
      ASSERT_TRUE(parsed.contains(name));
      expect_same(parsed.at(std::string(name)), field);
    });
    EXPECT_EQ(parsed.size(), fields);
  } else if constexpr (Array<T>) {
    ASSERT_EQ(parsed.size(), value.size());
    for (std::size_t i = 0; i < value.size(); ++i) {
      expect_same<typename FieldShape<T>::Element>(parsed[i], value[i]);
    }
  } else if constexpr (std::floating_point<T>) {
    EXPECT_EQ(parsed.is_null(), !std::isfinite(value));
    if (parsed.is_number()) {
      EXPECT_EQ(parsed.get<T>(), value);
    }
  } else if constexpr (std::same_as<T, std::string>) {
    EXPECT_EQ(parsed.get<std::string>(), replaced(value));
  } else {
    EXPECT_EQ(parsed.get<T>(), value);
  }
}

TEST(JsonCodec, WritesFieldsInTheOrderOfTheDefinition) {
  ros::JointState message;
  message.header.stamp = {12, 340};
  message.header.frame_id = "base";
  message.name = {"left_knee_pitch", "head_yaw"};
  message.position = {0.5, -1.25};
  message.velocity = {0.1, 1e-9};
  EXPECT_EQ(
      text_of(message),
      R"({"header":{"stamp":{"sec":12,"nanosec":340},"frame_id":"base"},)"
      R"("name":["left_knee_pitch","head_yaw"],"position":[0.5,-1.25],"velocity":[0.1,1e-09],"effort":[]})");
}

TEST(JsonCodec, WritesAMessageWithoutFieldsAsAnEmptyObject) {
  EXPECT_EQ(text_of(ros::Trigger::Request{}), "{}");
}

TEST(JsonCodec, WritesThePublishEnvelope) {
  std::string text;
  append_publish_json(text, "/clock", ros::Clock{{1, 2}});
  EXPECT_EQ(text, R"({"op":"publish","topic":"/clock","msg":{"clock":{"sec":1,"nanosec":2}}})");
}

TEST(JsonCodec, WritesNullForWhatIsNoNumber) {
  ros::Vector3 message;
  message.x = std::numeric_limits<double>::quiet_NaN();
  message.y = std::numeric_limits<double>::infinity();
  message.z = -std::numeric_limits<double>::infinity();
  EXPECT_EQ(text_of(message), R"({"x":null,"y":null,"z":null})");
}

TEST(JsonCodec, KeepsTheSignOfZero) {
  EXPECT_EQ(text_of(ros::Vector3{-0.0, 0.0, -1.0}), R"({"x":-0.0,"y":0,"z":-1})");
}

TEST(JsonCodec, EscapesWhatAStringMayNotHold) {
  EXPECT_EQ(string_text("a\"b\\c\b\f\n\r\t\x01\x1f\x7f/"),
            "\"a\\\"b\\\\c\\b\\f\\n\\r\\t\\u0001\\u001f\x7f/\"");
  EXPECT_EQ(string_text(std::string_view("\0", 1)), R"("\u0000")");
}

TEST(JsonCodec, KeepsCharactersAndReplacesBytesThatAreNone) {
  EXPECT_EQ(string_text("\xC3\xA4 \xF0\x9F\xA4\x96"), "\"\xC3\xA4 \xF0\x9F\xA4\x96\"");
  EXPECT_EQ(string_text("a\xFF"
                        "b"),
            "\"a\xEF\xBF\xBD"
            "b\"");
  EXPECT_EQ(string_text("\xC0\xAF"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\"") << "longer than needed";
  EXPECT_EQ(string_text("\xED\xA0\x80"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"") << "a surrogate";
  EXPECT_EQ(string_text("\xF4\x90\x80\x80"), "\"\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD\"");
  EXPECT_EQ(string_text("\xE2\x82"), "\"\xEF\xBF\xBD\"") << "cut off";
}

TEST(JsonCodec, AgreesWithAnotherLibraryAboutAnyBytes) {
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    SCOPED_TRACE(seed);
    std::mt19937_64 random(seed);
    std::string bytes;
    for (std::size_t left = random() % 12; left > 0; --left) {
      // Bytes with the high bit set half of the time, so that starts of characters meet continuations.
      bytes += static_cast<char>(static_cast<unsigned char>(random() % 2 == 0 ? 0x80 | random() : random()));
    }
    EXPECT_EQ(json::parse(string_text(bytes)).get<std::string>(), replaced(bytes));
  }
}

// The vectors of RFC 4648, 10.
TEST(JsonCodec, WritesBytesInBase64AsRosbridgeDoes) {
  const auto text_of_bytes = [](std::string_view bytes) {
    std::string text;
    append_json_value(text, std::vector<std::uint8_t>(bytes.begin(), bytes.end()));
    return text;
  };
  EXPECT_EQ(text_of_bytes(""), R"("")");
  EXPECT_EQ(text_of_bytes("f"), R"("Zg==")");
  EXPECT_EQ(text_of_bytes("fo"), R"("Zm8=")");
  EXPECT_EQ(text_of_bytes("foo"), R"("Zm9v")");
  EXPECT_EQ(text_of_bytes("foob"), R"("Zm9vYg==")");
  EXPECT_EQ(text_of_bytes("fooba"), R"("Zm9vYmE=")");
  EXPECT_EQ(text_of_bytes("foobar"), R"("Zm9vYmFy")");
  EXPECT_EQ(text_of_bytes("\xfb\xff\xfe"), R"("+//+")");
}

TEST(JsonCodec, HoldsEveryValueOfRandomMessages) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomMessage random(seed, Text::any_bytes);
    const auto message = random.make<EveryKind>();
    expect_same(json::parse(text_of(message)), message);
  }
}

TEST(JsonCodec, HoldsEveryValueOfTheMessagesOfTheRobot) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    RandomMessage random(seed, Text::any_bytes);
    const auto odometry = random.make<ros::Odometry>();
    expect_same(json::parse(text_of(odometry)), odometry);
    const auto diagnostics = random.make<ros::DiagnosticArray>();
    expect_same(json::parse(text_of(diagnostics)), diagnostics);
    const auto plugins = random.make<ros::ListPlugins::Response>();
    expect_same(json::parse(text_of(plugins)), plugins);
  }
}

}  // namespace
}  // namespace gaitway::api
