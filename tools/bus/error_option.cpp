// Parses `key:value` parts between commas.
#include "tools/bus/error_option.hpp"

#include <fmt/format.h>

#include <set>
#include <stdexcept>
#include <string_view>
#include <vector>

#include "gaitway/input/nearest_name.hpp"
#include "gaitway/input/number.hpp"

namespace gaitway::tools {
namespace {

constexpr int kMostErrors = 100'000;
constexpr std::int64_t kLongest_ns = 1'000'000'000'000;  // 1000 s

[[noreturn]] void refuse(const std::string& text, std::string_view rule) {
  throw std::invalid_argument(fmt::format("--errors {}: {}", text, rule));
}

std::int64_t time_ns(const std::string& text, std::string_view key, std::string_view value) {
  try {
    return input::number_with_unit(value, input::kTimeUnits_ns, 1, kLongest_ns);
  } catch (const input::ValueError& error) {
    refuse(text, fmt::format("{} = '{}': {}", key, value, error.what()));
  }
}

int count(const std::string& text, std::string_view value) {
  if (!input::option_fault<std::int64_t>(value, 1, kMostErrors).empty()) {
    refuse(text, fmt::format("burst = '{}': must be a whole number 1..{}", value, kMostErrors));
  }
  return static_cast<int>(input::plain_number<std::int64_t>(value));
}

// The parts between commas; a comma before a digit is somebody's decimal comma, which the number's reader
// tells.
std::vector<std::string> parts_of(const std::string& text) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == ',' && !(i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9')) {
      parts.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  if (begin < text.size()) {
    parts.push_back(text.substr(begin));
  }
  return parts;
}

}  // namespace

can::ErrorSource parse_errors(const std::string& text) {
  static const std::vector<std::string> kKeys{"burst", "interval", "jam"};
  can::ErrorSource source;
  std::set<std::string> seen;
  for (const std::string& part : parts_of(text)) {
    const std::size_t colon = part.find(':');
    const std::string key = part.substr(0, colon);
    const std::string value = colon == std::string::npos ? "" : part.substr(colon + 1);
    if (!seen.insert(key).second) {
      refuse(text, fmt::format("'{}' is there twice; give --errors again for a second source", key));
    }
    if (key == "burst") {
      source.burst = count(text, value);
    } else if (key == "interval") {
      source.interval_ns = time_ns(text, key, value);
    } else if (key == "jam") {
      source.duration_ns = time_ns(text, key, value);
    } else {
      refuse(text, fmt::format("'{}': there is no such part. {}", key, input::suggest(key, kKeys)));
    }
  }
  if (seen.empty()) {
    refuse(text, "says nothing. Write for example burst:4,interval:10ms or jam:2ms");
  }
  return source;
}

}  // namespace gaitway::tools
