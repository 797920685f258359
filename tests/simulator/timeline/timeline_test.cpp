// Any instant again, as it was, to the bit.
#include "gaitway/timeline/timeline.hpp"

#include <poll.h>
#include <signal.h>

#include <fstream>

#include "simulation_fixture.hpp"

namespace gaitway::timeline {
namespace {

using testing::HasSubstr;

class TimelineTest : public SimulationTest {
 protected:
  static constexpr std::int64_t kMillisecond_ns = 1'000'000;
  // What the copy has come to.
  static std::uint64_t digest(const CopyHandle& copy, std::int64_t to_ns) {
    copy.channel().send({{"do", "advance"}, {"to_ns", to_ns}});
    return copy.receive(CopyChannel::kForEver)->message.at("digest").get<std::uint64_t>();
  }
  // Of all that has come from it.
  static std::vector<pid_t> copies_of(pid_t process) {
    std::vector<pid_t> copies;
    std::ifstream list("/proc/" + std::to_string(process) + "/task/" + std::to_string(process) + "/children");
    for (pid_t child = 0; list >> child;) {
      copies.push_back(child);
      for (const pid_t further : copies_of(child)) copies.push_back(further);
    }
    return copies;
  }
  static void keep_up_until(Timeline& line, std::size_t copies) {
    while (line.copies() < copies) {
      line.keep_up();
      if (line.wake_fd() < 0) break;
      pollfd wake{line.wake_fd(), POLLIN, 0};
      poll(&wake, 1, 1000);
    }
  }
  const std::vector<TimedEvent> events_{
      {1'000 * kMillisecond_ns, false, "walk: [0.15, 0, 0]"},
      {3'017 * kMillisecond_ns, false,
       "push: {body: \"trunk\", direction: [0, 1, 0], impulse_Ns: 0.8, duration_s: 0.1}"},
      {5'000 * kMillisecond_ns, false,
       "spawn: {name: \"crate\", shape: box, size_m: [0.1, 0.1, 0.1], position_m: [0.9, 0, 0.05], yaw_rad: "
       "0, mass_kg: 0.2}"},
      {8'500 * kMillisecond_ns, false, "fault: {kind: lose_frames, probability: 0.05, duration_s: 1}"},
      {11'111 * kMillisecond_ns, false, "stand: true"},
      {12'003 * kMillisecond_ns, true, "stop: true"}};
};

TEST_F(TimelineTest, AnyInstantIsAsARunFromTheStartHasIt) {
  Timeline line(start());
  line.extend(26 * kSecond_ns, events_);
  keep_up_until(line, 3);
  EXPECT_EQ(line.copies(), 3U) << "at 0, 10 and 20 s";
  for (const std::int64_t at_ms :
       {0, 1, 999, 1'000, 1'001, 3'017, 5'000, 9'876, 10'000, 12'004, 20'001, 26'000}) {
    const std::int64_t at_ns = at_ms * kMillisecond_ns;
    EXPECT_EQ(digest(line.at(at_ns), at_ns), digest_of(events_, at_ns)) << at_ms << " ms";
  }
}

TEST_F(TimelineTest, FromThereItGoesOnAsItIsTold) {
  Timeline line(start());
  line.extend(12 * kSecond_ns, events_);
  const std::int64_t branch_ns = 4 * kSecond_ns, end_ns = 9 * kSecond_ns;
  const CopyHandle copy = line.at(branch_ns);
  line.forget_after(branch_ns);
  EXPECT_EQ(line.recorded_ns(), branch_ns);
  EXPECT_EQ(line.events().size(), 2U);
  const std::vector<TimedEvent> other{{5 * kSecond_ns, false, "walk: [0, 0, 0.5]"}};
  line.extend(end_ns, other);
  EXPECT_EQ(digest(line.at(end_ns), end_ns),
            digest_of(std::vector{events_[0], events_[1], other[0]}, end_ns));
  EXPECT_NE(digest(line.at(end_ns), end_ns), digest_of(events_, end_ns));
}

// Whoever paused there, did something to the world and looked at it finds it so again.
TEST_F(TimelineTest, WhatWasDoneAtAnInstantIsDoneThere) {
  Timeline line(start());
  line.extend(6 * kSecond_ns, events_);
  const CopyHandle copy = line.at(5 * kSecond_ns);
  line.forget_after(5 * kSecond_ns);
  EXPECT_EQ(line.events().size(), 3U) << "the crate came at 5 s, and stays";
  EXPECT_EQ(digest(copy, 6 * kSecond_ns), digest_of(events_, 6 * kSecond_ns));
}

TEST_F(TimelineTest, BegunAnewNothingHasHappened) {
  Timeline line(start());
  std::vector<TimedEvent> events = events_;
  events.front().at_ns = 0;
  line.extend(3 * kSecond_ns, events);
  const CopyHandle copy = line.begin_anew();
  EXPECT_EQ(line.recorded_ns(), 0);
  EXPECT_TRUE(line.events().empty());
  EXPECT_EQ(digest(copy, 2 * kSecond_ns), digest_of({}, 2 * kSecond_ns));
  EXPECT_EQ(digest(line.at(0), 2 * kSecond_ns), digest_of({}, 2 * kSecond_ns));
}

// Somebody ends processes: those that are left serve, as long as the first one is there.
TEST_F(TimelineTest, CopiesThatHaveBeenEndedAreDoneWithout) {
  CopyHandle first = start();
  const pid_t first_process = first.process();
  Timeline line(std::move(first));
  line.extend(26 * kSecond_ns, events_);
  keep_up_until(line, 3);
  ASSERT_EQ(line.copies(), 3U);
  for (const pid_t copy : copies_of(first_process)) kill(copy, SIGKILL);
  EXPECT_EQ(digest(line.at(21 * kSecond_ns), 21 * kSecond_ns), digest_of(events_, 21 * kSecond_ns));
  keep_up_until(line, 3);
  EXPECT_EQ(line.copies(), 3U) << "they are made anew";
  kill(first_process, SIGKILL);
  for (const pid_t copy : copies_of(first_process)) kill(copy, SIGKILL);
  try {
    for (int i = 0; i < 3; ++i) static_cast<void>(line.at(kSecond_ns));
    ADD_FAILURE() << "reached";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("the time line is lost"));
  }
  line.keep_up();
}

TEST_F(TimelineTest, AReplayThatEndsElsewhereIsTold) {
  Timeline line(start());
  line.extend(2 * kSecond_ns, events_);
  line.note_digest(2 * kSecond_ns, digest_of(events_, 2 * kSecond_ns));
  static_cast<void>(line.at(2 * kSecond_ns));
  EXPECT_EQ(line.differences(), 0U);
  line.note_digest(2 * kSecond_ns, 4711);
  static_cast<void>(line.at(2 * kSecond_ns));
  EXPECT_EQ(line.differences(), 1U);
}

TEST_F(TimelineTest, BehindABarNothingIsReached) {
  Timeline line(start());
  line.extend(2 * kSecond_ns, {});
  line.bar(1 * kSecond_ns, "a plug-in was changed");
  static_cast<void>(line.at(1 * kSecond_ns));
  try {
    static_cast<void>(line.at(1 * kSecond_ns + kMillisecond_ns));
    ADD_FAILURE() << "reached";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("a plug-in was changed at 1.000 s"), HasSubstr("before that")));
  }
  line.forget_after(kSecond_ns / 2);
  line.extend(2 * kSecond_ns, {});
  static_cast<void>(line.at(2 * kSecond_ns));
}

TEST_F(TimelineTest, ManyCopiesAreThinnedOutFromTheOldOnes) {
  constexpr std::size_t kMost = Timeline::kNewestKept + 3;
  constexpr std::int64_t kAll = static_cast<std::int64_t>(kMost) + 5;
  Timeline line(start(), kMost);
  line.extend(kAll * Timeline::kSpacing_ns, {});
  for (int round = 0; round < kAll; ++round) {
    line.keep_up();
    pollfd wake{line.wake_fd(), POLLIN, 0};
    if (wake.fd >= 0) poll(&wake, 1, 20'000);
  }
  line.keep_up();
  EXPECT_EQ(line.copies(), kMost);
  const std::int64_t late_ns = (kAll - 1) * Timeline::kSpacing_ns - 60 * kSecond_ns;
  EXPECT_EQ(digest(line.at(late_ns), late_ns), digest_of({}, late_ns));
}

// What cannot be replayed fails by name, and the time line is still there.
TEST_F(TimelineTest, AReplayThatFailsSaysWhy) {
  Timeline line(start());
  line.extend(2 * kSecond_ns, std::vector<TimedEvent>{{kSecond_ns, false, "remove: {name: \"nothing\"}"}});
  try {
    static_cast<void>(line.at(2 * kSecond_ns));
    ADD_FAILURE() << "reached";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), HasSubstr("'nothing' is nothing that was put"));
  }
  static_cast<void>(line.at(kSecond_ns - kMillisecond_ns));
}

}  // namespace
}  // namespace gaitway::timeline
