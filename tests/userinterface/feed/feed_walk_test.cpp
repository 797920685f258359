// The feed beside a walking robot, against the simulator's truth.
#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include "collector.hpp"
#include "gaitway/api/feed.hpp"
#include "gaitway/api/plan_digest.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "humanoid.hpp"
#include "plant_implementation.hpp"
#include "transform_tree.hpp"

namespace gaitway::api {
namespace {

using test::humanoid;

using facts::kSlot_ns;

// What was true at the beginning of a slot.
struct Truth {
  Eigen::Isometry3d base;
  Eigen::Vector3d com_m, cop_m;
  Eigen::Vector3d velocity_m_per_s;                // of the base, in the base
  Eigen::Vector3d turn_rate_rad_per_s;             // likewise
  std::map<std::string, Eigen::Isometry3d> links;  // in the base
};

Eigen::Isometry3d body_pose(const mjData& data, std::size_t body) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.translation() = Eigen::Map<const Eigen::Vector3d>(data.xpos + 3 * body);
  pose.linear() = Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(data.xmat + 9 * body);
  return pose;
}

Truth truth_of(const simulator::Plant& plant) {
  const mjData& data = *plant.implementation().data;
  Truth truth{plant.truth().base, plant.truth().com_m, plant.truth().cop_m, {}, {}, {}};
  const std::span<const double> velocities = plant.velocities();
  truth.velocity_m_per_s =
      truth.base.linear().transpose() * Eigen::Map<const Eigen::Vector3d>(velocities.data());
  truth.turn_rate_rad_per_s = Eigen::Map<const Eigen::Vector3d>(velocities.data() + 3);
  for (std::size_t link = 0; link < humanoid().links.size(); ++link) {
    truth.links[humanoid().links[link].name] = truth.base.inverse() * body_pose(data, link + 1);
  }
  return truth;
}

class Walk {
 public:
  Walk(double mismatch, double forward_m_per_s, double turn_rad_per_s, double seconds)
      : run(humanoid(), options(mismatch)), digest(run.client()), feed(run.client(), humanoid()) {
    run.apply({0.0, simulator::WalkEvent{.velocity_m_per_s = {forward_m_per_s, 0.0},
                                         .turn_rate_rad_per_s = turn_rad_per_s}});
    auto sink = test::sink_of(collector);
    while (static_cast<double>(run.now_ns()) < seconds * 1e9) {
      if (run.now_ns() % kSlot_ns == 0) truths[run.now_ns()] = truth_of(run.plant());
      run.advance_millisecond();
      digest.step(run.now_ns());
      feed.poll(run.now_ns(), sink);
    }
  }
  // What was true when the joints measured what has this stamp.
  [[nodiscard]] const Truth& at(const ros::Time& stamp) const {
    const std::int64_t time_ns = std::int64_t{stamp.sec} * 1'000'000'000 + stamp.nanosec;
    return truths.at(time_ns - time_ns % kSlot_ns);
  }

  simulator::Cosimulation run;
  PlanDigest digest;
  Feed feed;
  test::Collector collector;
  std::map<std::int64_t, Truth> truths;

