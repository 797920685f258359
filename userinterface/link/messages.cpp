// One line a field, in the order of the wire.
#include "gaitway/link/messages.hpp"

#include <algorithm>

#include "gaitway/link/byte_order.hpp"

namespace gaitway::link {
namespace {

ByteWriter start_of(FrameKind kind, std::uint32_t session, std::span<std::uint8_t> room) noexcept {
  ByteWriter out(room);
  out.put(static_cast<std::uint8_t>(kind)).put(session);
  return out;
}

// Behind the header, if the kind is right; otherwise a reader that is not ok.
ByteReader body_of(FrameKind kind, Bytes content) noexcept {
  ByteReader in(kind_of(content) == kind ? content : Bytes{});
  in.get_bytes(kHeaderBytes);
  return in;
}

bool is_time(std::int64_t time_ns) noexcept {
  return time_ns >= 0 && time_ns <= kMostTime_ns;
}

void put(ByteWriter& out, const Identity& identity) noexcept {
  out.put(identity.boot).put(identity.sessions);
}
void get(ByteReader& in, Identity& identity) noexcept {
  in.get(identity.boot).get(identity.sessions);
}
void put(ByteWriter& out, const StopCounts& counts) noexcept {
  out.put(counts.stops).put(counts.holds).put(counts.softs);
}
void get(ByteReader& in, StopCounts& counts) noexcept {
  in.get(counts.stops).get(counts.holds).get(counts.softs);
}

}  // namespace

std::size_t encode(const Hello& hello, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::hello, 0, room);
  out.put(hello.version).put(static_cast<std::uint8_t>(hello.role)).put(std::uint8_t{hello.open});
  put(out, hello.self);
  put(out, hello.heard);
  out.put(hello.table_hash).put(hello.robot_hash).put(hello.calibration_hash).put(hello.time_ns);
  for (const char letter : hello.name) {
    out.put(static_cast<std::uint8_t>(letter));
  }
  return out.size();
}

std::size_t encode(const Status& status, std::uint32_t session, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::status, session, room);
  out.put(status.time_ns).put(status.message).put(status.part).put(status.message_limit);
  out.put(status.state_sequence).put(status.state_received);
  return out.size();
}

std::size_t encode(const StopMessage& stop, std::uint32_t session, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::stop, session, room);
  put(out, stop.asked);
  put(out, stop.settled);
  return out.size();
}

std::size_t encode(const StopAnswer& answer, std::uint32_t session, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::stop_answer, session, room);
  put(out, answer.obeyed);
  return out.size();
}

std::size_t encode(const Part& part, std::uint32_t session, std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::part, session, room);
  out.put(part.message).put(part.part).put(part.parts).put(part.payload);
  return out.size();
}

std::size_t encode(const StateFragment& fragment, std::uint32_t session,
                   std::span<std::uint8_t> room) noexcept {
  ByteWriter out = start_of(FrameKind::state, session, room);
  out.put(fragment.sequence).put(fragment.channel).put(fragment.version).put(fragment.total_bytes);
  out.put(fragment.fragment).put(fragment.fragment_bytes).put(fragment.payload);
  return out.size();
}

std::optional<FrameKind> kind_of(Bytes content) noexcept {
  const std::uint8_t kind = content.size() < kHeaderBytes ? std::uint8_t{0} : content[0];
  if (kind < static_cast<std::uint8_t>(FrameKind::hello) ||
      kind > static_cast<std::uint8_t>(FrameKind::state)) {
    return std::nullopt;
  }
  return static_cast<FrameKind>(kind);
}

std::uint32_t session_of(Bytes content) noexcept {
  ByteReader in(content);
  in.get<std::uint8_t>();
  return in.get<std::uint32_t>();
}

std::optional<std::uint16_t> version_of_hello(Bytes content) noexcept {
  ByteReader in = body_of(FrameKind::hello, content);
  const auto version = in.get<std::uint16_t>();
  return in.ok() ? std::optional(version) : std::nullopt;
}

bool decode(Bytes content, Hello& hello) noexcept {
  ByteReader in = body_of(FrameKind::hello, content);
  in.get(hello.version);
  const auto role = in.get<std::uint8_t>();
  const auto is_open = in.get<std::uint8_t>();
  get(in, hello.self);
  get(in, hello.heard);
  in.get(hello.table_hash).get(hello.robot_hash).get(hello.calibration_hash).get(hello.time_ns);
  for (char& letter : hello.name) {
    letter = static_cast<char>(in.get<std::uint8_t>());
  }
  hello.role = static_cast<Role>(role);
  hello.open = is_open == 1;
  return in.ended() && session_of(content) == 0 && is_open <= 1 && is_time(hello.time_ns) &&
         (hello.role == Role::module || hello.role == Role::controller);
}

bool decode(Bytes content, Status& status) noexcept {
  ByteReader in = body_of(FrameKind::status, content);
  in.get(status.time_ns).get(status.message).get(status.part).get(status.message_limit);
  in.get(status.state_sequence).get(status.state_received);
  return in.ended() && is_time(status.time_ns);
}

bool decode(Bytes content, StopMessage& stop) noexcept {
  ByteReader in = body_of(FrameKind::stop, content);
  get(in, stop.asked);
  get(in, stop.settled);
  return in.ended();
}

bool decode(Bytes content, StopAnswer& answer) noexcept {
  ByteReader in = body_of(FrameKind::stop_answer, content);
  get(in, answer.obeyed);
  return in.ended();
}

bool decode(Bytes content, Part& part) noexcept {
  ByteReader in = body_of(FrameKind::part, content);
  in.get(part.message).get(part.part).get(part.parts);
  part.payload = in.get_rest();
  return in.ok() && part.message != 0 && part.part < part.parts;
}

bool decode(Bytes content, StateFragment& fragment) noexcept {
  ByteReader in = body_of(FrameKind::state, content);
  in.get(fragment.sequence).get(fragment.channel).get(fragment.version).get(fragment.total_bytes);
  in.get(fragment.fragment).get(fragment.fragment_bytes);
  fragment.payload = in.get_rest();
  if (!in.ok() || fragment.fragment_bytes == 0) {
    return false;
  }
  const std::size_t size = fragment.fragment_bytes;
  const std::size_t offset = fragment.fragment * size;
  return fragment.fragment < fragments_of(fragment.total_bytes, size) &&
         fragment.payload.size() == std::min<std::size_t>(size, fragment.total_bytes - offset);
}

}  // namespace gaitway::link
