// One line a datagram, in the order of the wire.
#include "gaitway/stopgram/datagrams.hpp"

#include "gaitway/link/byte_order.hpp"

namespace gaitway::stopgram {
namespace {

using link::ByteReader;
using link::ByteWriter;

constexpr std::uint32_t kMagic = 0x53'54'57'47;  // "GWTS"
constexpr std::size_t kGreetingFiller = 16;      // zeros: what a welcome has more

ByteWriter start_of(DatagramKind kind, std::span<std::uint8_t> room) noexcept {
  ByteWriter out(room);
  out.put(kMagic).put(kProtocolVersion).put(static_cast<std::uint8_t>(kind));
  return out;
}

// Behind the header, if the kind is right; otherwise a reader that is not ok.
ByteReader body_of(DatagramKind kind, Bytes content) noexcept {
  const bool is_ours = version_of(content) == kProtocolVersion && content.size() >= kHeaderBytes &&
                       content[kHeaderBytes - 1] == static_cast<std::uint8_t>(kind);
  return ByteReader(is_ours ? content.subspan(kHeaderBytes) : Bytes{});
}

bool is_kind(StopKind kind) noexcept {
  return static_cast<std::size_t>(kind) < kStopKinds;
}

StopKind get_kind(ByteReader& in) noexcept {
  return static_cast<StopKind>(in.get<std::uint8_t>());
}

}  // namespace

std::size_t encode(const Greeting& greeting, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(DatagramKind::greeting, room);
  out.put(greeting.client).put(greeting.number);
  for (std::size_t i = 0; i < kGreetingFiller; ++i) {
    out.put(std::uint8_t{0});
  }
  return out.size();
}

std::size_t encode(const Welcome& welcome, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(DatagramKind::welcome, room);
  return out.put(welcome.client).put(welcome.number).put(welcome.epoch).put(welcome.stamp_ns).size();
}

std::size_t encode(const Stop& stop, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(DatagramKind::stop, room);
  out.put(stop.client).put(stop.epoch).put(stop.stamp_ns).put(stop.number);
  return out.put(static_cast<std::uint8_t>(stop.kind)).size();
}

std::size_t encode(const Ack& ack, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(DatagramKind::ack, room);
  out.put(ack.client).put(ack.number).put(static_cast<std::uint8_t>(ack.kind));
  return out.put(std::uint8_t{ack.obeyed}).size();
}

std::size_t encode(const Stranger& stranger, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(DatagramKind::stranger, room);
  return out.put(stranger.client).put(stranger.epoch).put(stranger.stamp_ns).size();
}

std::optional<std::uint8_t> version_of(Bytes datagram) noexcept {
  ByteReader in(datagram);
  const auto magic = in.get<std::uint32_t>();
  const auto version = in.get<std::uint8_t>();
  return in.ok() && magic == kMagic ? std::optional(version) : std::nullopt;
}

bool decode(Bytes content, Greeting& greeting) noexcept {
  ByteReader in = body_of(DatagramKind::greeting, content);
  in.get(greeting.client).get(greeting.number);
  bool is_filled = false;
  for (std::size_t i = 0; i < kGreetingFiller; ++i) {
    is_filled = in.get<std::uint8_t>() != 0 || is_filled;
  }
  return in.ended() && !is_filled && greeting.number != 0;
}

bool decode(Bytes content, Welcome& welcome) noexcept {
  ByteReader in = body_of(DatagramKind::welcome, content);
  in.get(welcome.client).get(welcome.number).get(welcome.epoch).get(welcome.stamp_ns);
  return in.ended() && welcome.number != 0 && welcome.stamp_ns >= 0;
}

bool decode(Bytes content, Stop& stop) noexcept {
  ByteReader in = body_of(DatagramKind::stop, content);
  in.get(stop.client).get(stop.epoch).get(stop.stamp_ns).get(stop.number);
  stop.kind = get_kind(in);
  return in.ended() && stop.number != 0 && stop.stamp_ns >= 0 && is_kind(stop.kind);
}

bool decode(Bytes content, Ack& ack) noexcept {
  ByteReader in = body_of(DatagramKind::ack, content);
  in.get(ack.client).get(ack.number);
  ack.kind = get_kind(in);
  const auto state = in.get<std::uint8_t>();
  ack.obeyed = state == 1;
  return in.ended() && ack.number != 0 && is_kind(ack.kind) && state <= 1;
}

bool decode(Bytes content, Stranger& stranger) noexcept {
  ByteReader in = body_of(DatagramKind::stranger, content);
  in.get(stranger.client).get(stranger.epoch).get(stranger.stamp_ns);
  return in.ended() && stranger.stamp_ns >= 0;
}

}  // namespace gaitway::stopgram
