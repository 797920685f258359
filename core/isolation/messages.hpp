// What the manager and a child say to each other while the plug-in is constructed: one packet a
// message, over a socket pair. Reading trusts no length.
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/instance/configuration.hpp"
#include "gaitway/plugin/abi.h"
#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::core {

enum class ChildMessage : std::uint32_t {
  // From the manager.
  create = 1,  // library, base, robot directory, memory socket, search path; whole files are the child's own
               // affair
  granted,     // the declaration stands; for a parameter with its value
  refused,     // with the error text
  attach,      // with the segment's descriptor
  // From the child.
  open_topic,
  parameter,
  set_period,
  report,
  created,             // name, version, description and file of the library
  library_failed,      // the text says it all
  constructor_failed,  // the text is the plug-in's
  attached,
};

class PacketWriter {
 public:
  explicit PacketWriter(ChildMessage kind) { number(kind); }
  template <class T>
  PacketWriter& number(T value) {
    static_assert(std::is_trivially_copyable_v<T>);
    const std::size_t at = bytes_.size();
    bytes_.resize(at + sizeof value);
    std::memcpy(bytes_.data() + at, &value, sizeof value);
    return *this;
  }
  PacketWriter& text(std::string_view text);
  PacketWriter& text(const char* text);  // may be null
  PacketWriter& value(const gaitway_value& value);
  [[nodiscard]] std::span<const std::byte> bytes() const noexcept { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
};

// Throws PluginError where a packet is not what it should be.
class PacketReader {
 public:
  explicit PacketReader(std::span<const std::byte> bytes) : bytes_(bytes) {}
  template <class T>
  T number() {
    static_assert(std::is_trivially_copyable_v<T>);
    T value;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  std::string text();
  // A text's address stays valid as long as `keep`.
  gaitway_value value(std::string& keep);

 private:
  const std::byte* take(std::size_t size);
  std::span<const std::byte> bytes_;
};

// What a child says of its plug-in's library when the plug-in is constructed.
struct LibraryDescription {
  std::string name, version, text, file;
};

enum class Wait : std::uint8_t { no, yes };
enum class Sent : std::uint8_t { whole, full, failed };
enum class Receipt : std::uint8_t { packet, nothing, closed };

// `descriptor`: goes along if it is not negative. Full: the other side has not read what was sent before, of
// one that does not wait. Failed: it is gone, or the packet is too large.
Sent send_packet(const process::FileDescriptor& socket, std::span<const std::byte> bytes, Wait wait,
                 int descriptor = -1) noexcept;
// `descriptor`: what came along; without it, that is closed.
Receipt receive_packet(const process::FileDescriptor& socket, std::vector<std::byte>& bytes, Wait wait,
                       process::FileDescriptor* descriptor = nullptr);

}  // namespace gaitway::core
