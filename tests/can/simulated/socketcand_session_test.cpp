// A client of the bus: modes, subscriptions, send jobs and statistics in the time of the bus.
#include "gaitway/can/simulated/socketcand_session.hpp"
#include "gaitway/facts/facts.hpp"

#include <gmock/gmock.h>

#include <random>
#include <string>
#include <vector>

namespace gaitway::can {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

using facts::kMillisecond_ns;
constexpr std::int64_t kFirst_ns = 1'000'000'000;  // past the pause after the switch to raw mode

class SocketcandSessionTest : public testing::Test {
 protected:
  SocketcandSessionTest() { EXPECT_EQ(output(), "< hi >"); }

  // What the client is told in answer.
  std::string say(std::string_view text, std::int64_t now_ns = 0) {
    session.take(text, now_ns);
    EXPECT_TRUE(text.empty()) << "not taken: " << text;
    return output();
  }
  std::string hear(const Frame& frame, std::int64_t end_ns, bool own = false) {
    session.on_frame({frame, end_ns - 100'000, end_ns}, own);
    return output();
  }
  std::string step(std::int64_t now_ns) {
    session.step(now_ns);
    return output();
  }
  std::string output() { return std::exchange(session.output(), {}); }
  // Identifier and microsecond of everything that is wanted on the bus before `until_ns`.
  std::vector<std::pair<std::uint32_t, std::int64_t>> released(std::int64_t now_ns, std::int64_t until_ns) {
    std::vector<std::pair<std::uint32_t, std::int64_t>> all;
    while (const auto release = session.next_frame(now_ns, until_ns)) {
      all.emplace_back(release->frame.id, release->since_ns / 1000);
    }
    return all;
  }

  SocketcandSession session{"can0"};
};

TEST_F(SocketcandSessionTest, OpensTheRobotsBusAndNoOther) {
  EXPECT_EQ(say("< open can0 >"), "< ok >");
  SocketcandSession other("can0");
  other.output().clear();
  std::string_view text = "< open can1 >< rawmode >";
  other.take(text, 0);
  EXPECT_EQ(other.output(), "< error there is no bus 'can1'; the robot's bus is 'can0' >");
  EXPECT_TRUE(other.ended());
}

TEST_F(SocketcandSessionTest, NothingIsSentOrHeardBeforeABusIsOpen) {
  EXPECT_THAT(say("< send 123 0 >"), HasSubstr("no bus is open"));
  EXPECT_THAT(say("< rawmode >"), HasSubstr("no bus is open"));
  EXPECT_THAT(say("< can0 B 1 2 3 >"), HasSubstr("fixed bit rate"));
  EXPECT_EQ(hear({.id = 1}, kFirst_ns), "");
  EXPECT_THAT(released(0, kFirst_ns), IsEmpty());
}

TEST_F(SocketcandSessionTest, RawModeTellsEveryFrameOfOthersAndNotItsOwn) {
  EXPECT_EQ(say("< open can0 >< rawmode >"), "< ok >< ok >");
  EXPECT_EQ(hear({.id = 0x123, .size = 1, .data = {0xAB}}, kFirst_ns), "< frame 123 1.000000 AB >");
  EXPECT_EQ(hear({.id = 0x123}, kFirst_ns, true), "");
  EXPECT_EQ(hear({.id = 0x123, .size = 8, .remote = true}, kFirst_ns), "");
  EXPECT_EQ(session.untold_remote_frames(), 1);
}

TEST_F(SocketcandSessionTest, TheAnswerToRawmodeStandsAlone) {
  say("< open can0 >< rawmode >", kFirst_ns);
  EXPECT_EQ(hear({.id = 1}, kFirst_ns + SocketcandSession::kAnswerAlone_ns - 1), "");
  EXPECT_THAT(hear({.id = 1}, kFirst_ns + SocketcandSession::kAnswerAlone_ns), StartsWith("< frame 001"));
}

TEST_F(SocketcandSessionTest, BcmModeTellsWhatIsSubscribedTo) {
  say("< open can0 >< subscribe 0 0 123 >< subscribe 0 0 00000123 >");
  EXPECT_THAT(hear({.id = 0x123}, kFirst_ns), StartsWith("< frame 123 "));
  EXPECT_THAT(hear({.id = 0x123, .extended = true}, kFirst_ns), StartsWith("< frame 00000123 "));
  EXPECT_EQ(hear({.id = 0x124}, kFirst_ns), "");
  EXPECT_EQ(say("< unsubscribe 123 >"), "");
  EXPECT_EQ(hear({.id = 0x123}, kFirst_ns), "");
  EXPECT_EQ(say("< unsubscribe 123 >"), "< error there is no subscription to the identifier 123 >");
}

TEST_F(SocketcandSessionTest, AFilterTellsChangesInTheBitsOfItsMask) {
  say("< open can0 >< filter 0 0 123 2 F0 01 >");
  EXPECT_NE(hear({.id = 0x123, .size = 2, .data = {0x10, 0}}, kFirst_ns), "") << "the first one";
  EXPECT_EQ(hear({.id = 0x123, .size = 2, .data = {0x1F, 2}}, kFirst_ns), "");
  EXPECT_NE(hear({.id = 0x123, .size = 2, .data = {0x1F, 3}}, kFirst_ns), "");
  EXPECT_NE(hear({.id = 0x123, .size = 2, .data = {0x2F, 3}}, kFirst_ns), "");
  EXPECT_EQ(hear({.id = 0x123, .size = 2, .data = {0x2F, 3}}, kFirst_ns), "");
}

TEST_F(SocketcandSessionTest, AThrottleTellsTheLatestFrameWhenItsTimeHasCome) {
  say("< open can0 >< subscribe 0 20000 123 >");
  EXPECT_NE(hear({.id = 0x123, .size = 1, .data = {1}}, kFirst_ns), "");
  EXPECT_EQ(hear({.id = 0x123, .size = 1, .data = {2}}, kFirst_ns + 5 * kMillisecond_ns), "");
  EXPECT_EQ(hear({.id = 0x123, .size = 1, .data = {3}}, kFirst_ns + 10 * kMillisecond_ns), "");
  EXPECT_EQ(step(kFirst_ns + 19 * kMillisecond_ns), "");
  EXPECT_EQ(step(kFirst_ns + 20 * kMillisecond_ns), "< frame 123 1.010000 03 >");
  EXPECT_EQ(step(kFirst_ns + 90 * kMillisecond_ns), "") << "once";
}

TEST_F(SocketcandSessionTest, FramesGoOutInTheOrderInWhichTheyCame) {
  say("< open can0 >< send 300 0 >< send 100 0 >", kMillisecond_ns);
  say("< send 200 0 >", 2 * kMillisecond_ns);
  EXPECT_THAT(released(2 * kMillisecond_ns, 3 * kMillisecond_ns),
              ElementsAre(std::pair(0x300U, 1000), std::pair(0x100U, 1000), std::pair(0x200U, 2000)));
}

TEST_F(SocketcandSessionTest, AJobSendsAtOnceAndThenAtItsInterval) {
  say("< open can0 >< add 0 400 123 0 >< add 0 0 456 0 >", kMillisecond_ns);
  EXPECT_THAT(released(kMillisecond_ns, 2 * kMillisecond_ns),
              ElementsAre(std::pair(0x123U, 1000), std::pair(0x456U, 1000), std::pair(0x123U, 1400),
                          std::pair(0x123U, 1800)));
  EXPECT_THAT(released(2 * kMillisecond_ns, 2'300'000), ElementsAre(std::pair(0x123U, 2200)));
}

TEST_F(SocketcandSessionTest, AJobThatCouldNotSendDoesNotMakeUpForIt) {
  say("< open can0 >< add 0 1000 123 0 >", 0);
  EXPECT_THAT(released(10'500'000, 12 * kMillisecond_ns),
              ElementsAre(std::pair(0x123U, 10'000), std::pair(0x123U, 11'000)));
}

TEST_F(SocketcandSessionTest, AJobIsUpdatedInItsRhythmAndDeleted) {
  say("< open can0 >< add 0 1000 123 1 1 >", 0);
  ASSERT_EQ(session.next_frame(0, 1)->frame.data[0], 1);
  EXPECT_EQ(say("< update 123 1 2 >"), "");
  const auto next = session.next_frame(0, 2 * kMillisecond_ns);
  ASSERT_TRUE(next);
  EXPECT_EQ(next->frame.data[0], 2);
  EXPECT_EQ(next->since_ns, kMillisecond_ns);
  EXPECT_EQ(say("< delete 123 >"), "");
  EXPECT_THAT(released(0, kFirst_ns), IsEmpty());
  EXPECT_EQ(say("< delete 123 >"), "< error there is no send job with the identifier 123 >");
  EXPECT_THAT(say("< update 123 1 2 >"), HasSubstr("no send job"));
}

TEST_F(SocketcandSessionTest, JobsAndSubscriptionsEndWithTheirMode) {
  say("< open can0 >< add 0 1000 123 0 >< subscribe 0 0 456 >");
  EXPECT_EQ(say("< rawmode >< bcmmode >"), "< ok >< ok >");
  EXPECT_THAT(released(0, kFirst_ns), IsEmpty());
  EXPECT_EQ(hear({.id = 0x456}, kFirst_ns), "");
}

TEST_F(SocketcandSessionTest, ControlModeTellsTrafficAtTheIntervalThatWasAskedFor) {
  say("< open can0 >< controlmode >< statistics 100 >", 0);
  hear({.id = 1, .size = 8}, 1);
  hear({.id = 1, .size = 3}, 2);
  hear({.id = 2, .size = 5}, 3, true);
  EXPECT_EQ(step(99 * kMillisecond_ns), "");
  EXPECT_EQ(step(100 * kMillisecond_ns), "< stat 11 2 5 1 >");
  EXPECT_EQ(step(350 * kMillisecond_ns), "< stat 11 2 5 1 >") << "what was missed is not made up for";
  EXPECT_EQ(step(399 * kMillisecond_ns), "");
  EXPECT_EQ(say("< statistics 0 >"), "");
  EXPECT_EQ(step(900 * kMillisecond_ns), "");
}

TEST_F(SocketcandSessionTest, WhatAModeDoesNotHaveIsRefusedWithTheWayOut) {
  say("< open can0 >");
  EXPECT_THAT(say("< open can0 >"), HasSubstr("is open already"));
  EXPECT_THAT(say("< statistics 5 >"), HasSubstr("controlmode"));
  EXPECT_THAT(say("< isotpmode >"), HasSubstr("not served"));
  say("< rawmode >");
  EXPECT_THAT(say("< subscribe 0 0 123 >"), HasSubstr("bcmmode"));
  EXPECT_THAT(say("< add 0 0 123 0 >"), HasSubstr("bcmmode"));
  say("< controlmode >");
  EXPECT_THAT(say("< send 123 0 >"), HasSubstr("rawmode"));
  EXPECT_EQ(say("< echo >"), "< echo >");
  EXPECT_EQ(session.rejected(), 6);
}

TEST_F(SocketcandSessionTest, AClientThatSendsMoreThanTheBusTakesIsHeldBack) {
  say("< open can0 >");
  std::string input;
  for (std::size_t i = 0; i < SocketcandSession::kQueuedFrames + 3; ++i) {
    input += "< send 123 0 >";
  }
  std::string_view rest = input;
  session.take(rest, 0);
  EXPECT_EQ(rest.size(), 3 * std::string_view("< send 123 0 >").size());
  EXPECT_TRUE(session.next_frame(0, 1));
  session.take(rest, 0);
  EXPECT_EQ(rest.size(), 2 * std::string_view("< send 123 0 >").size());
}

TEST_F(SocketcandSessionTest, JobsAndSubscriptionsAreBounded) {
  say("< open can0 >");
  std::string last;
  for (std::size_t i = 0; i <= SocketcandSession::kJobs; ++i) {
    last = say("< add 1 0 " + std::string(1, "0123456"[i / 16]) + "0123456789ABCDEF"[i % 16] + " 0 >");
  }
  EXPECT_THAT(last, HasSubstr("at most 64 send jobs"));
}

TEST_F(SocketcandSessionTest, AClientThatReadsNothingIsOverrun) {
  say("< open can0 >< rawmode >");
  std::size_t frames = 0;
  while (!session.overrun() && frames < 1'000'000) {
    session.on_frame({{.id = 0x123, .size = 8}, 0, kFirst_ns}, false);
    ++frames;
  }
  EXPECT_GT(frames, 20'000);
  EXPECT_LE(session.output().size(), SocketcandSession::kLongestBacklog_bytes);
}

TEST_F(SocketcandSessionTest, WhateverComesIsTakenOrAnswered) {
  std::mt19937 random(3);
  const std::vector<std::string> pieces = {"<",         ">",         " ",           "send ",   "add ",
                                           "update ",   "filter ",   "delete",      "rawmode", "bcmmode",
                                           "subscribe", "0 ",        "8 ",          "123 ",    "ff ",
                                           "1 ",        "12345678 ", "statistics ", "\xFF",    "controlmode"};
  say("< open can0 >");
  std::int64_t now_ns = 0;
  for (int round = 0; round < 200'000; ++round) {
    const std::string& piece = pieces[random() % pieces.size()];
    std::string_view text = piece;
    session.take(text, now_ns);
    now_ns += 50'000;
    session.step(now_ns);
    session.on_frame({{.id = 0x123, .size = 8}, now_ns, now_ns}, random() % 4 == 0);
    while (const auto release = session.next_frame(now_ns, now_ns + 50'000)) {
      ASSERT_TRUE(is_valid(release->frame));
      ASSERT_LT(release->since_ns, now_ns + 50'000);
    }
    session.output().clear();
  }
  EXPECT_GT(session.rejected(), 1000);
  EXPECT_FALSE(session.ended());
}

}  // namespace
}  // namespace gaitway::can
