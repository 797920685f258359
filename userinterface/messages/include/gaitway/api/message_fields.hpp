// How a message's struct names its type and its fields, once, and what kinds of fields there are: all that
// the codecs and the definitions know of messages.
#pragma once

#include <algorithm>
#include <array>
#include <concepts>
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

namespace gaitway::api {

[[nodiscard]] consteval std::size_t count_names(std::string_view list) {
  return list.empty() ? 0 : static_cast<std::size_t>(std::ranges::count(list, ',')) + 1;
}

// The names in "position, orientation".
template <std::size_t count>
[[nodiscard]] consteval std::array<std::string_view, count> names_in(std::string_view list) {
  std::array<std::string_view, count> names;
  for (std::string_view& name : names) {
    list.remove_prefix(std::min(list.find_first_not_of(", "), list.size()));
    name = list.substr(0, list.find(','));
    list.remove_prefix(name.size());
  }
  return names;
}

template <class Visitor, class... Members>
void visit_named([[maybe_unused]] const std::array<std::string_view, sizeof...(Members)>& names,
                 [[maybe_unused]] Visitor& visit, Members&... members) {
  [[maybe_unused]] std::size_t i = 0;
  (visit(names[i++], members), ...);
}

// Gives `fields(visit)` as visit("name", member) for each member, const or not.
#define GAITWAY_FIELDS(...)                                                              \
  static constexpr auto kFieldNames =                                                    \
      ::gaitway::api::names_in<::gaitway::api::count_names(#__VA_ARGS__)>(#__VA_ARGS__); \
  template <class Visitor>                                                               \
  void fields(Visitor&& visit) {                                                         \
    ::gaitway::api::visit_named(kFieldNames, visit __VA_OPT__(, ) __VA_ARGS__);          \
  }                                                                                      \
  template <class Visitor>                                                               \
  void fields(Visitor&& visit) const {                                                   \
    ::gaitway::api::visit_named(kFieldNames, visit __VA_OPT__(, ) __VA_ARGS__);          \
  }

// The same of a message, which has a type's name, too.
#define GAITWAY_ROS_MESSAGE(type_name, ...) \
  GAITWAY_FIELDS(__VA_ARGS__)               \
  static constexpr std::string_view kName = type_name

// A constant of a definition, which tells what a number in a field means.
struct Constant {
  std::string_view type;
  std::string_view name;
  std::uint32_t value = 0;
};

template <std::size_t count>
[[nodiscard]] consteval std::array<Constant, count> constants_of(
    std::string_view type, const std::array<std::string_view, count>& names,
    const std::array<std::uint32_t, count>& values) {
  std::array<Constant, count> constants;
  for (std::size_t i = 0; i < count; ++i) {
    constants[i] = {type, names[i], values[i]};
  }
  return constants;
}

// Constants of a message or of a part of a service, all of one type: enumerators of the struct, which bear
// the names that the definition has.
#define GAITWAY_CONSTANTS(type, ...)                                                                \
  static constexpr auto kConstants =                                                                \
      ::gaitway::api::constants_of<::gaitway::api::count_names(#__VA_ARGS__)>(                      \
          #type, ::gaitway::api::names_in<::gaitway::api::count_names(#__VA_ARGS__)>(#__VA_ARGS__), \
          {__VA_ARGS__})

// A whole struct of one field, for the arguments and answers of services.
#define GAITWAY_ONE_FIELD(struct_name, type, field) \
  struct struct_name {                              \
    type field{};                                   \
    GAITWAY_FIELDS(field)                           \
  }

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
