// Many threads post, one collects: each line arrives once and in its poster's order, or is counted as lost.
// Then it is printed.
#include "gaitway/instance/event_log.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <array>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/core/events.hpp"

namespace gaitway::core {
namespace {

TEST(EventLog, LinesOfManyThreadsArriveInTheirOrderWhileTheTickAdds) {
  constexpr int kThreads = 4, kLines = 2'000;
  const auto log = std::make_unique<EventLog>();
  std::atomic<int> running = kThreads;
  std::vector<std::thread> threads;
  for (int thread = 0; thread < kThreads; ++thread) {
    threads.emplace_back([&, thread] {
      for (int line = 1; line <= kLines; ++line) {
        log->post(EventKind::info, std::to_string(thread), std::to_string(line));
      }
      --running;
    });
  }
  std::array<int, kThreads> last{};
  std::uint64_t next = 0;
  int heard = 0, lost = 0;
  const auto listen = [&] {
    ASSERT_GE(next, log->first()) << "read too late";
    for (; next < log->total(); ++next) {
      const Event& event = (*log)[next];
      const int number = std::stoi("0" + std::string(event.text()));
      if (event.kind == EventKind::info) {
        int& before = last.at(static_cast<std::size_t>(std::stoi(std::string(event.source()))));
        ASSERT_GT(number, before);
        before = number;
        ++heard;
      } else if (event.kind == EventKind::warning) {
        lost += number;
      }
    }
  };
  while (running > 0) {
    log->add(0, 0, EventKind::fault, "tick", "");
    listen();
  }
  for (std::thread& thread : threads) {
    thread.join();
  }
  log->collect();
  listen();
  EXPECT_EQ(heard + lost, kThreads * kLines);
}

TEST(EventLog, WhatHasNoRoomIsCounted) {
  const auto log = std::make_unique<EventLog>();
  log->set_time({.now_ns = 5, .tick = 3});
  for (std::size_t i = 0; i < EventLog::kPosts + 7; ++i) {
    log->post(EventKind::info, "leg", std::to_string(i));
  }
  EXPECT_EQ(log->total(), 0U);
  log->collect();
  ASSERT_EQ(log->total(), EventLog::kPosts + 1);
  EXPECT_EQ((*log)[0].text(), "0");
  EXPECT_EQ((*log)[0].stamp_ns, 5);
  EXPECT_EQ((*log)[0].tick, 3U);
  EXPECT_EQ((*log)[EventLog::kPosts].text(), "7 reports lost: too many between two ticks");
  log->post(EventKind::info, "leg", "again");
  log->collect();
  EXPECT_EQ((*log)[log->total() - 1].text(), "again");
}

// What a burst leaves over comes with the next prints; only what the log gave up is left out, and counted.
TEST(EventPrinter, PrintsEachEventOnceHoweverManyComeAtOnce) {
  const auto log = std::make_unique<EventLog>();
  EventPrinter printer("robot");
  const auto add = [&log](int from, int to) {
    for (int number = from; number < to; ++number) {
      log->add(1'000'000, 0, EventKind::fault, "zmp", fmt::format("number {}.", number));
    }
  };
  const auto printed = [&] {
    testing::internal::CaptureStderr();
    while (printer.print(*log)) {
    }
    return testing::internal::GetCapturedStderr();
  };
  add(0, 50);
  testing::internal::CaptureStderr();
  EXPECT_TRUE(printer.print(*log)) << "a print takes a bounded time";
  std::string text = testing::internal::GetCapturedStderr();
  text += printed();
  std::size_t at = 0;
  for (int number = 0; number < 50; ++number) {
    const auto found = text.find(fmt::format("robot: 0.001 s: fault: zmp: number {}.\n", number), at);
    ASSERT_NE(found, std::string::npos) << number;
    at = found;
  }
  EXPECT_EQ(printed(), "");
  const int kept = static_cast<int>(EventLog::kCapacity);
  add(50, 50 + kept + 7);
  EXPECT_THAT(printed(),
              testing::StartsWith("robot: 7 events are left out\nrobot: 0.001 s: fault: zmp: number 57.\n"));
}

}  // namespace
}  // namespace gaitway::core
