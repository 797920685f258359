// Lines for people on a pipe that is read, and on one that is not.
#include "gaitway/api/line_teller.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <future>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::api {
namespace {

using ::testing::EndsWith;
using ::testing::StartsWith;

class LineTellerTest : public ::testing::Test {
 protected:
  LineTellerTest() {
    std::array<int, 2> ends{};
    EXPECT_EQ(pipe2(ends.data(), O_CLOEXEC), 0);
    reads = process::FileDescriptor(ends[0]);
    writes = process::FileDescriptor(ends[1]);
    fcntl(writes.get(), F_SETPIPE_SZ, 8192);
    fcntl(reads.get(), F_SETFL, O_NONBLOCK);
  }
  std::string told() {
    std::string text(65536, '\0');
    const ssize_t count = read(reads.get(), text.data(), text.size());
    text.resize(count > 0 ? static_cast<std::size_t>(count) : 0);
    return text;
  }
  process::FileDescriptor reads, writes;
};

TEST_F(LineTellerTest, TellsWholeLines) {
  LineTeller teller(writes.get(), "user_interface");
  teller.tell("linked");
  EXPECT_EQ(told(), "user_interface: linked\n");
  teller.tell(std::string(100'000, 'x'));
  const std::string text = told();
  EXPECT_EQ(text.size(), LineTeller::kMostBytes);
  EXPECT_THAT(text, EndsWith("x\n"));
}

// A stop of the same thread would wait as long.
TEST_F(LineTellerTest, WaitsForNobodyAndTellsHowManyWereLeftOut) {
  LineTeller teller(writes.get(), "user_interface");
  const auto tells = std::async(std::launch::async, [&teller] {
    for (int i = 0; i < 1000; ++i) teller.tell("a stop by datagram, again");
  });
  const bool waits = tells.wait_for(std::chrono::seconds(5)) != std::future_status::ready;
  EXPECT_FALSE(waits);
  std::string before = told();
  while (waits && tells.wait_for(std::chrono::milliseconds(1)) != std::future_status::ready) told();
  ASSERT_THAT(before, StartsWith("user_interface: a stop by datagram, again\n"));
  const auto count = std::count(before.begin(), before.end(), '\n');
  teller.tell("linked");
  EXPECT_EQ(told(), "user_interface: " + std::to_string(1000 - count) +
                        " lines could not be told\nuser_interface: linked\n");
}

}  // namespace
}  // namespace gaitway::api
