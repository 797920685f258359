// What two processes of one simulation say to each other.
#include "gaitway/timeline/copy_channel.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <string>

namespace gaitway::timeline {
namespace {

TEST(CopyChannel, CarriesMessagesBothWaysWhole) {
  auto [here, there] = CopyChannel::pair();
  EXPECT_FALSE(here.receive(0));
  here.send({{"do", "advance"}, {"to_ns", 12}});
  here.send({{"text", std::string(100'000, 'x')}});
  there.send({{"at_ns", 12}});
  EXPECT_EQ(there.receive(CopyChannel::kForEver)->message.at("to_ns"), 12);
  EXPECT_EQ(there.receive(CopyChannel::kForEver)->message.at("text").get<std::string>().size(), 100'000U);
  EXPECT_EQ(here.receive(CopyChannel::kForEver)->message.at("at_ns"), 12);
}

TEST(CopyChannel, PassesADescriptorOn) {
  auto [here, there] = CopyChannel::pair();
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
  const process::FileDescriptor reading(ends[0]);
  {
    const process::FileDescriptor writing(ends[1]);
    here.send({{"copied", 1}}, writing.get());
  }
  const auto packet = there.receive(CopyChannel::kForEver);
  ASSERT_TRUE(packet->passed);
  ASSERT_EQ(write(packet->passed.get(), "!", 1), 1);
  char byte = 0;
  ASSERT_EQ(read(reading.get(), &byte, 1), 1);
  EXPECT_EQ(byte, '!');
}

TEST(CopyChannel, TellsThatTheOtherEndIsGone) {
  auto [here, there] = CopyChannel::pair();
  { const CopyChannel gone = std::move(there); }
  EXPECT_THROW(static_cast<void>(here.receive(CopyChannel::kForEver)), ChannelEnded);
  EXPECT_THROW(here.send({{"do", "copy"}}), ChannelEnded);
}

TEST(CopyChannel, WhereNobodyReadsNothingIsWaitedForThatMayBeLost) {
  auto [here, there] = CopyChannel::pair();
  const nlohmann::json large{{"text", std::string(100'000, 'x')}};
  int sent = 0;
  while (sent < 1000 && here.try_send(large)) ++sent;
  EXPECT_GT(sent, 0);
  EXPECT_LT(sent, 1000);
  EXPECT_THROW(here.send({{"text", std::string(CopyChannel::kMostBytes, 'x')}}), std::length_error);
}

}  // namespace
}  // namespace gaitway::timeline
