// Recordings of the robot API as trajectories: rows by their stamps, gaps drawn and told, what is missing
// told.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <string>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/mcap_writer.hpp"
#include "gaitway/api/publication.hpp"
#include "gaitway/input/complaint.hpp"
#include "tools/simulate/trajectory_source.hpp"

namespace gaitway::tools {
namespace {

using api::Topic;
using ::testing::HasSubstr;

class RecordedTrajectory : public ::testing::Test {
 protected:
  RecordedTrajectory()
      : file_(std::filesystem::temp_directory_path() /
              ("gaitway_recorded_" + std::to_string(::getpid()) + ".mcap")) {
    std::vector<api::McapChannel> channels;
    for (const api::TopicRow& row : api::kTopics)
      channels.push_back({std::string(row.name), std::string(row.type), ""});
    writer_.emplace(::open(file_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600), channels);
  }
  ~RecordedTrajectory() override { std::filesystem::remove(file_); }

  template <class Message>
  void write(Topic topic, Message message, std::int64_t slot) {
    // Somewhere within 3 ms of the slot's edge, as frames arrive.
    const std::int64_t ns = slot * 10'000'000 + (slot % 7 - 3) * 1'000'000;
    message.header.stamp.sec = static_cast<std::int32_t>(ns / 1'000'000'000);
    message.header.stamp.nanosec = static_cast<std::uint32_t>(ns % 1'000'000'000);
    std::string bytes;
    api::append_cdr(bytes, message);
    writer_->write(static_cast<std::size_t>(topic), bytes, ns, ns);
  }
  // Joints in another order than the robot's; the left knee's angle tells the slot.
  void write_joints(std::int64_t slot) {
    api::ros::JointState joints;
    for (auto joint = robot_.joints.rbegin(); joint != robot_.joints.rend(); ++joint) {
      joints.name.push_back(joint->name);
      joints.position.push_back(joint->name == "left_knee" ? 0.7 + 1e-4 * static_cast<double>(slot)
                                                           : joint->home_rad);
    }
    write(Topic::joint_states, joints, slot);
  }
  kinematic::Trajectory read() {
    EXPECT_TRUE(writer_->finish());
    return read_recording(robot_, file_);
  }
  std::string complaint() {
    try {
      (void)read();
    } catch (const input::InputError& error) {
      return error.what();
    }
    return "taken";
  }

  const urdf::RobotModel robot_ = urdf::load_robot(std::filesystem::path(GAITWAY_URDF_DIR) / "humanoid22");
  std::filesystem::path file_;
  std::optional<api::McapWriter> writer_;
};

TEST_F(RecordedTrajectory, HasARowForEachSlotAndDrawsGaps) {
  const auto knee = static_cast<std::size_t>(robot_.joint_index("left_knee"));
  for (std::int64_t slot = 500; slot < 600; ++slot) {
    if (slot >= 540 && slot < 545) continue;  // lost on the way
    write_joints(slot);
    api::ros::PointStamped point;
    point.point.x = 1e-3 * static_cast<double>(slot);
    write(Topic::zmp, point, slot);
    api::ros::Odometry odometry;
    odometry.pose.pose.position.z = 0.4;
    odometry.pose.pose.orientation.w = 1.0;
    write(Topic::odometry, odometry, slot);
    api::ros::WrenchStamped wrench;
    wrench.wrench.force.z = slot < 550 ? 35.0 : 60.0;
    write(Topic::left_wrench, wrench, slot);
    wrench.wrench.force.z = slot < 550 ? 35.0 : 0.0;
    write(Topic::right_wrench, wrench, slot);
  }
  const kinematic::Trajectory trajectory = read();
  ASSERT_EQ(trajectory.rows(), 100U);
  EXPECT_DOUBLE_EQ(trajectory.start_s, 5.0);
  for (std::size_t row = 0; row < 100; ++row)
    EXPECT_NEAR(trajectory.row(row)[knee], 0.7 + 1e-4 * static_cast<double>(500 + row), 1e-12) << row;
  EXPECT_EQ(trajectory.row(3)[0], robot_.joints[0].home_rad);
  EXPECT_DOUBLE_EQ(trajectory.base[50].translation().z(), 0.4);
  EXPECT_EQ(trajectory.contact[0], motion::Contact::both);
  EXPECT_EQ(trajectory.contact[60], motion::Contact::left);
  EXPECT_DOUBLE_EQ(trajectory.zmp[kinematic::index_of(kinematic::ZmpSource::cells)][20].x(), 0.52);
  EXPECT_TRUE(std::isnan(trajectory.zmp[kinematic::index_of(kinematic::ZmpSource::planned)][20].x()));
  EXPECT_THAT(trajectory.notes, ::testing::Contains(HasSubstr("5 of 100 rows are not in the recording")));
}

TEST_F(RecordedTrajectory, WithoutOdometryItsFeetCarryTheBase) {
  for (std::int64_t slot = 0; slot < 50; ++slot) write_joints(slot + 1);
  const kinematic::Trajectory trajectory = read();
  EXPECT_TRUE(trajectory.base.empty());
  EXPECT_TRUE(trajectory.contact.empty());
  EXPECT_THAT(trajectory.notes, ::testing::Contains(HasSubstr("/odom")));
}

TEST_F(RecordedTrajectory, RefusesALongSilenceByItsTimes) {
  write_joints(100);
  write_joints(200);
  EXPECT_THAT(complaint(), HasSubstr("none from 1.00 to 2.00 s"));
}

TEST_F(RecordedTrajectory, RefusesAnotherRobotByItsJoint) {
  api::ros::JointState joints;
  joints.name = {"left_kneee"};
  joints.position = {0.0};
  write(Topic::joint_states, joints, 1);
  EXPECT_THAT(complaint(), HasSubstr("left_kneee"));
}

TEST_F(RecordedTrajectory, RefusesARecordingWithoutJoints) {
  write(Topic::zmp, api::ros::PointStamped{}, 1);
  EXPECT_THAT(complaint(), HasSubstr("/joint_states"));
}

}  // namespace
}  // namespace gaitway::tools
