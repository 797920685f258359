// The main controller's end of the link at a real socket: one module at a time, and news for people.
#include "gaitway/api/link_host.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <initializer_list>
#include <string>
#include <string_view>

#include "gaitway/link/module_end.hpp"
#include "gaitway/link/unix_carrier.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::api {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr std::array kChannels{link::Channel{"state", 64}};

// A module and its way to the socket.
struct Module {
  Module(const std::filesystem::path& path, std::uint64_t boot, std::string_view name,
         std::uint32_t robot_hash = 0)
      : end({.role = link::Role::module,
             .boot = boot,
             .table_hash = 1,
             .name = name,
             .robot_hash = robot_hash},
            kChannels, {}),
        carrier(path) {}
  link::ModuleEnd end;
  link::UnixCarrier carrier;
};

class LinkHostTest : public ::testing::Test {
 protected:
  // Of a clock that the test moves: nothing waits.
  void pass(int milliseconds, std::initializer_list<Module*> modules) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      now_ns += facts::kMillisecond_ns;
      for (Module* module : modules) link::pump(module->end, module->carrier, now_ns);
      host.pump(controller, now_ns);
      if (const std::string report = host.take_report(); !report.empty()) reports += report + "\n";
      for (Module* module : modules) link::pump(module->end, module->carrier, now_ns);
    }
  }
  process::PrivateFolder folder{"gaitway_link_host"};
  std::filesystem::path path = folder.path() / "link.sock";
  LinkHost host{{link::LinkAddress::Kind::unix_socket, path, 0}};
  link::ControllerEnd controller{
      {.role = link::Role::controller, .boot = 1, .table_hash = 1, .name = "controller"}, kChannels, {}};
  std::int64_t now_ns = facts::kSecond_ns;
  std::string reports;
};

TEST_F(LinkHostTest, ASecondModuleIsToldWhoHasTheLinkAndTheFirstGoesOn) {
  Module first(path, 11, "the first one");
  pass(200, {&first});
  ASSERT_TRUE(first.end.session().open());
  EXPECT_THAT(reports, HasSubstr("linked to 'the first one'"));
  Module second(path, 12, "the second one");
  pass(200, {&first, &second});
  EXPECT_TRUE(first.end.session().open());
  EXPECT_EQ(first.end.session().count(), 1U) << "it has noticed nothing";
  EXPECT_FALSE(second.end.session().open());
  EXPECT_EQ(second.end.session().why(), link::SessionEnd::occupied) << "though it was cut off at once";
  EXPECT_THAT(
      second.end.session().description(),
      AllOf(HasSubstr("'the first one'"), HasSubstr("a robot has one"), HasSubstr("'the second one'")));
  EXPECT_FALSE(second.carrier.connected());
  EXPECT_THAT(reports, HasSubstr("another user interface module (process " + std::to_string(getpid()) +
                                 ") wants the link that 'the first one' has"));
}

TEST_F(LinkHostTest, AModuleThatIsTurnedAwayAgainAndAgainIsToldOfOnceAMinute) {
  Module first(path, 11, "the first one");
  pass(200, {&first});
  const auto told = [this] { return std::count(reports.begin(), reports.end(), '\n'); };
  const auto before = told();
  constexpr int kMinute_ms = 60'000, kBetween_ms = 500;
  for (int ms = 0; ms < kMinute_ms; ms += kBetween_ms) {
    Module second(path, 12, "the second one");
    pass(kBetween_ms, {&first, &second});
  }
  EXPECT_EQ(told(), before + 1) << reports;
  Module second(path, 12, "the second one");
  pass(kBetween_ms, {&first, &second});
  EXPECT_EQ(told(), before + 2) << reports;
}

TEST_F(LinkHostTest, AModuleOfAnotherRobotIsToldFirstThatThereIsOneAlready) {
  Module first(path, 11, "the first one");
  pass(200, {&first});
  Module other(path, 12, "of another robot", 2);
  pass(200, {&first, &other});
  EXPECT_EQ(other.end.session().why(), link::SessionEnd::occupied);
  EXPECT_THAT(other.end.session().description(), HasSubstr("linked to another module, 'the first one'"));
}

TEST_F(LinkHostTest, AModuleOfAnotherRobotIsRefusedAndToldOfOnce) {
  Module other(path, 11, "the module", 2);
  pass(2000, {&other});
  EXPECT_THAT(reports,
              AllOf(HasSubstr("no link to the user interface module: refused"),
                    HasSubstr("'the module', has 00000002"), HasSubstr("give both the same robot.urdf")));
  EXPECT_EQ(std::count(reports.begin(), reports.end(), '\n'), 1) << reports;
}

