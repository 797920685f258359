// The socketcand protocol as clients of the served bus speak it (can/simulated). Whatever they
// send, in pieces of any size: elements are found the same however the text is cut, none is longer than
// allowed; each is a command with a valid frame and times in range, or a rejection that holds no bracket; and
// what is told to clients is one element each.
#include "gaitway/can/simulated/socketcand_protocol.hpp"

#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "fuzz_frame.hpp"

namespace gaitway::fuzz {
namespace {

using namespace can::socketcand;

std::vector<ElementReader::Element> elements_of(std::string_view text, Input cuts) {
  ElementReader reader;
  std::vector<ElementReader::Element> elements;
  while (!text.empty()) {
    const std::size_t length = cuts.empty() ? text.size() : std::min(text.size(), 1 + cuts.choose(32));
    std::string_view piece = text.substr(0, length);
    text.remove_prefix(length);
    ElementReader::Element element;
    while (reader.next(piece, element)) {
      require(element.text.size() <= kLongestElement && element.text.empty() == element.too_long,
              "no element is longer than allowed");
      elements.push_back(element);
    }
  }
  return elements;
}

bool is_one_element(std::string_view text) {
  return text.size() >= 4 && text.substr(0, 2) == "< " && text.substr(text.size() - 2) == " >" &&
         std::count(text.begin(), text.end(), '<') == 1 && std::count(text.begin(), text.end(), '>') == 1 &&
         std::all_of(text.begin(), text.end(), [](char c) { return c >= ' ' && c <= '~'; });
}

void check_element(std::string_view element) {
  const auto parsed = parse_element(element);
  if (const auto* const rejection = std::get_if<Rejection>(&parsed)) {
    std::string told;
    append_error(told, rejection->reason);
    require(is_one_element(told), "a rejection is told in one element");
    return;
  }
  const auto& command = std::get<Command>(parsed);
  require(can::is_valid(command.frame), "a command has a valid frame");
  require(command.interval_ns >= 0 && command.interval_ns <= kLongestInterval_ns, "intervals are in range");
  require(command.bus.size() <= kLongestBusName, "names are in range");
  if (command.verb == Verb::send && !command.frame.remote) {
    std::string told;
    append_frame(told, command.frame, 0);
    require(is_one_element(told), "a frame is told in one element");
  }
}

}  // namespace

void socketcand_protocol(std::span<const std::uint8_t> bytes) {
  Input input(bytes);
  const Input cuts(input.take_bytes(4));
  const std::string_view text = input.rest_as_text();
  const auto elements = elements_of(text, cuts);
  const auto uncut = elements_of(text, Input({}));
  require(
      std::equal(elements.begin(), elements.end(), uncut.begin(), uncut.end(),
                 [](const auto& a, const auto& b) { return a.text == b.text && a.too_long == b.too_long; }),
      "it does not matter how the text is cut");
  for (const ElementReader::Element& element : elements) {
    check_element(element.text);
  }
  check_element(text.substr(0, std::min(text.size(), kLongestElement)));
}

}  // namespace gaitway::fuzz
