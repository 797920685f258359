// The link over real carriers of this computer: Unix sockets and a pseudo-terminal.
#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <stdlib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <optional>

#include "gaitway/link/serial_carrier.hpp"
#include "gaitway/link/unix_carrier.hpp"
#include "gaitway/process/listening_socket.hpp"
#include "link_pair.hpp"

namespace gaitway::link::test {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

std::int64_t clock_ns() {
  return std::chrono::steady_clock::now().time_since_epoch() / std::chrono::nanoseconds(1);
}

// A folder of this test's own, gone with it.
struct Folder {
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "gaitway_link_XXXXXX").native();
    path = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path); }
  std::filesystem::path path;
};

// Two ends in one thread, each woken by its carrier.
struct Ends {
  ModuleEnd module{module_identity(1), kChannels, {}};
  ControllerEnd controller{controller_identity(2), kChannels, {}};

  template <class Done>
  bool run_until(Carrier& left, int left_fd, Carrier& right, int right_fd, Done done) {
    for (const std::int64_t end_ns = clock_ns() + 5 * facts::kSecond_ns; clock_ns() < end_ns;) {
      pump(module, left, clock_ns());
      pump(controller, right, clock_ns());
      if (done()) return true;
      std::array<pollfd, 2> wakes{{{left_fd, POLLIN, 0}, {right_fd, POLLIN, 0}}};
      poll(wakes.data(), wakes.size(), 1);
    }
    return false;
  }
  [[nodiscard]] bool open() const { return module.session().open() && controller.session().open(); }
};

struct UnixLink : testing::Test {
  Folder folder;
  process::ListeningSocket listener{folder.path / "link", "main_controller"};
  std::optional<UnixCarrier> left{folder.path / "link"};
  UnixCarrier right{listener.accept()};
  Ends ends;
  template <class Done>
  bool run_until(Done done) {
    return ends.run_until(*left, left->wake_fd(), right, right.wake_fd(), done);
  }
};

TEST_F(UnixLink, CarriesOrdersStopsAndState) {
  ASSERT_TRUE(run_until([&] { return ends.open(); }));
  const std::string large(3000, 'l');
  ends.controller.publish(1, bytes_of(large), 5);
  ends.module.stop(StopKind::stop);
  const auto submission = ends.module.submit(
      3, bytes_of("walk"), *ends.module.robot_time_ns(clock_ns()) + facts::kSecond_ns, clock_ns());
  ASSERT_EQ(submission.refusal, Refusal::none);
  std::optional<Outcome> outcome;
  ASSERT_TRUE(run_until([&] {
    if (const auto order = ends.controller.next_order(clock_ns())) ends.controller.answer(order->id, 9, {});
    ends.controller.stops_obeyed(ends.controller.stops_asked());
    if (!outcome) outcome = ends.module.next_outcome(clock_ns());
    return outcome && ends.module.stops().obeyed().stops == 1 && ends.module.state().value(1).updates == 1;
  }));
  EXPECT_EQ(outcome->result, 9);
  EXPECT_EQ(text_of(ends.module.state().value(1).bytes), large);
}

TEST_F(UnixLink, WhenOneEndGoesTheOtherKnowsAtOnce) {
  ASSERT_TRUE(run_until([&] { return ends.open(); }));
  left.reset();
  pump(ends.controller, right, clock_ns());
  EXPECT_FALSE(right.connected());
  EXPECT_EQ(ends.controller.session().why(), SessionEnd::cut);
}

TEST_F(UnixLink, AReaderThatSleepsFillsNoMoreThanAFewFrames) {
  ASSERT_TRUE(run_until([&] { return ends.open(); }));
  const std::uint64_t before = ends.controller.statistics().sent_bytes;
  for (int i = 0; i < 200; ++i) {
    ends.controller.publish(2, bytes_of(std::to_string(i)), i);
    ends.controller.publish(1, bytes_of(std::string(3000, 'x')), i);
    pump(ends.controller, right, clock_ns());
  }
  EXPECT_LT(ends.controller.statistics().sent_bytes - before, 8U * kMostFrameBytes);
}

TEST(UnixCarrierTest, NamesThePathWhereNobodyListens) {
  const Folder folder;
  EXPECT_THAT([&] { UnixCarrier(folder.path / "nobody"); },
              ThrowsMessage<process::SocketError>(HasSubstr("Is main_controller running")));
}

// A pseudo-terminal: what a serial device is to its user.
struct Terminal {
  Terminal() : master(posix_openpt(O_RDWR | O_NOCTTY)) {
    grantpt(master.get());
    unlockpt(master.get());
    path = ptsname(master.get());
  }
  process::FileDescriptor master;
  std::filesystem::path path;
};

// The other end of a pseudo-terminal, which has no device of its own.
class MasterCarrier final : public Carrier {
 public:
  explicit MasterCarrier(int fd) : fd_(fd) { fcntl(fd_, F_SETFL, O_NONBLOCK); }
  std::size_t write(Bytes bytes) noexcept override {
    const ssize_t count = ::write(fd_, bytes.data(), bytes.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  std::size_t read(std::span<std::uint8_t> room) noexcept override {
    const ssize_t count = ::read(fd_, room.data(), room.size());
    return count > 0 ? static_cast<std::size_t>(count) : 0;
  }
  [[nodiscard]] bool connected() const noexcept override { return true; }

 private:
  int fd_;
};

TEST(SerialCarrierTest, CarriesEveryByteValue) {
  Terminal terminal;
  SerialCarrier device(terminal.path, 115200);
  MasterCarrier master(terminal.master.get());
  Ends ends;
  ASSERT_TRUE(
      ends.run_until(device, device.wake_fd(), master, terminal.master.get(), [&] { return ends.open(); }));
  std::string all(200, '\0');
  for (std::size_t i = 0; i < all.size(); ++i)
    all[i] = static_cast<char>(i + 3);  // Ctrl-C, XON, XOFF, CR, LF…
  ends.controller.publish(2, bytes_of(all), 1);
  ASSERT_TRUE(ends.run_until(device, device.wake_fd(), master, terminal.master.get(),
                             [&] { return ends.module.state().value(2).updates == 1; }));
  EXPECT_EQ(text_of(ends.module.state().value(2).bytes), all);
}

TEST(SerialCarrierTest, KnowsWhenTheDeviceIsGone) {
  Terminal terminal;
  SerialCarrier device(terminal.path, 115200);
  terminal.master = process::FileDescriptor();
  ModuleEnd module(module_identity(1), kChannels, {});
  pump(module, device, clock_ns());
  EXPECT_FALSE(device.connected());
}

TEST(SerialCarrierTest, RefusesByNameWhatItCannotOpen) {
  const Terminal terminal;
  EXPECT_THAT([&] { SerialCarrier(terminal.path, 12345); },
              ThrowsMessage<SerialError>(HasSubstr("baud rate 12345 is none of 9600, ")));
  EXPECT_THAT([&] { SerialCarrier("/dev/null", 115200); },
              ThrowsMessage<SerialError>(HasSubstr("no serial device")));
  EXPECT_THAT([&] { SerialCarrier("/nowhere/tty", 115200); },
              ThrowsMessage<SerialError>(HasSubstr("'/nowhere/tty': cannot open it")));
}

}  // namespace
}  // namespace gaitway::link::test
