// What people and programs ask of a simulation that runs.
#include "gaitway/timeline/director.hpp"

#include <signal.h>

#include "gaitway/process/real_time.hpp"
#include "gaitway/simulation/control_client.hpp"
#include "simulation_fixture.hpp"

namespace gaitway::timeline {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class DirectorTest : public SimulationTest {
 protected:
  DirectorTest() { direct(false); }

  void direct(bool playing) {
    director_.reset();
    director_.emplace(start(), DirectorOptions{.socket = folder_.path() / "orders.sock",
                                               .playing = playing,
                                               .speed = 40.0,
                                               .world = "empty",
                                               .plan_way = {}});
    client_.emplace(folder_.path() / "orders.sock");
  }
  // Until it is answered.
  simulation::Answer ask(const json& order) {
    const std::uint32_t number = client_->order(order.dump(), process::monotonic_ns(), 60 * kSecond_ns);
    while (true) {
      director_->step(1);
      client_->step(process::monotonic_ns());
      if (const auto answer = client_->take_answer()) {
        EXPECT_EQ(answer->number, number);
        return *answer;
      }
    }
  }
  json done(const json& order) {
    const simulation::Answer answer = ask(order);
    EXPECT_TRUE(answer.accepted) << order.dump() << ": " << answer.text;
    return answer.accepted ? json::parse(answer.text) : json::object();
  }
  std::string refused(const json& order) {
    const simulation::Answer answer = ask(order);
    EXPECT_FALSE(answer.accepted) << order.dump();
    return answer.text;
  }
  json state() { return done({{"order", "state"}}); }
  void apply(const std::string& event) { done({{"order", "apply"}, {"event", event}}); }
  void step(int milliseconds) { done({{"order", "step"}, {"milliseconds", milliseconds}}); }
  void play_until(double time_s) {
    done({{"order", "play"}});
    while (state().at("time_s").get<double>() < time_s) director_->step(5);
    done({{"order", "pause"}});
    while (state().at("state") != "paused") director_->step(5);
    settle();
  }
  void settle_answers(int count) {
    while (count > 0) {
      director_->step(1);
      client_->step(process::monotonic_ns());
      for (auto answer = client_->take_answer(); answer; answer = client_->take_answer()) {
        EXPECT_TRUE(answer->accepted) << answer->text;
        --count;
      }
    }
  }
  // All that the simulation did before it paused has been told.
  void settle() { done({{"order", "geometry"}}); }

