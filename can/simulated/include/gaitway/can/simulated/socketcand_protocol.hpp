// The text of the socketcand protocol: what a client may say, taken apart and checked, and how frames are
// told to it. Elements stand between angle brackets: "< send 123 2 1a ff >". Pure functions of their input.
// Protocol: doc/protocol.md of linux-can/socketcand.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <variant>

#include "gaitway/can/frame.hpp"

namespace gaitway::can::socketcand {

// Longest element, brackets included; a longer one is refused.
inline constexpr std::size_t kLongestElement = 512;
// Longest name of a bus, and longest interval of a job, a throttle or the statistics.
inline constexpr std::size_t kLongestBusName = 16;
inline constexpr std::int64_t kLongestInterval_ns = std::int64_t{86'400} * 1'000'000'000;

enum class Verb : std::uint8_t {
  open,         // bus
  configure,    // bus: bit timing or control mode
  echo,         //
  rawmode,      //
  bcmmode,      //
  controlmode,  //
  isotpmode,    //
  send,         // frame
  add,          // interval, frame
  update,       // frame
  erase,        // frame's identifier ("delete")
  subscribe,    // interval, frame's identifier
  filter,       // interval, frame: its data are the mask of the bits whose change matters
  unsubscribe,  // frame's identifier
  muxfilter,    //
  statistics    // interval
};

struct Command {
  Verb verb = Verb::echo;
  std::string bus;
  std::int64_t interval_ns = 0;
  Frame frame;
};

// Why an element is none, for its sender. Holds no angle bracket, whatever was sent.
struct Rejection {
  std::string reason;
};

// One element with its brackets. A frame with a size but without data is a remote frame: so python-can writes
// one.
std::variant<Command, Rejection> parse_element(std::string_view element);

// Finds the elements in what comes from a client, in pieces of any size. What stands between elements is
// skipped, as the protocol's server does.
class ElementReader {
 public:
  struct Element {
    bool too_long = false;  // more than kLongestElement characters; the text is empty
    std::string text;
  };
  // Takes the characters of `input` up to the end of the next element away from it; false when there is none
  // yet and all of `input` has been taken.
  bool next(std::string_view& input, Element& element);

 private:
  std::string text_;       // of an element that has begun
  bool skipping_ = false;  // to the end of an element that is too long
};

// "< frame 123 23.424242 1A2203 >"; the time is cut to microseconds and not negative. Remote frames cannot be
// told in this protocol: nothing is appended.
void append_frame(std::string& text, const Frame& frame, std::int64_t time_ns);
// "< error … >": angle brackets and control characters in `reason` become blanks and question marks.
void append_error(std::string& text, std::string_view reason);

// What a client has received and transmitted.
struct Traffic {
  std::uint64_t received_bytes = 0, received_frames = 0;
  std::uint64_t transmitted_bytes = 0, transmitted_frames = 0;
};
void append_statistics(std::string& text, const Traffic& traffic);

}  // namespace gaitway::can::socketcand
