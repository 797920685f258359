// Our topic, and a raw seqlock.
#include <atomic>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "gaitway/msgclient/memory_block.hpp"
#include "topic_rival.hpp"

namespace gaitway::peers {
namespace {

class OurTopic final : public TopicRival {
 public:
  explicit OurTopic(std::size_t bytes)
      : TopicRival("gaitway"),
        descriptor_{"sample", "Sample", 1, static_cast<std::uint32_t>(bytes), msgclient::TopicKind::latest,
                    0},
        written_(bytes / sizeof(std::uint64_t)),
        seen_(written_.size()) {}
  std::size_t write_and_read(std::size_t pairs) override {
    std::size_t whole = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
      ++written_[0];
      writer_.publish(written_.data(), 0);
      reader_.read(seen_.data());
      if (seen_[0] == written_[0]) ++whole;
    }
    return whole;
  }

 private:
  msgclient::MemoryBlock block_;
  msgclient::Client client_ = block_.local_client("bench");
  msgclient::TopicDescriptor descriptor_;
  msgclient::UntypedWriter writer_ = client_.write_untyped(descriptor_);
  msgclient::UntypedReader reader_ = client_.read_untyped(descriptor_);
  std::vector<std::uint64_t> written_, seen_;
};

// The payload as relaxed atomic words, fenced as H.-J. Boehm, "Can seqlocks get along with programming
// language memory models?", MSPC 2012.
class Seqlock {
 public:
  explicit Seqlock(std::size_t words) : words_(words) {}
  void write(const std::uint64_t* value) noexcept {
    const std::uint64_t before = sequence_.load(std::memory_order_relaxed);
    sequence_.store(before + 1, std::memory_order_relaxed);
    std::atomic_thread_fence(std::memory_order_release);
    std::atomic<std::uint64_t>* const to = words_.data();
    for (std::size_t i = 0, count = words_.size(); i < count; ++i) {
      to[i].store(value[i], std::memory_order_relaxed);
    }
    sequence_.store(before + 2, std::memory_order_release);
  }
  void read(std::uint64_t* value) const noexcept {
    const std::atomic<std::uint64_t>* const from = words_.data();
    const std::size_t count = words_.size();
    for (;;) {
      const std::uint64_t before = sequence_.load(std::memory_order_acquire);
      for (std::size_t i = 0; i < count; ++i) value[i] = from[i].load(std::memory_order_relaxed);
      std::atomic_thread_fence(std::memory_order_acquire);
      if (before % 2 == 0 && sequence_.load(std::memory_order_relaxed) == before) return;
    }
  }

 private:
  std::atomic<std::uint64_t> sequence_{0};
  std::vector<std::atomic<std::uint64_t>> words_;
};

class SeqlockTopic final : public TopicRival {
 public:
  explicit SeqlockTopic(std::size_t bytes)
      : TopicRival("seqlock"),
        lock_(bytes / sizeof(std::uint64_t)),
        written_(bytes / sizeof(std::uint64_t)),
        seen_(written_.size()) {}
  std::size_t write_and_read(std::size_t pairs) override {
    std::size_t whole = 0;
    for (std::size_t i = 0; i < pairs; ++i) {
      ++written_[0];
      lock_.write(written_.data());
      lock_.read(seen_.data());
      if (seen_[0] == written_[0]) ++whole;
    }
    return whole;
  }

 private:
  Seqlock lock_;
  std::vector<std::uint64_t> written_, seen_;
};

}  // namespace

std::unique_ptr<TopicRival> our_topic(std::size_t bytes) {
  return std::make_unique<OurTopic>(bytes);
}
std::unique_ptr<TopicRival> seqlock_topic(std::size_t bytes) {
  return std::make_unique<SeqlockTopic>(bytes);
}

}  // namespace gaitway::peers
