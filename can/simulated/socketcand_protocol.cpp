// Reads and writes the socketcand protocol's text: words of an element, one after the other, each checked as
// what the command expects there.
#include "gaitway/can/simulated/socketcand_protocol.hpp"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::can::socketcand {
namespace {

constexpr std::string_view kBlanks = " \t\r\n";
constexpr std::string_view kHex = "0123456789ABCDEF";
// Linux marks extended identifiers with it; some clients send it along.
constexpr std::uint64_t kExtendedFlag = 0x8000'0000U;
constexpr std::int64_t kMicrosecond_ns = 1'000;
using facts::kMillisecond_ns;
using facts::kSecond_ns;

// What an element breaks; caught within this file.
class Refused : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

std::string quoted(std::string_view word) {
  constexpr std::size_t kShown = 24;
  std::string text = "'";
  text += word.substr(0, kShown);
  text += word.size() > kShown ? "...'" : "'";
  return text;
}

class Words {
 public:
  explicit Words(std::string_view text) : rest_(text) {}

  // Empty at the end.
  std::string_view next() {
    const std::size_t begin = std::min(rest_.find_first_not_of(kBlanks), rest_.size());
    rest_.remove_prefix(begin);
    const std::size_t end = std::min(rest_.find_first_of(kBlanks), rest_.size());
    const std::string_view word = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return word;
  }
  [[nodiscard]] bool at_end() const { return rest_.find_first_not_of(kBlanks) == std::string_view::npos; }

 private:
  std::string_view rest_;
};

std::optional<std::uint64_t> number(std::string_view word, int base) {
  std::uint64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value, base);
  if (word.empty() || error != std::errc() || end != word.data() + word.size()) {
    return std::nullopt;
  }
  return value;
}

std::uint64_t count(Words& words, std::string_view what, std::uint64_t largest) {
  const std::string_view word = words.next();
  const auto value = number(word, 10);
  if (!value || *value > largest) {
    throw Refused(quoted(word) + ": " + std::string(what) + " must be a whole number from 0 to " +
                  std::to_string(largest));
  }
  return *value;
}

std::int64_t interval(Words& words) {
  constexpr auto kMost_s = static_cast<std::uint64_t>(kLongestInterval_ns / kSecond_ns);
  const auto seconds = static_cast<std::int64_t>(count(words, "the seconds of the interval", kMost_s));
  const auto us =
      static_cast<std::int64_t>(count(words, "the microseconds of the interval", kMost_s * 1'000'000));
  return std::min(seconds * kSecond_ns + us * kMicrosecond_ns, kLongestInterval_ns);
}

// A byte as it is, or sign-extended to 32 or 64 bits, as SavvyCAN writes one from 80 on.
std::optional<std::uint8_t> byte(std::string_view word) {
  const auto value = number(word, 16);
  const bool extended_to_32 = word.size() == 8 && value >= 0xFFFF'FF80U;
  const bool extended_to_64 = word.size() == 16 && value >= 0xFFFF'FFFF'FFFF'FF80U;
  if (!value || (word.size() > 2 && !extended_to_32 && !extended_to_64)) {
    return std::nullopt;
  }
  return static_cast<std::uint8_t>(*value & 0xFFU);
}

// The number of digits tells the formats apart: 8 for an extended identifier, at most 3 for a base one.
void identifier(Words& words, Frame& frame) {
  const std::string_view word = words.next();
  auto value = number(word, 16);
  frame.extended = word.size() == 8;
  if (value && frame.extended) {
    *value &= ~kExtendedFlag;
  }
  const std::uint32_t largest = frame.extended ? kLargestExtendedId : kLargestId;
  if (!value || *value > largest || (!frame.extended && word.size() > 3)) {
    throw Refused(
        quoted(word) +
        ": an identifier has 1 to 3 hexadecimal digits (at most 7FF), or 8 if it is an extended one "
        "(at most 1FFFFFFF)");
  }
  frame.id = static_cast<std::uint32_t>(*value);
}

void data(Words& words, Frame& frame) {
  frame.size = static_cast<std::uint8_t>(count(words, "the number of data bytes", frame.data.size()));
  if (words.at_end()) {
    frame.remote = frame.size > 0;
    return;
  }
  for (std::size_t i = 0; i < frame.size; ++i) {
    const std::string_view word = words.next();
    const auto value = byte(word);
    if (!value) {
      throw Refused(quoted(word) + ": data byte " + std::to_string(i + 1) + " of " +
                    std::to_string(frame.size) + " must be one or two hexadecimal digits");
    }
    frame.data[i] = *value;
  }
}

void bus(std::string_view name, Command& command) {
  if (name.empty() || name.size() > kLongestBusName) {
    throw Refused(quoted(name) + ": the name of a bus has 1 to " + std::to_string(kLongestBusName) +
                  " characters");
  }
  command.bus = name;
}

void filter_mask(Words& words, Frame& frame) {
  data(words, frame);
  if (frame.remote) {
    throw Refused("the mask of a filter is missing: give as many bytes as announced");
  }
}

struct Syntax {
  std::string_view word;
  Verb verb;
  void (*arguments)(Words&, Command&);
};

constexpr auto kNothing = [](Words&, Command&) {};
constexpr auto kFrame = [](Words& words, Command& command) {
  identifier(words, command.frame);
  data(words, command.frame);
};
constexpr auto kIdentifier = [](Words& words, Command& command) { identifier(words, command.frame); };

