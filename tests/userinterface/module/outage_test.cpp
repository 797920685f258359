// The link fails while a client walks the robot: it stands in time, comes back by itself, and nothing old is
// carried out.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "gaitway/api/feed.hpp"
#include "gaitway/api/link_robot_port.hpp"
#include "gaitway/api/publication_sink.hpp"
#include "gaitway/msgclient/client.hpp"
#include "linked_robot.hpp"
#include "simulation.hpp"
#include "test_client.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;

// A client that walks the robot through hub, link (I2C) and desk, all in virtual time.
class OutageTest : public ::testing::Test {
 protected:
  void run_for(std::int64_t duration_ns) {
    for (const std::int64_t end_ns = run_.now_ns() + duration_ns; run_.now_ns() < end_ns;) millisecond();
  }
  void millisecond() {
    run_.advance_millisecond();
    now_ns_ = run_.now_ns() + kSecond_ns;
    if (!frozen_) {
      linked_.pass_millisecond(now_ns_ - kMillisecond_ns);
    } else {
      linked_.desk.step(now_ns_);
      linked_.link.step(now_ns_);
    }
    port_.observe(now_ns_);
    const std::uint32_t session = linked_.link.session();
    if (session != session_) hub_.robot_lost();
    session_ = session;
    hub_.step(now_ns_);
    for (const json& message : client_.receive()) messages_.push_back(message);
    note_requests();
    if (drives_ && run_.now_ns() % (100 * kMillisecond_ns) == 0) drive();
  }
  void drive() {
    client_.send({{"op", "publish"}, {"topic", "/cmd_vel"}, {"msg", {{"linear", {{"x", 0.1}}}}}});
  }
  // When the robot was told to walk, and until when.
  void note_requests() {
    WalkCommand request;
    if (requests_.newest_sequence() == request_seen_) return;
    const auto read = requests_.read(request);
    if (!read) return;
    request_seen_ = read.sequence;
    if (request.walk != 0) {
      last_walk_ns_ = request.stamp_ns;
      walks_until_ns_ = request.valid_until_ns;
    } else {
      walks_until_ns_ = request.stamp_ns;
    }
  }
  [[nodiscard]] bool told_to_walk() const { return run_.now_ns() < walks_until_ns_; }
  [[nodiscard]] std::string told() const {
    std::string all;
    for (const json& message : messages_) all += message.dump() + "\n";
    return all;
  }
  [[nodiscard]] bool open() { return linked_.link.open() && linked_.desk.end().session().open(); }

  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  simulator::Cosimulation run_{robot_, served_walk()};
  test::LinkedRobot linked_{run_.client(), robot_};
  LinkRobotPort port_{linked_.link, robot_, nullptr};
  Hub hub_{port_, {}};
  std::int64_t now_ns_ = kSecond_ns;
  TestClient client_{hub_, now_ns_, "driver"};
  msgclient::Reader<WalkCommand> requests_ = run_.client().read<WalkCommand>("walk_command");
  std::vector<json> messages_;
  std::uint64_t request_seen_ = 0;
  std::int64_t last_walk_ns_ = 0, walks_until_ns_ = 0;
  std::uint32_t session_ = 0;
  bool drives_ = false;
  bool frozen_ = false;  // the wire carries nothing
};

