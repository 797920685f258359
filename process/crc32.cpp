// CRC-32, by zlib.
#include "gaitway/process/crc32.hpp"

#include <zlib.h>

namespace gaitway::process {

std::uint32_t crc32(std::span<const std::byte> bytes, std::uint32_t before) noexcept {
  return static_cast<std::uint32_t>(
      ::crc32_z(before, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace gaitway::process
