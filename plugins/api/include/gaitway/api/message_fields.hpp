// What kinds of fields there are in a message of ros_messages.hpp or service_types.hpp. The codecs and the
// definitions distinguish them by these concepts alone.
#pragma once

#include <array>
#include <concepts>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::api {

// A struct that names its type and its fields.
template <class T>
concept Message = requires(const T& message) {
  { T::kName } -> std::convertible_to<std::string_view>;
  message.fields([](std::string_view, const auto&) {});
};

template <class T>
concept Integer = std::integral<T> && !std::same_as<T, bool>;

template <class T>
concept Number = Integer<T> || std::floating_point<T>;

// How many elements an array field has: its length, or kAnyLength. Not an array: kNoArray.
inline constexpr int kNoArray = -1;
inline constexpr int kAnyLength = 0;

template <class T>
struct FieldShape {
  using Element = T;
  static constexpr int kLength = kNoArray;
};
template <class T>
struct FieldShape<std::vector<T>> {
  using Element = T;
  static constexpr int kLength = kAnyLength;
};
template <class T, std::size_t size>
struct FieldShape<std::array<T, size>> {
  using Element = T;
  static constexpr int kLength = static_cast<int>(size);
};

template <class T>
concept Array = FieldShape<T>::kLength != kNoArray;

template <class T>
concept Vector = FieldShape<T>::kLength == kAnyLength;

}  // namespace gaitway::api
