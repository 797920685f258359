// What a program holds to write and read topics. Made by Client; the calls below are for the cycle: no lock,
// no allocation, no system call, no exception. Each handle is for one thread at a time, and keeps its memory
// mapped when client and block go. "model: NAME.N" names a step of the models in tests/models.
#pragma once

#include <algorithm>
#include <functional>
#include <memory>
#include <vector>

#include "gaitway/msgclient/ring.hpp"
#include "gaitway/msgclient/segment.hpp"
#include "gaitway/msgclient/topic.hpp"

namespace gaitway::msgclient {

// The right to write a topic (or to read a queue); given back on destruction.
class Claim {
 public:
  Claim() = default;
  explicit Claim(std::function<void()> release) : release_(std::move(release)) {}
  Claim(Claim&& other) noexcept : release_(std::exchange(other.release_, nullptr)) {}
  Claim& operator=(Claim&& other) noexcept {
    release_.swap(other.release_);
    return *this;
  }
  ~Claim() {
    if (release_) {
      release_();  // model: release.1
    }
  }

 private:
  std::function<void()> release_;
};

// What set-up gives to make a handle of.
struct TopicGrant {
  TopicDescriptor descriptor;  // as declared
  RingGeometry geometry;
  std::uint32_t generation = 0;
  std::shared_ptr<const Segment> storage;  // written by the writer
  std::shared_ptr<const Segment> cursor;   // of a queue: written by its reader
  Claim claim;
};

class TopicHandle {
 public:
  [[nodiscard]] const TopicDescriptor& descriptor() const noexcept { return grant_.descriptor; }
  // How often the topic had been claimed by a writer when this handle was made.
  [[nodiscard]] std::uint32_t generation() const noexcept { return grant_.generation; }

 protected:
  explicit TopicHandle(TopicGrant grant) : grant_(std::move(grant)), base_(words(*grant_.storage)) {}
  static SharedWord* words(const Segment& segment) noexcept {
    return static_cast<SharedWord*>(segment.data());
  }

  TopicGrant grant_;
  SharedWord* base_;
};

// Publishes values of a latest-value topic or a stream.
class UntypedWriter : public TopicHandle {
 public:
  explicit UntypedWriter(TopicGrant grant) : TopicHandle(std::move(grant)) {}
  // `value`: descriptor().size bytes. Returns the value's sequence.
  std::uint64_t publish(const void* value, std::int64_t stamp_ns) noexcept {
    return ring::publish(base_, grant_.geometry, value, stamp_ns);
  }
};

// A reader's own copy: a value reaches the caller only when it is whole.
class CopyingReader : public TopicHandle {
 protected:
  explicit CopyingReader(TopicGrant grant)
      : TopicHandle(std::move(grant)), copy_(1 + grant_.geometry.value_words()) {}

  [[nodiscard]] bool copy(std::uint64_t sequence) noexcept {
    return ring::try_copy(base_, grant_.geometry, sequence, copy_.data());
  }
  ReadResult deliver(std::uint64_t sequence, void* value) const noexcept {
    std::memcpy(value, copy_.data() + 1, grant_.geometry.value_bytes);
    return {ReadStatus::value, sequence, static_cast<std::int64_t>(copy_[0])};
  }

 private:
  std::vector<std::uint64_t> copy_;
};

// Reads the newest value of a latest-value topic.
class UntypedReader : public CopyingReader {
 public:
  explicit UntypedReader(TopicGrant grant) : CopyingReader(std::move(grant)) {}
  // Fills `value` (descriptor().size bytes) with the newest whole value; leaves it untouched unless the
  // status is `value`.
  ReadResult read(void* value) noexcept {
    for (int attempt = 0; attempt < ring::kMaxAttempts; ++attempt) {
      const std::uint64_t sequence = ring::published(base_);
      if (sequence == 0) {
        return {};
      }
      if (copy(sequence)) {
        return deliver(sequence, value);
      }
      ++retries_;
    }
    return {ReadStatus::overtaken, 0, 0};
  }
  // Sequence of the newest value without reading it; 0: none.
  [[nodiscard]] std::uint64_t newest_sequence() const noexcept { return ring::published(base_); }
  // How often the writer overtook this reader since it was made.
  [[nodiscard]] std::uint64_t retries() const noexcept { return retries_; }

 private:
  std::uint64_t retries_ = 0;
};

// Reads a stream in order, from the first value after it was opened (or the oldest still there, if asked).
class UntypedStreamReader : public CopyingReader {
 public:
  explicit UntypedStreamReader(TopicGrant grant, bool from_oldest = false)  // model: stream_open.1
      : CopyingReader(std::move(grant)), next_(from_oldest ? 1 : ring::published(base_) + 1) {}
  // The next value; `none` when all were read. What the writer has overwritten is skipped and counted.
  ReadResult read(void* value) noexcept {
    for (int attempt = 0; attempt < ring::kMaxAttempts; ++attempt) {
      const std::uint64_t newest = ring::published(base_);  // model: stream_read.1
      next_ = std::min(next_, newest + 1);  // a writer that breaks the rules may have gone back
      if (next_ > newest) {
        return {};
      }
      // The writer may be at work in the slot of newest + 1: one slot less than there are can be relied on.
      const std::uint64_t reliable = grant_.geometry.slots - 1;
      const std::uint64_t oldest = newest > reliable ? newest - reliable + 1 : 1;
      if (next_ < oldest) {
        missed_ += oldest - next_;  // model: stream_read.2
        next_ = oldest;
      }
      if (copy(next_)) {
        return deliver(next_++, value);
      }
    }
    return {ReadStatus::overtaken, 0, 0};
  }
  [[nodiscard]] std::uint64_t missed() const noexcept { return missed_; }

