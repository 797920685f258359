// The directory segment: who is there, written by the block's owner, readable for all. Every row is a small
// ring of its own, so that a reader never sees half a change.
#pragma once

#include <string_view>
#include <vector>

#include "gaitway/msgclient/client.hpp"

namespace gaitway::msgclient {

inline constexpr std::uint64_t kDirectoryMagic = 0x6b6c625f79617467;  // "gtay_blk"
inline constexpr std::uint64_t kLayoutVersion = 1;
inline constexpr std::size_t kMaxTopics = 96;

struct DirectoryRow {
  char name[kMaxNameLength + 1];
  char type_name[kMaxNameLength + 1];
  char writer[kMaxNameLength + 1];
  char reader[kMaxNameLength + 1];
  std::uint64_t type_hash;
  std::uint64_t storage_bytes;
  std::uint32_t size;
  std::uint32_t kind;
  std::uint32_t capacity;
  std::uint32_t generation;
};

// Copies at most kMaxNameLength characters and the terminating zero.
void copy_name(std::string_view from, char (&to)[kMaxNameLength + 1]) noexcept;
// Up to the terminating zero, or the whole array if a broken peer left none.
std::string_view name_of(const char (&text)[kMaxNameLength + 1]) noexcept;

// Works on the mapped segment; the writing half is for the owner.
class Directory {
 public:
  static std::size_t bytes() noexcept;
  explicit Directory(const Segment& segment) noexcept;

  void format(std::size_t block_bytes) noexcept;
  void store_row(std::size_t index, const TopicInfo& info) noexcept;  // also counts one generation on
  void beat(std::int64_t now_ns) noexcept;

  // Throws TopicError for memory of another kind or layout.
  void check() const;
  [[nodiscard]] std::vector<TopicInfo> rows() const;
  [[nodiscard]] std::uint64_t generation() const noexcept;
  [[nodiscard]] std::int64_t heartbeat_ns() const noexcept;

 private:
  enum Word : std::size_t { kMagic, kVersion, kBlockBytes, kGeneration, kHeartbeat, kRows, kHeaderWords = 8 };

  SharedWord* words_;
};

}  // namespace gaitway::msgclient
