// A client asks for a motion, and hears what becomes of it: from the API through topics, trajectory plug-in
// and bus to the joints of the simulated robot, and back.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/api/publication_sink.hpp"
#include "linked_robot.hpp"
#include "simulation.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;

class MotionRequestTest : public ::testing::Test {
 protected:
  MotionRequestTest() {
    client_.send({{"op", "subscribe"}, {"topic", "/motion_state"}});
    run_for(1.0);
  }
  void run_for(double seconds) {
    const std::int64_t end_ns = run_.now_ns() + static_cast<std::int64_t>(seconds * 1e9);
    while (run_.now_ns() < end_ns) {
      run_.advance_millisecond();
      now_ns_ = run_.now_ns() + kSecond_ns;
      linked_.pass_millisecond(now_ns_ - kMillisecond_ns);
      port_.observe(now_ns_);
      GenericSink sink([this](Topic topic) { return hub_.wanted(topic); },
                       [this](Topic topic, const auto& value, std::int64_t) { hub_.publish(topic, value); });
      feed_.poll(now_ns_, sink);
      hub_.step(now_ns_);
      for (const json& message : client_.receive()) {
        (message["op"] == "publish" ? states_ : answers_).push_back(message);
      }
    }
  }
  void call(const std::string& service, const json& arguments = json::object()) {
    client_.send({{"op", "call_service"}, {"service", service}, {"args", arguments}});
  }
  [[nodiscard]] std::string last_state() const {
    return states_.empty() ? "" : states_.back()["msg"]["state"];
  }
  [[nodiscard]] std::string last_result() const {
    return states_.empty() ? "" : states_.back()["msg"]["result"];
  }

  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_, served_walk()};
  test::LinkedRobot linked_{run_.client(), robot_};
  LinkRobotPort port_{linked_.link, robot_, nullptr};
  msgclient::Client topics_ = linked_.link.topics("feed");
  Feed feed_{topics_, robot_};
  Hub hub_{port_, {}};
  std::int64_t now_ns_ = kSecond_ns;
  TestClient client_{hub_, now_ns_, "anna"};
  std::vector<json> answers_, states_;
};

TEST_F(MotionRequestTest, IsAnsweredWhenItBeginsAndToldOfUntilItHasEnded) {
  call("/play_motion", {{"motion", "wave"}});
  run_for(0.3);
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_EQ(answers_[0]["values"], (json{{"success", true}, {"message", "'wave' begins"}}));
  EXPECT_EQ(last_state(), "playing");
  EXPECT_EQ(states_.back()["msg"]["motion"], "wave");
  call("/play_motion", {{"motion", "bow"}});
  run_for(0.3);
  EXPECT_THAT(answers_.back()["values"]["message"], HasSubstr("another motion plays"));
  run_for(2.5);
  EXPECT_EQ(last_state(), "none");
  EXPECT_EQ(last_result(), "finished");
  EXPECT_EQ(states_.back()["msg"]["ended"], 1);
  EXPECT_FALSE(run_.plant().fallen());
}

TEST_F(MotionRequestTest, IsRefusedWithWhatThereIs) {
  call("/play_motion", {{"motion", "jump"}});
  run_for(0.3);
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_EQ(answers_[0]["values"]["success"], false);
  EXPECT_THAT(answers_[0]["values"]["message"],
              HasSubstr("there is: bow, get_up_back, get_up_front, kick, squat, wave"));
}

TEST_F(MotionRequestTest, OfTwoAtOnceTheSecondIsPlayedAndBothAreAnswered) {
  call("/play_motion", {{"motion", "bow"}});
  call("/play_motion", {{"motion", "squat"}});
  run_for(0.3);
  ASSERT_EQ(answers_.size(), 2U);
  EXPECT_THAT(answers_[0]["values"]["message"], HasSubstr("another motion was asked for"));
  EXPECT_EQ(answers_[1]["values"]["message"], "'squat' begins");
}

TEST_F(MotionRequestTest, AStandLeavesIt) {
  call("/play_motion", {{"motion", "bow"}});
  run_for(0.8);
  call("/stand");
  run_for(2.0);
  EXPECT_EQ(last_result(), "left");
  EXPECT_LT(run_.plant().truth().trunk_tilt_rad, 0.05);
}

TEST_F(MotionRequestTest, AfterAStandThatWasAnsweredAMotionBegins) {
  for (int tenth = 0; tenth < 20; ++tenth) {
    client_.drive(0.1);
    run_for(0.1);
  }
  call("/stand");
  run_for(0.3);
  EXPECT_TRUE(answers_.empty()) << "it takes steps still";
  for (int tenth = 0; tenth < 50 && answers_.empty(); ++tenth) {
    run_for(0.1);
  }
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_EQ(answers_[0]["values"], (json{{"success", true}, {"message", "stands"}}));
  call("/play_motion", {{"motion", "wave"}});
  run_for(0.3);
  EXPECT_EQ(answers_.back()["values"]["message"], "'wave' begins");
}

TEST_F(MotionRequestTest, AWalkThatIsAboutToBeginIsNoStandYet) {
  client_.drive(0.1);
  run_for(0.1);
  call("/stand");
  for (int tenth = 0; tenth < 50 && answers_.empty(); ++tenth) {
    run_for(0.1);
  }
  ASSERT_EQ(answers_.size(), 1U);
  EXPECT_EQ(answers_[0]["values"]["message"], "stands");
  call("/play_motion", {{"motion", "wave"}});
  run_for(0.3);
  EXPECT_EQ(answers_.back()["values"]["message"], "'wave' begins");
}

TEST_F(MotionRequestTest, AStopBreaksItOff) {
  call("/play_motion", {{"motion", "squat"}});
  run_for(0.5);
  call("/stop");
  run_for(2.0);
  EXPECT_EQ(last_result(), "broken off");
  EXPECT_LT(run_.plant().truth().trunk_tilt_rad, 0.05);
}

}  // namespace
}  // namespace gaitway::api
