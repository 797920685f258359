// CBOR of messages: what an independent decoder reads out of it is what the message holds.
#include "gaitway/api/cbor_codec.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/service_types.hpp"
#include "random_message.hpp"

namespace gaitway::api {
namespace {

using nlohmann::json;
using testing_messages::EveryKind;
using testing_messages::RandomMessage;
using testing_messages::Text;

template <Message M>
std::string bytes_of(const M& message) {
  std::string bytes;
  append_cbor(bytes, message);
  return bytes;
}

// Tags of byte strings are kept as their subtype.
json decoded(const std::string& bytes) {
  return json::from_cbor(bytes, true, true, json::cbor_tag_handler_t::store);
}

std::string hexadecimal(const std::string& bytes) {
  std::string text;
  for (const char byte : bytes) {
    constexpr std::string_view kDigits = "0123456789abcdef";
    text += kDigits[static_cast<unsigned char>(byte) >> 4U];
    text += kDigits[static_cast<unsigned char>(byte) & 0xFU];
  }
  return text;
}

// RFC 8746, table 1.
template <class T>
constexpr std::uint64_t kTag = 0;
template <>
constexpr std::uint64_t kTag<std::uint16_t> = 69;
template <>
constexpr std::uint64_t kTag<std::uint32_t> = 70;
template <>
constexpr std::uint64_t kTag<std::uint64_t> = 71;
template <>
constexpr std::uint64_t kTag<std::int8_t> = 72;
template <>
constexpr std::uint64_t kTag<std::int16_t> = 77;
template <>
constexpr std::uint64_t kTag<std::int32_t> = 78;
template <>
constexpr std::uint64_t kTag<std::int64_t> = 79;
template <>
constexpr std::uint64_t kTag<float> = 85;
template <>
constexpr std::uint64_t kTag<double> = 86;

template <class T>
void expect_same_bits(T left, T right) {
  EXPECT_EQ(std::memcmp(&left, &right, sizeof left), 0) << +left << " and " << +right;
}

template <class T>
void expect_typed_array(const json& item, std::span<const T> numbers) {
  ASSERT_TRUE(item.is_binary());
  EXPECT_EQ(item.get_binary().subtype(), kTag<T>);
  ASSERT_EQ(item.get_binary().size(), numbers.size_bytes());
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    T number{};
    std::memcpy(&number, item.get_binary().data() + i * sizeof(T), sizeof(T));
    expect_same_bits(number, numbers[i]);
  }
}

template <class T>
void expect_decoded(const json& item, const T& value) {
  if constexpr (Message<T>) {
    std::size_t fields = 0;
    value.fields([&](std::string_view name, const auto& field) {
      ++fields;
      SCOPED_TRACE(name);
      ASSERT_TRUE(item.contains(name));
      expect_decoded(item.at(std::string(name)), field);
    });
    EXPECT_EQ(item.size(), fields);
  } else if constexpr (Array<T>) {
    using Element = typename FieldShape<T>::Element;
    if constexpr (Number<Element>) {
      expect_typed_array(item, std::span<const Element>(value));
    } else {
      ASSERT_EQ(item.size(), value.size());
      for (std::size_t i = 0; i < value.size(); ++i) {
        expect_decoded<Element>(item[i], value[i]);
      }
    }
  } else if constexpr (std::floating_point<T>) {
    ASSERT_TRUE(item.is_number_float());
    EXPECT_EQ(std::isnan(item.get<T>()), std::isnan(value));
    if (!std::isnan(value)) {
      expect_same_bits(item.get<T>(), value);
    }
  } else {
    EXPECT_EQ(item.get<T>(), value);
  }
}

// RFC 8949, appendix A.
TEST(CborCodec, WritesTheExamplesOfTheStandard) {
  const auto integer = [](auto value) {
    std::string bytes;
    append_cbor_integer(bytes, value);
    return hexadecimal(bytes);
  };
  EXPECT_EQ(integer(0), "00");
  EXPECT_EQ(integer(23), "17");
  EXPECT_EQ(integer(24), "1818");
  EXPECT_EQ(integer(1000), "1903e8");
  EXPECT_EQ(integer(1000000), "1a000f4240");
  EXPECT_EQ(integer(1000000000000), "1b000000e8d4a51000");
  EXPECT_EQ(integer(std::numeric_limits<std::uint64_t>::max()), "1bffffffffffffffff");
  EXPECT_EQ(integer(-1), "20");
  EXPECT_EQ(integer(-1000), "3903e7");
  EXPECT_EQ(integer(std::numeric_limits<std::int64_t>::min()), "3b7fffffffffffffff");
  std::string bytes;
  append_cbor_number(bytes, 1.1);
  append_cbor_number(bytes, 100000.0F);
  append_cbor_bool(bytes, false);
  append_cbor_bool(bytes, true);
  append_cbor_text(bytes, "\xE6\xB0\xB4");
  EXPECT_EQ(hexadecimal(bytes),
            "fb3ff199999999999a"
            "fa47c35000"
            "f4"
            "f5"
            "63e6b0b4");
}

TEST(CborCodec, TagsArraysOfNumbersAsRosbridgeDoes) {
  ros::JointState message;
  message.position = {1.5};
  EXPECT_NE(hexadecimal(bytes_of(message))
                .find("68706f736974696f6e"
                      "d856"
                      "48"
                      "000000000000f83f"),
            std::string::npos)
      << "\"position\", tag 86, eight bytes, 1.5 in little endian";
}

struct Picture {
  std::vector<std::uint8_t> data;
  GAITWAY_ROS_MESSAGE("test_msgs/msg/Picture", data);
};

TEST(CborCodec, WritesBytesAsAByteStringWithoutTag) {
  EXPECT_EQ(hexadecimal(bytes_of(Picture{{1, 2, 255}})),
            "a1"
            "6464617461"
            "43"
            "0102ff");
}

TEST(CborCodec, HoldsEveryValueOfRandomMessages) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    RandomMessage random(seed, Text::utf8);
    const auto message = random.make<EveryKind>();
    expect_decoded(decoded(bytes_of(message)), message);
  }
}

