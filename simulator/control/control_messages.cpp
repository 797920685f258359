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

struct RequestLayout {
  std::uint32_t magic = kRequestMagic;
  std::uint16_t version = kControlVersion;
  std::uint16_t kind = 0;
  std::uint32_t number = 0;
  std::uint32_t reserved = 0;
  std::array<std::byte, kRequestBytes - 16> body{};
};
struct PushLayout {
  char link[kMostLinkNameBytes + 1]{};
  double force_N[3]{};
  double duration_s = 0.0;
  std::uint32_t frame = 0;
  std::uint8_t reserved[28]{};
};
struct AnswerLayout {
  std::uint32_t magic = kAnswerMagic;
  std::uint16_t version = kControlVersion;
  std::uint16_t outcome = 0;
  std::uint32_t number = 0;
  std::uint32_t reserved = 0;
  char reason[kMostReasonBytes + 1]{};
};
static_assert(sizeof(RequestLayout) == kRequestBytes && sizeof(AnswerLayout) == kAnswerBytes);
static_assert(sizeof(PushLayout) == sizeof(RequestLayout::body));

template <class Layout, std::size_t size>
std::array<std::byte, size> bytes_of(const Layout& layout) {
  static_assert(sizeof layout == size);
  std::array<std::byte, size> bytes{};
  std::memcpy(bytes.data(), &layout, size);
  return bytes;
}

template <class Layout>
Layout layout_of(std::span<const std::byte> bytes) {
  Layout layout;
  std::memcpy(&layout, bytes.data(), sizeof layout);
  return layout;
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
  if (!(force_N >= kLeastForce_N && force_N <= kLargestForce_N)) {
    return "force is [" + text_of(x) + ", " + text_of(y) + ", " + text_of(z) + "] N, but must be from " +
           text_of(kLeastForce_N) + " to " + text_of(kLargestForce_N) + " N together";
  }
  if (!(push.duration_s >= kShortestPush_s && push.duration_s <= kLongestPush_s)) {
    return "duration is " + text_of(push.duration_s) + " s, but must be from " + text_of(kShortestPush_s) +
           " to " + text_of(kLongestPush_s) + " s";
  }
  return {};
}

RequestPacket encode(const Request& request) {
  RequestLayout layout;
  layout.version = request.version;
  layout.kind = request.kind;
  layout.number = request.number;
  layout.body = request.body;
  return bytes_of<RequestLayout, kRequestBytes>(layout);
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
  return {.kind = static_cast<std::uint16_t>(RequestKind::push),
          .number = number,
          .body = bytes_of<PushLayout, sizeof layout>(layout)};
}

AnswerPacket encode(const Answer& answer) {
  AnswerLayout layout;
  layout.outcome = answer.accepted ? kAccepted : kRefused;
  layout.number = answer.number;
  std::ranges::copy(cut(answer.reason, kMostReasonBytes), layout.reason);
  return bytes_of<AnswerLayout, kAnswerBytes>(layout);
}

std::optional<Request> decode_request(std::span<const std::byte> packet) {
  if (packet.size() != kRequestBytes) {
    return std::nullopt;
  }
  const auto layout = layout_of<RequestLayout>(packet);
  if (layout.magic != kRequestMagic || layout.reserved != 0) {
    return std::nullopt;
  }
  return Request{layout.version, layout.kind, layout.number, layout.body};
}

std::optional<Answer> decode_answer(std::span<const std::byte> packet) {
  if (packet.size() != kAnswerBytes) {
    return std::nullopt;
  }
  const auto layout = layout_of<AnswerLayout>(packet);
  const bool known = layout.outcome == kAccepted || layout.outcome == kRefused;
  if (layout.magic != kAnswerMagic || layout.version != kControlVersion || layout.reserved != 0 || !known ||
      !is_text(layout.reason)) {
    return std::nullopt;
  }
  return Answer{layout.number, layout.outcome == kAccepted, layout.reason};
}

Push push_of(const Request& request) {
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

}  // namespace gaitway::simulation
