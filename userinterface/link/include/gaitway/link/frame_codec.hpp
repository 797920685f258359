// Frames in a stream of bytes: content and CRC-32, stuffed (COBS) so that a zero stands at their ends only.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

namespace gaitway::link {

using Bytes = std::span<const std::uint8_t>;

inline constexpr std::size_t kCrcBytes = 4;
// Below the 254 bytes of a COBS block, so that stuffing always adds exactly one byte.
inline constexpr std::size_t kMostContentBytes = 240;

// What a frame adds to its content: a zero before and behind it, the stuffing byte, the CRC. The zero in
// front ends whatever garbage came before, so that it costs no frame.
inline constexpr std::size_t kFramingBytes = 3 + kCrcBytes;
inline constexpr std::size_t kMostFrameBytes = kMostContentBytes + kFramingBytes;

// The bytes of a frame on the wire. `content` has 1 to kMostContentBytes bytes, `wire` room for
// kFramingBytes more. Returns the length; 0, and nothing is written, when one of them does not.
std::size_t encode_frame(Bytes content, std::span<std::uint8_t> wire) noexcept;

// One counter for each cause of loss.
struct FrameCounts {
  std::uint64_t whole = 0;      // frames that were taken
  std::uint64_t torn = 0;       // stuffing that does not add up, or too short for a CRC
  std::uint64_t corrupt = 0;    // wrong CRC
  std::uint64_t oversized = 0;  // more bytes between zeros than any frame has
};

// Finds frames in whatever comes. Needs no start-up: the next zero puts it in step. Does not allocate.
class FrameDecoder {
 public:
  // The content of the frame that this byte ends; it is valid until the next call.
  std::optional<Bytes> take(std::uint8_t byte) noexcept;
  // Forgets what came of a frame that is not complete.
  void reset() noexcept;
  [[nodiscard]] const FrameCounts& counts() const noexcept { return counts_; }

 private:
  [[nodiscard]] std::optional<Bytes> finish() noexcept;

  std::array<std::uint8_t, kMostContentBytes + kCrcBytes + 1> buffer_{};
  std::size_t size_ = 0;
  bool overflowed_ = false;
  FrameCounts counts_;
};

}  // namespace gaitway::link
