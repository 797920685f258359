// What the frames of the link say, down to the byte: README.md has the same as tables.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/link/frame_codec.hpp"

namespace gaitway::link {

// Raised with every change of a layout; two numbers do not talk to each other. A hello of any version begins
// with it, so that each can say so.
inline constexpr std::uint16_t kProtocolVersion = 2;

enum class Role : std::uint8_t { module = 1, controller = 2 };

enum class FrameKind : std::uint8_t { hello = 1, status = 2, stop = 3, stop_answer = 4, part = 5, state = 6 };

// Clocks count from 0, and nobody's has come so far: differences of times do not overflow.
inline constexpr std::int64_t kMostTime_ns = std::int64_t{1} << 62;

// Kind and session, in front of every content.
inline constexpr std::size_t kHeaderBytes = 5;

// One session of one run of a process. Two ends that know each other's have a session.
struct Identity {
  std::uint64_t boot = 0;      // random, chosen at the process's start
  std::uint32_t sessions = 0;  // how many this end has ended since
  bool operator==(const Identity&) const = default;
};

// "I am", and whom the sender has heard. Belongs to no session.
struct Hello {
  std::uint16_t version = kProtocolVersion;
  Role role = Role::module;
  bool open = false;                   // the sender has a session with `heard`
  Identity self{}, heard{};            // `heard`: zero while nobody was
  std::uint32_t table_hash = 0;        // of the channels and kinds of orders that both must agree on
  std::uint32_t robot_hash = 0;        // of the robot's description, on which both must agree, too
  std::uint16_t calibration_hash = 0;  // of what the robot was calibrated with, which may differ
  std::int64_t time_ns = 0;            // of the sender's clock
  std::array<char, 24> name{};         // of the sender, for texts; ended by 0 unless full
};

// What the sender has received, and how much more it can take.
struct Status {
  std::int64_t time_ns = 0;          // of the sender's clock: the robot's time, if it is the controller
  std::uint32_t message = 0;         // messages 1 .. `message` are complete
  std::uint8_t part = 0;             // and so many parts of the next one
  std::uint32_t message_limit = 0;   // there is room up to this message
  std::uint16_t state_sequence = 0;  // the newest state frame that arrived
  std::uint32_t state_received = 0;  // bit i: so did the one i before it (bit 0 clear: none yet)
};

// How many stops of each kind. Counts only rise, so a newer frame holds all older ones.
struct StopCounts {
  std::uint32_t stops = 0;  // of the walk
  std::uint32_t holds = 0;  // emergency stops that hold
  std::uint32_t softs = 0;  // emergency stops that let go
  bool operator==(const StopCounts&) const = default;
};

// Since the module's start: what was asked, and what it knows to be obeyed.
struct StopMessage {
  StopCounts asked{}, settled{};
};

struct StopAnswer {
  StopCounts obeyed;  // in the module's counts
};

// A piece of an order or of an answer.
struct Part {
  std::uint32_t message = 0;  // from 1 on in a session
  std::uint8_t part = 0;      // from 0 on
  std::uint8_t parts = 1;
  Bytes payload{};
};

// A piece of a channel's value. All but the last have `fragment_bytes`.
struct StateFragment {
  std::uint16_t sequence = 0;  // of the frame: one more for each state frame that is sent, also again
  std::uint8_t channel = 0;
  std::uint16_t version = 0;  // of the value: fragments of two versions are never mixed
  std::uint32_t total_bytes = 0;
  std::uint16_t fragment = 0;  // from 0 on
  std::uint8_t fragment_bytes = 0;
  Bytes payload{};
};

inline constexpr std::size_t kHelloContentBytes = kHeaderBytes + 70;
inline constexpr std::size_t kStatusContentBytes = kHeaderBytes + 23;
inline constexpr std::size_t kStopContentBytes = kHeaderBytes + 24;
inline constexpr std::size_t kStopAnswerContentBytes = kHeaderBytes + 12;
inline constexpr std::size_t kPartHeadBytes = kHeaderBytes + 6;
inline constexpr std::size_t kStateHeadBytes = kHeaderBytes + 12;
// What a frame can carry of a message or a value.
inline constexpr std::size_t kMostFragmentBytes = kMostContentBytes - kStateHeadBytes;

// The content of a frame, into `room`; returns its length, 0 when it does not fit.
std::size_t encode(const Hello& hello, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Status& status, std::uint32_t session, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const StopMessage& stop, std::uint32_t session, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const StopAnswer& answer, std::uint32_t session, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Part& part, std::uint32_t session, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const StateFragment& fragment, std::uint32_t session,
                   std::span<std::uint8_t> room) noexcept;

// Nothing: no kind of frame.
[[nodiscard]] std::optional<FrameKind> kind_of(Bytes content) noexcept;
// 0 in a hello.
[[nodiscard]] std::uint32_t session_of(Bytes content) noexcept;
// Of a hello, in whatever version its rest is; nothing: it is none.
[[nodiscard]] std::optional<std::uint16_t> version_of_hello(Bytes content) noexcept;

// False: not a frame of this kind, or one that contradicts itself. Payloads point into `content`. What
// decodes encodes to the same bytes.
[[nodiscard]] bool decode(Bytes content, Hello& hello) noexcept;
[[nodiscard]] bool decode(Bytes content, Status& status) noexcept;
[[nodiscard]] bool decode(Bytes content, StopMessage& stop) noexcept;
[[nodiscard]] bool decode(Bytes content, StopAnswer& answer) noexcept;
[[nodiscard]] bool decode(Bytes content, Part& part) noexcept;
[[nodiscard]] bool decode(Bytes content, StateFragment& fragment) noexcept;

// How many fragments a value of so many bytes has; an empty one has one.
[[nodiscard]] constexpr std::size_t fragments_of(std::size_t bytes, std::size_t fragment_bytes) noexcept {
  return bytes == 0 ? 1 : (bytes + fragment_bytes - 1) / fragment_bytes;
}

}  // namespace gaitway::link
