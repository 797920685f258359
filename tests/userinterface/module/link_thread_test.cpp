// The link's thread, that of stops by datagram and that of the sessions, all at work on one link over a Unix
// socket. Run under the thread sanitizer, too.
#include "gaitway/api/link_thread.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "gaitway/api/link_host.hpp"
#include "gaitway/api/stop_post.hpp"
#include "gaitway/contract/channel_table.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/stopgram/stop_sender.hpp"

namespace gaitway::api {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr std::int64_t kLongest_ns = 60 * facts::kSecond_ns;
constexpr char kThreadsToken[] = "0123456789abcdef";
constexpr std::size_t kNetworkChannel = 2;

// The robot's side, in a thread of its own: carries out whatever comes, at once, and tells of a network.
class Robot {
 public:
  Robot(const std::filesystem::path& socket, const urdf::RobotModel& robot)
      : codec_{.joint_count = robot.joints.size()},
        host_({.kind = link::LinkAddress::Kind::unix_socket, .path = socket}),
        end_(contract::identity_of(link::Role::controller, link::random_boot(), "robot", robot),
             contract::link_channels(codec_), {}),
        thread_([this](const std::stop_token& stop) { run(stop); }) {}

 private:
  void run(const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      host_.wait(1);
      const std::int64_t now_ns = process::monotonic_ns();
      host_.pump(end_, now_ns);
      while (const auto order = end_.next_order(now_ns)) {
        end_.answer(order->id, static_cast<std::uint16_t>(contract::OrderResultCode::done), {});
      }
      end_.stops_obeyed(end_.stops_heard());
      publish_network(now_ns);
      host_.pump(end_, now_ns);
    }
  }
  void publish_network(std::int64_t now_ns) {
    NetworkState state{};
    state.accepted_sequence = ++published_;
    std::vector<std::uint8_t> value(contract::link_channels(codec_)[kNetworkChannel].most_bytes);
    value[0] = contract::topic_bit(0);
    const std::size_t bytes =
        codec_.encode(TopicType<NetworkState>::descriptor, &state, std::span(value).subspan(1));
    end_.publish(kNetworkChannel, link::Bytes(value).first(1 + bytes), now_ns);
  }

  contract::TopicCodec codec_;
  LinkHost host_;
  link::ControllerEnd end_;
  std::uint32_t published_ = 0;
  std::jthread thread_;
};

class LinkThreadTest : public ::testing::Test {
 protected:
  // As the server's thread does, every 2 ms.
  template <class Done>
  void serve_until(Done done) {
    constexpr int kPeriod_ms = 2;
    const std::int64_t end_ns = process::monotonic_ns() + kLongest_ns;
    while (!done()) {
      ASSERT_LT(process::monotonic_ns(), end_ns) << link_.description();
      pollfd wakes{datagrams_.wake_fd(), POLLIN, 0};
      poll(&wakes, 1, kPeriod_ms);
      while (const auto received = datagrams_.receive()) {
        sender_.on_datagram(received->datagram, process::monotonic_ns());
      }
      for (link::Bytes said; !(said = sender_.next(process::monotonic_ns())).empty();) {
        datagrams_.send(said, desk_);
      }
      while (const auto result = link_.take_result(process::monotonic_ns())) {
        (result->done ? done_ : refused_) += 1;
      }
      if (const auto stops = post_.take_stops()) {
        link_.see_stops(stops->count);
      }
    }
  }
  void note(std::string& told, const std::string& line) {
    const std::scoped_lock lock(told_mutex_);
    told += line + "\n";
  }
  void order_velocity() {
    WalkCommand command{};
    command.walk = 1;
    link_.order(contract::OrderKind::walk, command, 0, process::monotonic_ns());
  }

  const urdf::RobotModel robot_model_ =
      urdf::load_robot(std::filesystem::path(GAITWAY_SOURCE_DIR) / "urdf" / "humanoid22");
  const process::PrivateFolder folder_{"gaitway-link"};
  std::mutex told_mutex_;
  std::vector<std::string> told_;
  ModuleLink link_{robot_model_, {.boot = link::random_boot()}};
  msgclient::Client topics_ = link_.topics("test");
  msgclient::Reader<NetworkState> network_ = topics_.read<NetworkState>("network_state");
  stopgram::StopSocket desk_socket_{"127.0.0.1", 0};
  stopgram::Peer desk_ = stopgram::find_peer("127.0.0.1", desk_socket_.port());
  stopgram::StopSocket datagrams_{desk_};
  stopgram::StopSender sender_{stopgram::StopKey(kThreadsToken), 7};
  int done_ = 0, refused_ = 0;
  LinkThread link_thread_{link_,
                          {.kind = link::LinkAddress::Kind::unix_socket, .path = folder_.path() / "link"},
                          [this](const std::string& line) {
                            const std::scoped_lock lock(told_mutex_);
                            told_.push_back(line);
                          }};
  StopPost post_{link_, std::move(desk_socket_), stopgram::StopKey(kThreadsToken)};
};