TEST_F(LinkHostTest, AModuleThatWasRefusedAndHasGoneIsSpokenOfNoMore) {
  {
    Module other(path, 11, "the module", 2);
    pass(200, {&other});
  }
  reports.clear();
  pass(61'000, {});
  EXPECT_EQ(reports, "");
}

TEST_F(LinkHostTest, AModuleThatComesAfterAnotherHasGoneIsLinked) {
  {
    Module first(path, 11, "the first one");
    pass(200, {&first});
    ASSERT_TRUE(controller.session().open());
  }
  Module second(path, 12, "the second one");
  pass(200, {&second});
  EXPECT_TRUE(second.end.session().open());
  EXPECT_THAT(reports, AllOf(HasSubstr("is lost"), HasSubstr("linked to 'the second one'")));
}

TEST_F(LinkHostTest, AModuleThatHangsIsReplacedOnceItsSilenceHasEnded) {
  Module first(path, 11, "the first one");
  pass(200, {&first});
  Module second(path, 12, "the second one");
  pass(20, {&second});
  EXPECT_FALSE(second.end.session().open()) << "the first one may yet speak";
  pass(300, {});
  EXPECT_FALSE(controller.session().open());
  Module third(path, 13, "the third one");
  pass(200, {&third});
  EXPECT_TRUE(third.end.session().open());
}

TEST_F(LinkHostTest, WhoFloodsTheLinkDoesNotKeepItsProcessBusy) {
  Module first(path, 11, "the first one");
  pass(200, {&first});
  const std::array<std::uint8_t, 200> garbage{};
  while (first.carrier.write(garbage) > 0) {  // nobody reads it: whoever waits is woken at once
  }
  constexpr int kWaits = 100, kOfAMillisecond = 5;
  const std::int64_t begin_ns = process::monotonic_ns();
  for (int i = 0; i < kWaits; ++i) host.wait(1000);
  EXPECT_GE(process::monotonic_ns() - begin_ns, (kWaits / kOfAMillisecond - 1) * facts::kMillisecond_ns);
}

TEST_F(LinkHostTest, ConnectionsWithoutAWordKeepNobodyOut) {
  const link::UnixCarrier silent(path), another(path);
  Module first(path, 11, "the first one");
  pass(200, {&first});
  EXPECT_TRUE(first.end.session().open());
}

// An adapter that is pulled out and plugged in again: a pseudo-terminal after another one.
TEST(LinkHostOnASerialLine, IsBackWhenItsDeviceIs) {
  const process::PrivateFolder folder("gaitway_link_host");
  const std::filesystem::path device = folder.path() / "ttyUSB0";
  const auto plug_in = [&device] {
    process::FileDescriptor other(posix_openpt(O_RDWR | O_NOCTTY | O_NONBLOCK));
    grantpt(other.get());
    unlockpt(other.get());
    std::filesystem::create_symlink(ptsname(other.get()), device);
    return other;
  };
  process::FileDescriptor line = plug_in();
  LinkHost host({link::LinkAddress::Kind::serial, device, 1'000'000});
  link::ControllerEnd controller(
      {.role = link::Role::controller, .boot = 1, .table_hash = 1, .name = "controller"}, kChannels, {});
  link::ModuleEnd module({.role = link::Role::module, .boot = 11, .table_hash = 1, .name = "the module"},
                         kChannels, {});
  std::string reports;
  std::int64_t now_ns = facts::kSecond_ns;
  const auto pass = [&](int milliseconds) {
    for (int ms = 0; ms < milliseconds; ++ms) {
      now_ns += facts::kMillisecond_ns;
      std::array<std::uint8_t, link::kReadBytes> bytes{};
      const ssize_t came = line ? read(line.get(), bytes.data(), bytes.size()) : 0;
      if (came > 0) module.on_bytes(link::Bytes(bytes).first(static_cast<std::size_t>(came)), now_ns);
      const link::Bytes says = module.pending(now_ns);
      const ssize_t left = line && !says.empty() ? write(line.get(), says.data(), says.size()) : 0;
      if (left > 0) module.taken(static_cast<std::size_t>(left));
      host.pump(controller, now_ns);
      if (const std::string report = host.take_report(); !report.empty()) reports += report + "\n";
    }
  };
  pass(500);
  ASSERT_TRUE(controller.session().open());
  line = {};
  std::filesystem::remove(device);
  pass(1000);
  EXPECT_FALSE(controller.session().open());
  EXPECT_THAT(reports, AllOf(HasSubstr("is lost"), HasSubstr("ttyUSB0': cannot open it: No such file")));
  line = plug_in();
  pass(1000);
  EXPECT_TRUE(controller.session().open()) << reports;
  EXPECT_EQ(std::count(reports.begin(), reports.end(), '\n'), 4) << reports;
}

}  // namespace
}  // namespace gaitway::api
