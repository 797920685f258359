// Messages with values by chance, and a message that has every kind of field, for the properties of the
// codecs.
#pragma once

#include <array>
#include <bit>
#include <concepts>
#include <cstdint>
#include <random>
#include <string>
#include <vector>

#include "gaitway/api/message_fields.hpp"
#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api::testing_messages {

struct EveryKind {
  bool flag = false;
  std::int8_t i8 = 0;
  std::int16_t i16 = 0;
  std::int32_t i32 = 0;
  std::int64_t i64 = 0;
  std::uint8_t u8 = 0;
  std::uint16_t u16 = 0;
  std::uint32_t u32 = 0;
  std::uint64_t u64 = 0;
  float f32 = 0.0F;
  double f64 = 0.0;
  std::string text;
  ros::Pose pose;
  std::vector<bool> flags;
  std::vector<std::int8_t> i8s;
  std::vector<std::int16_t> i16s;
  std::vector<std::int32_t> i32s;
  std::vector<std::int64_t> i64s;
  std::vector<std::uint16_t> u16s;
  std::vector<std::uint32_t> u32s;
  std::vector<std::uint64_t> u64s;
  std::vector<float> f32s;
  std::vector<double> f64s;
  std::array<double, 3> three{};
  std::vector<std::string> texts;
  std::array<ros::Header, 2> headers;
  GAITWAY_ROS_MESSAGE("test_msgs/msg/EveryKind", flag, i8, i16, i32, i64, u8, u16, u32, u64, f32, f64, text,
                      pose, flags, i8s, i16s, i32s, i64s, u16s, u32s, u64s, f32s, f64s, three, texts,
                      headers);
};

enum class Text { any_bytes, utf8 };

class RandomMessage {
 public:
  RandomMessage(std::uint64_t seed, Text text) : random_(seed), text_(text) {}

  template <Message M>
  M make() {
    M message;
    fill(message);
    return message;
  }

  std::string text() {
    static const std::array<std::string, 8> pieces{
        "\"", "\\", "\n", "\x01", "\xC3\xA4", "\xE2\x82\xAC", "\xF0\x9F\xA4\x96", "joint"};
    std::string result;
    for (std::size_t left = random_() % 6; left > 0; --left) {
      result += text_ == Text::utf8 || random_() % 2 == 0
                    ? pieces[random_() % pieces.size()]
                    : std::string(1, static_cast<char>(static_cast<unsigned char>(random_() % 256)));
    }
    return result;
  }

 private:
  template <class T>
  void fill(T& value) {
    if constexpr (Message<T>) {
      value.fields([this](std::string_view, auto& field) { fill(field); });
    } else if constexpr (Array<T>) {
      if constexpr (Vector<T>) {
        value.resize(random_() % 40);
      }
      for (std::size_t i = 0; i < value.size(); ++i) {
        typename FieldShape<T>::Element element{};
        fill(element);
        value[i] = std::move(element);
      }
    } else if constexpr (std::same_as<T, bool>) {
      value = random_() % 2 == 0;
    } else if constexpr (std::same_as<T, double>) {
      value =
          random_() % 2 == 0 ? std::bit_cast<double>(random_()) : static_cast<double>(random_() % 1000) / 8;
    } else if constexpr (std::same_as<T, float>) {
      value = std::bit_cast<float>(static_cast<std::uint32_t>(random_()));
    } else if constexpr (Integer<T>) {
      value = static_cast<T>(random_() >> (random_() % 64));
    } else {
      value = text();
    }
  }

  std::mt19937_64 random_;
  Text text_;
};

// Calls check(field name, value, value) for every plain value of two messages of one type; arrays must be of
// one length, or check is called with their lengths.
template <class T, class Check>
void for_each_pair(std::string_view name, const T& left, const T& right, const Check& check) {
  if constexpr (Message<T>) {
    left.fields([&]<class Field>(std::string_view field, const Field& value) {
      right.fields([&]<class Other>(std::string_view other, const Other& other_value) {
        if constexpr (std::same_as<Field, Other>) {
          if (field == other) {
            for_each_pair(field, value, other_value, check);
          }
        }
      });
    });
  } else if constexpr (Array<T>) {
    check(name, left.size(), right.size());
    for (std::size_t i = 0; i < std::min(left.size(), right.size()); ++i) {
      for_each_pair<typename FieldShape<T>::Element>(name, left[i], right[i], check);
    }
  } else {
    check(name, left, right);
  }
}

}  // namespace gaitway::api::testing_messages
