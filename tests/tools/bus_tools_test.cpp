// `gaitway bus monitor`, `replay` and `measure` as a user meets them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/profile.hpp"
#include "gaitway/can/simulated/bus_server.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

class BusTools : public ::testing::Test {
 protected:
  BusTools()
      : folder_(std::filesystem::temp_directory_path() / ("gaitway_bus_tools_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~BusTools() override { std::filesystem::remove_all(folder_); }

  // Returns the exit code; what was printed is in said_ and complaint_.
  int gaitway(const std::string& arguments) {
    const std::string line = std::string(GAITWAY_COMMAND) + " " + arguments + " >'" +
                             (folder_ / "said").string() + "' 2>'" + (folder_ / "complaint").string() + "'";
    const int status = std::system(line.c_str());
    said_ = text("said");
    complaint_ = text("complaint");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string text(const std::string& name) const {
    std::ifstream in(folder_ / name);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  [[nodiscard]] std::string file(const std::string& name) const {
    return "'" + (folder_ / name).string() + "'";
  }

  // A fresh run; its log is run/bus.log.
  void record(const std::string& arguments) {
    ASSERT_EQ(gaitway("run --quiet --no-pictures --out " + file("run") + " " + arguments), 0) << complaint_;
  }
  // Writes run/bus.log anew, with what `change` makes of it, as altered.log.
  template <class Change>
  void alter(Change change) {
    std::vector<can::LoggedFrame> log = can::read_candump_log(folder_ / "run" / "bus.log");
    change(log);
    can::CandumpWriter writer(folder_ / "altered.log");
    for (const can::LoggedFrame& logged : log) {
      writer.write(logged.time_ns, logged.frame);
    }
    writer.close();
  }
  static std::size_t find(const std::vector<can::LoggedFrame>& log, std::uint32_t id, std::int64_t from_ns) {
    for (std::size_t i = 0; i < log.size(); ++i) {
      if (log[i].frame.id == id && log[i].time_ns >= from_ns) {
        return i;
      }
    }
    ADD_FAILURE() << "no frame of identifier " << id << " in the log";
    return 0;
  }

  std::filesystem::path folder_;
  std::string said_, complaint_;
};

using facts::kSecond_ns;

TEST_F(BusTools, AReplayOfAFreshRunIsEqualToTheBit) {
  record("--seconds 3 --seed 7");  // later the other body falls, since its own feedback is not heard
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log") + " --seed 7 --out " + file("joints.csv")), 0)
      << said_;
  EXPECT_THAT(said_, HasSubstr("\nequal\n"));
  const std::string csv = text("joints.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 1 + 299)
      << "the last slot is not over with the last frame";
  EXPECT_THAT(csv, HasSubstr("left_knee_reference_count,left_knee_reference_rad,left_knee_position_rad"));
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log") + " --seed 8"), 3)
      << "another body answers otherwise";
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log") + " --seed 8 --references"), 0)
      << "but it plays the same batches\n"
      << said_;
}

TEST_F(BusTools, AReplayInThePapersProfileIsEqualToTheBit) {
  record("--seconds 3 --profile paper --walk 0.1");
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log") + " --profile paper"), 0) << said_;
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log")), 1);
  EXPECT_THAT(complaint_, HasSubstr("no messages of the profile 'full'"));
  EXPECT_THAT(complaint_, HasSubstr("--profile"));
}

TEST_F(BusTools, WhatTheScenarioDoesBesidesTheBusIsReplayed) {
  std::ofstream(folder_ / "push.yaml")
      << "seconds: 3\nevents:\n  - {at_s: 1.5, push: {body: trunk, direction: "
         "[1, 0, 0], impulse_Ns: 0.8, duration_s: 0.1}}\n"
         "  - {at_s: 2.0, fault: {kind: joint_restarts, joint: left_elbow, "
         "duration_s: 0.05}}\n";
  record("--scenario " + file("push.yaml"));
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log")), 3);
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log") + " --scenario " + file("push.yaml")), 0) << said_;
}

TEST_F(BusTools, ACorruptedBusReplaysToTheBit) {
  std::ofstream(folder_ / "corrupted.yaml")
      << "seconds: 3\nevents:\n  - {at_s: 0.5, walk: [0.1, 0, 0]}\n"
         "  - {at_s: 1.0, fault: {kind: disturb_bus, corruption: 0.02, duration_s: 2}}\n";
  record("--scenario " + file("corrupted.yaml"));
  EXPECT_EQ(gaitway("bus replay " + file("run/bus.log")), 0) << said_;
}

// Some joints have a repeated SYNC from its first frame, some from its second; no log tells which.
TEST_F(BusTools, FramesThatTheBusDeliveredTwiceLeaveTheReferencesEqual) {
  std::ofstream(folder_ / "doubled.yaml")
      << "seconds: 3\nevents:\n  - {at_s: 0.5, walk: [0.1, 0, 0]}\n"
         "  - {at_s: 1.0, fault: {kind: disturb_bus, duplicate: 0.01, duration_s: 2}}\n";
  record("--scenario " + file("doubled.yaml"));
  EXPECT_EQ(gaitway("bus replay --references " + file("run/bus.log")), 0) << said_;
  EXPECT_THAT(said_, HasSubstr("delivered twice"));
}

TEST_F(BusTools, AnAlteredByteIsNamedWithNodeFieldAndValues) {
  record("--seconds 2");
  std::int64_t altered_ns = 0;
  alter([&](std::vector<can::LoggedFrame>& log) {
    const std::uint32_t id = can::kFullProfile.id_of(can::MessageKind::feedback, 3);
    can::LoggedFrame& logged = log[find(log, id, kSecond_ns)];
    logged.frame.data[2] = static_cast<std::uint8_t>(logged.frame.data[2] ^ 1U);
    altered_ns = logged.time_ns;
  });
  EXPECT_EQ(gaitway("bus replay " + file("altered.log")), 3);
  char time[32];
  std::snprintf(time, sizeof time, "%.6f s", static_cast<double>(altered_ns) * 1e-9);
  EXPECT_THAT(said_, HasSubstr(std::string("differs first at ") + time +
                               ", node 3 (left_hip_pitch), feedback current"));
  EXPECT_EQ(gaitway("bus replay " + file("altered.log") + " --references"), 0)
      << "torque is the body's affair";
}

TEST_F(BusTools, AnAlteredPointShowsInTheJointsReference) {
  record("--seconds 2");
  alter([](std::vector<can::LoggedFrame>& log) {
    const auto trajectory = can::kFullProfile.id_of(can::MessageKind::trajectory, 4, false);
    can::LoggedFrame& logged = log[find(log, trajectory, kSecond_ns)];
    logged.frame.data[0] = static_cast<std::uint8_t>(logged.frame.data[0] + 1);
  });
  EXPECT_EQ(gaitway("bus replay " + file("altered.log") + " --references"), 3);
  EXPECT_THAT(said_, HasSubstr("node 4 (left_knee), feedback reference_low: recorded"));
}

TEST_F(BusTools, AnAnswerThatIsNotInTheLogIsNamedUnlessLossesAreAllowed) {
  record("--seconds 2");
  alter([](std::vector<can::LoggedFrame>& log) {
    const std::uint32_t id = can::kFullProfile.id_of(can::MessageKind::feedback, 5);
    log.erase(log.begin() + static_cast<std::ptrdiff_t>(find(log, id, kSecond_ns)));
  });
  EXPECT_EQ(gaitway("bus replay " + file("altered.log")), 3);
  EXPECT_THAT(said_, HasSubstr("node 5"));
  EXPECT_THAT(said_, HasSubstr("recorded not in the log, replayed sent"));
  EXPECT_EQ(gaitway("bus replay " + file("altered.log") + " --losses"), 0) << said_;
}

TEST_F(BusTools, TheMonitorReadsALog) {
  record("--seconds 3");
  alter([](std::vector<can::LoggedFrame>& log) {  // without the storm of reports that every joint has started
    std::erase_if(log, [](const can::LoggedFrame& logged) { return logged.time_ns < kSecond_ns; });
  });
  EXPECT_EQ(gaitway("bus monitor --log " + file("altered.log")), 0) << said_;
  EXPECT_THAT(said_, HasSubstr("22 of 22 answer"));
  EXPECT_THAT(said_, HasSubstr("unknown   0 frames"));
  EXPECT_THAT(said_, HasSubstr("SYNC's end"));
  EXPECT_EQ(said_.find('\x1b'), std::string::npos);
  EXPECT_EQ(said_.find("0x041 "), std::string::npos);
  EXPECT_EQ(gaitway("bus monitor --all --log " + file("altered.log")), 0);
  EXPECT_THAT(said_, HasSubstr("0x041 "));
}

TEST_F(BusTools, TheMonitorTellsOfALateAnswer) {
  record("--seconds 2");
  alter([](std::vector<can::LoggedFrame>& log) {
    const std::uint32_t id = can::kFullProfile.id_of(can::MessageKind::feedback, 1);
    const std::size_t late = find(log, id, kSecond_ns);
    log[late].time_ns += 6'000'000;
    std::erase_if(log, [](const can::LoggedFrame& logged) { return logged.time_ns < kSecond_ns; });
  });
  EXPECT_EQ(gaitway("bus monitor --log " + file("altered.log")), 3) << said_;
  EXPECT_THAT(said_, HasSubstr("BEYOND ITS BOUND"));
}

// Sends a SYNC each slot on a bus that clients can join, paced by the clock.
void serve(can::BusServer& server, int slots, std::int64_t first_edge_ns) {
  const int station = server.bus().attach();
  for (int slot = 0; slot < slots; ++slot) {
    const std::int64_t edge_ns = first_edge_ns + slot * facts::kSlot_ns;
    process::wait_until(edge_ns, {});
    server.step();
    server.bus().transmit(
        station, can::encode(can::kFullProfile, can::Sync{.slot = static_cast<std::uint8_t>(slot % 8)}),
        edge_ns);
    while (server.advance(edge_ns + 1'000'000)) {
    }
    server.flush();
  }
}

TEST_F(BusTools, TheMonitorListensUntilTheBusEnds) {
  const std::filesystem::path socket = folder_ / "bus.sock";
  const std::int64_t start_ns = process::monotonic_ns() / facts::kSlot_ns * facts::kSlot_ns;
  auto server = std::make_unique<can::BusServer>(socket, start_ns);
  int exit_code = -1;
  std::thread monitor([&] { exit_code = gaitway("bus monitor --bus '" + socket.string() + "'"); });
  while (server->client_count() == 0) {
    pollfd wake{server->wake_fd(), POLLIN, 0};
    poll(&wake, 1, -1);
    server->step();
  }
  constexpr int kSlots = 130;  // more than one block
  serve(*server, kSlots, process::monotonic_ns() / facts::kSlot_ns * facts::kSlot_ns);
  server.reset();
  monitor.join();
  EXPECT_EQ(exit_code, 0) << said_ << complaint_;
  EXPECT_THAT(said_, HasSubstr(std::to_string(kSlots) + " frames in all"));
  EXPECT_THAT(said_, HasSubstr("0 of 22 answer; silent: 1 2 3"));
  EXPECT_THAT(said_, HasSubstr("this station is error-active"));
  EXPECT_GE(std::count(said_.begin(), said_.end(), '%'), 4) << "a block a second";
  EXPECT_EQ(said_.find('\x1b'), std::string::npos) << "no terminal, no escape codes";
}

TEST_F(BusTools, BadInputIsRefusedByName) {
  const auto refused = [&](const std::string& arguments, const std::string& part) {
    EXPECT_EQ(gaitway("bus " + arguments), 1) << arguments << "\n" << said_;
    EXPECT_THAT(complaint_, HasSubstr(part));
  };
  refused("replay /nowhere/bus.log", "/nowhere/bus.log: cannot be read");
  std::ofstream(folder_ / "broken.log") << "(0.000100) can0 008#000000\n(0.0002) can0 041#00\n";
  refused("replay " + file("broken.log"), "broken.log:2: the time must have six digits");
  refused("monitor --log " + file("broken.log"), "broken.log:2: the time must have six digits");
  std::ofstream(folder_ / "empty.log") << "";
  refused("replay " + file("empty.log"), "no frame in it");
  std::ofstream(folder_ / "disordered.log") << "(0.000200) can0 008#000000\n(0.000100) can0 008#000000\n";
  refused("replay " + file("disordered.log"), "frame 2 at 0.000100 s comes before");
  refused("replay " + file("empty.log") + " --profile pepper", "there is no profile 'pepper'");
  refused("monitor", "--");
  refused("monitor --bus /nowhere/bus.sock", "/nowhere/bus.sock");
  refused("monitor --can no_such_if", "no_such_if");
  refused("measure --seconds 2", "--seconds 2: must be at least 4");
  refused("measure --walk 1,2,3,4", "--walk");
}

}  // namespace
}  // namespace gaitway::tools
