// What a local process asks of a simulator, and the answers: packets of a fixed size, each of which says what
// it is and of which version.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace gaitway::simulation {

inline constexpr std::uint16_t kControlVersion = 1;
inline constexpr std::size_t kRequestBytes = 128, kAnswerBytes = 256;
inline constexpr std::size_t kMostLinkNameBytes = 47, kMostReasonBytes = 239;

enum class RequestKind : std::uint16_t { push = 1 };

// In which frame a force is given.
enum class Frame : std::uint32_t {
  world = 0,   // the simulator's
  heading = 1  // of the robot's base, turned about the vertical alone: x ahead, y left, z up
};

// A constant force on a link's centre of mass.
struct Push {
  std::string link = {};
  std::array<double, 3> force_N{};
  Frame frame = Frame::world;
  double duration_s = 0.0;
};

inline constexpr double kLeastForce_N = 0.1, kLargestForce_N = 200.0;
inline constexpr double kShortestPush_s = 0.01, kLongestPush_s = 2.0;

// Why nobody may be pushed so, naming field, value and rule; empty: he may, if there is such a link.
[[nodiscard]] std::string objection(const Push& push);

using RequestPacket = std::array<std::byte, kRequestBytes>;
using AnswerPacket = std::array<std::byte, kAnswerBytes>;

// A packet of the right size and magic: what a peer that speaks this protocol sends. Its kind, version and
// body may be anything yet.
struct Request {
  std::uint16_t version = kControlVersion;
  std::uint16_t kind = 0;    // RequestKind
  std::uint32_t number = 0;  // that its answer bears; the sender's choice
  std::array<std::byte, kRequestBytes - 16> body{};
};

struct Answer {
  std::uint32_t number = 0;  // of the request; 0: nobody asked, the simulator turns the client away
  bool accepted = false;
  std::string reason = {};  // why not, for people; cut at kMostReasonBytes
};

[[nodiscard]] RequestPacket encode(const Request& request);
// Throws std::invalid_argument with objection()'s text.
[[nodiscard]] Request request_of(const Push& push, std::uint32_t number);
[[nodiscard]] AnswerPacket encode(const Answer& answer);

// Nothing: this is no packet of the protocol.
[[nodiscard]] std::optional<Request> decode_request(std::span<const std::byte> packet);
[[nodiscard]] std::optional<Answer> decode_answer(std::span<const std::byte> packet);
// The body of a push. Throws std::invalid_argument, naming field, value and rule.
[[nodiscard]] Push push_of(const Request& request);

}  // namespace gaitway::simulation
