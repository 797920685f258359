// A station's end of the bus socket against a server that says what no bus can.
#include "gaitway/can/simulated/bus_client.hpp"

#include <gtest/gtest.h>
#include <sys/socket.h>

#include <array>
#include <filesystem>
#include <string>

#include "can/simulated/bus_protocol.hpp"
#include "gaitway/process/listening_socket.hpp"

namespace gaitway::can {
namespace {

using protocol::Kind;
using protocol::Record;

TEST(BusClientTest, FramesThatNoBusCanCarryReachNobodyThoughTheirSenderIsToldOfThem) {
  std::string folder = (std::filesystem::temp_directory_path() / "gaitway_bus_XXXXXX").native();
  ASSERT_NE(mkdtemp(folder.data()), nullptr);
  {
    process::ListeningSocket listener(std::filesystem::path(folder) / "bus", "bus");
    BusClient client(listener.path(), "client", Pace::free);
    const process::FileDescriptor server = listener.accept();
    ASSERT_TRUE(server);
    const Frame frame{.id = 0x100, .size = 1};
    ASSERT_TRUE(client.transmit(frame, 1));
    ASSERT_TRUE(client.transmit(frame, 1));
    Record too_long = protocol::record_of(Kind::sent, frame, 1, 2);
    too_long.size = 255;
    const std::array said{too_long, protocol::record_of(Kind::sent, frame, 3, 4)};
    ASSERT_EQ(send(server.get(), said.data(), sizeof said, 0), static_cast<ssize_t>(sizeof said));
    EXPECT_FALSE(client.receive());
    const auto notice = client.next_notice();
    ASSERT_TRUE(notice);
    EXPECT_EQ(notice->frame.start_ns, 3) << "the one that can be";
    EXPECT_FALSE(client.next_notice());
  }
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace gaitway::can
