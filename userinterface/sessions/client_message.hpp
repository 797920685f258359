// What a client sent, read with suspicion: bounded depth, checked fields, and refusals that it can act on.
#pragma once

#include <cstddef>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>

namespace gaitway::api {

// Something that a client asked for and does not get: names the field, its value and the rule.
class Refused : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

// Names of topics, services and subscriptions are no longer than this.
inline constexpr std::size_t kMostNameBytes = 256;

// The JSON object in `text`. Throws Refused: no JSON, no UTF-8, a number that no double holds, deeper than
// `most_depth`, no object.
[[nodiscard]] nlohmann::json parse_message(std::string_view text, std::size_t most_depth);

// Fields of an operation. A field that is null counts as absent. Each throws Refused for a wrong type.
[[nodiscard]] std::optional<std::string> optional_text(const nlohmann::json& message, const char* field);
// Throws Refused also when it is absent, empty or longer than kMostNameBytes.
[[nodiscard]] std::string name_in(const nlohmann::json& message, const char* field);
// A whole number from 0 to `most`; `otherwise` when absent.
[[nodiscard]] std::uint64_t whole_number(const nlohmann::json& message, const char* field,
                                         std::uint64_t otherwise, std::uint64_t most);
// The `id`: a text of at most kMostNameBytes or a whole number; null when absent.
[[nodiscard]] nlohmann::json id_in(const nlohmann::json& message);

// Throws Refused for a text of more bytes, or with control characters.
void require_short(const char* field, const std::string& value, std::size_t most);

// `value` as JSON, cut to what fits in a message for people. Always UTF-8.
[[nodiscard]] std::string shown_json(const nlohmann::json& value);
[[nodiscard]] std::string shown(std::string_view text);

}  // namespace gaitway::api