constexpr Syntax kSyntax[]{
    {"open", Verb::open, [](Words& words, Command& command) { bus(words.next(), command); }},
    {"echo", Verb::echo, kNothing},
    {"rawmode", Verb::rawmode, kNothing},
    {"bcmmode", Verb::bcmmode, kNothing},
    {"controlmode", Verb::controlmode, kNothing},
    {"isotpmode", Verb::isotpmode, kNothing},
    {"send", Verb::send, kFrame},
    {"add", Verb::add,
     [](Words& words, Command& command) {
       command.interval_ns = interval(words);
       kFrame(words, command);
     }},
    {"update", Verb::update, kFrame},
    {"delete", Verb::erase, kIdentifier},
    {"subscribe", Verb::subscribe,
     [](Words& words, Command& command) {
       command.interval_ns = interval(words);
       kIdentifier(words, command);
     }},
    {"filter", Verb::filter,
     [](Words& words, Command& command) {
       command.interval_ns = interval(words);
       identifier(words, command.frame);
       filter_mask(words, command.frame);
     }},
    {"unsubscribe", Verb::unsubscribe, kIdentifier},
    {"statistics", Verb::statistics, [](Words& words, Command& command) {
       constexpr auto kMost_ms = static_cast<std::uint64_t>(kLongestInterval_ns / kMillisecond_ns);
       command.interval_ns =
           static_cast<std::int64_t>(count(words, "the interval in milliseconds", kMost_ms)) *
           kMillisecond_ns;
     }}};

Command parse(std::string_view inside) {
  Words words(inside);
  const std::string_view verb = words.next();
  Command command;
  const auto* const known = std::ranges::find(kSyntax, verb, &Syntax::word);
  if (known != std::end(kSyntax)) {
    command.verb = known->verb;
    known->arguments(words, command);
    if (!words.at_end()) {
      throw Refused(quoted(words.next()) + ": there is more than '" + std::string(verb) + "' takes");
    }
    return command;
  }
  if (verb == "muxfilter") {
    command.verb = Verb::muxfilter;
    return command;
  }
  if (const std::string_view what = words.next(); what == "B" || what == "C") {
    command.verb = Verb::configure;
    bus(verb, command);
    return command;
  }
  throw Refused("unknown command " + quoted(verb));
}

void append_number(std::string& text, std::uint64_t value, std::ptrdiff_t width = 1) {
  char digits[20];
  char* const end = std::to_chars(std::begin(digits), std::end(digits), value).ptr;
  text.append(static_cast<std::size_t>(std::max<std::ptrdiff_t>(0, width - (end - digits))), '0');
  text.append(std::begin(digits), end);
}

}  // namespace

std::variant<Command, Rejection> parse_element(std::string_view element) {
  if (element.size() < 2 || element.front() != '<' || element.back() != '>') {
    return Rejection{"a command stands between angle brackets"};
  }
  try {
    return parse(element.substr(1, element.size() - 2));
  } catch (const Refused& refused) {
    return Rejection{refused.what()};
  }
}

bool ElementReader::next(std::string_view& input, Element& element) {
  while (!input.empty()) {
    const char character = input.front();
    input.remove_prefix(1);
    if (character == '<') {  // also within an element: what came before it was cut off
      text_.assign(1, character);
      skipping_ = false;
      continue;
    }
    if (skipping_) {
      skipping_ = character != '>';
      continue;
    }
    if (text_.empty()) {
      continue;
    }
    text_ += character;
    if (character == '>') {
      element = {false, std::exchange(text_, {})};
      return true;
    }
    if (text_.size() == kLongestElement) {
      text_.clear();
      skipping_ = true;
      element = {true, {}};
      return true;
    }
  }
  return false;
}

void append_frame(std::string& text, const Frame& frame, std::int64_t time_ns) {
  if (frame.remote) {
    return;
  }
  const auto time_us = static_cast<std::uint64_t>(std::max<std::int64_t>(time_ns, 0) / kMicrosecond_ns);
  text += "< frame ";
  for (unsigned digit = frame.extended ? 8 : 3; digit-- > 0;) {
    text += kHex[(frame.id >> (4 * digit)) & 0xFU];
  }
  text += ' ';
  append_number(text, time_us / 1'000'000);
  text += '.';
  append_number(text, time_us % 1'000'000, 6);
  text += ' ';
  for (const std::uint8_t byte : frame.payload()) {
    text += kHex[byte >> 4U];
    text += kHex[byte & 0xFU];
  }
  text += " >";
}

void append_error(std::string& text, std::string_view reason) {
  text += "< error ";
  std::ranges::transform(reason, std::back_inserter(text), [](char character) {
    const bool printable = character >= ' ' && character <= '~';
    return !printable ? '?' : character == '<' || character == '>' ? ' ' : character;
  });
  text += " >";
}

void append_statistics(std::string& text, const Traffic& traffic) {
  text += "< stat";
  for (const std::uint64_t value : {traffic.received_bytes, traffic.received_frames,
                                    traffic.transmitted_bytes, traffic.transmitted_frames}) {
    text += ' ';
    append_number(text, value);
  }
  text += " >";
}

}  // namespace gaitway::can::socketcand