TEST(CborCodec, HoldsEveryValueOfTheMessagesOfTheRobot) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    SCOPED_TRACE(seed);
    RandomMessage random(seed, Text::utf8);
    const auto odometry = random.make<ros::Odometry>();
    expect_decoded(decoded(bytes_of(odometry)), odometry);
    const auto transforms = random.make<ros::TFMessage>();
    expect_decoded(decoded(bytes_of(transforms)), transforms);
    const auto parameters = random.make<ros::GetParameters::Response>();
    expect_decoded(decoded(bytes_of(parameters)), parameters);
  }
}

TEST(CborCodec, WritesTheSameTextsAsJsonWhateverTheBytes) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    SCOPED_TRACE(seed);
    const ros::String message{RandomMessage(seed, Text::any_bytes).text()};
    std::string text;
    append_json(text, message);
    EXPECT_EQ(decoded(bytes_of(message)), json::parse(text));
  }
}

TEST(CborCodec, WritesThePublishEnvelope) {
  std::string bytes;
  append_publish_cbor(bytes, "/clock", ros::Clock{{1, 2}});
  EXPECT_EQ(decoded(bytes),
            json::parse(R"({"op":"publish","topic":"/clock","msg":{"clock":{"sec":1,"nanosec":2}}})"));
}

TEST(CborCodec, WritesTheEnvelopeOfRawMessages) {
  std::string bytes;
  const std::string cdr("\0\1\0\0abc", 7);
  append_publish_cbor_raw(bytes, "/events", 3'000'000'005, cdr);
  const json item = decoded(bytes);
  EXPECT_EQ(item.at("op"), "publish");
  EXPECT_EQ(item.at("topic"), "/events");
  EXPECT_EQ(item.at("msg").at("secs"), 3);
  EXPECT_EQ(item.at("msg").at("nsecs"), 5);
  EXPECT_EQ(item.at("msg").at("bytes").get_binary(), json::binary_t({0, 1, 0, 0, 'a', 'b', 'c'}));
}

}  // namespace
}  // namespace gaitway::api
