// Stops over real UDP sockets of this machine.
#include "gaitway/stopgram/stop_socket.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>

#include <string>
#include <vector>

#include "gaitway/stopgram/stop_desk.hpp"
#include "gaitway/stopgram/stop_sender.hpp"

namespace gaitway::stopgram {
namespace {

using testing::HasSubstr;

std::optional<StopSocket::Received> wait_for_datagram(StopSocket& socket) {
  constexpr int kPatience_ms = 5000;
  pollfd wakes{socket.wake_fd(), POLLIN, 0};
  poll(&wakes, 1, kPatience_ms);
  return socket.receive();
}

template <class Action>
std::string refusal(Action action) {
  try {
    action();
  } catch (const StopSocketError& error) {
    return error.what();
  }
  return {};
}

class StopSocketOf : public testing::TestWithParam<const char*> {};

TEST_P(StopSocketOf, CarriesAStopAndItsAnswers) {
  StopSocket desk_socket(GetParam(), 0);
  ASSERT_NE(desk_socket.port(), 0);
  const Peer robot = find_peer(GetParam(), desk_socket.port());
  StopSocket socket(robot);
  EXPECT_FALSE(desk_socket.receive()) << "does not block";
  StopDesk desk(StopKey("0123456789abcdef"), 1);
  StopSender sender(StopKey("0123456789abcdef"), 7);
  sender.stop(StopKind::emergency_hold);
  link::StopCounts asked;
  for (std::int64_t now_ns = 0; sender.state(StopKind::emergency_hold) != StopState::obeyed; ++now_ns) {
    ASSERT_LT(now_ns, 3);
    ASSERT_TRUE(socket.send(sender.next(now_ns * StopSender::kRepeat_ns), robot));
    const auto said = wait_for_datagram(desk_socket);
    ASSERT_TRUE(said);
    const Bytes answer = desk.on_datagram(said->datagram, said->from, now_ns);
    while (desk.next_stop(asked)) ++asked.holds;
    desk.obeyed(asked);
    ASSERT_TRUE(desk_socket.send(answer, said->from));
    const auto answered = wait_for_datagram(socket);
    ASSERT_TRUE(answered);
    EXPECT_EQ(answered->from, robot);
    sender.on_datagram(answered->datagram, now_ns);
  }
  EXPECT_EQ(asked.holds, 1U);
}
INSTANTIATE_TEST_SUITE_P(Addresses, StopSocketOf, testing::Values("127.0.0.1", "localhost", "::1"));

TEST(StopSocket, DoesNotTakeALongDatagramForAShortOne) {
  StopSocket desk_socket("127.0.0.1", 0);
  const Peer robot = find_peer("127.0.0.1", desk_socket.port());
  StopSocket socket(robot);
  const std::vector<std::uint8_t> much(1000, 1);
  ASSERT_TRUE(socket.send(much, robot));
  const auto said = wait_for_datagram(desk_socket);
  ASSERT_TRUE(said);
  EXPECT_GT(said->datagram.size(), kMostDatagramBytes);
}

TEST(StopSocket, SaysWhatIsWrongAndWhatToDo) {
  StopSocket first("127.0.0.1", 0);
  const std::string port = std::to_string(first.port());
  EXPECT_THAT(refusal([&] { StopSocket("127.0.0.1", first.port()); }),
              testing::AllOf(HasSubstr(port), HasSubstr("127.0.0.1"), HasSubstr("--stop-port")));
  EXPECT_THAT(refusal([] { StopSocket("203.0.113.1", 9091); }), HasSubstr("no such address"));
  EXPECT_THAT(refusal([] { StopSocket("robot.invalid", 9091); }), HasSubstr("numeric"));
  EXPECT_THAT(refusal([] { find_peer("robot.invalid", 9091); }),
              testing::AllOf(HasSubstr("robot.invalid"), HasSubstr("9091"), HasSubstr("numeric address")));
}

}  // namespace
}  // namespace gaitway::stopgram