TEST_F(OutageTest, StandsInTimeAndIsBackWithinASecondAndOldOrdersAreGone) {
  std::mt19937_64 random(4);
  run_for(kSecond_ns);
  ASSERT_TRUE(open());
  for (int outage = 0; outage < GAITWAY_OUTAGES; ++outage) {
    client_.send({{"op", "call_service"}, {"service", "/command/acquire"}, {"args", {{"name", "driver"}}}});
    drives_ = true;
    run_for(kSecond_ns + static_cast<std::int64_t>(random() % 1'500) * kMillisecond_ns);
    ASSERT_TRUE(told_to_walk()) << "outage " << outage << "\n" << told();
    messages_.clear();
    // Who drives goes on asking, which is in vain.
    frozen_ = true;
    const std::int64_t cut_ns = run_.now_ns();
    const std::int64_t length_ns = (300 + static_cast<std::int64_t>(random() % 9'700)) * kMillisecond_ns;
    run_for(300 * kMillisecond_ns);
    EXPECT_FALSE(told_to_walk()) << "it stands as soon as the link is known to be lost, outage " << outage;
    EXPECT_LE(last_walk_ns_, cut_ns);
    run_for(length_ns - 300 * kMillisecond_ns);
    frozen_ = false;
    std::int64_t waited_ns = 0;
    for (; !open() && waited_ns < kSecond_ns; waited_ns += kMillisecond_ns) run_for(kMillisecond_ns);
    EXPECT_TRUE(open()) << "outage " << outage;
    run_for(300 * kMillisecond_ns);
    EXPECT_FALSE(told_to_walk()) << "who drove must take the command again, outage " << outage;
    EXPECT_LE(last_walk_ns_, cut_ns) << "nothing that was asked for meanwhile is carried out";
    EXPECT_THAT(told(), HasSubstr("the robot is not there: its main controller does not answer"));
    drives_ = false;
    run_for(2 * kSecond_ns);
    ASSERT_FALSE(run_.plant().fallen()) << "outage " << outage;
  }
}

TEST_F(OutageTest, AVelocityThatHasBecomeTooOldOnTheWayIsRefusedByName) {
  run_for(kSecond_ns);
  drive();
  // Longer than a velocity may take, shorter than the link's patience.
  for (int ms = 0; ms < 215; ++ms) {
    run_.advance_millisecond();
    now_ns_ = run_.now_ns() + kSecond_ns;
  }
  run_for(200 * kMillisecond_ns);
  EXPECT_EQ(last_walk_ns_, 0) << "it is not carried out";
  EXPECT_THAT(told(), HasSubstr("late: this velocity is older than 200 ms"));
  drive();
  run_for(50 * kMillisecond_ns);
  EXPECT_TRUE(told_to_walk()) << "the link goes on";
}

TEST_F(OutageTest, WhatWasGivenBeforeAStopMovesTheRobotNoMore) {
  run_for(kSecond_ns);
  // The stop goes ahead of it on the wire.
  drive();
  client_.send({{"op", "call_service"}, {"service", "/stop"}});
  run_for(100 * kMillisecond_ns);
  EXPECT_FALSE(told_to_walk());
  EXPECT_THAT(told(), HasSubstr("\"success\":true"));
}

TEST_F(OutageTest, AStopFromElsewhereHoldsBeforeTheSessionsKnowOfIt) {
  run_for(kSecond_ns);
  drives_ = true;
  run_for(kSecond_ns);
  ASSERT_TRUE(told_to_walk()) << told();
  messages_.clear();
  linked_.link.stop_unseen(link::StopKind::stop);
  run_for(20 * kMillisecond_ns);
  EXPECT_EQ(linked_.link.stops_obeyed().stops, 1U);
  const std::int64_t stopped_ns = run_.now_ns();
  run_for(400 * kMillisecond_ns);
  EXPECT_LE(last_walk_ns_, stopped_ns) << "who drives does not know of it yet";
  EXPECT_THAT(told(), HasSubstr("it was given before a stop"));
  linked_.link.see_stops(1);
  hub_.stopped_by_datagram();
  EXPECT_EQ(hub_.commander(), "");
  run_for(400 * kMillisecond_ns);
  EXPECT_LE(last_walk_ns_, stopped_ns) << "and must let go first";
  EXPECT_THAT(told(), HasSubstr("the robot was stopped by somebody else"));
  client_.send({{"op", "call_service"}, {"service", "/command/acquire"}, {"args", {{"name", "driver"}}}});
  run_for(200 * kMillisecond_ns);
  EXPECT_TRUE(told_to_walk()) << told();
}

TEST_F(OutageTest, AStopThatWasCalledDuringAnOutageIsTheFirstThatIsDoneAfterIt) {
  run_for(kSecond_ns);
  frozen_ = true;
  run_for(400 * kMillisecond_ns);
  client_.send({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", {{"data", false}}}});
  run_for(100 * kMillisecond_ns);
  EXPECT_EQ(run_.message_controller().mode(), msgcontroller::Mode::batches);
  frozen_ = false;
  run_for(200 * kMillisecond_ns);
  EXPECT_EQ(run_.message_controller().mode(), msgcontroller::Mode::emergency_stop);
}

TEST_F(OutageTest, AModuleThatIsStartedAnewFindsTheRobotStandingAndNoStopIsDoneTwice) {
  run_for(kSecond_ns);
  client_.send({{"op", "call_service"}, {"service", "/emergency_stop"}, {"args", {{"data", false}}}});
  run_for(100 * kMillisecond_ns);
  client_.send({{"op", "call_service"}, {"service", "/release"}});
  run_for(2 * kSecond_ns);
  ASSERT_EQ(run_.message_controller().mode(), msgcontroller::Mode::batches);
  ModuleLink another(robot_, {.boot = 11});
  const link::StopCounts before = linked_.desk.end().stops_asked();
  for (int ms = 0; ms < 500; ++ms) {
    run_.advance_millisecond();
    now_ns_ = run_.now_ns() + kSecond_ns;
    another.pump(&linked_.bus.master(), now_ns_);
    link::pump(linked_.desk.end(), linked_.bus.slave(), now_ns_);
    linked_.desk.step(now_ns_);
    for (auto next = linked_.bus.advance(now_ns_); next; next = linked_.bus.advance(now_ns_)) {
      another.pump(&linked_.bus.master(), *next);
      link::pump(linked_.desk.end(), linked_.bus.slave(), *next);
    }
  }
  EXPECT_TRUE(another.open());
  EXPECT_EQ(linked_.desk.end().stops_asked(), before);
  EXPECT_EQ(run_.message_controller().mode(), msgcontroller::Mode::batches);
}

// What the page draws, over the slowest carrier.
TEST_F(OutageTest, TheRobotsStateComesOverI2cAtARateThatCanBeLookedAt) {
  msgclient::Client topics = linked_.link.topics("test");
  auto joints = topics.read<JointStates>("joint_states");
  auto estimates = topics.read<Estimate>("estimate");
  auto planned = topics.read<PlannedState>("planned_state");
  run_for(kSecond_ns);
  drives_ = true;
  auto bus_slots = topics.read<BusSlot>("bus_slot");
  const std::uint64_t first = joints.newest_sequence();
  const std::uint64_t first_slot = bus_slots.newest_sequence();
  std::int64_t oldest_ns = 0;
  int different = 0;
  for (int ms = 0; ms < 5'000; ++ms) {
    run_for(kMillisecond_ns);
    JointStates state;
    Estimate estimate;
    PlannedState plan;
    ASSERT_TRUE(joints.read(state) && estimates.read(estimate) && planned.read(plan));
    oldest_ns = std::max(oldest_ns, run_.now_ns() - state.stamp_ns);
    different += state.stamp_ns / facts::kSlot_ns != estimate.stamp_ns / facts::kSlot_ns ? 1 : 0;
  }
  RecordProperty("values_per_s", std::to_string((joints.newest_sequence() - first) / 5));
  RecordProperty("oldest_ms", std::to_string(oldest_ns / kMillisecond_ns));
  EXPECT_GE(joints.newest_sequence() - first, 5U * 15U);
  EXPECT_LE(oldest_ns, 200 * kMillisecond_ns);
  EXPECT_GE(bus_slots.newest_sequence() - first_slot, 6U) << "each third of those that are recorded";
  EXPECT_EQ(different, 0) << "joints and estimate are always of one slot";
}

}  // namespace
}  // namespace gaitway::api
