// One process at a path: clients come in, a second server is refused, what a dead one left is replaced.
#include "gaitway/process/listening_socket.hpp"

#include <gmock/gmock.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <functional>
#include <string>

namespace gaitway::process {
namespace {

using testing::AllOf;
using testing::HasSubstr;

std::string refusal(const std::function<void()>& action) {
  try {
    action();
  } catch (const SocketError& error) {
    return error.what();
  }
  return "nothing was refused";
}

bool readable(int fd) {
  pollfd wake{fd, POLLIN, 0};
  return poll(&wake, 1, 0) == 1;
}

class ListeningSocketTest : public testing::Test {
 protected:
  ListeningSocketTest() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_socket_XXXXXX").string();
    folder = mkdtemp(name.data());
    path = folder / "s";
  }
  ~ListeningSocketTest() override { std::filesystem::remove_all(folder); }

  [[nodiscard]] FileDescriptor connect_to(const std::filesystem::path& there) const {
    FileDescriptor client(socket(AF_UNIX, SOCK_SEQPACKET | SOCK_CLOEXEC, 0));
    const sockaddr_un address = socket_address(there);
    EXPECT_EQ(connect(client.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
    return client;
  }

  std::filesystem::path folder, path;
};

TEST_F(ListeningSocketTest, WakesForAClientForItsDataAndForItsEnd) {
  ListeningSocket server(path, "bus");
  EXPECT_FALSE(server.accept()) << "nobody waits";
  EXPECT_FALSE(readable(server.wake_fd()));
  {
    const FileDescriptor client = connect_to(path);
    EXPECT_TRUE(readable(server.wake_fd()));
    const FileDescriptor connection = server.accept();
    ASSERT_TRUE(connection);
    server.watch(connection);
    EXPECT_FALSE(readable(server.wake_fd()));
    ASSERT_EQ(send(client.get(), "x", 1, 0), 1);
    EXPECT_TRUE(readable(server.wake_fd()));
    char got = 0;
    EXPECT_EQ(recv(connection.get(), &got, 1, 0), 1);
    EXPECT_EQ(recv(connection.get(), &got, 1, 0), -1) << "a connection does not block";
  }
  EXPECT_FALSE(readable(server.wake_fd())) << "both ends are closed, nothing is watched any more";
}

TEST_F(ListeningSocketTest, RefusesASecondServerAndServesAgainAfterTheFirst) {
  {
    ListeningSocket first(path, "bus");
    EXPECT_THAT(refusal([&] { ListeningSocket second(path, "bus"); }),
                AllOf(HasSubstr(path.string()), HasSubstr("another bus serves it")));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  ListeningSocket third(path, "bus");
  EXPECT_TRUE(std::filesystem::exists(path));
}

TEST_F(ListeningSocketTest, ReplacesASocketThatADeadServerLeft) {
  {
    const FileDescriptor dead(socket(AF_UNIX, SOCK_SEQPACKET, 0));
    const sockaddr_un address = socket_address(path);
    ASSERT_EQ(bind(dead.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address), 0);
  }
  ListeningSocket server(path, "bus");
  EXPECT_TRUE(connect_to(path));
}

TEST_F(ListeningSocketTest, LeavesAFileThatIsNoSocketAlone) {
  std::ofstream(path) << "precious";
  EXPECT_THAT(refusal([&] { ListeningSocket server(path, "bus"); }), HasSubstr("cannot bind"));
  EXPECT_EQ(std::filesystem::file_size(path), 8U);
}

TEST_F(ListeningSocketTest, RefusesPathsThatTheSystemCannotTake) {
  EXPECT_THAT(refusal([&] { ListeningSocket server(folder / std::string(120, 'x'), "bus"); }),
              AllOf(HasSubstr("107 characters"), HasSubstr("choose another one")));
  EXPECT_THAT(refusal([] { (void)socket_address(""); }), HasSubstr("this one has 0"));
  EXPECT_THAT(refusal([&] { ListeningSocket server(folder / "missing" / "s", "bus"); }),
              AllOf(HasSubstr("cannot make"), HasSubstr("No such file")));
}

}  // namespace
}  // namespace gaitway::process
