#include "client_message.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaitway::api {
namespace {

using nlohmann::json;

constexpr std::size_t kShownBytes = 80;

// Walks over a text without keeping anything; says at what depth or byte it is to be refused.
class Inspector final : public nlohmann::json_sax<json> {
 public:
  explicit Inspector(std::size_t most_depth) : most_depth_(most_depth) {}
  [[nodiscard]] const std::string& complaint() const noexcept { return complaint_; }

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool key(string_t&) override { return true; }
  bool start_object(std::size_t) override { return deeper(); }
  bool start_array(std::size_t) override { return deeper(); }
  bool end_object() override { return higher(); }
  bool end_array() override { return higher(); }
  bool parse_error(std::size_t position, const std::string&, const json::exception& error) override {
    constexpr int kNumberOverflow = 406;
    complaint_ = error.id == kNumberOverflow
                     ? "a number before byte " + std::to_string(position) + " is too large for a double"
                     : "the message is not JSON in UTF-8: see byte " + std::to_string(position);
    return false;
  }

 private:
  bool deeper() {
    if (++depth_ > most_depth_) {
      complaint_ =
          "the message is nested too deeply: at most " + std::to_string(most_depth_) + " levels are read";
      return false;
    }
    return true;
  }
  bool higher() {
    --depth_;
    return true;
  }

  std::size_t most_depth_;
  std::size_t depth_ = 0;
  std::string complaint_;
};

const json* find(const json& message, const char* field) {
  const auto found = message.find(field);
  return found == message.end() || found->is_null() ? nullptr : &*found;
}

[[noreturn]] void refuse(const char* field, const json& value, const std::string& rule) {
  throw Refused(std::string(field) + " is " + shown_json(value) + ", but must be " + rule);
}

}  // namespace

json parse_message(std::string_view text, std::size_t most_depth) {
  Inspector inspector(most_depth);
  if (!json::sax_parse(text, &inspector)) {
    throw Refused(inspector.complaint());
  }
  json message = json::parse(text);
  if (!message.is_object()) {
    throw Refused("the message is " + shown_json(message) + ", but must be an object with a field \"op\"");
  }
  return message;
}

std::optional<std::string> optional_text(const json& message, const char* field) {
  const json* const value = find(message, field);
  if (value == nullptr) {
    return std::nullopt;
  }
  if (!value->is_string()) {
    refuse(field, *value, "a text");
  }
  return value->get<std::string>();
}

std::string name_in(const json& message, const char* field) {
  auto text = optional_text(message, field);
  if (!text) {
    throw Refused(std::string(field) + " is missing");
  }
  if (text->empty() || text->size() > kMostNameBytes) {
    refuse(field, *text, "a text of 1 to " + std::to_string(kMostNameBytes) + " bytes");
  }
  return *std::move(text);
}

std::uint64_t whole_number(const json& message, const char* field, std::uint64_t otherwise,
                           std::uint64_t most) {
  const json* const value = find(message, field);
  if (value == nullptr) {
    return otherwise;
  }
  const std::string rule = "a whole number from 0 to " + std::to_string(most);
  if (value->is_number_unsigned() && value->get<std::uint64_t>() <= most) {
    return value->get<std::uint64_t>();
  }
  // Some clients write 100.0.
  if (value->is_number_float()) {
    const double number = value->get<double>();
    if (number >= 0.0 && number <= static_cast<double>(most) && std::floor(number) == number) {
      return static_cast<std::uint64_t>(number);
    }
  }
  refuse(field, *value, rule);
}

json id_in(const json& message) {
  const json* const id = find(message, "id");
  if (id == nullptr) {
    return nullptr;
  }
  if (!id->is_number_integer() &&
      !(id->is_string() && id->get_ref<const std::string&>().size() <= kMostNameBytes)) {
    refuse("id", *id, "a whole number or a text of at most " + std::to_string(kMostNameBytes) + " bytes");
  }
  return *id;
}

void require_short(const char* field, const std::string& value, std::size_t most) {
  const bool printable = std::ranges::none_of(
      value, [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; });
  if (value.size() > most || !printable) {
    throw Refused(std::string(field) + " is " + shown(value) + ", but must be a text of at most " +
                  std::to_string(most) + " bytes without control characters");
  }
}

std::string shown_json(const json& value) {
  if (value.is_structured()) {
    return value.is_object() ? "an object" : "a list";
  }
  if (value.is_string()) {
    return shown(value.get_ref<const std::string&>());
  }
  return value.dump();
}

std::string shown(std::string_view text) {
  std::size_t end = text.size();
  const bool cut = end > kShownBytes;
  if (cut) {
    end = kShownBytes;
    while (end > 0 && (static_cast<unsigned char>(text[end]) & 0xC0U) == 0x80U) {
      --end;
    }
  }
  return json(text.substr(0, end)).dump(-1, ' ', false, json::error_handler_t::replace) + (cut ? "..." : "");
}

}  // namespace gaitway::api
