// The memory block, as its owner sees it: the message controller, or a lock-step run in one process.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "gaitway/msgclient/client.hpp"

namespace gaitway::msgclient {

class TopicRegistry;

// Only what topics are opened for is taken from the system: a size is a limit. The default one holds all
// standard topics, pictures of both sizes among them, in its first half.
inline constexpr std::size_t kDefaultBlockBytes = std::size_t{12} << 20;
inline constexpr std::size_t kMaxBlockBytes = std::size_t{16} << 20;
// Values above this size get kSlotsOfLargeTopic slots, so that a plan doesn't fill the block.
inline constexpr std::uint32_t kLargeTopicBytes = 16384;
inline constexpr std::uint32_t kSlots = 8;
inline constexpr std::uint32_t kSlotsOfLargeTopic = 4;

// Directory and topics' storage. Each topic's storage is a sealed memfd of its own, so that a process can be
// given exactly those topics writable that it writes, and a restarted or different writer goes on in the same
// memory under its readers' eyes.
class MemoryBlock {
 public:
  // `size_bytes`: what directory and topics may use together, in whole pages; at most kMaxBlockBytes.
  // Throws TopicError for a size that is out of range, std::system_error when the system has no memory.
  explicit MemoryBlock(std::size_t size_bytes = kDefaultBlockBytes);
  ~MemoryBlock();
  MemoryBlock(MemoryBlock&&) noexcept;
  MemoryBlock& operator=(MemoryBlock&&) noexcept;

  // A client in this process.
  [[nodiscard]] Client local_client(const std::string& name);
  // Shows all clients that the owner lives; for the cycle.
  void beat(std::int64_t now_ns) noexcept;

  // For a copy of the owner's process that fork() made and that goes on with what is in the block alone: the
  // owner and its other copies see nothing of what it writes from now on. The owner must not write while the
  // copy lives, or the copy may see it. Throws std::system_error.
  void keep_to_this_process();
  // For a copy that keeps it to itself, and that wants to be an owner with clients in other processes: what
  // is in the block moves into shared memory of its own, under the eyes of this process's clients. Nobody
  // else may have it yet. Throws std::system_error.
  void share_anew();

  [[nodiscard]] std::size_t size_bytes() const noexcept;
  [[nodiscard]] std::size_t used_bytes() const noexcept;
  [[nodiscard]] const std::shared_ptr<TopicRegistry>& registry() const noexcept { return registry_; }

 private:
  std::shared_ptr<TopicRegistry> registry_;
};

}  // namespace gaitway::msgclient