 private:
  static simulator::CosimulationOptions options(double mismatch) {
    simulator::CosimulationOptions result;
    result.plant.seed = 3;
    result.plant.mismatch = mismatch;
    result.plant.sensor_noise = mismatch > 0.0;
    result.main_controller.configuration =
        std::filesystem::path(GAITWAY_SOURCE_DIR) / "core" / "config" / "walk.yaml";
    result.main_controller.plugin_path = {GAITWAY_PLUGIN_DIR};
    return result;
  }
};

// Five seconds with the body that its planner knows only roughly, turning on the way.
const Walk& rough_walk() {
  static const Walk walk(1.0, 0.15, 0.2, 5.0);
  return walk;
}
// The same with the body as it is described, and quiet sensors.
const Walk& exact_walk() {
  static const Walk walk(0.0, 0.15, 0.2, 5.0);
  return walk;
}

Eigen::Vector3d vector_of(const ros::Point& point) {
  return {point.x, point.y, point.z};
}
Eigen::Vector3d vector_of(const ros::Vector3& vector) {
  return {vector.x, vector.y, vector.z};
}
double rms(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

TEST(FeedOfAWalk, OdometryStaysWithTheSimulatedBase) {
  const auto messages = rough_walk().collector.of<ros::Odometry>(Topic::odometry);
  ASSERT_GT(messages.size(), 490U);
  const Truth& end = rough_walk().at(messages.back().header.stamp);
  ASSERT_GT(end.base.translation().head<2>().norm(), 0.4) << "it has walked";
  double worst_m = 0.0, worst_rad = 0.0;
  for (const ros::Odometry& message : messages) {
    const Truth& truth = rough_walk().at(message.header.stamp);
    const ros::Quaternion& q = message.pose.pose.orientation;
    worst_m = std::max(worst_m, (vector_of(message.pose.pose.position) - truth.base.translation()).norm());
    worst_rad = std::max(
        worst_rad,
        Eigen::Quaterniond(q.w, q.x, q.y, q.z).angularDistance(Eigen::Quaterniond(truth.base.linear())));
  }
  RecordProperty("worst_mm", std::to_string(worst_m * 1e3));
  RecordProperty("worst_rad", std::to_string(worst_rad));
  EXPECT_LT(worst_m, 0.02);
  EXPECT_LT(worst_rad, 0.035) << "half of it is how askew the IMU is mounted, which nobody has told";
}

TEST(FeedOfAWalk, TwistIsTheBasesVelocity) {
  std::vector<double> linear, angular;
  for (const ros::Odometry& message : rough_walk().collector.of<ros::Odometry>(Topic::odometry)) {
    const Truth& truth = rough_walk().at(message.header.stamp);
    linear.push_back((vector_of(message.twist.twist.linear) - truth.velocity_m_per_s).norm());
    angular.push_back((vector_of(message.twist.twist.angular) - truth.turn_rate_rad_per_s).norm());
  }
  RecordProperty("linear_m_per_s", std::to_string(rms(linear)));
  RecordProperty("angular_rad_per_s", std::to_string(rms(angular)));
  EXPECT_LT(rms(linear), 0.06);
  EXPECT_LT(rms(angular), 0.15);
}

TEST(FeedOfAWalk, PointsAreInTheSameFrameAsTheBase) {
  // Seen from the base, the CoM and the ZMP are where they are in the simulation: the walk's own error is
  // out.
  const auto bases = exact_walk().collector.of<ros::Odometry>(Topic::odometry);
  const auto coms = exact_walk().collector.of<ros::PointStamped>(Topic::com);
  const auto zmps = exact_walk().collector.of<ros::PointStamped>(Topic::zmp);
  ASSERT_EQ(bases.size(), coms.size());
  ASSERT_EQ(bases.size(), zmps.size());
  std::vector<double> com_m, zmp_m;
  for (std::size_t i = 100; i < bases.size(); ++i) {
    const Truth& truth = exact_walk().at(bases[i].header.stamp);
    const Eigen::Vector3d shift = truth.base.translation() - vector_of(bases[i].pose.pose.position);
    com_m.push_back((vector_of(coms[i].point) + shift - truth.com_m).norm());
    zmp_m.push_back((vector_of(zmps[i].point) + shift - truth.cop_m).head<2>().norm());
  }
  RecordProperty("com_mm", std::to_string(rms(com_m) * 1e3));
  RecordProperty("zmp_mm", std::to_string(rms(zmp_m) * 1e3));
  EXPECT_LT(rms(com_m), 0.010);
  EXPECT_LT(rms(zmp_m), 0.015);
}

TEST(FeedOfAWalk, TransformsPutEveryLinkWhereTheSimulatorHasIt) {
  const auto messages = exact_walk().collector.of<ros::TFMessage>(Topic::transforms);
  ASSERT_GT(messages.size(), 490U);
  double worst_m = 0.0, worst_rad = 0.0;
  for (const ros::TFMessage& message : messages) {
    const test::TransformTree tree(message);
    const Truth& truth = exact_walk().at(message.transforms.front().header.stamp);
    EXPECT_NO_THROW(static_cast<void>(tree.pose("odom", "left_sole")));
    for (const auto& [link, pose] : truth.links) {
      const Eigen::Isometry3d difference = pose.inverse() * tree.pose("pelvis", link);
      worst_m = std::max(worst_m, difference.translation().norm());
      worst_rad = std::max(worst_rad, Eigen::AngleAxisd(difference.linear()).angle());
    }
  }
  RecordProperty("worst_mm", std::to_string(worst_m * 1e3));
  RecordProperty("worst_rad", std::to_string(worst_rad));
  EXPECT_LT(worst_m, 0.003);
  EXPECT_LT(worst_rad, 0.02);
}

TEST(FeedOfAWalk, ReferenceAndMeasuredZmpLieTogether) {
  const auto measured = exact_walk().collector.of<ros::PointStamped>(Topic::zmp);
  const auto reference = exact_walk().collector.of<ros::PointStamped>(Topic::reference_zmp);
  ASSERT_GT(reference.size(), 480U);
  std::map<std::int64_t, Eigen::Vector3d> by_slot;
  for (const ros::PointStamped& message : reference) {
    by_slot[std::int64_t{message.header.stamp.sec} * 100 + message.header.stamp.nanosec / 10'000'000] =
        vector_of(message.point);
  }
  // The walk's ZMP goes from heel to toe about the reference: on the average they are at one place.
  Eigen::Vector3d sum_m = Eigen::Vector3d::Zero();
  std::vector<double> difference_m;
  for (const ros::PointStamped& message : measured) {
    const auto found = by_slot.find(std::int64_t{message.header.stamp.sec} * 100 +
                                    message.header.stamp.nanosec / 10'000'000);
    if (found == by_slot.end()) continue;
    sum_m += vector_of(message.point) - found->second;
    difference_m.push_back((vector_of(message.point) - found->second).norm());
  }
  ASSERT_GT(difference_m.size(), 480U);
  const double mean_m = sum_m.norm() / static_cast<double>(difference_m.size());
  RecordProperty("mean_mm", std::to_string(mean_m * 1e3));
  RecordProperty("rms_mm", std::to_string(rms(difference_m) * 1e3));
  EXPECT_LT(mean_m, 0.015);
  EXPECT_LT(rms(difference_m), 0.07);
}

TEST(FeedOfAWalk, FootstepsAreAheadOfTheRobotAndItsFeetComeToStandOnThem) {
  const auto plans = rough_walk().collector.of<ros::PoseArray>(Topic::footsteps);
  ASSERT_GT(plans.size(), 10U);
  // The first footstep of the last message but some has become a place of a sole.
  const auto transforms = rough_walk().collector.of<ros::TFMessage>(Topic::transforms);
  int landed = 0;
  for (std::size_t i = 1; i < plans.size(); ++i) {
    if (plans[i].poses.size() >= plans[i - 1].poses.size() || plans[i - 1].poses.empty()) continue;
    const ros::Time& stamp = plans[i].header.stamp;  // the first of the last message has just landed
    const Eigen::Vector3d place = vector_of(plans[i - 1].poses.front().position);
    double nearest_m = 1.0;
    for (const ros::TFMessage& message : transforms) {
      const ros::Time& time = message.transforms.front().header.stamp;
      if (time.sec != stamp.sec || time.nanosec / 10'000'000 != stamp.nanosec / 10'000'000) continue;
      const test::TransformTree tree(message);
      for (const char* sole : {"left_sole", "right_sole"}) {
        nearest_m = std::min(nearest_m, (tree.pose("odom", sole).translation() - place).head<2>().norm());
      }
    }
    EXPECT_LT(nearest_m, 0.03);
    ++landed;
  }
  EXPECT_GE(landed, 3);
}

TEST(FeedOfAWalk, EveryTopicComesAtItsRate) {
  for (const TopicRow& topic : kTopics) {
    if (topic.rate_hz == 0.0 || topic.of_simulation) continue;
    const auto count = static_cast<double>(rough_walk().collector.count(topic.topic));
    EXPECT_NEAR(count / 5.0, topic.rate_hz, 0.03 * topic.rate_hz + 0.21) << topic.name;
  }
}

}  // namespace
}  // namespace gaitway::api
