// Contents of frames down to the byte, and what does not decode.
#include "gaitway/link/messages.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace gaitway::link {
namespace {

struct Content {
  std::array<std::uint8_t, kMostContentBytes> room{};
  std::size_t size = 0;
  [[nodiscard]] Bytes bytes() const { return Bytes(room).first(size); }
};

template <class Message>
Content content_of(const Message& message, std::uint32_t session = 0x04030201) {
  Content content;
  content.size = encode(message, session, content.room);
  return content;
}

TEST(Messages, AreAsLongAsTheirConstantsSay) {
  Content hello;
  EXPECT_EQ(encode(Hello{}, hello.room), kHelloContentBytes);
  EXPECT_EQ(content_of(Status{}).size, kStatusContentBytes);
  EXPECT_EQ(content_of(StopMessage{}).size, kStopContentBytes);
  EXPECT_EQ(content_of(StopAnswer{}).size, kStopAnswerContentBytes);
  EXPECT_EQ(content_of(Part{}).size, kPartHeadBytes);
  EXPECT_EQ(content_of(StateFragment{}).size, kStateHeadBytes);
}

TEST(Messages, LieOnTheWireAsTheReadmeSays) {
  const std::vector<std::uint8_t> payload{0xAA, 0xBB};
  const Content part = content_of(Part{.message = 0x0D0C0B0A, .part = 1, .parts = 2, .payload = payload});
  const std::vector<std::uint8_t> expected{5, 1, 2, 3, 4, 0x0A, 0x0B, 0x0C, 0x0D, 1, 2, 0xAA, 0xBB};
  EXPECT_EQ(std::vector(part.bytes().begin(), part.bytes().end()), expected);
  EXPECT_EQ(kind_of(part.bytes()), FrameKind::part);
  EXPECT_EQ(session_of(part.bytes()), 0x04030201U);
}

TEST(Messages, DecodeToWhatTheyWere) {
  Hello hello{.role = Role::controller,
              .open = true,
              .self = {1, 2},
              .heard = {3, 4},
              .table_hash = 5,
              .robot_hash = 7,
              .calibration_hash = 8,
              .time_ns = 6};
  hello.name[0] = 'g';
  Content content;
  content.size = encode(hello, content.room);
  Hello back;
  ASSERT_TRUE(decode(content.bytes(), back));
  EXPECT_EQ(back.self, hello.self);
  EXPECT_EQ(back.heard, hello.heard);
  EXPECT_EQ(back.time_ns, 6);
  EXPECT_TRUE(back.open);
  EXPECT_EQ(back.table_hash, 5U);
  EXPECT_EQ(back.robot_hash, 7U);
  EXPECT_EQ(back.calibration_hash, 8U);
  EXPECT_EQ(back.name, hello.name);

  Status status;
  ASSERT_TRUE(decode(content_of(Status{1, 2, 3, 4, 5, 6}).bytes(), status));
  EXPECT_EQ(status.time_ns, 1);
  EXPECT_EQ(status.state_received, 6U);

  StopMessage stop;
  ASSERT_TRUE(decode(content_of(StopMessage{{1, 2, 3}, {4, 5, 6}}).bytes(), stop));
  EXPECT_EQ(stop.settled, (StopCounts{4, 5, 6}));
}

TEST(Messages, AHelloTellsItsVersionWhateverFollows) {
  const std::vector<std::uint8_t> of_the_future{1, 0, 0, 0, 0, 0x09, 0x03, 'n', 'e', 'w'};
  EXPECT_EQ(version_of_hello(of_the_future), 0x0309);
  EXPECT_FALSE(version_of_hello(Bytes(of_the_future).first(kHeaderBytes + 1)));
  EXPECT_FALSE(version_of_hello(content_of(Status{}).bytes()));
}

TEST(Messages, OfAnotherKindOrLengthDoNotDecode) {
  const Content status = content_of(Status{});
  StopAnswer answer;
  EXPECT_FALSE(decode(status.bytes(), answer));
  Status back;
  EXPECT_FALSE(decode(status.bytes().first(status.size - 1), back));
  EXPECT_FALSE(kind_of(Bytes{}));
  const std::vector<std::uint8_t> unknown{9, 0, 0, 0, 0};
  EXPECT_FALSE(kind_of(unknown));
}

TEST(Messages, ThatContradictThemselvesDoNotDecode) {
  Status status;
  EXPECT_FALSE(decode(content_of(Status{.time_ns = -1}).bytes(), status));
  EXPECT_FALSE(decode(content_of(Status{.time_ns = kMostTime_ns + 1}).bytes(), status));
  Part part;
  EXPECT_FALSE(decode(content_of(Part{.message = 1, .part = 2, .parts = 2}).bytes(), part));
  EXPECT_FALSE(decode(content_of(Part{.message = 0}).bytes(), part));
  const std::vector<std::uint8_t> payload(10);
  StateFragment fragment{
      .total_bytes = 25, .fragment = 2, .fragment_bytes = 10, .payload = Bytes(payload).first(5)};
  EXPECT_TRUE(decode(content_of(fragment).bytes(), fragment));
  fragment.payload = payload;  // the last one has five
  EXPECT_FALSE(decode(content_of(fragment).bytes(), fragment));
  fragment = {.total_bytes = 25, .fragment = 3, .fragment_bytes = 10};
  EXPECT_FALSE(decode(content_of(fragment).bytes(), fragment));
  fragment = {.total_bytes = 25, .fragment = 0, .fragment_bytes = 0};
  EXPECT_FALSE(decode(content_of(fragment).bytes(), fragment));
}

}  // namespace
}  // namespace gaitway::link
