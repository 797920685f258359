// The lock-free heart of the memory block: a small ring of slots, published by index. Works on shared memory
// in which nothing but atomic 64-bit words lies; the geometry comes from the directory, never from memory
// that the other side writes. "model: NAME.N" names a step of the models in tests/models.
//
// clang-format off
// Memory orders. Writer of value n (slot n mod slots):       Reader:
//   W1 slot.sequence = 0        relaxed                        R1 p = published             acquire   // model: publish.1, read.1
//   W2 slot.words[i] = ...      release                        R2 slot(p).sequence == p ?   acquire   // model: publish.2, read.2
//   W3 slot.sequence = n        release                        R3 read slot(p).words[i]     acquire   // model: publish.3, read.3
//   W4 published = n            release                        R4 slot(p).sequence == p ?   relaxed   // model: publish.4, read.4
//
//  a) Whole: R2 sees W3 of value p, so W3 synchronises with R2 and every W2 of p happens before R3:
//     R3 sees words of p or newer.
//  b) Not newer: suppose an R3 sees a word that W2 of a later value q stored. That W2 (release)
//     synchronises with R3 (acquire), so W1 of q happens before R4, and R4 sees 0 or something later,
//     never p again: sequences don't repeat in 64 bits. So if R4 still sees p, all words are of p.
//     Acquire on R3 also keeps R4 behind the words.
//     Words with relaxed order would need a release fence after W1 and an acquire fence before R4;
//     fences are invisible to the thread sanitizer. Release stores and acquire loads are the same plain
//     moves as relaxed ones on x86.
//  c) W1 may be relaxed: each W2 is a release and so cannot become visible without it.
//  d) Killed between any two of these steps, the writer leaves `published` at n - 1, whose slot it has
//     not touched (slots >= 2). Its successor begins with n again.
//  e) A reader is overtaken only if slots - 1 further values are published while it copies one.
// clang-format on
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <utility>

namespace gaitway::msgclient {

using SharedWord = std::atomic<std::uint64_t>;
static_assert(SharedWord::is_always_lock_free && sizeof(SharedWord) == 8,
              "shared memory needs address-free atomics");

inline constexpr std::size_t kCacheLine = 64;

// Where things lie in a ring; same on both sides.
struct RingGeometry {
  std::uint32_t value_bytes = 0;
  std::uint32_t slots = 0;

  [[nodiscard]] constexpr std::size_t value_words() const noexcept {
    return (std::size_t{value_bytes} + 7) / 8;
  }
  // Sequence, stamp and value, rounded up so that no two slots share a cache line.
  [[nodiscard]] constexpr std::size_t slot_words() const noexcept { return (2 + value_words() + 7) / 8 * 8; }
  [[nodiscard]] constexpr std::size_t bytes() const noexcept { return kCacheLine + slots * slot_words() * 8; }
};

enum class ReadStatus : std::uint8_t {
  none,      // no value has been published yet
  value,     // read
  overtaken  // the writer was faster at every one of the bounded tries: the destination is untouched
};

struct ReadResult {
  ReadStatus status = ReadStatus::none;
  std::uint64_t sequence = 0;  // 1 for the first value of a topic
  std::int64_t stamp_ns = 0;   // as given by the writer

  [[nodiscard]] explicit operator bool() const noexcept { return status == ReadStatus::value; }
};

namespace ring {

inline constexpr int kMaxAttempts = 16;

inline SharedWord* slot(SharedWord* base, const RingGeometry& geometry, std::uint64_t sequence) noexcept {
  return base + kCacheLine / 8 + sequence % geometry.slots * geometry.slot_words();
}
inline const SharedWord* slot(const SharedWord* base, const RingGeometry& geometry,
                              std::uint64_t sequence) noexcept {
  return base + kCacheLine / 8 + sequence % geometry.slots * geometry.slot_words();
}

// Calls function(i) for all i < count, eight to a turn of the loop: compilers unroll no loop of atomic words,
// and a turn costs more than a word.
template <class Function>
inline void for_each_word(std::size_t count, const Function& function) noexcept {
  const auto turn = [&]<std::size_t... k>(std::size_t i, std::index_sequence<k...>) {
    (function(i + k), ...);
  };
  constexpr std::size_t kTogether = 8;
  std::size_t i = 0;
  for (const std::size_t last = count - count % kTogether; i < last; i += kTogether) {
    turn(i, std::make_index_sequence<kTogether>{});
  }
  for (; i < count; ++i) {
    function(i);
  }
}

inline void store_words(SharedWord* words, const void* value, std::size_t bytes) noexcept {
  const auto* source = static_cast<const unsigned char*>(value);
  const std::size_t whole = bytes / 8;
  for_each_word(whole, [&](std::size_t i) {
    std::uint64_t word;
    std::memcpy(&word, source + i * 8, 8);
    words[i].store(word, std::memory_order_release);  // W2
  });
  if (bytes % 8 != 0) {
    std::uint64_t word = 0;
    std::memcpy(&word, source + whole * 8, bytes % 8);
    words[whole].store(word, std::memory_order_release);
  }
}

inline void load_words(const SharedWord* words, std::uint64_t* copy, std::size_t count) noexcept {
  for_each_word(count, [&](std::size_t i) {
    copy[i] = words[i].load(std::memory_order_acquire);  // R3
  });
}

inline std::uint64_t published(const SharedWord* base) noexcept {
  return base->load(std::memory_order_acquire);  // R1
}

// Publishes a value; never waits. Returns its sequence. One caller at a time.
inline std::uint64_t publish(SharedWord* base, const RingGeometry& geometry, const void* value,
                             std::int64_t stamp_ns) noexcept {
  // Only this side stores here, so it sees its own last store; after a restart, the kernel that handed over
  // the memory ordered it.
  const std::uint64_t sequence = base->load(std::memory_order_relaxed) + 1;
  SharedWord* const words = slot(base, geometry, sequence);
  words[0].store(0, std::memory_order_relaxed);                                     // W1
  words[1].store(static_cast<std::uint64_t>(stamp_ns), std::memory_order_release);  // W2
  store_words(words + 2, value, geometry.value_bytes);                              // W2
  words[0].store(sequence, std::memory_order_release);                              // W3
  base->store(sequence, std::memory_order_release);                                 // W4
  return sequence;
}

// Copies value `sequence`, stamp first, into `copy` (1 + value_words() words). False: overtaken.
inline bool try_copy(const SharedWord* base, const RingGeometry& geometry, std::uint64_t sequence,
                     std::uint64_t* copy) noexcept {
  const SharedWord* const words = slot(base, geometry, sequence);
  if (words[0].load(std::memory_order_acquire) != sequence) {  // R2
    return false;
  }
  load_words(words + 1, copy, 1 + geometry.value_words());      // R3
  return words[0].load(std::memory_order_relaxed) == sequence;  // R4
}

}  // namespace ring
}  // namespace gaitway::msgclient
