// What a value of a message may be, and the words for one that it may not be.
#include "gaitway/api/json_reader.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace gaitway::api {
namespace {

using nlohmann::json;

// The value as JSON, its beginning when it is long.
std::string shown(const json& value) {
  constexpr std::size_t kLongest = 60;
  if (value.is_array()) {
    return fmt::format("an array of {}", value.size());
  }
  if (value.is_object()) {
    return fmt::format("an object with {} fields", value.size());
  }
  if (value.is_number_float() && !std::isfinite(value.get<double>())) {
    return fmt::format("{}", value.get<double>());
  }
  std::string text = value.dump(-1, ' ', true, json::error_handler_t::replace);
  if (text.size() > kLongest) {
    text.resize(kLongest);
    text += "...";
  }
  return text;
}

// A float that is a whole number, and small enough to be exact.
std::optional<std::int64_t> whole_number(const json& value) {
  constexpr double kLargestExact = 9007199254740992.0;  // 2^53
  if (!value.is_number_float()) {
    return std::nullopt;
  }
  const auto number = value.get<double>();
  if (!(std::abs(number) <= kLargestExact) || std::trunc(number) != number) {
    return std::nullopt;
  }
  return static_cast<std::int64_t>(number);
}

// The name of a field as a client wrote it, harmless to print.
std::string shown_name(std::string_view name) {
  const std::string text = shown(json(name));
  return text.substr(1, text.size() > 1 && text.back() == '"' ? text.size() - 2 : std::string::npos);
}

}  // namespace

std::string FieldPath::text() const {
  if (parent_ == nullptr) {
    return "the message";
  }
  const std::string before = parent_->parent_ == nullptr ? "" : parent_->text();
  if (name_.data() == nullptr) {
    return fmt::format("{}[{}]", before, index_);
  }
  return (before.empty() ? "" : before + ".") + shown_name(name_);
}

void refuse_value(const FieldPath& path, const json& json, std::string_view rule) {
  throw MessageError(fmt::format("{} is {}, but must be {}", path.text(), shown(json), rule));
}

void refuse_field(const FieldPath& path, std::string_view type, std::string_view fields) {
  throw MessageError(fmt::format("{} is not a field of {}, which has {}", path.text(), type,
                                 fields.empty() ? "none" : fields));
}

bool read_bool(const json& json, const FieldPath& path) {
  if (!json.is_boolean()) {
    refuse_value(path, json, "true or false");
  }
  return json.get<bool>();
}

std::string read_text(const json& json, const FieldPath& path) {
  if (!json.is_string()) {
    refuse_value(path, json, "a string");
  }
  return json.get<std::string>();
}

double read_number(const json& json, const FieldPath& path, double largest) {
  const double value = json.is_number() ? json.get<double>() : NAN;
  if (!(std::abs(value) <= largest)) {
    refuse_value(path, json,
                 json.is_number() && std::isfinite(value)
                     ? fmt::format("a number of at most {} in size", largest)
                     : "a finite number");
  }
  return value;
}

std::int64_t read_integer(const json& json, const FieldPath& path, std::int64_t lowest,
                          std::int64_t highest) {
  std::optional<std::int64_t> value = whole_number(json);
  if (json.is_number_unsigned()) {
    const auto number = json.get<std::uint64_t>();
    value = number <= static_cast<std::uint64_t>(highest) ? std::optional(static_cast<std::int64_t>(number))
                                                          : std::nullopt;
  } else if (json.is_number_integer()) {
    value = json.get<std::int64_t>();
  }
  if (!value || *value < lowest || *value > highest) {
    refuse_value(path, json, fmt::format("a whole number from {} to {}", lowest, highest));
  }
  return *value;
}

std::uint64_t read_unsigned(const json& json, const FieldPath& path, std::uint64_t highest) {
  const std::optional<std::int64_t> whole = json.is_number_unsigned() ? std::nullopt
                                            : json.is_number_integer()
                                                ? std::optional(json.get<std::int64_t>())
                                                : whole_number(json);
  const bool is_unsigned = json.is_number_unsigned() || (whole && *whole >= 0);
  const std::uint64_t value = !is_unsigned ? 0
                              : whole      ? static_cast<std::uint64_t>(*whole)
                                           : json.get<std::uint64_t>();
  if (!is_unsigned || value > highest) {
    refuse_value(path, json, fmt::format("a whole number from 0 to {}", highest));
  }
  return value;
}

void check_array(const json& json, const FieldPath& path, int length) {
  if (!json.is_array() || (length != kAnyLength && json.size() != static_cast<std::size_t>(length))) {
    refuse_value(path, json,
                 length == kAnyLength ? "an array" : fmt::format("an array of {} elements", length));
  }
}

}  // namespace gaitway::api
