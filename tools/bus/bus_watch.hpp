// What a listener can know of a robot's bus: load, rates, exact lengths, how long answers take, which frames
// belong to no message, which nodes are silent. Passive, and the same for a live bus, a log and the simulated
// one.
//
// A listener sees neither when a sender wanted to send nor what it holds back. Responses are therefore given
// only where the instant of release is itself seen on the bus, or is an edge of the robot's own clock:
//
//   message      profile       from                                          to
//   SYNC         full          the slot's edge (robot's clock only)           its last bit
//   feedback     full          the last bit of the SYNC that it answers       its last bit
//   trajectory   full          the first bit of the first frame of its batch  its last bit (at least so long)
//   trajectory   paper         the cycle's edge (robot's clock only)          its last bit
//   feedback     paper         the last bit of its node's trajectory frame    its last bit
//
// In the full profile a batch is released at a hand-over, which no listener sees: what is shown is the least
// that the response can have been.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "gaitway/can/bus_port.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {

// How a quantity is spread: how often it was seen, its mean and its extremes.
struct Spread {
  std::uint64_t count = 0;
  double sum = 0.0;
  double min = std::numeric_limits<double>::infinity();
  double max = -std::numeric_limits<double>::infinity();

  void add(double value) noexcept {
    ++count;
    sum += value;
    min = std::min(min, value);
    max = std::max(max, value);
  }
  // Only of a quantity that was seen.
  [[nodiscard]] double mean() const noexcept { return count == 0 ? 0.0 : sum / static_cast<double>(count); }
};

// Where the times of the frames come from.
enum class BusClock : std::uint8_t {
  robot,  // the clock of the message controller: slots begin at its multiples of 10 ms
  other   // any other: only differences mean something
};

// Of all frames of one message, or of one identifier.
struct MessageFigures {
  std::uint64_t frames = 0;
  std::uint64_t frames_in_window = 0;
  Spread length_us;    // interframe space included, from the frame's content
  Spread interval_ms;  // between the ends of two frames of one identifier (both toggles are one)
  Spread response_ms;  // as of the table above
};

// Why a frame belongs to none of the profile's messages.
enum class Stranger : std::uint8_t { unknown_identifier, wrong_size, extended, remote };
inline constexpr std::size_t kStrangers = 4;

struct NodeFigures {
  std::int64_t last_heard_ns = 0;
  std::uint64_t feedbacks = 0;
  can::JointState state = can::JointState::holding;
  std::uint8_t faults = 0;  // of the last fault report
};

// Since the last call of close_window().
struct BusWindow {
  double seconds = 0.0;
  double load = 0.0;  // interframe spaces included
  double frames_per_s = 0.0;
  std::array<double, can::kMessageKinds> rate_per_s{};
};

class BusWatch {
 public:
  // `nodes`: those whose feedback is expected.
  BusWatch(const can::Profile& profile, std::span<const can::NodeId> nodes, BusClock clock);

  // Frames in the order of the bus.
  void take(const can::TimedFrame& frame);
  // What an interface reported about errors.
  void take_error_reports(std::uint64_t count) noexcept { error_reports_ += count; }
  // Ends the window at `now_ns`, of the frames' clock; the next one begins.
  BusWindow close_window(std::int64_t now_ns);

  [[nodiscard]] const can::Profile& profile() const noexcept { return profile_; }
  [[nodiscard]] BusClock clock() const noexcept { return clock_; }
  [[nodiscard]] std::uint64_t frames() const noexcept { return frames_; }
  // From the first frame's first bit to the last one's last.
  [[nodiscard]] double seconds() const noexcept;
  [[nodiscard]] std::int64_t last_ns() const noexcept { return last_ns_; }
  [[nodiscard]] double load() const noexcept;
  [[nodiscard]] const MessageFigures& message(can::MessageKind kind) const noexcept {
    return messages_[static_cast<std::size_t>(kind)];
  }
  // Every identifier that was heard, of base frames with a message of the profile.
  [[nodiscard]] const std::map<std::uint32_t, MessageFigures>& identifiers() const noexcept {
    return identifiers_;
  }
  // Where the response of a message is measured from; empty when a listener cannot know.
  [[nodiscard]] std::string_view response_from(can::MessageKind kind) const noexcept;
  [[nodiscard]] std::uint64_t strangers(Stranger cause) const noexcept {
    return strangers_[static_cast<std::size_t>(cause)];
  }
  [[nodiscard]] std::uint64_t strangers() const noexcept;
  [[nodiscard]] const std::optional<can::Frame>& last_stranger() const noexcept { return last_stranger_; }
  [[nodiscard]] std::uint64_t error_reports() const noexcept { return error_reports_; }
  [[nodiscard]] const std::map<can::NodeId, NodeFigures>& nodes() const noexcept { return nodes_; }
  // Nodes that sent no feedback in the last two time slots.
  [[nodiscard]] std::vector<can::NodeId> silent_nodes() const;

 private:
  [[nodiscard]] std::optional<Stranger> stranger(
      const can::Frame& frame, const std::optional<can::Identified>& message) const noexcept;
  void learn(const can::TimedFrame& frame, const can::Identified& message);
  [[nodiscard]] std::optional<std::int64_t> released_ns(const can::TimedFrame& frame,
                                                        const can::Identified& message);
  [[nodiscard]] std::optional<std::int64_t> feedback_released_ns(const can::TimedFrame& frame,
                                                                 can::NodeId node);
  [[nodiscard]] std::int64_t batch_began_ns(const can::TimedFrame& frame, const can::Identified& message);

  can::Profile profile_;
  BusClock clock_;
  std::array<MessageFigures, can::kMessageKinds> messages_;
  std::map<std::uint32_t, MessageFigures> identifiers_;
  std::map<std::uint32_t, std::int64_t> last_end_ns_;  // of each identifier; toggles are one
  std::map<can::NodeId, NodeFigures> nodes_;
  std::array<std::uint64_t, kStrangers> strangers_{};
  std::optional<can::Frame> last_stranger_;
  std::uint64_t error_reports_ = 0;

  std::uint64_t frames_ = 0;
  std::int64_t busy_ns_ = 0;
  std::int64_t first_ns_ = 0, last_ns_ = 0;
  std::uint64_t frames_in_window_ = 0;
  std::int64_t busy_in_window_ns_ = 0;
  std::optional<std::int64_t> window_start_ns_;

  std::map<can::NodeId, std::int64_t> unanswered_since_ns_;  // what the node's next feedback answers
  std::map<can::NodeId, bool> in_batch_;                     // nodes whose frame of this batch has come
  std::int64_t batch_start_ns_ = 0;
};

}  // namespace gaitway::tools
