// The frames on their way out, byte for byte.
#include "outgoing_queue.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace gaitway::api {
namespace {

Frame frame(std::string text, bool binary = false) {
  return {std::make_shared<const std::string>(std::move(text)), binary};
}

std::string bytes(OutgoingQueue& queue) {
  std::string all;
  for (const auto& buffer : queue.gather()) {
    all.append(static_cast<const char*>(buffer.data()), buffer.size());
  }
  return all;
}

TEST(OutgoingQueue, WritesLengthsAsTheProtocolWantsThem) {
  using namespace std::string_literals;
  const std::pair<std::size_t, std::string> headers[] = {{0, "\x81\x00"s},
                                                         {125, "\x81\x7D"s},
                                                         {126, "\x81\x7E\x00\x7E"s},
                                                         {65535, "\x81\x7E\xFF\xFF"s},
                                                         {65536, "\x81\x7F\0\0\0\0\0\1\0\0"s}};
  for (const auto& [size, header] : headers) {
    OutgoingQueue queue;
    const std::string text(size, 'x');
    queue.append(frame(text));
    EXPECT_EQ(queue.bytes(), header.size() + size);
    EXPECT_EQ(bytes(queue), header + text) << size;
  }
  OutgoingQueue queue;
  queue.append(frame("b", true));
  EXPECT_EQ(bytes(queue),
            "\x82\x01"
            "b");
}

TEST(OutgoingQueue, GoesOnWhereAWriteEnded) {
  std::string expected;
  OutgoingQueue queue;
  for (int count = 0; count < 100; ++count) {
    const std::string text(static_cast<std::size_t>(count), static_cast<char>('a' + count % 26));
    queue.append(frame(text));
    expected += '\x81';
    expected += static_cast<char>(count);
    expected += text;
  }
  std::string written;
  for (std::size_t step = 1; !queue.empty(); step = step % 37 + 1) {
    const std::string next = bytes(queue);
    const std::size_t taken = std::min(step, next.size());
    written += next.substr(0, taken);
    const auto progress = queue.consume(taken);
    EXPECT_FALSE(progress.finished_raw);
  }
  EXPECT_EQ(written, expected);
  EXPECT_EQ(queue.bytes(), 0U);
}

TEST(OutgoingQueue, TellsWhenBytesOfItsOwnHaveGone) {
  OutgoingQueue queue;
  queue.append(frame("message"));
  queue.append_raw("control");
  queue.append(frame("further"));
  EXPECT_FALSE(queue.consume(8).finished_any);
  const auto message = queue.consume(1);
  EXPECT_TRUE(message.finished_any);
  EXPECT_FALSE(message.finished_raw);
  EXPECT_FALSE(queue.consume(6).finished_raw);
  EXPECT_TRUE(queue.consume(4).finished_raw);
}

TEST(OutgoingQueue, DropsMessagesButNotHalfOnesNorControlFrames) {
  OutgoingQueue queue;
  queue.append(frame("begun"));
  queue.append(frame("waits"));
  queue.append_raw("ping");
  queue.append(frame("waits, too"));
  static_cast<void>(queue.consume(3));
  queue.drop_messages(false);
  EXPECT_EQ(bytes(queue),
            "egun"
            "ping");
  EXPECT_EQ(queue.bytes(), 8U);
}

TEST(OutgoingQueue, DropsNothingThatAWriteIsUsing) {
  OutgoingQueue queue;
  queue.append(frame("one"));
  queue.append(frame("two"));
  static_cast<void>(queue.gather());
  queue.append(frame("three"));
  queue.drop_messages(true);
  EXPECT_EQ(queue.bytes(), 10U);
  EXPECT_EQ(queue.frames(), 2U);
}

}  // namespace
}  // namespace gaitway::api
