// What a message is about, told without keeping the rest of it.
#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <string_view>

namespace gaitway::api {

// Fields of the outermost object; of one that stands there twice, the last. Empty, or null: none of its kind.
struct MessageHead {
  std::string op, service, compression;
  nlohmann::json id;  // a text or a whole number
};

// Nothing when the message is no JSON object.
[[nodiscard]] std::optional<MessageHead> head_of(std::string_view message);

}  // namespace gaitway::api
