// Frames in, buffers out; a frame leaves the queue when its last byte has been written.
#include "outgoing_queue.hpp"

#include <algorithm>
#include <utility>

namespace gaitway::api {
namespace {

constexpr std::uint8_t kFinalText = 0x81, kFinalBinary = 0x82;
constexpr std::size_t kLargestShort = 125, kLargestMedium = 0xFFFF;

// Writes `value` in network order.
void put(std::span<char> to, std::uint64_t value) {
  for (auto byte = to.rbegin(); byte != to.rend(); ++byte, value >>= 8U) {
    *byte = static_cast<char>(value & 0xFFU);
  }
}

}  // namespace

void OutgoingQueue::append(Frame frame) {
  Item item{.header = {}, .header_bytes = 2, .raw = false, .payload = std::move(frame.bytes)};
  const std::size_t size = item.payload->size();
  item.header[0] = static_cast<char>(frame.binary ? kFinalBinary : kFinalText);
  if (size <= kLargestShort) {
    item.header[1] = static_cast<char>(size);
  } else if (size <= kLargestMedium) {
    item.header[1] = 126;
    item.header_bytes = 4;
  } else {
    item.header[1] = 127;
    item.header_bytes = 10;
  }
  put(std::span(item.header).subspan(2, item.header_bytes - std::size_t{2}), size);
  bytes_ += item.header_bytes + size;
  items_.push_back(std::move(item));
}

void OutgoingQueue::append_raw(std::string bytes) {
  bytes_ += bytes.size();
  items_.push_back({.header = {},
                    .header_bytes = 0,
                    .raw = true,
                    .payload = std::make_shared<const std::string>(std::move(bytes))});
}

OutgoingQueue::Gathered OutgoingQueue::gather() {
  std::size_t count = 0, skip = written_of_first_;
  gathered_items_ = 0;
  const auto add = [&](const char* data, std::size_t size) {
    const std::size_t skipped = std::min(skip, size);
    skip -= skipped;
    if (size > skipped) {
      gathered_[count++] = boost::asio::const_buffer(data + skipped, size - skipped);
    }
  };
  for (const Item& item : items_) {
    if (count + 2 > kBuffers) {
      break;
    }
    add(item.header.data(), item.header_bytes);
    add(item.payload->data(), item.payload->size());
    ++gathered_items_;
  }
  return {gathered_.data(), count};
}

OutgoingQueue::Progress OutgoingQueue::consume(std::size_t bytes) {
  Progress progress;
  bytes_ -= bytes;
  gathered_items_ = 0;
  written_of_first_ += bytes;
  while (!items_.empty()) {
    const Item& first = items_.front();
    const std::size_t size = first.header_bytes + first.payload->size();
    if (written_of_first_ < size) {
      break;
    }
    written_of_first_ -= size;
    progress.finished_any = true;
    progress.finished_raw |= first.raw;
    items_.pop_front();
  }
  return progress;
}

void OutgoingQueue::drop_messages(bool keep_gathered) {
  const std::size_t begun = written_of_first_ > 0 ? 1 : 0;
  const auto keep = static_cast<std::ptrdiff_t>(keep_gathered ? std::max(begun, gathered_items_) : begun);
  const auto dropped = std::remove_if(items_.begin() + keep, items_.end(), [this](const Item& item) {
    bytes_ -= item.raw ? 0 : item.header_bytes + item.payload->size();
    return !item.raw;
  });
  items_.erase(dropped, items_.end());
}

}  // namespace gaitway::api
