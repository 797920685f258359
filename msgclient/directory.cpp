// Layout of the directory segment.
#include "directory.hpp"

#include <algorithm>

namespace gaitway::msgclient {
namespace {

constexpr RingGeometry kRowGeometry{sizeof(DirectoryRow), 2};

TopicInfo info_of(const DirectoryRow& row) {
  TopicInfo info;
  info.descriptor = {std::string(name_of(row.name)),
                     std::string(name_of(row.type_name)),
                     row.type_hash,
                     row.size,
                     static_cast<TopicKind>(row.kind),
                     row.capacity};
  info.writer = name_of(row.writer);
  info.reader = name_of(row.reader);
  info.generation = row.generation;
  info.storage_bytes = row.storage_bytes;
  return info;
}

}  // namespace

void copy_name(std::string_view from, char (&to)[kMaxNameLength + 1]) noexcept {
  const std::size_t length = std::min(from.size(), kMaxNameLength);
  std::copy_n(from.data(), length, to);
  std::fill(to + length, to + sizeof to, '\0');
}

std::string_view name_of(const char (&text)[kMaxNameLength + 1]) noexcept {
  return {text, static_cast<std::size_t>(std::find(text, text + sizeof text, '\0') - text)};
}

std::size_t Directory::bytes() noexcept {
  return kHeaderWords * 8 + kMaxTopics * kRowGeometry.bytes();
}

Directory::Directory(const Segment& segment) noexcept : words_(static_cast<SharedWord*>(segment.data())) {}

void Directory::format(std::size_t block_bytes) noexcept {
  words_[kVersion].store(kLayoutVersion, std::memory_order_relaxed);
  words_[kBlockBytes].store(block_bytes, std::memory_order_relaxed);
  words_[kMagic].store(kDirectoryMagic,
                       std::memory_order_release);  // last: with the magic, all of the header is there
}

void Directory::store_row(std::size_t index, const TopicInfo& info) noexcept {
  DirectoryRow row{};
  copy_name(info.descriptor.name, row.name);
  copy_name(info.descriptor.type_name, row.type_name);
  copy_name(info.writer, row.writer);
  copy_name(info.reader, row.reader);
  row.type_hash = info.descriptor.type_hash;
  row.storage_bytes = info.storage_bytes;
  row.size = info.descriptor.size;
  row.kind = static_cast<std::uint32_t>(info.descriptor.kind);
  row.capacity = info.descriptor.capacity;
  row.generation = info.generation;
  ring::publish(words_ + kHeaderWords + index * kRowGeometry.bytes() / 8, kRowGeometry, &row, 0);
  // Release: who sees the new counts sees the row behind them.
  words_[kRows].store(std::max<std::uint64_t>(words_[kRows].load(std::memory_order_relaxed), index + 1),
                      std::memory_order_release);
  words_[kGeneration].store(words_[kGeneration].load(std::memory_order_relaxed) + 1,
                            std::memory_order_release);
}

void Directory::beat(std::int64_t now_ns) noexcept {
  words_[kHeartbeat].store(static_cast<std::uint64_t>(now_ns), std::memory_order_release);
}

void Directory::check() const {
  if (words_[kMagic].load(std::memory_order_acquire) != kDirectoryMagic) {
    throw TopicError(
        "the memory that the server gave is no directory of a memory block: is it another program's socket?");
  }
  const std::uint64_t version = words_[kVersion].load(std::memory_order_relaxed);
  if (version != kLayoutVersion) {
    throw TopicError("the memory block has layout version " + std::to_string(version) +
                     ", this program knows " + std::to_string(kLayoutVersion) +
                     ": build both from the same release");
  }
}

std::vector<TopicInfo> Directory::rows() const {
  const std::size_t count = std::min<std::size_t>(words_[kRows].load(std::memory_order_acquire), kMaxTopics);
  std::vector<TopicInfo> infos;
  infos.reserve(count);
  std::vector<std::uint64_t> copy(1 + kRowGeometry.value_words());
  for (std::size_t index = 0; index < count; ++index) {
    const SharedWord* const base = words_ + kHeaderWords + index * kRowGeometry.bytes() / 8;
    for (int attempt = 0; attempt < ring::kMaxAttempts; ++attempt) {
      if (ring::try_copy(base, kRowGeometry, ring::published(base), copy.data())) {
        DirectoryRow row;
        std::memcpy(&row, copy.data() + 1, sizeof row);
        infos.push_back(info_of(row));
        break;
      }
    }
  }
  return infos;
}

std::uint64_t Directory::generation() const noexcept {
  return words_[kGeneration].load(std::memory_order_acquire);
}

std::int64_t Directory::heartbeat_ns() const noexcept {
  return static_cast<std::int64_t>(words_[kHeartbeat].load(std::memory_order_acquire));
}

}  // namespace gaitway::msgclient
