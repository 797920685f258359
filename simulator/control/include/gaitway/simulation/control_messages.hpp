// What a local process asks of a simulator, and the answers: packets that say what they are and of which
// version, and end where their content does.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::simulation {

inline constexpr std::uint16_t kControlVersion = 2;
inline constexpr std::size_t kHeadBytes = 16;  // of a request and of an answer
inline constexpr std::size_t kMostBodyBytes = 4'000, kMostTextBytes = 100'000;
inline constexpr std::size_t kMostRequestBytes = kHeadBytes + kMostBodyBytes,
                             kMostAnswerBytes = kHeadBytes + kMostTextBytes;
inline constexpr std::size_t kPushBytes = 112, kMostLinkNameBytes = 47;

enum class RequestKind : std::uint16_t {
  push = 1,  // its body: kPushBytes
  order = 2  // its body: one JSON object
};

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

// Why this is no text of an order, before anybody has parsed it; empty: it is one.
[[nodiscard]] std::string objection_to_order(std::string_view json);

using Packet = std::vector<std::byte>;

// A packet of a possible size and of the right magic: what a peer that speaks this protocol sends. Its kind,
// version and body may be anything yet.
struct Request {
  std::uint16_t version = kControlVersion;
  std::uint16_t kind = 0;    // RequestKind
  std::uint32_t number = 0;  // that its answer bears; the sender's choice
  std::vector<std::byte> body = {};
};

struct Answer {
  std::uint32_t number = 0;  // of the request; 0: nobody asked, the simulator turns the client away
  bool accepted = false;
  std::string text = {};  // refused: why, for people; an order that is accepted: a JSON object
};

// Throws std::invalid_argument for a body of more than kMostBodyBytes.
[[nodiscard]] Packet encode(const Request& request);
// Both throw std::invalid_argument, with their objection's text.
[[nodiscard]] Request request_of(const Push& push, std::uint32_t number);
[[nodiscard]] Request request_of(std::string_view order, std::uint32_t number);
// A reason is cut at kMostTextBytes, between characters. Throws std::invalid_argument for a longer text of
// what was accepted, which would mean nothing without its end.
[[nodiscard]] Packet encode(const Answer& answer);

// Nothing: this is no packet of the protocol.
[[nodiscard]] std::optional<Request> decode_request(std::span<const std::byte> packet);
[[nodiscard]] std::optional<Answer> decode_answer(std::span<const std::byte> packet);
// The body of a push. Throws std::invalid_argument, naming field, value and rule.
[[nodiscard]] Push push_of(const Request& request);
// The body of an order, valid while `request` is. Throws std::invalid_argument with its objection's text.
[[nodiscard]] std::string_view order_of(const Request& request);

}  // namespace gaitway::simulation
