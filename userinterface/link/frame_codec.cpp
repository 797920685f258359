// Stuffing after Cheshire and Baker: each block begins with the distance to the zero that it replaces.
#include "gaitway/link/frame_codec.hpp"

#include <algorithm>

#include "gaitway/link/byte_order.hpp"
#include "gaitway/process/crc32.hpp"

namespace gaitway::link {
namespace {

// Replaces the zeros of `text`, one byte for one, and returns the length of the first block.
std::uint8_t stuff(std::span<std::uint8_t> text) noexcept {
  std::uint8_t distance = 1;
  for (std::size_t i = text.size(); i > 0; --i) {
    if (text[i - 1] == 0) {
      text[i - 1] = distance;
      distance = 0;
    }
    ++distance;
  }
  return distance;
}

// The reverse, in place; false when the blocks do not end with the text.
bool unstuff(std::uint8_t first, std::span<std::uint8_t> text) noexcept {
  std::size_t zero = first;  // counted from 1: position 0 is the stuffing byte itself
  while (zero <= text.size()) {
    const std::uint8_t distance = text[zero - 1];
    text[zero - 1] = 0;
    zero += distance;
  }
  return zero == text.size() + 1;
}

}  // namespace

std::size_t encode_frame(Bytes content, std::span<std::uint8_t> wire) noexcept {
  const std::size_t length = content.size() + kFramingBytes;
  if (content.empty() || content.size() > kMostContentBytes || wire.size() < length) {
    return 0;
  }
  const std::span<std::uint8_t> text = wire.subspan(2, content.size() + kCrcBytes);
  std::ranges::copy(content, text.begin());
  ByteWriter(text.last(kCrcBytes)).put(process::crc32(std::as_bytes(content)));
  wire[1] = stuff(text);
  wire.front() = wire[length - 1] = 0;
  return length;
}

std::optional<Bytes> FrameDecoder::take(std::uint8_t byte) noexcept {
  if (byte == 0) {
    const std::optional<Bytes> content = finish();
    size_ = 0;
    overflowed_ = false;
    return content;
  }
  if (size_ == buffer_.size()) {
    overflowed_ = true;
  } else {
    buffer_[size_++] = byte;
  }
  return std::nullopt;
}

void FrameDecoder::reset() noexcept {
  size_ = 0;
  overflowed_ = false;
}

std::optional<Bytes> FrameDecoder::finish() noexcept {
  if (size_ == 0) {
    return std::nullopt;  // zeros between frames
  }
  if (overflowed_) {
    ++counts_.oversized;
    return std::nullopt;
  }
  const std::span<std::uint8_t> text = std::span(buffer_).subspan(1, size_ - 1);
  if (text.size() <= kCrcBytes || !unstuff(buffer_[0], text)) {
    ++counts_.torn;
    return std::nullopt;
  }
  const Bytes content = text.first(text.size() - kCrcBytes);
  if (ByteReader(text.last(kCrcBytes)).get<std::uint32_t>() != process::crc32(std::as_bytes(content))) {
    ++counts_.corrupt;
    return std::nullopt;
  }
  ++counts_.whole;
  return content;
}

}  // namespace gaitway::link
