// What an order and its answer are, to those who give, carry out and answer them.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gaitway/link/frame_codec.hpp"
#include "gaitway/link/message_lane.hpp"

namespace gaitway::link {

// Unique among all orders of one module.
struct OrderId {
  std::uint32_t session = 0;  // the module's count
  std::uint32_t number = 0;   // from 1 on in a session
  bool operator==(const OrderId&) const = default;
};

// In front of the payloads: expiry and kind of an order; number, verdict and result of an answer.
inline constexpr std::size_t kOrderHeadBytes = 10;
inline constexpr std::size_t kAnswerHeadBytes = 7;
inline constexpr std::size_t kMostOrderBytes = kMostMessageBytes - kOrderHeadBytes;
inline constexpr std::size_t kMostAnswerBytes = kMostMessageBytes - kAnswerHeadBytes;
// Given and not answered, or answered and not confirmed, at a time.
inline constexpr std::size_t kMostOpenOrders = kLaneMessages;

// What became of an order that was given.
enum class Verdict : std::uint8_t {
  answered = 1,   // by who carries orders out; `result` and payload are his
  late = 2,       // refused: its expiry had passed before it was carried out
  unanswered = 3  // the session ended, or nobody answered in time: it may have been carried out or not
};

// Why an order was not even taken.
enum class Refusal : std::uint8_t {
  none,
  no_session,  // the controller is not there; nothing is kept for later
  full,        // kMostOpenOrders are open
  too_long,    // more than kMostOrderBytes
  expired      // the robot's time is past the expiry already
};

}  // namespace gaitway::link
