// How often an end of the link speaks, how long it waits, and into which pieces it cuts what is large.
#pragma once

#include <cstddef>
#include <cstdint>

#include "gaitway/facts/facts.hpp"

namespace gaitway::link {

inline constexpr std::size_t kMostStateWindow = 32;  // bits of Status::state_received

// The two ends need not agree on them, but for `silence_ns`, which must be longer than the other's
// `status_period_ns`.
struct LinkSettings {
  std::int64_t hello_period_ns = 50 * facts::kMillisecond_ns;   // while there is no session
  std::int64_t status_period_ns = 20 * facts::kMillisecond_ns;  // the longest pause between two of them
  // So long without a whole frame of the session, and it is over.
  std::int64_t silence_ns = 250 * facts::kMillisecond_ns;
  // A part or a state frame that is not confirmed by then was lost. Longer than a round trip takes at worst.
  std::int64_t resend_after_ns = 25 * facts::kMillisecond_ns;
  std::int64_t stop_repeat_ns = 10 * facts::kMillisecond_ns;  // until it is known to be obeyed
  // An order that nobody has answered so long after its expiry is reported as unanswered.
  std::int64_t answer_limit_ns = 500 * facts::kMillisecond_ns;
  std::size_t fragment_bytes = 72;  // of a message or a value in one frame: 8 .. kMostFragmentBytes
  std::size_t state_window = 16;    // state frames under way at a time: 1 .. kMostStateWindow
};

// Throws std::invalid_argument that names the value and its rule.
void check(const LinkSettings& settings);

}  // namespace gaitway::link
