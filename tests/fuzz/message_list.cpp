// Lists of messages as users write them for the bus analysis (tools/bus/bus_options.hpp). Whatever the text:
// it is refused with std::invalid_argument and nothing else, or gives messages that the analysis takes, with
// a response for each that is no shorter than its own frame.
#include "tools/bus/bus_options.hpp"

#include <cstdint>
#include <span>
#include <stdexcept>
#include <vector>

#include "fuzz_input.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/facts/facts.hpp"
#include "memory_file.hpp"

namespace gaitway::fuzz {

void message_list(std::span<const std::uint8_t> bytes) {
  const MemoryFile file(Input(bytes).rest_as_text());
  std::vector<can::AnalysedMessage> messages;
  try {
    messages = tools::read_message_list(file.path());
  } catch (const std::invalid_argument&) {
    return;
  }
  require(!messages.empty(), "a list holds messages");
  for (const can::AnalysedMessage& message : messages) {
    require(can::is_valid({.id = message.id,
                           .size = static_cast<std::uint8_t>(message.bytes),
                           .extended = message.extended}),
            "every message has a frame");
  }
  constexpr std::size_t kQuicklyAnalysed = 4;
  if (messages.size() > kQuicklyAnalysed) {
    return;
  }
  using facts::kBitTime_ns;
  const auto responses = can::response_times(messages, {.bit_time_ns = kBitTime_ns, .errors = {}});
  require(responses.size() == messages.size(), "every message has a response");
  for (const can::MessageResponse& response : responses) {
    require(!response.worst_response_ns || *response.worst_response_ns >= response.length_bits * kBitTime_ns,
            "no response is shorter than its frame");
  }
}

}  // namespace gaitway::fuzz
