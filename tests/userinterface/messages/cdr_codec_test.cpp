// CDR byte for byte; the recording's test has the MCAP library decode every topic.
#include "gaitway/api/cdr_codec.hpp"

#include <gtest/gtest.h>

#include <stdexcept>
#include <string>

#include "gaitway/api/ros_messages.hpp"

namespace gaitway::api {
namespace {

using namespace std::string_literals;

template <class Message>
std::string cdr(const Message& message) {
  std::string out;
  append_cdr(out, message);
  return out;
}

const std::string kHeader = "\x00\x01\x00\x00"s;

TEST(CdrCodec, NumbersAreLittleEndian) {
  EXPECT_EQ(cdr(ros::Time{1, 0x0A0B0C0D}), kHeader + "\x01\x00\x00\x00\x0D\x0C\x0B\x0A"s);
  EXPECT_EQ(cdr(ros::Time{-2, 0}), kHeader + "\xFE\xFF\xFF\xFF\x00\x00\x00\x00"s);
}

TEST(CdrCodec, StringsHaveTheirLengthAndAClosingZero) {
  EXPECT_EQ(cdr(ros::String{"ab"}), kHeader + "\x03\x00\x00\x00"s + "ab\0"s);
  EXPECT_EQ(cdr(ros::String{}), kHeader + "\x01\x00\x00\x00\x00"s);
}

TEST(CdrCodec, DoublesStandAtMultiplesOfEightAfterTheHeader) {
  ros::PointStamped message;
  message.header.frame_id = "odom";  // 4 + 4 + 4 + 5 = 17 bytes, then 7 of padding
  message.point.x = 1.0;
  EXPECT_EQ(cdr(message), kHeader + std::string(8, '\0') + "\x05\x00\x00\x00"s + "odom\0"s +
                              std::string(7, '\0') + "\x00\x00\x00\x00\x00\x00\xF0\x3F"s +
                              std::string(16, '\0'));
}

TEST(CdrCodec, SequencesHaveACountAndArraysHaveNone) {
  ros::JointState joints;
  joints.name = {"a"};
  joints.position = {1.0};
  EXPECT_EQ(cdr(joints), kHeader + std::string(8, '\0') + "\x01\x00\x00\x00\x00"s + std::string(3, '\0') +
                             "\x01\x00\x00\x00"s + "\x02\x00\x00\x00"s + "a\0"s + std::string(2, '\0') +
                             "\x01\x00\x00\x00"s +  // at 28: the position's count; 32 is a multiple of eight
                             "\x00\x00\x00\x00\x00\x00\xF0\x3F"s + std::string(4, '\0') +
                             std::string(4, '\0'));
  const std::string imu = cdr(ros::Imu{});  // header 13, padded to 16; then 4 + 9 + 3 + 9 + 3 + 9 doubles
  EXPECT_EQ(imu.size(), 4U + 16U + 37U * 8U);
}

TEST(CdrCodec, BytesAreNotPadded) {
  ros::DiagnosticStatus status;
  status.level = 2;
  // level at 0, name at 4; each empty string 5 bytes, the next at a multiple of four.
  EXPECT_EQ(cdr(status), kHeader + "\x02\x00\x00\x00"s + "\x01\x00\x00\x00\x00\x00\x00\x00"s +
                             "\x01\x00\x00\x00\x00\x00\x00\x00"s + "\x01\x00\x00\x00\x00\x00\x00\x00"s +
                             std::string(4, '\0'));
}

TEST(CdrCodec, AppendsToWhatIsThereAndAlignsFromItsOwnBeginning) {
  std::string out = "123";
  append_cdr(out, ros::Time{1, 2});
  EXPECT_EQ(out, "123"s + cdr(ros::Time{1, 2}));
}

TEST(CdrReader, ReadsWhatIsWrittenWhateverItIs) {
  ros::JointState joints;
  joints.header.frame_id = "b";
  joints.name = {"left_knee", "", "x"};
  joints.position = {1.5, -2.0, 0.0};
  const auto back = read_cdr<ros::JointState>(cdr(joints));
  EXPECT_EQ(back.header.frame_id, "b");
  EXPECT_EQ(back.name, joints.name);
  EXPECT_EQ(back.position, joints.position);
  EXPECT_TRUE(back.velocity.empty());
  ros::Odometry odometry;
  odometry.pose.pose.orientation.w = 0.5;
  odometry.pose.covariance[35] = 7.0;
  odometry.child_frame_id = "base";
  EXPECT_EQ(cdr(read_cdr<ros::Odometry>(cdr(odometry))), cdr(odometry));
}

TEST(CdrReader, RefusesWhatIsCutOffAndWhatIsNoCdr) {
  ros::JointState joints;
  joints.name = {"left_knee"};
  joints.position = {1.5};
  const std::string whole = cdr(joints);
  for (std::size_t size = 0; size < whole.size(); ++size)
    EXPECT_THROW((void)read_cdr<ros::JointState>(whole.substr(0, size)), std::invalid_argument) << size;
  std::string large = whole;
  large[12 + 3] = '\x7f';  // of the frame's name: its length
  EXPECT_THROW((void)read_cdr<ros::JointState>(large), std::invalid_argument);
  std::string big_endian = whole;
  big_endian[1] = '\0';
  EXPECT_THROW((void)read_cdr<ros::JointState>(big_endian), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::api
