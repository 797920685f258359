// Numbers for keys: a hash table that only grows, with open addressing.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace gaitway::planning {

// Keys are any but kNone.
class IdTable {
 public:
  static constexpr std::uint64_t kNone = ~std::uint64_t{0};

  IdTable() : keys_(kLeast, kNone), ids_(kLeast, 0) {}

  // The number of the key; `next` becomes that of a new one. Returns whether it is new.
  bool find_or_add(std::uint64_t key, std::uint32_t next, std::uint32_t& id) {
    if (2 * (count_ + 1) > keys_.size()) grow();
    const std::size_t slot = slot_of(key);
    if (keys_[slot] == key) {
      id = ids_[slot];
      return false;
    }
    keys_[slot] = key;
    ids_[slot] = id = next;
    ++count_;
    return true;
  }

 private:
  static constexpr std::size_t kLeast = 4096;

  [[nodiscard]] std::size_t slot_of(std::uint64_t key) const noexcept {
    std::uint64_t mixed = key * 0x9E37'79B9'7F4A'7C15ULL;
    mixed ^= mixed >> 32U;
    std::size_t slot = static_cast<std::size_t>(mixed) & (keys_.size() - 1);
    while (keys_[slot] != kNone && keys_[slot] != key) slot = (slot + 1) & (keys_.size() - 1);
    return slot;
  }
  void grow() {
    std::vector<std::uint64_t> keys(2 * keys_.size(), kNone);
    std::vector<std::uint32_t> ids(keys.size(), 0);
    keys.swap(keys_);
    ids.swap(ids_);
    for (std::size_t i = 0; i < keys.size(); ++i) {
      if (keys[i] == kNone) continue;
      const std::size_t slot = slot_of(keys[i]);
      keys_[slot] = keys[i];
      ids_[slot] = ids[i];
    }
  }

  std::size_t count_ = 0;
  std::vector<std::uint64_t> keys_;
  std::vector<std::uint32_t> ids_;
};

}  // namespace gaitway::planning
