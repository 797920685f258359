// Frames in streams: whole, cut, flipped, among garbage.
#include "gaitway/link/frame_codec.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace gaitway::link {
namespace {

using Stream = std::vector<std::uint8_t>;

Stream frame_of(Bytes content) {
  Stream wire(kMostFrameBytes);
  wire.resize(encode_frame(content, wire));
  return wire;
}

std::vector<Stream> decode_all(FrameDecoder& decoder, Bytes stream) {
  std::vector<Stream> frames;
  for (const std::uint8_t byte : stream) {
    if (const auto content = decoder.take(byte)) frames.emplace_back(content->begin(), content->end());
  }
  return frames;
}

Stream random_content(std::mt19937_64& random) {
  Stream content(1 + random() % kMostContentBytes);
  const bool sparse = random() % 2 == 0;
  std::ranges::generate(content,
                        [&] { return static_cast<std::uint8_t>(sparse && random() % 3 ? 0 : random()); });
  return content;
}

TEST(FrameCodec, LooksAsTheReadmeSays) {
  const Stream content{0x11, 0x00, 0x22};
  const Stream wire = frame_of(content);
  ASSERT_EQ(wire.size(), content.size() + kFramingBytes);
  EXPECT_EQ(Stream(wire.begin(), wire.begin() + 4), (Stream{0x00, 0x02, 0x11, wire[3]}));
  EXPECT_EQ(wire[4], 0x22);
  EXPECT_EQ(wire.back(), 0x00);
  EXPECT_EQ(std::count(wire.begin(), wire.end(), 0), 2);
}

TEST(FrameCodec, GivesBackWhatWasEncoded) {
  std::mt19937_64 random(1);
  FrameDecoder decoder;
  for (int i = 0; i < 2000; ++i) {
    const Stream content = random_content(random);
    const auto frames = decode_all(decoder, frame_of(content));
    ASSERT_EQ(frames.size(), 1U);
    EXPECT_EQ(frames[0], content);
  }
  EXPECT_EQ(decoder.counts().whole, 2000U);
}

TEST(FrameCodec, RefusesWhatIsEmptyOrTooLong) {
  Stream wire(kMostFrameBytes + 10);
  EXPECT_EQ(encode_frame({}, wire), 0U);
  EXPECT_EQ(encode_frame(Stream(kMostContentBytes + 1), wire), 0U);
  EXPECT_EQ(encode_frame(Stream(10), std::span(wire).first(10)), 0U);
}

TEST(FrameCodec, GarbageInFrontCostsNoFrame) {
  Stream stream{1, 2, 3, 0xFF};
  const Stream content{5, 0, 5};
  std::ranges::copy(frame_of(content), std::back_inserter(stream));
  FrameDecoder decoder;
  const auto frames = decode_all(decoder, stream);
  ASSERT_EQ(frames.size(), 1U);
  EXPECT_EQ(frames[0], content);
  EXPECT_EQ(decoder.counts().torn + decoder.counts().corrupt, 1U);
}

TEST(FrameCodec, AnEndlessFrameCostsOnlyItself) {
  Stream stream(5000, 7);
  const Stream content{5, 0, 5};
  std::ranges::copy(frame_of(content), std::back_inserter(stream));
  FrameDecoder decoder;
  EXPECT_EQ(decode_all(decoder, stream).size(), 1U);
  EXPECT_EQ(decoder.counts().oversized, 1U);
}

TEST(FrameCodec, EachOfUpToThreeFlippedBitsIsSeen) {
  std::mt19937_64 random(2);
  for (int i = 0; i < 5000; ++i) {
    const Stream content = random_content(random);
    Stream wire = frame_of(content);
    for (std::uint64_t flips = 1 + random() % 3; flips > 0; --flips) {
      wire[random() % wire.size()] ^= static_cast<std::uint8_t>(1U << (random() % 8));
    }
    FrameDecoder decoder;
    for (const Stream& frame : decode_all(decoder, wire)) {
      EXPECT_EQ(frame, content);  // flipped back, or outside of it
    }
  }
}

TEST(FrameCodec, EachLostOrDoubledByteIsSeen) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 5000; ++i) {
    const Stream content = random_content(random);
    Stream wire = frame_of(content);
    const auto place = wire.begin() + static_cast<std::ptrdiff_t>(random() % wire.size());
    if (random() % 2 == 0) {
      wire.erase(place);
    } else {
      wire.insert(place, *place);
    }
    wire.push_back(0);
    FrameDecoder decoder;
    for (const Stream& frame : decode_all(decoder, wire)) {
      EXPECT_EQ(frame, content);  // one of the zeros at its ends
    }
  }
}

}  // namespace
}  // namespace gaitway::link
