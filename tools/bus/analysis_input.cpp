// What users write for the bus analysis: how the bus is disturbed, and lists of messages.
#include "tools/bus/bus_options.hpp"

#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/can/frame.hpp"
#include "gaitway/input/complaint.hpp"
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

namespace {

using nlohmann::json;

constexpr double kLongest_us = 1e12;

// One entry of the list, which it can complain about.
class Entry {
 public:
  Entry(const std::filesystem::path& file, std::size_t index, const json& value)
      : where_(fmt::format("{}: [{}]", file.string(), index)), value_(value) {
    if (!value.is_object()) {
      refuse("", "must be an object with name, id, bytes, period_us, jitter_us and deadline_us");
    }
    check_keys();
    where_ += fmt::format(" '{}'", text("name"));
  }

  [[noreturn]] void refuse(std::string_view field, std::string_view rule) const {
    if (field.empty()) {
      throw std::invalid_argument(fmt::format("{}: {}", where_, rule));
    }
    const std::string key(field);
    throw std::invalid_argument(
        fmt::format("{} {} = {}: {}", where_, field, value_.contains(key) ? value_[key].dump() : "", rule));
  }

  [[nodiscard]] bool has(const char* key) const { return value_.contains(key); }
  [[nodiscard]] std::string text(const char* key) const {
    if (!value_[key].is_string() || value_[key].get_ref<const std::string&>().empty()) {
      refuse(key, "must be a text that is not empty");
    }
    return value_[key].get<std::string>();
  }
  [[nodiscard]] bool flag(const char* key) const {
    if (has(key) && !value_[key].is_boolean()) {
      refuse(key, "must be true or false");
    }
    return has(key) && value_[key].get<bool>();
  }
  [[nodiscard]] std::int64_t whole(const char* key, std::int64_t highest, std::string_view remedy) const {
    const double number = value_[key].is_number() ? value_[key].get<double>() : -1.0;
    if (!(number >= 0.0 && number <= static_cast<double>(highest)) || number != std::floor(number)) {
      refuse(key, fmt::format("must be a whole number 0..{}. {}", highest, remedy));
    }
    return static_cast<std::int64_t>(number);
  }
  [[nodiscard]] std::int64_t time_ns(const char* key, bool zero_allowed) const {
    constexpr double kNanosecond_us = 1e-3;
    const double number = value_[key].is_number() ? value_[key].get<double>() : -1.0;
    if (!(number >= (zero_allowed ? 0.0 : kNanosecond_us) && number <= kLongest_us)) {
      refuse(key, fmt::format("must be a number of microseconds, {} 0 and at most {:.0e}",
                              zero_allowed ? "at least" : "above", kLongest_us));
    }
    return std::llround(number * 1e3);
  }

 private:
  void check_keys() const {
    static const std::vector<std::string> kRequired{"name",      "id",        "bytes",
                                                    "period_us", "jitter_us", "deadline_us"};
    std::vector<std::string> known = kRequired;
    known.insert(known.end(), {"extended", "fifo"});
    for (const auto& [key, unused] : value_.items()) {
      if (std::ranges::find(known, key) == known.end()) {
        refuse("", fmt::format("key '{}': there is no such key. {}", key, input::suggest(key, known)));
      }
    }
    for (const std::string& key : kRequired) {
      if (!value_.contains(key)) {
        refuse("", fmt::format("{} is missing. Every message needs name, id, bytes, period_us, jitter_us and "
                               "deadline_us",
                               key));
      }
    }
  }

  std::string where_;
  const json& value_;
};

can::AnalysedMessage message_of(const Entry& entry, std::map<std::string, int>& fifos) {
  can::AnalysedMessage message;
  message.name = entry.text("name");
  message.extended = entry.flag("extended");
  message.id = static_cast<std::uint32_t>(
      entry.whole("id", message.extended ? can::kLargestExtendedId : can::kLargestId,
                  message.extended ? "An identifier has at most 29 bits"
                                   : "Write \"extended\": true for a 29-bit identifier"));
  message.bytes = static_cast<int>(entry.whole("bytes", 8, "A CAN frame carries no more; split the message"));
  message.period_ns = entry.time_ns("period_us", false);
  message.jitter_ns = entry.time_ns("jitter_us", true);
  message.deadline_ns = entry.time_ns("deadline_us", false);
  if (entry.has("fifo")) {
    message.fifo = fifos.try_emplace(entry.text("fifo"), static_cast<int>(fifos.size())).first->second;
  }
  return message;
}

json parse(const std::filesystem::path& file) {
  std::ifstream in(file);
  if (!in || std::filesystem::is_directory(file)) {
    throw std::invalid_argument(
        fmt::format("{}: cannot be read. Name a file that holds a JSON list of messages", file.string()));
  }
  try {
    return json::parse(in);
  } catch (const json::exception& error) {
    throw std::invalid_argument(fmt::format("{}: malformed JSON: {}", file.string(), error.what()));
  }
}

}  // namespace

std::vector<can::AnalysedMessage> read_message_list(const std::filesystem::path& file) {
  const json list = parse(file);
  if (!list.is_array() || list.empty()) {
    throw std::invalid_argument(fmt::format(
        "{}: must be a list of at least one message: [{{\"name\": ..., \"id\": ...}}, ...]", file.string()));
  }
  std::vector<can::AnalysedMessage> messages;
  std::map<std::string, int> fifos;
  std::map<std::uint32_t, std::size_t> taken;  // by arbitration
  for (std::size_t i = 0; i < list.size(); ++i) {
    const Entry entry(file, i, list[i]);
    messages.push_back(message_of(entry, fifos));
    const can::AnalysedMessage& message = messages.back();
    const auto [first, fresh] =
        taken.try_emplace(can::arbitration_key({.id = message.id, .extended = message.extended}), i);
    if (!fresh) {
      entry.refuse("id", fmt::format("[{}] '{}' has it already. Give each message an identifier of its own",
                                     first->second, messages[first->second].name));
    }
  }
  return messages;
}

}  // namespace gaitway::tools
