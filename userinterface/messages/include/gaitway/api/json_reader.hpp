// Messages out of JSON that a client sent.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <string>
#include <string_view>

#include "gaitway/api/message_fields.hpp"

namespace gaitway::api {

// What is wrong with a message, for the client: "linear.x is \"fast\", but must be a finite number".
class MessageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Where in a message a value stands. Made on the stack as the reader goes down; a text only when asked for.
class FieldPath {
 public:
  FieldPath() = default;
  FieldPath(const FieldPath& parent, std::string_view name) noexcept : parent_(&parent), name_(name) {}
  FieldPath(const FieldPath& parent, std::size_t index) noexcept : parent_(&parent), index_(index) {}
  // "transforms[2].header.frame_id"; of the whole message: "the message".
  [[nodiscard]] std::string text() const;

 private:
  const FieldPath* parent_ = nullptr;
  std::string_view name_;
  std::size_t index_ = 0;
};

// Throws MessageError: what stands at `path` is `json`, but must be `rule`.
[[noreturn]] void refuse_value(const FieldPath& path, const nlohmann::json& json, std::string_view rule);
// Throws MessageError: `type` has no field of that name.
[[noreturn]] void refuse_field(const FieldPath& path, std::string_view type, std::string_view fields);

// These give the value or throw MessageError.
[[nodiscard]] bool read_bool(const nlohmann::json& json, const FieldPath& path);
[[nodiscard]] std::string read_text(const nlohmann::json& json, const FieldPath& path);
// Finite and at most `largest` in size.
[[nodiscard]] double read_number(const nlohmann::json& json, const FieldPath& path, double largest);
// Whole numbers may be written with a fraction of zero (3.0).
[[nodiscard]] std::int64_t read_integer(const nlohmann::json& json, const FieldPath& path,
                                        std::int64_t lowest, std::int64_t highest);
[[nodiscard]] std::uint64_t read_unsigned(const nlohmann::json& json, const FieldPath& path,
                                          std::uint64_t highest);
// Checks that it is an array, of `length` elements unless that is kAnyLength.
void check_array(const nlohmann::json& json, const FieldPath& path, int length);

template <Message M>
void read_message(const nlohmann::json& json, M& message, const FieldPath& path);

template <class T>
void read_value(const nlohmann::json& json, T& value, const FieldPath& path) {
  if constexpr (Message<T>) {
    read_message(json, value, path);
  } else if constexpr (Array<T>) {
    check_array(json, path, FieldShape<T>::kLength);
    T elements{};
    if constexpr (Vector<T>) {
      elements.resize(json.size());
    }
    for (std::size_t i = 0; i < elements.size(); ++i) {
      typename FieldShape<T>::Element element{};
      read_value(json[i], element, FieldPath(path, i));
      elements[i] = std::move(element);
    }
    value = std::move(elements);
  } else if constexpr (std::same_as<T, bool>) {
    value = read_bool(json, path);
  } else if constexpr (std::floating_point<T>) {
    value = static_cast<T>(read_number(json, path, static_cast<double>(std::numeric_limits<T>::max())));
  } else if constexpr (std::signed_integral<T>) {
    value = static_cast<T>(
        read_integer(json, path, std::numeric_limits<T>::min(), std::numeric_limits<T>::max()));
  } else if constexpr (std::unsigned_integral<T>) {
    value = static_cast<T>(read_unsigned(json, path, std::numeric_limits<T>::max()));
  } else {
    value = read_text(json, path);
  }
}

template <Message M>
void read_message(const nlohmann::json& json, M& message, const FieldPath& path) {
  if (!json.is_object()) {
    refuse_value(path, json, "an object with the fields of " + std::string(M::kName));
  }
  std::size_t known = 0;
  message.fields([&](std::string_view name, auto& value) {
    if (const auto found = json.find(name); found != json.end()) {
      ++known;
      read_value(*found, value, FieldPath(path, name));
    }
  });
  if (known == json.size()) {
    return;
  }
  std::string fields;
  message.fields([&fields](std::string_view name, const auto&) {
    fields += fields.empty() ? "" : ", ";
    fields += name;
  });
  for (const auto& item : json.items()) {
    const std::string& name = item.key();
    bool is_field = false;
    message.fields([&](std::string_view field, const auto&) { is_field = is_field || field == name; });
    if (!is_field) {
      refuse_field(FieldPath(path, name), M::kName, fields);
    }
  }
}

// Fields that `json` does not name keep their values. Throws MessageError for an unknown field, a wrong type,
// a number out of range or not finite, or an array of wrong length; then the message may be half read.
template <Message M>
void from_json(const nlohmann::json& json, M& message) {
  read_message(json, message, FieldPath());
}

}  // namespace gaitway::api
