// What the feed publishes when topics change, the clock moves, or a robot is started anew.
#include "gaitway/api/feed.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <memory>

#include "collector.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgclient/memory_block.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "humanoid.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;

using facts::kMillisecond_ns;
using facts::kSlot_ns;

ros::Time time_of(std::int64_t time_ns) {
  return {static_cast<std::int32_t>(time_ns / 1'000'000'000),
          static_cast<std::uint32_t>(time_ns % 1'000'000'000)};
}
bool operator==(const ros::Time& a, const ros::Time& b) {
  return a.sec == b.sec && a.nanosec == b.nanosec;
}

// A robot that stands, as its topics tell of it.
class FeedTest : public ::testing::Test {
 protected:
  FeedTest() {
    for (std::size_t i = 0; i < humanoid().joints.size(); ++i) {
      joint_states.position[i] = humanoid().joints[i].home_rad;
    }
    joint_states.joint_count = 22;
  }
  void beat(std::int64_t to_ns) {
    now_ns = to_ns;
    block.beat(now_ns);
  }
  // What the message controller publishes in a slot: 3 ms after its edge.
  void publish_sensors() {
    const std::int64_t stamp_ns = now_ns - now_ns % kSlot_ns + 3 * kMillisecond_ns;
    joint_states.stamp_ns = foot_forces.stamp_ns = imu.stamp_ns = stamp_ns;
    joints_writer.publish(joint_states, now_ns);
    forces_writer.publish(foot_forces, now_ns);
    imu_writer.publish(imu, now_ns);
  }
  void publish_estimate() {
    estimate.stamp_ns = now_ns - now_ns % kSlot_ns + 2 * kMillisecond_ns;
    estimate_writer.publish(estimate, now_ns);
  }
  void poll() {
    digest.step(now_ns);
    feed.poll(now_ns, sink);
  }
  // One slot of everything.
  void slot() {
    beat(now_ns - now_ns % kSlot_ns + kSlot_ns + 4 * kMillisecond_ns);
    publish_sensors();
    publish_estimate();
    poll();
  }

  msgclient::MemoryBlock block;
  msgclient::Client robot = block.local_client("robot");
  msgclient::Writer<JointStates> joints_writer = robot.write<JointStates>("joint_states");
  msgclient::Writer<FootForces> forces_writer = robot.write<FootForces>("foot_forces");
  msgclient::Writer<gaitway::Imu> imu_writer = robot.write<gaitway::Imu>("imu");
  msgclient::Writer<NetworkState> network_writer = robot.write<NetworkState>("network_state");
  msgclient::Writer<Estimate> estimate_writer = robot.write<Estimate>("estimate");
  msgclient::Writer<MotionPlan> plan_writer = robot.write<MotionPlan>("motion_plan");
  msgclient::Writer<Event> events_writer = robot.write_stream<Event>("events", 8);
  msgclient::Client api = block.local_client("api");
  PlanDigest digest{api};
  Feed feed{api, humanoid()};
  test::Collector collector;
  decltype(test::sink_of(collector)) sink = test::sink_of(collector);
  std::int64_t now_ns = 0;
  JointStates joint_states{};
  FootForces foot_forces{};
  gaitway::Imu imu{};
  Estimate estimate{};
};

TEST_F(FeedTest, PublishesEachValueOnce) {
  for (int i = 0; i < 50; ++i) {
    slot();
    poll();
    poll();
  }
  for (const Topic topic : {Topic::joint_states, Topic::imu, Topic::left_wrench, Topic::right_wrench,
                            Topic::odometry, Topic::transforms, Topic::com, Topic::zmp, Topic::clock}) {
    EXPECT_EQ(collector.count(topic), 50U) << row(topic).name;
  }
}

TEST_F(FeedTest, StampsAreTheMeasurements) {
  slot();
  const ros::Time joints = time_of(13 * kMillisecond_ns);
  EXPECT_TRUE(collector.of<ros::JointState>(Topic::joint_states).at(0).header.stamp == joints);
  EXPECT_TRUE(collector.of<ros::Imu>(Topic::imu).at(0).header.stamp == joints);
  EXPECT_TRUE(collector.of<ros::WrenchStamped>(Topic::left_wrench).at(0).header.stamp == joints);
  EXPECT_TRUE(collector.of<ros::Odometry>(Topic::odometry).at(0).header.stamp == joints);
  EXPECT_TRUE(collector.of<ros::TFMessage>(Topic::transforms).at(0).transforms.at(0).header.stamp == joints);
  EXPECT_TRUE(collector.of<ros::PointStamped>(Topic::com).at(0).header.stamp ==
              time_of(12 * kMillisecond_ns));
  EXPECT_TRUE(collector.of<ros::Clock>(Topic::clock).at(0).clock == time_of(14 * kMillisecond_ns));
}

TEST_F(FeedTest, FramesAreAsTheTableOfTopicsSays) {
  slot();
  EXPECT_EQ(collector.of<ros::Imu>(Topic::imu).at(0).header.frame_id,
            humanoid().links[static_cast<std::size_t>(humanoid().imu.link)].name);
  EXPECT_EQ(collector.of<ros::WrenchStamped>(Topic::left_wrench).at(0).header.frame_id,
            row(Topic::left_wrench).frame);
  EXPECT_EQ(collector.of<ros::WrenchStamped>(Topic::right_wrench).at(0).header.frame_id,
            row(Topic::right_wrench).frame);
  EXPECT_EQ(collector.of<ros::Odometry>(Topic::odometry).at(0).header.frame_id, row(Topic::odometry).frame);
  EXPECT_EQ(collector.of<ros::PointStamped>(Topic::com).at(0).header.frame_id, row(Topic::com).frame);
  EXPECT_EQ(collector.of<ros::PointStamped>(Topic::zmp).at(0).header.frame_id, row(Topic::zmp).frame);
  EXPECT_EQ(collector.of<ros::PoseArray>(Topic::footsteps).at(0).header.frame_id,
            row(Topic::footsteps).frame);
}

TEST_F(FeedTest, PublishesOnlyWhatIsWanted) {
  collector.want({Topic::imu, Topic::right_wrench});
  for (int i = 0; i < 10; ++i) slot();
  EXPECT_EQ(collector.count(Topic::imu), 10U);
  EXPECT_EQ(collector.count(Topic::right_wrench), 10U);
  EXPECT_EQ(collector.count(), 20U);
}

TEST_F(FeedTest, WhatIsWantedLaterComesFromThenOn) {
  collector.want({});
  for (int i = 0; i < 10; ++i) slot();
  collector.want({Topic::joint_states, Topic::robot_description});
  slot();
  EXPECT_EQ(collector.count(Topic::joint_states), 1U);
  EXPECT_EQ(collector.count(Topic::robot_description), 1U);
}

TEST_F(FeedTest, TheDescriptionIsTheUrdfAndComesOnce) {
  for (int i = 0; i < 3; ++i) slot();
  const auto descriptions = collector.of<ros::String>(Topic::robot_description);
  ASSERT_EQ(descriptions.size(), 1U);
  EXPECT_NE(descriptions[0].data.find("<robot name=\"humanoid22\""), std::string::npos);
  EXPECT_NE(descriptions[0].data.find("</robot>"), std::string::npos);
}

TEST_F(FeedTest, PairsAnEstimateWithTheJointsOfItsSlotWheneverItIsPolled) {
  // The estimate comes at 8 ms of the slot; polls come at 5 ms.
  for (int i = 1; i <= 5; ++i) {
    beat(i * kSlot_ns + 4 * kMillisecond_ns);
    joint_states.position[3] = 0.1 * i;
    publish_sensors();
    beat(i * kSlot_ns + 5 * kMillisecond_ns);
    poll();
    beat(i * kSlot_ns + 8 * kMillisecond_ns);
    publish_estimate();
  }
  const auto messages = collector.of<ros::TFMessage>(Topic::transforms);
  ASSERT_EQ(messages.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    EXPECT_EQ(messages[i].transforms.size(), 25U);
    EXPECT_TRUE(messages[i].transforms[3].header.stamp ==
                time_of(static_cast<std::int64_t>(i + 1) * kSlot_ns + 3 * kMillisecond_ns));
    EXPECT_NEAR(messages[i].transforms[3].transform.rotation.y, std::sin(0.05 * static_cast<double>(i + 1)),
                1e-12);
  }
}

TEST_F(FeedTest, WithoutEstimatesTheLinksAreStillTold) {
  for (int i = 1; i <= 5; ++i) {
    beat(i * kSlot_ns + 4 * kMillisecond_ns);
    publish_sensors();
    poll();
  }
  const auto messages = collector.of<ros::TFMessage>(Topic::transforms);
  ASSERT_EQ(messages.size(), 4U) << "each when the next joint states are there";
  EXPECT_EQ(messages.back().transforms.size(), 24U) << "without odom";
  EXPECT_EQ(collector.count(Topic::odometry), 0U);
  EXPECT_EQ(collector.of<ros::Imu>(Topic::imu).at(0).orientation_covariance[0], -1.0);
}

TEST_F(FeedTest, ValuesWithoutAnythingNewInThemAreNotPublishedAgain) {
  slot();
  joints_writer.publish(joint_states, now_ns + kSlot_ns);  // no joint has answered: the stamp is the same
  imu_writer.publish(imu, now_ns + kSlot_ns);
  forces_writer.publish(foot_forces, now_ns + kSlot_ns);
  poll();
  EXPECT_EQ(collector.count(Topic::joint_states), 1U);
  EXPECT_EQ(collector.count(Topic::imu), 1U);
  EXPECT_EQ(collector.count(Topic::left_wrench), 1U);
}

TEST_F(FeedTest, PutsThePlanIntoThePicture) {
  auto plan = std::make_unique<MotionPlan>();
  plan->sequence = 1;
  plan->start_ns = 8 * kSlot_ns;
  for (int point = 0; point < kBatchPoints; ++point) {
    plan->support[point] = 2;
    plan->foot_position[point][0][0] = 2.0;
    plan->foot_position[point][0][1] = 1.0;
    plan->zmp[point][0] = 2.0 + 0.01 * point;
  }
  plan->footstep_count = 2;
  plan->footstep_landing_ns[0] = 9 * kSlot_ns;
  plan->footstep_landing_ns[1] = 12 * kSlot_ns;
  NetworkState network{};
  network.accepted_sequence = 1;
  network_writer.publish(network, 0);
  beat(7 * kSlot_ns);
  plan_writer.publish(*plan, 0);
  estimate.zmp[0] = 0.03;
  estimate.com[2] = 0.37;
  for (int i = 0; i < 5; ++i) slot();  // 8 to 12

  // The left foot stands in odom, half a foot spacing to the left, where the plan has it at (2, 1).
  const double spacing_m = urdf::ForwardKinematics(humanoid()).sole_pose(urdf::Side::left).translation().y();
  const auto reference = collector.of<ros::PointStamped>(Topic::reference_zmp);
  ASSERT_EQ(reference.size(), 5U);
  EXPECT_NEAR(reference[1].point.x, 0.0, 1e-9) << "point 0, reached 10 ms after the start";
  EXPECT_NEAR(reference[4].point.x, 0.03, 1e-9);
  EXPECT_NEAR(reference[4].point.y, spacing_m - 1.0, 1e-9);
  EXPECT_TRUE(reference[4].header.stamp == time_of(12 * kSlot_ns));
  EXPECT_NEAR(collector.of<ros::PointStamped>(Topic::zmp).back().point.x, 0.03, 1e-9);
  EXPECT_NEAR(collector.of<ros::PointStamped>(Topic::zmp).back().point.y, spacing_m, 1e-9);
  EXPECT_NEAR(collector.of<ros::PointStamped>(Topic::com).back().point.z, 0.37, 1e-9);
  const auto footsteps = collector.of<ros::PoseArray>(Topic::footsteps);
  ASSERT_EQ(footsteps.size(), 3U) << "two, one, none";
  EXPECT_EQ(footsteps[0].poses.size(), 2U);
  EXPECT_EQ(footsteps[1].poses.size(), 1U);
  EXPECT_TRUE(footsteps[2].poses.empty());
}

TEST_F(FeedTest, TheClockTicksEveryTenMilliseconds) {
  for (int millisecond = 1; millisecond <= 100; ++millisecond) {
    beat(kSlot_ns + millisecond * kMillisecond_ns);
    poll();
  }
  EXPECT_EQ(collector.count(Topic::clock), 11U) << "the first poll, and ten edges";
  EXPECT_EQ(feed.robot_ns(), 110 * kMillisecond_ns);
}

TEST_F(FeedTest, DiagnosticsComeEverySecondAndGoOnWhenTheRobotIsSilent) {
  for (int i = 0; i < 300; ++i) slot();
  EXPECT_EQ(collector.count(Topic::diagnostics), 3U);
  EXPECT_EQ(feed.heartbeat_age_ns(), 0);
  collector.clear();
  const std::int64_t silent_from_ns = now_ns;
  for (int i = 1; i <= 300; ++i) feed.poll(silent_from_ns + i * kSlot_ns, sink);
  const auto reports = collector.of<ros::DiagnosticArray>(Topic::diagnostics);
  ASSERT_EQ(reports.size(), 3U);
  EXPECT_EQ(reports.back().status.back().name, "loop");
  EXPECT_EQ(reports.back().status.back().level, 3);
  EXPECT_EQ(feed.heartbeat_age_ns(), 300 * kSlot_ns);
}

TEST_F(FeedTest, EventsComeInOrderAndTheMissedOnesAreCounted) {
  // Numbers would not tell them apart.
  const auto text_of_event = [](int number) {
    return std::string("event ") + static_cast<char>('a' + number / 10) +
           static_cast<char>('a' + number % 10);
  };
  const auto publish = [&](int number) {
    Event event{};
    event.kind = 1;
    const std::string text = text_of_event(number);
    std::memcpy(event.text, text.data(), text.size());
    events_writer.publish(event, number);
  };
  for (int i = 0; i < 3; ++i) publish(i);
  poll();
  auto logs = collector.of<ros::Log>(Topic::events);
  ASSERT_EQ(logs.size(), 3U);
  EXPECT_EQ(logs[0].msg, text_of_event(0));
  EXPECT_EQ(logs[2].msg, text_of_event(2));
  collector.clear();
  for (int i = 0; i < 100; ++i) publish(i);
  poll();
  logs = collector.of<ros::Log>(Topic::events);
  ASSERT_GE(logs.size(), 2U);
  EXPECT_EQ(logs[logs.size() - 2].msg, text_of_event(99));
  EXPECT_EQ(logs.back().name, "api");
  EXPECT_NE(logs.back().msg.find(std::to_string(100 - (logs.size() - 1)) + " events"), std::string::npos)
      << logs.back().msg;
}

TEST_F(FeedTest, GoesOnWithARobotThatIsStartedAnew) {
  beat(1000 * kSlot_ns);
  for (int i = 0; i < 20; ++i) {
    estimate.attitude[2] += 0.1;
    slot();
  }
  EXPECT_NEAR(collector.of<ros::Odometry>(Topic::odometry).back().pose.pose.orientation.z, std::sin(0.95),
              1e-9);
  collector.clear();
  beat(kSlot_ns);
  poll();
  for (int i = 0; i < 3; ++i) slot();
  for (const Topic topic :
       {Topic::joint_states, Topic::imu, Topic::odometry, Topic::transforms, Topic::zmp}) {
    EXPECT_EQ(collector.count(topic), 3U) << row(topic).name;
  }
  EXPECT_GE(collector.count(Topic::clock), 3U);
  EXPECT_EQ(collector.count(Topic::diagnostics), 1U);
  EXPECT_NEAR(collector.of<ros::Odometry>(Topic::odometry).back().pose.pose.orientation.z, 0.0, 1e-9)
      << "the turn was the old robot's";
}

TEST_F(FeedTest, NoticesARestartFromTheStampsAlone) {
  beat(1000 * kSlot_ns);
  slot();
  collector.clear();
  joint_states.stamp_ns = 3;
  imu.stamp_ns = 3;
  joints_writer.publish(joint_states, 0);
  imu_writer.publish(imu, 0);
  poll();
  EXPECT_EQ(collector.count(Topic::joint_states), 1U);
  EXPECT_EQ(collector.count(Topic::imu), 1U);
}

// Without a way, too, whoever looks on knows where the robot is: after a walk by velocities.
TEST_F(FeedTest, APlaceIsToldWhenItIsAnother) {
  msgclient::Writer<NavigationState> navigation = robot.write<NavigationState>("navigation_state");
  NavigationState there{};
  const auto told_after = [&](double x_m, double yaw_rad) {
    there.pose[0] = x_m;
    there.pose[2] = yaw_rad;
    beat(now_ns + 8 * kSlot_ns);
    navigation.publish(there, now_ns);
    const std::size_t before = collector.count(Topic::way_state);
    poll();
    return collector.count(Topic::way_state) - before;
  };
  EXPECT_EQ(told_after(1.0, 0.0), 1U) << "the first";
  EXPECT_EQ(told_after(1.015, 0.02), 0U) << "noise of a stand";
  EXPECT_EQ(told_after(1.03, 0.02), 1U);
  EXPECT_EQ(told_after(1.03, 0.06), 1U);
  EXPECT_EQ(collector.of<ros::WayState>(Topic::way_state).back().pose.at(0), 1.03);
}

TEST_F(FeedTest, WithoutARobotItSaysSoAndNothingElse) {
  poll();
  poll();
  EXPECT_EQ(collector.count(Topic::robot_description), 1U);
  EXPECT_EQ(collector.count(Topic::diagnostics), 1U);
  EXPECT_EQ(collector.of<ros::RobotState>(Topic::robot_state).at(0).state, "gone");
  EXPECT_EQ(collector.count(), 3U);
  EXPECT_EQ(feed.robot_ns(), 0);
}

}  // namespace
}  // namespace gaitway::api
