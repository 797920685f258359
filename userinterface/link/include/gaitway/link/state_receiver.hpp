// The robot's state as it arrives: each channel's newest whole value, with its age.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "gaitway/link/messages.hpp"
#include "gaitway/link/state_sender.hpp"

namespace gaitway::link {

// A channel's newest whole value. `bytes` stays valid and unchanged until more bytes come from the carrier.
struct StateValue {
  Bytes bytes;
  std::int64_t stamp_ns = 0;     // the robot's time
  std::int64_t received_ns = 0;  // this end's time
  std::uint64_t updates = 0;     // how many whole values have come; 0: none yet
};

// Allocates in the constructor only.
class StateReceiver {
 public:
  explicit StateReceiver(std::span<const Channel> channels);

  // False: no such channel, or it holds less; the fragment is left out.
  bool take(const StateFragment& fragment, std::int64_t now_ns) noexcept;
  // Writes what has arrived into a status.
  void confirm_in(Status& status) noexcept;
  // For a new session. Values stay, and age.
  void reset() noexcept;

  // A channel whose value is new since this was last asked, the channels by turns; nothing when none is.
  std::optional<std::size_t> next_changed() noexcept;
  [[nodiscard]] const StateValue& value(std::size_t channel) const { return states_.at(channel).value; }
  // Frames that arrived since confirm_in().
  [[nodiscard]] std::size_t unconfirmed() const noexcept { return unconfirmed_; }

 private:
  struct State {
    std::vector<std::uint8_t> whole, partial;
    StateValue value;
    std::vector<bool> arrived;  // fragments of `partial`
    std::size_t missing = 0;
    std::uint16_t version = 0;  // of `partial`, or of what it became
    std::uint32_t total_bytes = 0;
    std::uint8_t fragment_bytes = 0;
    bool begun = false, changed = false;
  };

  void note(std::uint16_t sequence) noexcept;
  void begin(State& state, const StateFragment& fragment) const noexcept;
  static void finish(State& state, std::int64_t now_ns) noexcept;

  std::vector<State> states_;
  std::uint16_t newest_sequence_ = 0;
  std::uint32_t received_ = 0;  // Status::state_received
  std::size_t unconfirmed_ = 0;
  std::size_t turn_ = 0;
};

}  // namespace gaitway::link
