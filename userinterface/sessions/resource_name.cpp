// Strict, since what is let in here is shown to all other clients.
#include "resource_name.hpp"

#include <algorithm>
#include <vector>

#include "client_message.hpp"
#include "gaitway/api/message_definition.hpp"

namespace gaitway::api {
namespace {

bool is_plain(char letter) {
  return (letter >= 'a' && letter <= 'z') || (letter >= 'A' && letter <= 'Z') ||
         (letter >= '0' && letter <= '9') || letter == '_';
}

// The parts between slashes; nothing when one is empty or has another character.
std::vector<std::string_view> plain_parts(std::string_view text) {
  std::vector<std::string_view> parts;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find('/', begin), text.size());
    const std::string_view part = text.substr(begin, end - begin);
    if (part.empty() || !std::ranges::all_of(part, is_plain)) {
      return {};
    }
    parts.push_back(part);
    begin = end + 1;
  }
  return parts;
}

}  // namespace

std::string resource_name_in(const nlohmann::json& message, const char* field) {
  std::string name = name_in(message, field);
  if (plain_parts(std::string_view(name).substr(name.front() == '/' ? 1 : 0)).empty()) {
    throw Refused(std::string(field) + " is " + shown(name) +
                  ", but must be letters, digits and _, in parts between single slashes");
  }
  return name;
}

std::string absolute_name(std::string_view name) {
  return name.starts_with('/') ? std::string(name) : "/" + std::string(name);
}

std::string type_in(const nlohmann::json& message, std::string_view kind) {
  const auto given = optional_text(message, "type");
  if (!given || given->empty()) {
    return "";
  }
  const auto parts = plain_parts(*given);
  if (given->size() > kMostNameBytes || parts.size() < 2 || parts.size() > 3) {
    throw Refused("type is " + shown(*given) + ", but must be a package and a name, such as \"std_msgs/" +
                  std::string(kind) + "/Name\", of at most " + std::to_string(kMostNameBytes) + " bytes");
  }
  if (const std::string_view known = canonical_type(*given); !known.empty()) {
    return std::string(known);
  }
  return std::string(parts.front()) + "/" + std::string(parts.size() == 3 ? parts[1] : kind) + "/" +
         std::string(parts.back());
}

}  // namespace gaitway::api
