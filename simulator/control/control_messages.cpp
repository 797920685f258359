// Packets as both sides of one computer see them: numbers in its own byte order, which the magic shows.
#include "gaitway/simulation/control_messages.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <stdexcept>

namespace gaitway::simulation {
namespace {

constexpr std::uint32_t kRequestMagic = 0x51'53'57'47;  // GWSQ
constexpr std::uint32_t kAnswerMagic = 0x41'53'57'47;   // GWSA
constexpr std::uint16_t kAccepted = 1, kRefused = 2;

struct HeadLayout {
  std::uint32_t magic = 0;
  std::uint16_t version = kControlVersion;
  std::uint16_t meaning = 0;  // a request's kind, an answer's outcome
  std::uint32_t number = 0;
  std::uint32_t reserved = 0;
};
struct PushLayout {
  char link[kMostLinkNameBytes + 1]{};
  double force_N[3]{};
  double duration_s = 0.0;
  std::uint32_t frame = 0;
  std::uint8_t reserved[28]{};
};
static_assert(sizeof(HeadLayout) == kHeadBytes && sizeof(PushLayout) == kPushBytes);

Packet packet_of(const HeadLayout& head, std::span<const std::byte> content) {
  Packet packet(kHeadBytes + content.size());
  std::memcpy(packet.data(), &head, kHeadBytes);
  std::ranges::copy(content, packet.begin() + kHeadBytes);
  return packet;
}

template <class Layout>
Layout layout_of(std::span<const std::byte> bytes) {
  Layout layout;
  std::memcpy(&layout, bytes.data(), sizeof layout);
  return layout;
}

// Of a packet of a possible size and of this magic.
std::optional<HeadLayout> head_of(std::span<const std::byte> packet, std::size_t most_bytes,
                                  std::uint32_t magic) {
  if (packet.size() < kHeadBytes || packet.size() > most_bytes) {
    return std::nullopt;
  }
  const auto head = layout_of<HeadLayout>(packet);
  return head.magic == magic && head.reserved == 0 ? std::optional(head) : std::nullopt;
}

std::string_view text_in(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Ends within the field, and is followed by zeros alone.
template <std::size_t size>
bool is_text(const char (&field)[size]) {
  const char* const end = std::find(field, field + size, '\0');
  return end != field + size && std::all_of(end, field + size, [](char c) { return c == '\0'; });
}

// At most so many bytes of it, and no part of a character.
std::string_view cut(std::string_view text, std::size_t most) {
  constexpr auto goes_on = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
  if (text.size() <= most) {
    return text;
  }
  while (most > 0 && goes_on(text[most])) {
    --most;
  }
  return text.substr(0, most);
}

bool is_printable(std::string_view text) {
  return std::ranges::none_of(text,
                              [](char c) { return static_cast<unsigned char>(c) < 0x20U || c == '\x7f'; });
}

std::string text_of(double value) {
  std::string text = std::to_string(value);
  if (std::isfinite(value)) {
    text.erase(std::max(text.find_last_not_of('0'), text.find('.') + 1) + 1);
  }
  return text;
}

}  // namespace

std::string objection(const Push& push) {
  if (push.link.empty() || push.link.size() > kMostLinkNameBytes || !is_printable(push.link)) {
    return "link has " + std::to_string(push.link.size()) + " bytes, but must be a link's name of 1 to " +
           std::to_string(kMostLinkNameBytes) + " printable bytes";
  }
  if (push.frame != Frame::world && push.frame != Frame::heading) {
    return "frame is " + std::to_string(static_cast<std::uint32_t>(push.frame)) +
           ", but must be world (0) or heading (1)";
  }
  const auto& [x, y, z] = push.force_N;
  const double force_N = std::hypot(x, y, z);
  constexpr double kRounding = 1.0 + 1e-9;  // of the largest one, turned into any direction
  if (!(force_N >= kLeastForce_N && force_N <= kRounding * kLargestForce_N)) {
    return "force is [" + text_of(x) + ", " + text_of(y) + ", " + text_of(z) + "] N, but must be from " +
           text_of(kLeastForce_N) + " to " + text_of(kLargestForce_N) + " N together";
  }
  if (!(push.duration_s >= kShortestPush_s && push.duration_s <= kLongestPush_s)) {
    return "duration is " + text_of(push.duration_s) + " s, but must be from " + text_of(kShortestPush_s) +
           " to " + text_of(kLongestPush_s) + " s";
  }
  return {};
}

std::string objection_to_order(std::string_view json) {
  if (json.empty() || json.size() > kMostBodyBytes) {
    return "the order has " + std::to_string(json.size()) + " bytes, but must be a JSON object of 1 to " +
           std::to_string(kMostBodyBytes);
  }
  return {};
}

Packet encode(const Request& request) {
  if (request.body.size() > kMostBodyBytes) {
    throw std::invalid_argument("the request's body has " + std::to_string(request.body.size()) +
                                " bytes, but must have at most " + std::to_string(kMostBodyBytes));
  }
  return packet_of(
      {.magic = kRequestMagic, .version = request.version, .meaning = request.kind, .number = request.number},
      request.body);
}

Request request_of(const Push& push, std::uint32_t number) {
  if (const std::string why = objection(push); !why.empty()) {
    throw std::invalid_argument(why);
  }
  PushLayout layout;
  std::memcpy(layout.link, push.link.data(), push.link.size());
  std::ranges::copy(push.force_N, layout.force_N);
  layout.duration_s = push.duration_s;
  layout.frame = static_cast<std::uint32_t>(push.frame);
  const auto bytes = std::as_bytes(std::span(&layout, 1));
  return {.kind = static_cast<std::uint16_t>(RequestKind::push),
          .number = number,
          .body = {bytes.begin(), bytes.end()}};
}

Request request_of(std::string_view order, std::uint32_t number) {
  if (const std::string why = objection_to_order(order); !why.empty()) {
    throw std::invalid_argument(why);
  }
  const auto bytes = std::as_bytes(std::span(order));
  return {.kind = static_cast<std::uint16_t>(RequestKind::order),
          .number = number,
          .body = {bytes.begin(), bytes.end()}};
}

Packet encode(const Answer& answer) {
  if (answer.accepted && answer.text.size() > kMostTextBytes) {
    throw std::invalid_argument("the answer has " + std::to_string(answer.text.size()) +
                                " bytes, but must have at most " + std::to_string(kMostTextBytes));
  }
  const std::string_view text = cut(answer.text, kMostTextBytes);
  return packet_of(
      {.magic = kAnswerMagic, .meaning = answer.accepted ? kAccepted : kRefused, .number = answer.number},
      std::as_bytes(std::span(text)));
}

std::optional<Request> decode_request(std::span<const std::byte> packet) {
  const auto head = head_of(packet, kMostRequestBytes, kRequestMagic);
  if (!head) {
    return std::nullopt;
  }
  const auto body = packet.subspan(kHeadBytes);
  return Request{head->version, head->meaning, head->number, {body.begin(), body.end()}};
}

std::optional<Answer> decode_answer(std::span<const std::byte> packet) {
  const auto head = head_of(packet, kMostAnswerBytes, kAnswerMagic);
  if (!head || head->version != kControlVersion ||
      (head->meaning != kAccepted && head->meaning != kRefused)) {
    return std::nullopt;
  }
  return Answer{head->number, head->meaning == kAccepted, std::string(text_in(packet.subspan(kHeadBytes)))};
}

Push push_of(const Request& request) {
  if (request.body.size() != kPushBytes) {
    throw std::invalid_argument("the push has " + std::to_string(request.body.size()) +
                                " bytes, but must have " + std::to_string(kPushBytes));
  }
  const auto layout = layout_of<PushLayout>(request.body);
  const bool clear = std::ranges::all_of(layout.reserved, [](std::uint8_t byte) { return byte == 0; });
  if (!is_text(layout.link) || !clear) {
    throw std::invalid_argument("the push has bytes behind its fields, which must be zero");
  }
  Push push{layout.link,
            {layout.force_N[0], layout.force_N[1], layout.force_N[2]},
            static_cast<Frame>(layout.frame),
            layout.duration_s};
  if (const std::string why = objection(push); !why.empty()) {
    throw std::invalid_argument(why);
  }
  return push;
}

std::string_view order_of(const Request& request) {
  const std::string_view json = text_in(request.body);
  if (const std::string why = objection_to_order(json); !why.empty()) {
    throw std::invalid_argument(why);
  }
  return json;
}

}  // namespace gaitway::simulation
