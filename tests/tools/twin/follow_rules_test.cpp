// From what is told of a real robot to what the simulated one is told.
#include <gmock/gmock.h>

#include <nlohmann/json.hpp>

#include "tools/twin/follower.hpp"

namespace gaitway::tools {
namespace {

using nlohmann::json;
using testing::ElementsAre;
using testing::IsEmpty;

class FollowRulesTest : public testing::Test {
 protected:
  // "SERVICE ARGUMENTS", or "walk X".
  std::vector<std::string> look() {
    std::vector<std::string> words;
    for (const FollowOrder& order : rules_.look(news_)) {
      words.push_back(order.service.empty() ? "walk " + std::to_string(order.velocity[0]).substr(0, 4)
                                            : order.service + " " + order.argument);
    }
    return words;
  }

  static RobotNews stands() {
    RobotNews news;
    news.activity = "stands";
    news.motion_state = "none";
    news.way_state = "idle";
    return news;
  }

  FollowRules rules_;
  RobotNews news_ = stands();
};

TEST_F(FollowRulesTest, ARobotThatStandsHasNothingDone) {
  EXPECT_THAT(look(), IsEmpty());
  news_.commander = "anna";
  EXPECT_THAT(look(), IsEmpty());
}

TEST_F(FollowRulesTest, AVelocityIsWalkedUntilItHoldsNoMore) {
  news_.walk = {0.15, 0.0, 0.1};
  news_.activity = "walks";
  EXPECT_THAT(look(), ElementsAre("walk 0.15"));
  EXPECT_THAT(look(), IsEmpty());
  news_.walk = {0.25, 0.0, 0.0};
  EXPECT_THAT(look(), ElementsAre("walk 0.25"));
  news_.walk = {};
  EXPECT_THAT(look(), ElementsAre("/stand {}"));
}

TEST_F(FollowRulesTest, AMotionIsPlayedOnceAndLeftWhenItIsLeft) {
  static_cast<void>(look());
  news_.motion = "kick";
  news_.motion_state = "approaching";
  EXPECT_THAT(look(), ElementsAre(R"(/play_motion {"motion":"kick"})"));
  for (const char* const state : {"playing", "leaving"}) {
    news_.motion_state = state;
    EXPECT_THAT(look(), IsEmpty()) << state;
  }
  news_.motion_state = "none";
  news_.motions_ended = 1;
  news_.motion_result = "finished";
  EXPECT_THAT(look(), IsEmpty());
  news_.motion_state = "playing";
  EXPECT_THAT(look(), ElementsAre(R"(/play_motion {"motion":"kick"})")) << "once more";
  news_.motion_state = "none";
  news_.motions_ended = 2;
  news_.motion_result = "left";
  EXPECT_THAT(look(), ElementsAre(R"(/play_motion {"motion":""})"));
}

TEST_F(FollowRulesTest, AWayIsWalkedToItsGoalAndLeft) {
  static_cast<void>(look());
  news_.way_state = "plans";
  news_.goal = std::array{1.0, 0.5, 0.25};
  EXPECT_THAT(look(), ElementsAre(R"(/walk_to {"x":1.0,"y":0.5,"yaw":0.25})"));
  news_.way_state = "walks";
  EXPECT_THAT(look(), IsEmpty());
  news_.goal = std::array{2.0, 0.5, 0.25};
  EXPECT_THAT(look(), ElementsAre(R"(/walk_to {"x":2.0,"y":0.5,"yaw":0.25})")) << "another goal on the way";
  news_.way_state = "idle";
  news_.way_result = "arrived";
  EXPECT_THAT(look(), IsEmpty());
  news_.way_state = "walks";
  EXPECT_EQ(look().size(), 1U);
  news_.way_state = "idle";
  news_.way_result = "cancelled";
  EXPECT_THAT(look(), ElementsAre("/walk_to/cancel {}"));
}

TEST_F(FollowRulesTest, StopsAreStops) {
  static_cast<void>(look());
  news_.activity = "stops";
  EXPECT_THAT(look(), ElementsAre("/stop {}"));
  news_.activity = "stands";
  EXPECT_THAT(look(), IsEmpty());
  news_.activity = "stopped";
  EXPECT_THAT(look(), ElementsAre(R"(/emergency_stop {"data":false})"));
  news_.activity = "stands";
  EXPECT_THAT(look(), ElementsAre("/release {}"));
}

TEST_F(FollowRulesTest, WhatIsUnderWayAtTheFirstLookIsBegun) {
  news_.motion = "wave";
  news_.motion_state = "playing";
  news_.motions_ended = 7;
  news_.motion_result = "left";
  EXPECT_THAT(look(), ElementsAre(R"(/play_motion {"motion":"wave"})"))
      << "and what ended long ago is not left";
}

}  // namespace
}  // namespace gaitway::tools