 private:
  std::uint64_t next_;
  std::uint64_t missed_ = 0;
};

// A bounded command queue's two ends. The reader's word `taken` lies in memory that only the reader can
// write.
//   Push: reads `taken` (acquire: the reader's loads of that slot happened before), writes the slot,
//   publishes (release). Pop: reads `published` (acquire), reads the slot, stores `taken` (release).
// A slot is never written while it may be read, so nothing is overtaken.
class UntypedQueueWriter : public TopicHandle {
 public:
  explicit UntypedQueueWriter(TopicGrant grant)
      : TopicHandle(std::move(grant)), taken_(words(*grant_.cursor)) {}
  // False: the queue is full, and the value was not taken; counted.
  [[nodiscard]] bool push(const void* value, std::int64_t stamp_ns) noexcept {
    const std::uint64_t waiting =  // model: push.1
        base_->load(std::memory_order_relaxed) - taken_->load(std::memory_order_acquire);
    if (waiting >= grant_.geometry.slots) {
      ++refused_;
      return false;
    }
    ring::publish(base_, grant_.geometry, value, stamp_ns);
    return true;
  }
  [[nodiscard]] std::uint64_t refused() const noexcept { return refused_; }

 private:
  const SharedWord* taken_;
  std::uint64_t refused_ = 0;
};

class UntypedQueueReader : public CopyingReader {
 public:
  explicit UntypedQueueReader(TopicGrant grant)
      : CopyingReader(std::move(grant)), taken_(words(*grant_.cursor)) {}
  // The oldest value that waits, or `none`. What a writer that broke the rules has left behind (more values
  // than there are slots, or values that are not whole) is passed over, so that its successor's queue is
  // not full for ever.
  ReadResult pop(void* value) noexcept {
    const std::uint64_t newest = ring::published(base_);  // model: pop.1
    std::uint64_t taken = taken_->load(std::memory_order_relaxed);
    if (newest - taken > grant_.geometry.slots) {
      taken = newest;
      taken_->store(taken, std::memory_order_release);
    }
    while (taken != newest) {
      const bool whole = copy(++taken);
      taken_->store(taken, std::memory_order_release);  // model: pop.2
      if (whole) {
        return deliver(taken, value);
      }
    }
    return {};
  }

 private:
  SharedWord* taken_;
};

// Typed faces of the above.
template <class T>
class Writer {
 public:
  explicit Writer(UntypedWriter untyped) : untyped_(std::move(untyped)) {}
  std::uint64_t publish(const T& value, std::int64_t stamp_ns) noexcept {
    return untyped_.publish(&value, stamp_ns);
  }
  [[nodiscard]] const UntypedWriter& untyped() const noexcept { return untyped_; }

 private:
  UntypedWriter untyped_;
};

template <class T>
class Reader {
 public:
  explicit Reader(UntypedReader untyped) : untyped_(std::move(untyped)) {}
  ReadResult read(T& value) noexcept { return untyped_.read(&value); }
  [[nodiscard]] std::uint64_t newest_sequence() const noexcept { return untyped_.newest_sequence(); }
  [[nodiscard]] const UntypedReader& untyped() const noexcept { return untyped_; }

 private:
  UntypedReader untyped_;
};

template <class T>
class StreamReader {
 public:
  explicit StreamReader(UntypedStreamReader untyped) : untyped_(std::move(untyped)) {}
  ReadResult read(T& value) noexcept { return untyped_.read(&value); }
  [[nodiscard]] std::uint64_t missed() const noexcept { return untyped_.missed(); }

 private:
  UntypedStreamReader untyped_;
};

template <class T>
class QueueWriter {
 public:
  explicit QueueWriter(UntypedQueueWriter untyped) : untyped_(std::move(untyped)) {}
  [[nodiscard]] bool push(const T& value, std::int64_t stamp_ns) noexcept {
    return untyped_.push(&value, stamp_ns);
  }
  [[nodiscard]] std::uint64_t refused() const noexcept { return untyped_.refused(); }

 private:
  UntypedQueueWriter untyped_;
};

template <class T>
class QueueReader {
 public:
  explicit QueueReader(UntypedQueueReader untyped) : untyped_(std::move(untyped)) {}
  ReadResult pop(T& value) noexcept { return untyped_.pop(&value); }

 private:
  UntypedQueueReader untyped_;
};

}  // namespace gaitway::msgclient
