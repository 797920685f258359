// Messages of the robot API out of JSON, and texts into JSON and CBOR (userinterface/messages). Whatever the
// text: it is no JSON, or it is refused with MessageError and a short printable reason, or what is read is
// finite and stays the same when it is written and read again. Whatever the bytes: as a text they become JSON
// and CBOR that decoders take.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <span>
#include <string>
#include <string_view>

#include "fuzz_input.hpp"
#include "gaitway/api/cbor_codec.hpp"
#include "gaitway/api/json_codec.hpp"
#include "gaitway/api/json_reader.hpp"
#include "gaitway/api/rosapi_types.hpp"
#include "gaitway/api/service_types.hpp"

namespace gaitway::fuzz {
namespace {

using nlohmann::json;

bool is_printable(std::string_view text) {
  return std::none_of(text.begin(), text.end(),
                      [](char c) { return static_cast<unsigned char>(c) < 0x20 || c == '\x7f'; });
}

template <api::Message M>
std::string written(const M& message) {
  std::string text;
  api::append_json(text, message);
  return text;
}

template <api::Message M>
bool check(const json& value, M& message) {
  try {
    api::from_json(value, message);
  } catch (const api::MessageError& error) {
    constexpr std::size_t kLongestReason = 2000;
    require(std::string_view(error.what()).size() < kLongestReason, "reasons are short");
    require(is_printable(error.what()), "reasons are printable");
    return false;
  }
  const std::string text = written(message);
  M again;
  api::from_json(json::parse(text), again);
  require(written(again) == text, "what was read is written and read again as the same");
  return true;
}

void check_text(std::string_view bytes) {
  std::string text, cbor;
  api::append_json_string(text, bytes);
  const json from_text = json::parse(text, nullptr, false);
  require(from_text.is_string(), "any bytes become a JSON string");
  api::append_cbor_text(cbor, bytes);
  require(json::from_cbor(cbor) == from_text, "and the same text in CBOR");
}

}  // namespace

void api_messages(std::span<const std::uint8_t> bytes) {
  const std::string_view text = Input(bytes).rest_as_text();
  check_text(text);
  const json value = json::parse(text, nullptr, false);
  if (value.is_discarded()) {
    return;
  }
  api::ros::Twist twist;
  if (check(value, twist)) {
    for (const api::ros::Vector3& part : {twist.linear, twist.angular}) {
      require(std::isfinite(part.x) && std::isfinite(part.y) && std::isfinite(part.z), "numbers are finite");
    }
  }
  api::ros::MoveJoint::Request move;
  check(value, move);
  api::ros::Log log;
  check(value, log);
  api::ros::TypeDef definition;
  check(value, definition);
  api::ros::Odometry odometry;
  check(value, odometry);
}

}  // namespace gaitway::fuzz
