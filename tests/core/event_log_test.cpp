// Many threads post, one collects: each line arrives once and in its poster's order, or is counted as lost.
// Then it is printed.
#include "gaitway/instance/event_log.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/core/events.hpp"
#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"

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

Event event_that_says(const char* text) {
  Event event;
  event.stamp_ns = 1'234'000'000;
  event.kind = EventKind::fault;
  copy_text("zmp", event.source_text);
  copy_text(text, event.message_text);
  return event;
}

TEST(EventLine, IsJsonWhateverTheTextSays) {
  std::string line;
  append_event_line(line, event_that_says("a \"b\" \\ c\nd\x1b[2J \xc3"));
  EXPECT_EQ(line, R"({"time_s":1.234,"kind":"fault","source":"zmp","text":"a \"b\" \\ c\nd\\x1B[2J \\xC3"})"
                  "\n");
}

class EventLinesTest : public testing::Test {
 protected:
  [[nodiscard]] std::vector<std::string> lines() const {
    std::ifstream in(file);
    std::vector<std::string> all;
    for (std::string line; std::getline(in, line);) all.push_back(line);
    return all;
  }

  process::PrivateFolder folder{"gaitway_event_lines"};
  std::filesystem::path file = folder.path() / "events.jsonl";
  std::unique_ptr<EventLog> log = std::make_unique<EventLog>();
};

TEST_F(EventLinesTest, GoOnAfterTheEventsOfAProcessThatDied) {
  for (int life = 1; life <= 2; ++life) {
    EventLines events("robot", file, false);
    log->add(life, 0, EventKind::fault, "zmp", fmt::format("life {}", life));
    EXPECT_FALSE(events.step(*log));
    const process::LogCount count = events.end(*log);
    EXPECT_EQ(count.lines, static_cast<std::uint64_t>(1 + life)) << "the beginning, and what the log holds";
    EXPECT_EQ(count.lost, 0U);
  }
  const std::vector<std::string> all = lines();
  ASSERT_EQ(all.size(), 5U);
  EXPECT_THAT(all[0], testing::HasSubstr(R"("source":"robot","text":"begins as process )"));
  EXPECT_THAT(all[1], testing::HasSubstr("life 1"));
  EXPECT_THAT(all[2], testing::HasSubstr("begins as process"));
  EXPECT_THAT(all[4], testing::HasSubstr("life 2"));
}

// Its terminal was halted, or its reader hangs: stderr is a pipe that is full.
TEST_F(EventLinesTest, ATerminalThatTakesNothingHoldsNeitherTheTickNorTheFile) {
  int pipe_ends[2];
  ASSERT_EQ(pipe2(pipe_ends, O_NONBLOCK | O_CLOEXEC), 0);
  const process::FileDescriptor reader(pipe_ends[0]), full(pipe_ends[1]);
  const std::string piece(4096, 'x');
  while (::write(full.get(), piece.data(), piece.size()) > 0) {
  }
  fcntl(full.get(), F_SETFL, 0);  // from now on writing waits
  const int terminal = dup(STDERR_FILENO);
  dup2(full.get(), STDERR_FILENO);
  process::DurationHistogram took;
  {
    EventLines events("robot", file, true);
    for (int i = 0; i < 200; ++i) {
      log->add(i, 0, EventKind::fault, "zmp", fmt::format("number {}", i));
      const std::int64_t begin_ns = process::monotonic_ns();
      events.step(*log);
      took.add(process::monotonic_ns() - begin_ns);
    }
    EXPECT_EQ(events.end(*log).lines, 201U);
  }
  std::string drained(1 << 16, ' ');
  while (::read(reader.get(), drained.data(), drained.size()) > 0) {  // lets the terminal's thread go
  }
  dup2(terminal, STDERR_FILENO);
  close(terminal);
  EXPECT_LT(took.percentile_ns(0.9), 2'000'000.0);
  EXPECT_EQ(lines().size(), 201U);
}

}  // namespace
}  // namespace gaitway::core
