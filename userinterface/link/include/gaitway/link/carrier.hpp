// What carries the link's bytes: a Unix socket, a serial line, I2C. Bytes may be lost or changed on it, not
// reordered.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

#include "gaitway/link/frame_codec.hpp"
#include "gaitway/link/link_end.hpp"

namespace gaitway::link {

// One end's access. Never waits. For one thread.
class Carrier {
 public:
  Carrier() = default;
  Carrier(const Carrier&) = delete;
  Carrier& operator=(const Carrier&) = delete;
  virtual ~Carrier() = default;

  // Takes as many of the bytes as fit now, and returns how many. What is in a carrier can't be overtaken any
  // more: a good one takes little.
  virtual std::size_t write(Bytes bytes) noexcept = 0;
  // What has arrived, into `room`, which has kReadBytes or more; returns how many. 0: nothing now.
  virtual std::size_t read(std::span<std::uint8_t> room) noexcept = 0;
  // False: there will never be anything to read or write again; make a new one.
  [[nodiscard]] virtual bool connected() const noexcept = 0;
};

inline constexpr std::size_t kReadBytes = 4096;

// Brings to the end what has arrived, and sends what it has to say, as far as the carrier takes it. At most
// `most_reads` times kReadBytes are read, so that a flood does not keep the caller.
void pump(LinkEnd& end, Carrier& carrier, std::int64_t now_ns, int most_reads = 16) noexcept;

}  // namespace gaitway::link