  std::optional<Director> director_;
  std::optional<simulation::ControlClient> client_;
};

TEST_F(DirectorTest, StepsAreExact) {
  EXPECT_EQ(state().at("time_s"), 0.0);
  EXPECT_EQ(state().at("state"), "paused");
  step(1);
  EXPECT_NEAR(state().at("time_s").get<double>(), 0.001, 1e-9);
  step(80);
  EXPECT_NEAR(state().at("time_s").get<double>(), 0.081, 1e-9);
  EXPECT_EQ(director_->timeline().recorded_ns(), 81'000'000);
}

TEST_F(DirectorTest, PlaysAtTheSpeedThatIsAsked) {
  done({{"order", "speed"}, {"times", 0.5}});
  done({{"order", "play"}});
  const std::int64_t began_ns = process::monotonic_ns(), from_ns = director_->now_ns();
  while (director_->now_ns() < from_ns + kSecond_ns / 2) director_->step(5);
  EXPECT_GT(process::monotonic_ns() - began_ns, kSecond_ns * 9 / 10) << "no faster than asked";
  done({{"order", "pause"}});
  settle();
  const std::int64_t paused_ns = director_->now_ns();
  for (int i = 0; i < 20; ++i) director_->step(5);
  EXPECT_EQ(director_->now_ns(), paused_ns);
}

TEST_F(DirectorTest, TheTimeLineOfWhatWasDoneLiveReplaysToTheBit) {
  play_until(1.0);
  apply("{push: {body: trunk, direction: [0, 1, 0], impulse_Ns: 0.9}}");
  apply(
      "{spawn: {name: ball, shape: sphere, size_m: [0.2, 0.2, 0.2], position_m: [0.7, 0, 0.5], mass_kg: "
      "0.3}}");
  play_until(10.2);
  apply("{fault: {kind: lose_frames, probability: 0.05, duration_s: 1}}");
  play_until(21.0);
  while (director_->timeline().copies() < 3) director_->step(20);
  EXPECT_EQ(director_->timeline().differences(), 0U)
      << "copies at 10 and 20 s are compared with the live run";
  const std::int64_t end_ns = director_->now_ns();
  const std::vector<TimedEvent> events(director_->timeline().events().begin(),
                                       director_->timeline().events().end());
  EXPECT_EQ(events.size(), 3U);
  done({{"order", "seek"}, {"time_s", 4.321}});
  EXPECT_NEAR(state().at("time_s").get<double>(), 4.321, 1e-9);
  done({{"order", "seek"}, {"time_s", static_cast<double>(end_ns) * 1e-9}});
  EXPECT_EQ(director_->now_ns(), end_ns);
  EXPECT_EQ(director_->timeline().differences(), 0U);
}

TEST_F(DirectorTest, FromAnEarlierInstantItGoesOnDifferently) {
  apply("{push: {body: trunk, direction: [1, 0, 0], impulse_Ns: 0.5}}");
  step(3000);
  apply("{push: {body: trunk, direction: [0, 1, 0], impulse_Ns: 9}}");
  step(3000);
  EXPECT_TRUE(state().at("fallen"));
  done({{"order", "seek"}, {"time_s", 2.999}});
  EXPECT_FALSE(state().at("fallen"));
  EXPECT_EQ(state().at("recorded_s"), 6.0) << "nothing is forgotten while one looks";
  EXPECT_EQ(state().at("marks").size(), 3U) << "two pushes and a fall";
  step(3000);
  EXPECT_FALSE(state().at("fallen"));
  EXPECT_EQ(state().at("marks").size(), 1U);
  EXPECT_EQ(director_->timeline().events().size(), 1U);
}

TEST_F(DirectorTest, WhatIsRefusedForgetsNothing) {
  step(2000);
  done({{"order", "seek"}, {"time_s", 1.0}});
  refused({{"order", "apply"}, {"event", "{fault: {kind: jan}}"}});
  refused({{"order", "apply"},
           {"event", "{spawn: {name: in, shape: box, size_m: [0.2, 0.2, 0.2], position_m: [0, 0, 0.1]}}"}});
  EXPECT_EQ(state().at("recorded_s"), 2.0);
  apply("{fault: {kind: jam, duration_s: 0.001}}");
  EXPECT_EQ(state().at("recorded_s"), 1.0) << "this was done, and what came after it was not";
}

TEST_F(DirectorTest, AnInstantIsFoundAsItWasLeft) {
  step(1000);
  apply("{spawn: {name: block, shape: box, size_m: [0.2, 0.2, 0.2], position_m: [1, 0, 0.1]}}");
  done({{"order", "seek"}, {"time_s", 1.0}});
  EXPECT_EQ(state().at("spawned"), json({"block"}));
  step(100);
  EXPECT_EQ(state().at("spawned"), json({"block"}));
  EXPECT_EQ(director_->timeline().events().size(), 1U);
}

TEST_F(DirectorTest, ASeekThatIsRefusedLeavesItPlaying) {
  step(100);
  done({{"order", "speed"}, {"times", 1.0}});
  done({{"order", "play"}});
  refused({{"order", "seek"}, {"time_s", 1e6}});
  const std::int64_t before_ns = director_->now_ns();
  while (director_->now_ns() < before_ns + 50'000'000) director_->step(5);
  EXPECT_EQ(state().at("state"), "playing");
}

// As a time line is dragged. What one that lived has held is free for the next one.
TEST_F(DirectorTest, ManySeeksInARowAllArrive) {
  step(2000);
  for (int i = 0; i < 25; ++i) {
    const double time_s = 0.1 * (1 + i % 17);
    EXPECT_NEAR(done({{"order", "seek"}, {"time_s", time_s}}).at("time_s").get<double>(), time_s, 1e-9);
  }
}

TEST_F(DirectorTest, ThePluginThatKeepsTheLinkIsNotFailed) {
  EXPECT_THAT(
      refused({{"order", "apply"}, {"event", "{fault: {kind: plugin_fails, plugin: api, how: throws}}"}}),
      HasSubstr("choose another plug-in"));
}

// Flood: a report has room for so much, and nothing is lost.
TEST_F(DirectorTest, ManyEventsAtOnceAllArrive) {
  for (int i = 0; i < 200; ++i) {
    client_->order(
        json{{"order", "apply"}, {"event", "{push: {direction: [0, 0, 1], impulse_Ns: 0.001}}"}}.dump(),
        process::monotonic_ns(), 60 * kSecond_ns);
    if (i % 50 == 49) settle_answers(50);
  }
  EXPECT_EQ(director_->timeline().events().size(), 200U);
}

TEST_F(DirectorTest, ResetBeginsAnew) {
  apply("{spawn: {name: block, shape: box, size_m: [0.2, 0.2, 0.2], position_m: [1, 0, 0.1]}}");
  step(500);
  const auto run = state().at("run").get<int>();
  done({{"order", "reset"}});
  EXPECT_EQ(state().at("time_s"), 0.0);
  EXPECT_EQ(state().at("recorded_s"), 0.0);
  EXPECT_TRUE(state().at("spawned").empty());
  EXPECT_GT(state().at("run").get<int>(), run);
  EXPECT_TRUE(director_->timeline().events().empty());
}

TEST_F(DirectorTest, GeometryTellsWhatStandsThere) {
  apply(
      "{spawn: {name: block, shape: box, size_m: [0.2, 0.3, 0.4], position_m: [1, 0, 0.2], colour: [1, 0, "
      "0]}}");
  const json geometry = done({{"order", "geometry"}});
  EXPECT_EQ(geometry.at("total"), 1);
  const json& block = geometry.at("solids").at(0);
  EXPECT_EQ(block.at("name"), "block");
  EXPECT_EQ(block.at("size"), json({0.2, 0.3, 0.4}));
  EXPECT_EQ(block.at("colour"), json({1.0, 0.0, 0.0}));
  EXPECT_FALSE(block.at("movable").get<bool>());
  EXPECT_EQ(geometry.at("geometry"), state().at("geometry"));
}

TEST_F(DirectorTest, RefusalsNameFieldValueAndRule) {
  EXPECT_THAT(refused({{"order", "seekk"}}), HasSubstr("Did you mean 'seek'?"));
  EXPECT_THAT(refused({{"no", "order"}}), HasSubstr("field `order`"));
  EXPECT_THAT(refused(json::array()), HasSubstr("JSON object"));
  EXPECT_THAT(refused({{"order", "seek"}, {"time_s", 5.0}}), HasSubstr("from 0 to 0 s"));
  EXPECT_THAT(refused({{"order", "seek"}}), HasSubstr("time_s is missing"));
  EXPECT_THAT(refused({{"order", "speed"}, {"times", 41}}), HasSubstr("times is 41"));
  EXPECT_THAT(refused({{"order", "step"}, {"milliseconds", 0}}), HasSubstr("milliseconds is 0"));
  EXPECT_THAT(refused({{"order", "apply"}}), HasSubstr("event is missing"));
  EXPECT_THAT(refused({{"order", "apply"}, {"event", "{walk: [0.1, 0, 0]}"}}), HasSubstr("/walk_to"));
  EXPECT_THAT(refused({{"order", "apply"}, {"event", "{push: {}}"}}), HasSubstr("direction"));
  EXPECT_THAT(
      refused({{"order", "apply"}, {"event", "{fault: {kind: plugin_fails, plugin: zmq, how: throws}}"}}),
      HasSubstr("Did you mean 'zmp'?"));
  EXPECT_THAT(refused({{"order", "plan"}, {"goal", {1, 2, 3}}}), HasSubstr("plans no ways"));
  EXPECT_EQ(director_->timeline().recorded_ns(), 0) << "nothing has happened";
}

TEST_F(DirectorTest, PushesOfTheOldKindAreAnsweredWhenTheyBegin) {
  const std::uint32_t number = client_->push(
      {.link = "trunk", .force_N = {0.0, 90.0, 0.0}, .duration_s = 0.1}, process::monotonic_ns());
  std::optional<simulation::Answer> answer;
  while (!answer) {
    director_->step(1);
    client_->step(process::monotonic_ns());
    answer = client_->take_answer();
  }
  EXPECT_EQ(answer->number, number);
  EXPECT_TRUE(answer->accepted) << answer->text;
  EXPECT_EQ(director_->timeline().events().size(), 1U);
}

// Its own fault, or a plug-in's in its process: nothing else ends with it.
TEST_F(DirectorTest, ASimulationThatDiesIsToldAndCanBeRewound) {
  step(2000);
  apply("{push: {body: trunk, direction: [1, 0, 0], impulse_Ns: 0.5}}");
  settle();
  kill(state().at("process").get<pid_t>(), SIGKILL);
  while (director_->failure().empty()) director_->step(5);
  EXPECT_EQ(state().at("state"), "failed");
  EXPECT_THAT(state().at("text").get<std::string>(), HasSubstr("ended at 2.000 s"));
  EXPECT_THAT(refused({{"order", "play"}}), HasSubstr("reset"));
  done({{"order", "seek"}, {"time_s", 1.0}});
  EXPECT_EQ(state().at("state"), "paused");
  step(10);
}

}  // namespace
}  // namespace gaitway::timeline
