// What the datagrams of stops say, down to the byte: README.md has the same as tables.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "gaitway/link/frame_codec.hpp"
#include "gaitway/link/stop_slot.hpp"

namespace gaitway::stopgram {

using link::Bytes;
using link::StopKind;

// Raised with every change of a layout; it is part of the key, too, so two numbers cannot be mixed up.
inline constexpr std::uint8_t kProtocolVersion = 1;
inline constexpr std::size_t kStopKinds = 3;

enum class DatagramKind : std::uint8_t { greeting = 1, welcome = 2, stop = 3, ack = 4, stranger = 5 };

// From a client: "what time is it at the desk?". As long as its answer, so that it can win an attacker
// nothing.
struct Greeting {
  std::uint64_t client = 0;  // random, chosen at each start of the client
  std::uint32_t number = 0;  // of the greeting, from 1 on; the same until it is answered
};

// The desk's answer.
struct Welcome {
  std::uint64_t client = 0;  // of the greeting
  std::uint32_t number = 0;
  std::uint64_t epoch = 0;    // random, chosen at each start of the desk
  std::int64_t stamp_ns = 0;  // the desk's time
};

struct Stop {
  std::uint64_t client = 0;
  std::uint64_t epoch = 0;    // of the newest welcome: not of another run of the desk,
  std::int64_t stamp_ns = 0;  // and not older than this
  std::uint32_t number = 0;   // of the stop, from 1 on; the same each time it is said
  StopKind kind = StopKind::stop;
};

// The desk has the stop.
struct Ack {
  std::uint64_t client = 0;  // of the stop
  std::uint32_t number = 0;
  StopKind kind = StopKind::stop;
  bool obeyed = false;  // the robot has obeyed it; otherwise it is heard
};

// The desk does not take this epoch and stamp: the client is to greet, and to say its stop again.
struct Stranger {
  std::uint64_t client = 0;  // of the stop
  std::uint64_t epoch = 0;
  std::int64_t stamp_ns = 0;
};

inline constexpr std::size_t kHeaderBytes = 6;  // magic 4, version 1, kind 1
inline constexpr std::size_t kMacBytes = 16;
inline constexpr std::size_t kGreetingBytes = kHeaderBytes + 28 + kMacBytes;
inline constexpr std::size_t kWelcomeBytes = kHeaderBytes + 28 + kMacBytes;
inline constexpr std::size_t kStopBytes = kHeaderBytes + 29 + kMacBytes;
inline constexpr std::size_t kAckBytes = kHeaderBytes + 14 + kMacBytes;
inline constexpr std::size_t kStrangerBytes = kHeaderBytes + 24 + kMacBytes;
inline constexpr std::size_t kMostDatagramBytes = kStopBytes;
// An answer is never longer than its question.
static_assert(kWelcomeBytes <= kGreetingBytes && kAckBytes <= kStopBytes && kStrangerBytes <= kStopBytes);

// The content of a datagram, without the code behind it, into `room`; returns its length, 0 when it does not
// fit.
std::size_t encode(const Greeting& greeting, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Welcome& welcome, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Stop& stop, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Ack& ack, std::span<std::uint8_t> room) noexcept;
std::size_t encode(const Stranger& stranger, std::span<std::uint8_t> room) noexcept;

// The version of what has our magic in front; nothing for anything else.
[[nodiscard]] std::optional<std::uint8_t> version_of(Bytes datagram) noexcept;

// False: not a datagram of this kind and version, or one that contradicts itself. What decodes encodes to the
// same bytes.
[[nodiscard]] bool decode(Bytes content, Greeting& greeting) noexcept;
[[nodiscard]] bool decode(Bytes content, Welcome& welcome) noexcept;
[[nodiscard]] bool decode(Bytes content, Stop& stop) noexcept;
[[nodiscard]] bool decode(Bytes content, Ack& ack) noexcept;
[[nodiscard]] bool decode(Bytes content, Stranger& stranger) noexcept;

}  // namespace gaitway::stopgram