TEST_F(LinkThreadTest, OrdersStopsAndStateGoOverOneLinkAtOnce) {
  constexpr int kOrders = 100;
  const Robot robot(folder_.path() / "link", robot_model_);
  serve_until([this] { return link_.open(); });
  for (int i = 0; i < kOrders; ++i) {
    const int before = done_ + refused_;
    order_velocity();
    sender_.stop(i % 2 == 0 ? link::StopKind::stop : link::StopKind::emergency_hold);
    serve_until([&] { return done_ + refused_ > before; });
  }
  link_.stop(link::StopKind::emergency_soft);
  serve_until([this] {
    return link_.stops_asked() == link_.stops_obeyed() &&
           sender_.state(link::StopKind::stop) == stopgram::StopState::obeyed;
  });
  EXPECT_GT(done_, 0);
  EXPECT_GE(link_.stops_obeyed().stops, 1U);
  EXPECT_EQ(link_.stops_obeyed().softs, 1U);
  NetworkState state;
  ASSERT_TRUE(network_.read(state));
  const std::uint32_t seen = state.accepted_sequence;
  serve_until([&] { return network_.read(state) && state.accepted_sequence > seen; });
}

TEST_F(LinkThreadTest, SaysAtWhichPathThereIsNobody) {
  serve_until([this] { return link_thread_.report().text.find("cannot connect") != std::string::npos; });
  EXPECT_EQ(link_thread_.report().state, LinkReport::State::down);
  EXPECT_THAT(link_thread_.report().text, AllOf(HasSubstr("'" + (folder_.path() / "link").native() + "'"),
                                                HasSubstr("Is main_controller running")));
}

TEST_F(LinkThreadTest, ASecondModuleIsRefusedByNameAndTheFirstGoesOn) {
  const Robot robot(folder_.path() / "link", robot_model_);
  serve_until([this] {
    order_velocity();
    return done_ > 0;  // the robot's side knows it, too
  });
  std::string told;
  ModuleLink second(robot_model_, {.boot = link::random_boot(), .name = "the second"});
  std::optional<LinkThread> thread(std::in_place, second, link::LinkAddress{.path = folder_.path() / "link"},
                                   [&](const std::string& line) { note(told, line); });
  serve_until([&] { return thread->report().state == LinkReport::State::refused; });
  EXPECT_THAT(thread->report().text,
              AllOf(HasSubstr("linked to another module, 'user_interface'"), HasSubstr("'the second'"),
                    HasSubstr("end that one, or this one")));
  EXPECT_TRUE(link_.open()) << "the first goes on";
  EXPECT_EQ(link_.session(), 1U);
  thread.reset();
  EXPECT_THAT(told, HasSubstr("no link to the main controller: refused"));
}

TEST_F(LinkThreadTest, AModuleOfAnotherRobotsFolderIsRefusedAndSaysWhichFolder) {
  const std::filesystem::path path = folder_.path() / "that_no_other_module_wants";
  const Robot robot(path, robot_model_);
  const std::filesystem::path other = folder_.path() / "other";
  std::filesystem::copy(robot_model_.directory, other, std::filesystem::copy_options::recursive);
  std::ofstream(other / "robot.yaml", std::ios::app) << "# changed\n";
  ModuleLink module(urdf::load_robot(other), {.boot = link::random_boot(), .name = "the other's"});
  std::string told;
  LinkThread thread(module, {.path = path}, [&](const std::string& line) { note(told, line); });
  serve_until([&] { return thread.report().state == LinkReport::State::refused; });
  EXPECT_THAT(thread.report().text, AllOf(HasSubstr("has the robot's description"), HasSubstr("'robot', has"),
                                          HasSubstr("here it is 'humanoid22' of " + other.native())));
}

TEST_F(LinkThreadTest, ConnectsAgainAsOftenAsTheOtherSideGoes) {
  constexpr std::size_t kTimes = 5;
  for (std::size_t times = 1; times <= kTimes; ++times) {
    {
      const Robot robot(folder_.path() / "link", robot_model_);
      serve_until([this] { return link_.open(); });
      const int before = done_;
      serve_until([&] {
        order_velocity();
        return done_ > before;
      });
    }
    // That it is linked, and that the link is lost.
    serve_until([this, times] {
      const std::scoped_lock lock(told_mutex_);
      return told_.size() >= 2 * times;
    });
    EXPECT_FALSE(link_.open());
  }
}

}  // namespace
}  // namespace gaitway::api
