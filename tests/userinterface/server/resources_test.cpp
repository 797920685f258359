// Descriptors and memory: what connections leave behind, and what happens when there are none to have.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <malloc.h>
#include <sys/resource.h>
#include <sys/socket.h>

#include <chrono>
#include <filesystem>
#include <iterator>

#include "raw_client.hpp"
#include "running_server.hpp"
#include "websocket_client.hpp"

namespace gaitway::api {
namespace {

std::size_t open_descriptors() {
  const std::filesystem::directory_iterator all("/proc/self/fd");
  return static_cast<std::size_t>(std::distance(begin(all), end(all)));
}

// In every way in which connections end.
void connect_and_disconnect(RunningServer& server, int times) {
  const std::uint64_t before = server.statistics().accepted;
  for (int count = 0; count < times; ++count) {
    RawClient client(server.port());
    if (count % 4 == 0) {
      continue;  // without a word
    }
    client.open_websocket();
    client.send(masked_frame(kText, "hello"));
    ASSERT_EQ(client.receive_frame().value().payload, "hello");
    if (count % 4 == 1) {
      client.send(masked_frame(kClose, "\x03\xE8"));
      client.receive_all();
    } else if (count % 4 == 2) {
      client.reset();
    }
  }
  const auto accepted = before + static_cast<std::uint64_t>(times);
  server.await([=](const ServerStatistics& statistics, EchoHub& hub) {
    hub.opened.clear();
    hub.opened.shrink_to_fit();
    return statistics.accepted == accepted && statistics.connected == 0 && hub.sessions == 0;
  });
}

TEST(Resources, ConnectionsLeaveNothingBehind) {
  RunningServer server(local());
  connect_and_disconnect(server, 100);  // what is kept for reuse
  const std::size_t descriptors = open_descriptors();
  const auto memory = mallinfo2().uordblks;
  connect_and_disconnect(server, GAITWAY_CONNECTIONS);
  EXPECT_EQ(open_descriptors(), descriptors);
  EXPECT_LT(mallinfo2().uordblks, memory + 20'000);
}

#ifndef GAITWAY_SANITIZED
// Lets this process have no further descriptor while it lives. Not under a sanitizer: to look at an object's
// type, its runtime opens a pipe, and without one it sees errors.
class NoMoreDescriptors {
 public:
  explicit NoMoreDescriptors() {
    getrlimit(RLIMIT_NOFILE, &before_);
    const process::FileDescriptor next(dup(0));
    rlimit now = before_;
    now.rlim_cur = static_cast<rlim_t>(next.get());
    setrlimit(RLIMIT_NOFILE, &now);
  }
  ~NoMoreDescriptors() { setrlimit(RLIMIT_NOFILE, &before_); }
  NoMoreDescriptors(const NoMoreDescriptors&) = delete;
  NoMoreDescriptors& operator=(const NoMoreDescriptors&) = delete;

 private:
  rlimit before_{};
};

TEST(Resources, WithoutDescriptorsNewClientsWaitAndOldOnesGoOn) {
  RunningServer server(local());
  RawClient old_one(server.port());
  old_one.open_websocket();
  process::FileDescriptor spare(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0));
  const auto since = std::chrono::steady_clock::now();
  auto none = std::make_unique<NoMoreDescriptors>();
  RawClient new_one(std::move(spare), server.port());
  new_one.send(upgrade_request());
  std::uint64_t steps = 0;
  server.await([&](const ServerStatistics& statistics, EchoHub& hub) {
    steps = steps == 0 && statistics.accept_errors > 0 ? hub.steps : steps;
    return steps > 0 && hub.steps >= steps + 50;
  });
  const std::uint64_t tries = server.statistics().accept_errors;
  const auto pauses =
      (std::chrono::steady_clock::now() - since) / std::chrono::nanoseconds(local().accept_pause_ns);
  EXPECT_LE(tries, static_cast<std::uint64_t>(pauses) + 1);  // at first, and after each pause
  old_one.send(masked_frame(kText, "still served"));
  EXPECT_EQ(old_one.receive_frame().value().payload, "still served");
  none.reset();
  EXPECT_THAT(new_one.receive_header(), testing::StartsWith("HTTP/1.1 101 "));
}
#endif

}  // namespace
}  // namespace gaitway::api
