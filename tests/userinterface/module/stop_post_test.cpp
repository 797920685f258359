// Stops by datagram come to the link from a thread of their own, and are told to the thread of the sessions.
#include "gaitway/api/stop_post.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <filesystem>
#include <string>
#include <vector>

#include "gaitway/process/real_time.hpp"
#include "gaitway/stopgram/stop_sender.hpp"

namespace gaitway::api {
namespace {

using ::testing::HasSubstr;

constexpr std::int64_t kPatience_ns = 20 * facts::kSecond_ns;
constexpr char kPostToken[] = "0123456789abcdef";

class StopPostTest : public ::testing::Test {
 protected:
  // Says what `sender` has to say until `done`.
  template <class Done>
  void converse(stopgram::StopSender& sender, Done done) {
    const std::int64_t end_ns = process::monotonic_ns() + kPatience_ns;
    while (!done()) {
      ASSERT_LT(process::monotonic_ns(), end_ns);
      for (link::Bytes said; !(said = sender.next(process::monotonic_ns())).empty();)
        socket_.send(said, desk_);
      pollfd wakes{socket_.wake_fd(), POLLIN, 0};
      poll(&wakes, 1, 10);
      while (const auto received = socket_.receive()) {
        sender.on_datagram(received->datagram, process::monotonic_ns());
      }
    }
  }

  const urdf::RobotModel robot_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  ModuleLink link_{robot_, {.boot = 9}};
  stopgram::StopSocket desk_socket_{"127.0.0.1", 0};
  stopgram::Peer desk_ = stopgram::find_peer("127.0.0.1", desk_socket_.port());
  stopgram::StopSocket socket_{desk_};
  StopPost post_{link_, std::move(desk_socket_), stopgram::StopKey(kPostToken)};
};

TEST_F(StopPostTest, GoToTheLinkOnceAndAreTold) {
  stopgram::StopSender sender(stopgram::StopKey(kPostToken), 7);
  sender.stop(link::StopKind::emergency_soft);
  converse(sender,
           [&] { return sender.state(link::StopKind::emergency_soft) == stopgram::StopState::heard; });
  EXPECT_EQ(link_.stops_asked(), (link::StopCounts{0, 0, 1}));
  const auto stops = post_.take_stops();
  ASSERT_TRUE(stops);
  EXPECT_EQ(stops->count, 1U);
  EXPECT_THAT(text_of(*stops), HasSubstr("emergency stop that lets go by datagram from 127.0.0.1:"));
  EXPECT_FALSE(post_.take_stops());
  for (int i = 0; i < 5; ++i) {  // the robot is not there: it is said on and on
    const std::int64_t until_ns = process::monotonic_ns() + stopgram::StopSender::kRepeat_ns;
    converse(sender, [&] { return process::monotonic_ns() > until_ns; });
  }
  EXPECT_EQ(sender.state(link::StopKind::emergency_soft), stopgram::StopState::heard) << "nobody has obeyed";
  EXPECT_EQ(link_.stops_asked(), (link::StopCounts{0, 0, 1}));
  EXPECT_TRUE(post_.take_refusals().empty());
}

TEST_F(StopPostTest, OfStrangersAreNotPassedOnButTold) {
  stopgram::StopSender sender(stopgram::StopKey("another token 01"), 7);
  sender.stop(link::StopKind::stop);
  std::vector<std::string> lines;
  converse(sender, [&] {
    lines = post_.take_refusals();
    return !lines.empty();
  });
  EXPECT_THAT(lines.front(), HasSubstr("wrong code"));
  EXPECT_FALSE(post_.take_stops());
  EXPECT_EQ(link_.stops_asked(), link::StopCounts{});
}

}  // namespace
}  // namespace gaitway::api
