// The ring between its two sides: overtaking, half-written slots, and both roles as threads over one mapping,
// where the thread sanitizer can see them.
#include "gaitway/msgclient/ring.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <thread>
#include <vector>

#include "checked_value.hpp"
#include "gaitway/msgclient/handles.hpp"
#include "gaitway/msgclient/memory_block.hpp"

namespace gaitway::msgclient {
namespace {

using Value = CheckedValue<128>;  // 1 KiB

TopicDescriptor descriptor_of(TopicKind kind, std::uint32_t capacity = 0) {
  return {"checked", "CheckedValue", 1, sizeof(Value), kind, capacity};
}

class RingTest : public testing::Test {
 protected:
  static constexpr RingGeometry kGeometry{sizeof(Value), 4};
  SharedWord* base() { return memory.data(); }
  void publish(std::uint64_t seed) {
    Value value;
    value.fill(seed);
    ring::publish(base(), kGeometry, &value, static_cast<std::int64_t>(seed));
  }
  bool copy(std::uint64_t sequence) {
    std::vector<std::uint64_t> words(1 + kGeometry.value_words());
    const bool whole = ring::try_copy(base(), kGeometry, sequence, words.data());
    return whole && words[0] == sequence && words[1] == sequence;
  }

  std::vector<SharedWord> memory = std::vector<SharedWord>(kGeometry.bytes() / 8);
};

TEST_F(RingTest, KeepsAsManyValuesAsItHasSlots) {
  for (std::uint64_t i = 1; i <= 9; ++i) {
    publish(i);
  }
  EXPECT_EQ(ring::published(base()), 9u);
  for (std::uint64_t sequence = 6; sequence <= 9; ++sequence) {
    EXPECT_TRUE(copy(sequence)) << sequence;
  }
  EXPECT_FALSE(copy(5)) << "overwritten by 9";
  EXPECT_FALSE(copy(10)) << "not there yet";
}

// A writer that stops after any of its stores leaves the newest value whole, and the torn one is never taken
// for a value.
TEST_F(RingTest, AWriterThatStopsAnywhereHarmsOnlyTheOldestValue) {
  for (std::uint64_t i = 1; i <= 7; ++i) {
    publish(i);
  }
  SharedWord* const slot = ring::slot(base(), kGeometry, 8);  // that of value 4
  ASSERT_TRUE(copy(4));
  slot[0] = 0;
  for (std::size_t stored = 0; stored <= kGeometry.value_words(); ++stored) {
    EXPECT_FALSE(copy(4)) << "after " << stored << " words";
    EXPECT_FALSE(copy(8)) << "after " << stored << " words";
    EXPECT_TRUE(copy(7)) << "after " << stored << " words";
    EXPECT_EQ(ring::published(base()), 7u);
    slot[1 + stored] = ~std::uint64_t{0};
  }
  slot[0] = 8;  // stopped before publishing: still not the newest
  EXPECT_EQ(ring::published(base()), 7u);
  publish(8);  // the successor
  EXPECT_TRUE(copy(8));
  EXPECT_TRUE(copy(7));
}

TEST(UntypedReader, TriesAgainWhenOvertakenAndGivesUpAfterABoundedNumber) {
  // The slot of the newest value says that it is being written: what a writer looks like that overtakes all
  // the time.
  TopicGrant grant;
  grant.descriptor = descriptor_of(TopicKind::latest);
  grant.geometry = {sizeof(Value), 4};
  grant.storage = std::make_shared<const Segment>(Segment::create("overtaken", 8192));
  auto* const base = static_cast<SharedWord*>(grant.storage->data());
  Value value;
  value.fill(1);
  ring::publish(base, grant.geometry, &value, 1);
  ring::slot(base, grant.geometry, 1)[0] = 0;
  UntypedReader overtaken(std::move(grant));
  Value untouched;
  untouched.fill(77);
  EXPECT_EQ(overtaken.read(&untouched).status, ReadStatus::overtaken);
  EXPECT_EQ(untouched.word[0], 77u) << "the last value stays";
  EXPECT_EQ(overtaken.retries(), static_cast<std::uint64_t>(ring::kMaxAttempts));
  ring::slot(base, {sizeof(Value), 4}, 1)[0] = 1;
  EXPECT_EQ(overtaken.read(&untouched).status, ReadStatus::value);
  EXPECT_EQ(untouched.word[0], 1u);
}

TEST(RingStress, NoReaderEverSeesATornValueOrGoesBack) {
  constexpr std::uint64_t kValues = 60'000;
  MemoryBlock block;
  Client client = block.local_client("stress");
  UntypedWriter writer = client.write_untyped(descriptor_of(TopicKind::latest));
  std::vector<UntypedReader> readers;
  for (int i = 0; i < 2; ++i) {
    readers.push_back(client.read_untyped(descriptor_of(TopicKind::latest)));
  }
  std::vector<std::uint64_t> torn(readers.size()), backwards(readers.size()), whole(readers.size());
  std::vector<std::thread> threads;
  for (std::size_t i = 0; i < readers.size(); ++i) {
    threads.emplace_back([&, i] {
      Value value;
      std::uint64_t last = 0;
      while (last < kValues) {
        const ReadResult result = readers[i].read(&value);
        if (!result) {
          continue;
        }
        torn[i] += value.whole() && value.word[0] == result.sequence ? 0u : 1u;
        backwards[i] += result.sequence < last ? 1u : 0u;
        last = result.sequence;
        ++whole[i];
      }
    });
  }
  Value value;
  for (std::uint64_t i = 1; i <= kValues; ++i) {
    value.fill(i);
    writer.publish(&value, 0);
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  for (std::size_t i = 0; i < readers.size(); ++i) {
    EXPECT_EQ(torn[i], 0u);
    EXPECT_EQ(backwards[i], 0u);
    EXPECT_GT(whole[i], 0u);
  }
}

// Two slots and a busy writer: overtaking is the rule here, so that the detection itself is put to work.
TEST(RingStress, OvertakenCopiesAreDetected) {
  constexpr RingGeometry kTwoSlots{sizeof(Value), 2};
  std::vector<SharedWord> memory(kTwoSlots.bytes() / 8);
  std::atomic<bool> done{false};
  std::thread writer([&] {
    Value value;
    for (std::uint64_t i = 1; i <= 60'000 || !done.load(); ++i) {
      value.fill(i);
      ring::publish(memory.data(), kTwoSlots, &value, 0);
    }
  });
  std::vector<std::uint64_t> copy(1 + kTwoSlots.value_words());
  std::uint64_t torn = 0, detected = 0, whole = 0;
  // A loaded machine may let the writer wait: time bounds the loop, not a number of looks.
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(30);
  while ((detected < 100 || whole < 100) && std::chrono::steady_clock::now() < deadline) {
    const std::uint64_t sequence = ring::published(memory.data());
    if (sequence == 0) {
      continue;
    }
    if (!ring::try_copy(memory.data(), kTwoSlots, sequence, copy.data())) {
      ++detected;
      continue;
    }
    Value value;
    std::memcpy(value.word.data(), copy.data() + 1, sizeof value.word);
    torn += value.whole() && value.word[0] == sequence ? 0u : 1u;
    ++whole;
  }
  done = true;
  writer.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_GT(whole, 0u);
  EXPECT_GT(detected, 0u);
}

TEST(Stream, EachReaderGetsAllInOrderAndCountsWhatItMissed) {
  MemoryBlock block;
  Client client = block.local_client("a");
  UntypedWriter writer = client.write_untyped(descriptor_of(TopicKind::stream, 4));
  UntypedStreamReader keeps_up = client.read_stream_untyped(descriptor_of(TopicKind::stream));
  UntypedStreamReader falls_behind = client.read_stream_untyped(descriptor_of(TopicKind::stream));
  Value value;
  for (std::uint64_t i = 1; i <= 10; ++i) {
    value.fill(i);
    writer.publish(&value, 0);
    ASSERT_EQ(keeps_up.read(&value).sequence, i);
    EXPECT_EQ(keeps_up.read(&value).status, ReadStatus::none);
  }
  EXPECT_EQ(keeps_up.missed(), 0u);
  for (std::uint64_t i = 7; i <= 10; ++i) {
    ASSERT_EQ(falls_behind.read(&value).sequence, i);
    EXPECT_EQ(value.word[0], i);
  }
  EXPECT_EQ(falls_behind.read(&value).status, ReadStatus::none);
  EXPECT_EQ(falls_behind.missed(), 6u);

  UntypedStreamReader late = client.read_stream_untyped(descriptor_of(TopicKind::stream));
  EXPECT_EQ(late.read(&value).status, ReadStatus::none) << "begins with the next value";
  UntypedStreamReader historian = client.read_stream_untyped(descriptor_of(TopicKind::stream), true);
  EXPECT_EQ(historian.read(&value).sequence, 7u) << "begins with the oldest";
}

TEST(Stream, UnderStressEveryValueIsReadOrCountedAsMissed) {
  constexpr std::uint64_t kValues = 40'000;
  MemoryBlock block;
  Client client = block.local_client("a");
  UntypedWriter writer = client.write_untyped(descriptor_of(TopicKind::stream, 8));
  UntypedStreamReader reader = client.read_stream_untyped(descriptor_of(TopicKind::stream));
  std::thread thread([&] {
    Value value;
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      value.fill(i);
      writer.publish(&value, 0);
    }
  });
  Value value;
  std::uint64_t read = 0, last = 0, torn = 0;
  while (last < kValues) {
    if (const ReadResult result = reader.read(&value); result) {
      EXPECT_GT(result.sequence, last);
      torn += value.whole() && value.word[0] == result.sequence ? 0u : 1u;
      last = result.sequence;
      ++read;
    }
  }
  thread.join();
  EXPECT_EQ(torn, 0u);
  EXPECT_EQ(read + reader.missed(), kValues);
}

TEST(Queue, RefusesWhenFullAndDeliversInOrder) {
  MemoryBlock block;
  Client client = block.local_client("a");
  UntypedQueueReader reader = client.read_queue_untyped(descriptor_of(TopicKind::queue, 3));
  UntypedQueueWriter writer = client.write_queue_untyped(descriptor_of(TopicKind::queue));
  Value value;
  EXPECT_EQ(reader.pop(&value).status, ReadStatus::none);
  for (std::uint64_t round = 0; round < 5; ++round) {
    for (std::uint64_t i = 1; i <= 4; ++i) {
      value.fill(10 * round + i);
      EXPECT_EQ(writer.push(&value, 0), i <= 3);
    }
    for (std::uint64_t i = 1; i <= 3; ++i) {
      ASSERT_TRUE(reader.pop(&value));
      EXPECT_EQ(value.word[0], 10 * round + i);
    }
    EXPECT_EQ(reader.pop(&value).status, ReadStatus::none);
  }
  EXPECT_EQ(writer.refused(), 5u);
}

// A writer may put what it likes into its own memory before it dies.
class RogueQueueWriter : public UntypedQueueWriter {
 public:
  explicit RogueQueueWriter(UntypedQueueWriter writer) : UntypedQueueWriter(std::move(writer)) {}
  void publish_up_to(std::uint64_t sequence) noexcept { base_->store(sequence); }
};

TEST(Queue, AWriterThatLeavesNonsenseBehindHarmsNoSuccessor) {
  for (const std::uint64_t nonsense :
       {std::uint64_t{2}, std::uint64_t{5}, std::uint64_t{1} << 63U, std::uint64_t{0}, ~std::uint64_t{0}}) {
    MemoryBlock block;
    Client client = block.local_client("api");
    UntypedQueueReader reader =
        block.local_client("message_controller").read_queue_untyped(descriptor_of(TopicKind::queue, 4));
    Value value;
    {
      RogueQueueWriter rogue(client.write_queue_untyped(descriptor_of(TopicKind::queue)));
      value.fill(1);
      ASSERT_TRUE(rogue.push(&value, 0));
      ASSERT_TRUE(reader.pop(&value));
      rogue.publish_up_to(nonsense);
    }
    UntypedQueueWriter successor = client.write_queue_untyped(descriptor_of(TopicKind::queue));
    EXPECT_NE(reader.pop(&value).status, ReadStatus::value) << nonsense;
    for (std::uint64_t i = 10; i < 20; ++i) {
      value.fill(i);
      ASSERT_TRUE(successor.push(&value, 0)) << nonsense;
      ASSERT_TRUE(reader.pop(&value)) << nonsense;
      EXPECT_EQ(value.word[0], i) << nonsense;
    }
  }
}

class RogueStreamWriter : public UntypedWriter {
 public:
  explicit RogueStreamWriter(UntypedWriter writer) : UntypedWriter(std::move(writer)) {}
  void publish_up_to(std::uint64_t sequence) noexcept { base_->store(sequence); }
};

TEST(Stream, AWriterThatGoesBackHarmsNoReaderOfItsSuccessor) {
  MemoryBlock block;
  Client client = block.local_client("a");
  UntypedStreamReader reader = client.read_stream_untyped(descriptor_of(TopicKind::stream, 4));
  Value value;
  {
    RogueStreamWriter rogue(client.write_untyped(descriptor_of(TopicKind::stream)));
    for (std::uint64_t i = 1; i <= 9; ++i) {
      value.fill(i);
      rogue.publish(&value, 0);
      ASSERT_TRUE(reader.read(&value));
    }
    rogue.publish_up_to(2);
  }
  EXPECT_FALSE(reader.read(&value));
  UntypedWriter successor = client.write_untyped(descriptor_of(TopicKind::stream));
  value.fill(77);
  successor.publish(&value, 0);
  ASSERT_TRUE(reader.read(&value));
  EXPECT_EQ(value.word[0], 77u);
}

TEST(Queue, HasOneReaderAtATimeAndANewOneGoesOn) {
  MemoryBlock block;
  Client client = block.local_client("ctl");
  Client controller = block.local_client("message_controller");
  UntypedQueueWriter writer = client.write_queue_untyped(descriptor_of(TopicKind::queue, 4));
  Value value;
  for (std::uint64_t i = 1; i <= 2; ++i) {
    value.fill(i);
    ASSERT_TRUE(writer.push(&value, 0));
  }
  {
    UntypedQueueReader reader = controller.read_queue_untyped(descriptor_of(TopicKind::queue));
    EXPECT_EQ(client.find("checked")->reader, "message_controller");
    EXPECT_THROW((void)client.read_queue_untyped(descriptor_of(TopicKind::queue)), TopicError);
    ASSERT_TRUE(reader.pop(&value));
  }
  UntypedQueueReader next = controller.read_queue_untyped(descriptor_of(TopicKind::queue));
  ASSERT_TRUE(next.pop(&value));
  EXPECT_EQ(value.word[0], 2u);
}

TEST(Queue, UnderStressNothingIsLostDoubledOrTorn) {
  constexpr std::uint64_t kValues = 20'000;
  MemoryBlock block;
  Client client = block.local_client("a");
  UntypedQueueWriter writer = client.write_queue_untyped(descriptor_of(TopicKind::queue, 4));
  UntypedQueueReader reader = client.read_queue_untyped(descriptor_of(TopicKind::queue));
  std::thread thread([&] {
    Value value;
    for (std::uint64_t i = 1; i <= kValues; ++i) {
      value.fill(i);
      while (!writer.push(&value, 0)) {
        std::this_thread::yield();
      }
    }
  });
  Value value;
  std::uint64_t wrong = 0;
  for (std::uint64_t next = 1; next <= kValues;) {
    if (reader.pop(&value)) {
      wrong += value.whole() && value.word[0] == next ? 0u : 1u;
      ++next;
    } else {
      std::this_thread::yield();
    }
  }
  thread.join();
  EXPECT_EQ(wrong, 0u);
}

}  // namespace
}  // namespace gaitway::msgclient
