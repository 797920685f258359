// What bus server and bus clients say to each other: packets of fixed records over a SOCK_SEQPACKET Unix
// socket. Both ends run on one machine, so the records travel as they lie in memory.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "gaitway/can/frame.hpp"

namespace gaitway::can::protocol {

inline constexpr std::uint32_t kMagic = 0x47425333;  // "GBS3": grows with every change of what follows
inline constexpr std::size_t kRecordsAPacket = 64;

inline constexpr std::uint8_t kExtended = 1;
inline constexpr std::uint8_t kRemote = 2;

enum class Kind : std::uint32_t {
  hello = 1,  // client: start_ns is the magic, frame data its name, flag whether the bus keeps its pace
  transmit,   // client: `frame` from start_ns on
  mark,       // client: everything up to start_ns has been offered; server: the bus has run to start_ns
  delivery,   // server: `frame` of another station, from start_ns to end_ns
  sent,       // server: the client's own `frame`, from start_ns to end_ns
  error       // server: the stations have signalled an error at end_ns
};

struct Record {
  Kind kind = Kind::hello;
  std::uint32_t id = 0;
  std::uint8_t size = 0;
  std::uint8_t format = 0;  // kExtended | kRemote
  std::uint8_t flag = 0;
  std::array<std::uint8_t, 8> data{};
  std::int64_t start_ns = 0;
  std::int64_t end_ns = 0;
};
static_assert(sizeof(Record) == 40);

using Packet = std::array<Record, kRecordsAPacket>;

inline Record record_of(Kind kind, const Frame& frame, std::int64_t start_ns,
                        std::int64_t end_ns = 0) noexcept {
  const auto format =
      static_cast<std::uint8_t>((frame.extended ? kExtended : 0U) | (frame.remote ? kRemote : 0U));
  return {kind, frame.id, frame.size, format, 0, frame.data, start_ns, end_ns};
}
inline Frame frame_of(const Record& record) noexcept {
  return {record.id, record.size, record.data, (record.format & kExtended) != 0,
          (record.format & kRemote) != 0};
}
inline bool valid_frame(const Record& record) noexcept {
  return (record.format & ~(kExtended | kRemote)) == 0 && is_valid(frame_of(record));
}

}  // namespace gaitway::can::protocol
