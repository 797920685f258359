// The process in real time: hands over, ends as told or when the message controller goes, and is started
// again after what killed it.
#include <gmock/gmock.h>

#include "main_controller_process_fixture.hpp"

namespace gaitway::core {
namespace {

TEST_F(MainControllerProcess, HandsOverInRealTimeAndStopsWhenTold) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 5; }), -1) << output();
  ASSERT_GE(batches, 5) << output();
  EXPECT_LE(lead_ns, 16'000'000);
  kill(process, SIGTERM);
  EXPECT_EQ(serve(5.0), 0) << output();
  EXPECT_THAT(output(), testing::HasSubstr("batches"));
  EXPECT_THAT(output(), testing::HasSubstr("planner"));
}

TEST_F(MainControllerProcess, EndsWhenTheMessageControllerFallsSilent) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  beating = false;
  EXPECT_EQ(serve(5.0), 3) << output();
  EXPECT_THAT(output(), testing::HasSubstr("no sign of life of the message controller"));
}

TEST_F(MainControllerProcess, ItsEventsSurviveItAndGoOn) {
  const std::string events = (folder / "events.jsonl").string();
  const auto lines_with = [&events](const std::string& text) {
    std::ifstream in(events);
    int lines = 0;
    for (std::string line; std::getline(in, line);) lines += line.find(text) != std::string::npos ? 1 : 0;
    return lines;
  };
  configure(
      "  - {name: planner, library: joint_planner.so}\n"
      "  - {name: teller, library: counter.so, parameters: {reports: true}}\n");
  std::vector<std::string> arguments = normal_arguments();
  arguments.insert(arguments.end(), {"--quiet", "--events", events});
  for (int life = 1; life <= 2; ++life) {
    launch(arguments);
    ASSERT_EQ(
        serve(20.0, [&] { return lines_with("begins as process") == life && lines_with("teller") >= life; }),
        -1)
        << output();
    kill(process, SIGKILL);
    EXPECT_EQ(serve(5.0), 1000 + SIGKILL);
    renew_block();
  }
  EXPECT_EQ(lines_with("begins as process"), 2);
}

// A terminal that was halted, or whose reader hangs, is no reason to lose a batch.
TEST_F(MainControllerProcess, ATerminalThatTakesNothingHoldsNoTick) {
  int ends[2];
  ASSERT_EQ(pipe2(ends, O_CLOEXEC), 0);
  const std::string of_the_pipe = "/proc/self/fd/" + std::to_string(ends[1]);
  const int filler = open(of_the_pipe.c_str(), O_WRONLY | O_NONBLOCK | O_CLOEXEC);
  ASSERT_GE(filler, 0);
  configure(
      "  - {name: planner, library: joint_planner.so}\n"
      "  - {name: teller, library: counter.so, parameters: {reports: true}}\n");
  terminal = ends[1];
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const std::string line(64, 'x');
  while (write(filler, line.data(), line.size()) > 0) {
  }
  EXPECT_EQ(serve(20.0, [this] { return batches >= 21; }), -1);
  EXPECT_GE(batches, 21) << "1.6 s and 160 events later";
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0);
  for (const int end : {ends[0], ends[1], filler}) close(end);
}

// Whoever sends SIGKILL does so at any instant: that a plug-in is being stepped then is no fault of its, and
// no reason to give up. A second apart, so that it does not take the computer.
TEST_F(MainControllerProcess, KilledFromOutsideItIsStartedAgainWithEveryPluginHoweverOften) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 9}}\n");
  launch_supervised();
  const std::int64_t begin_ns = monotonic_ns();
  ASSERT_EQ(serve(60.0, [this] { return times_told("started again\n") >= 5; }), -1) << output();
  EXPECT_GE(monotonic_ns() - begin_ns, 4'000'000'000);
  EXPECT_THAT(output(), testing::HasSubstr("from outside, the process was ended by signal 9"));
  EXPECT_THAT(output(), testing::Not(testing::HasSubstr("without 'stepped'")));
  kill(process, SIGTERM);
  EXPECT_NE(serve(10.0), -1) << output();
}

// As by a person with a debugger: the robot is on its safe tail and needs another one, and no plug-in did it.
TEST_F(MainControllerProcess, StoppedFromOutsideItIsReplacedWithEveryPlugin) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 19}}\n");
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return times_told("started again\n") >= 1; }), -1) << output();
  EXPECT_THAT(output(),
              testing::HasSubstr("from outside, the process was stopped for 1000 ms and was ended"));
  EXPECT_THAT(output(), testing::Not(testing::HasSubstr("without 'stepped'")));
  kill(process, SIGTERM);
  EXPECT_NE(serve(10.0), -1) << output();
}

// However often it goes: that is nobody's fault in here.
TEST_F(MainControllerProcess, AMessageControllerThatComesBackFindsAnotherMainController) {
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const int scheduling = scheduling_of_worker();
  for (int time = 1; time <= 5; ++time) {
    served.reset();  // every connection is hung up, as when the process has been killed
    ASSERT_EQ(serve(5.0, [&] { return times_told("waiting for the message controller") == time; }), -1)
        << output();
    EXPECT_EQ(times_told("the message controller on " + socket.string() + " has ended"), time) << output();
    renew_block();
    const std::int64_t back_ns = monotonic_ns();
    ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
    EXPECT_LT(monotonic_ns() - back_ns, 800'000'000);
    EXPECT_EQ(scheduling_of_worker(), scheduling) << "what is allowed once is allowed again";
  }
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

TEST_F(MainControllerProcess, AMessageControllerThatEndsIsMissedAtOnce) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  served.reset();
  const std::int64_t gone_ns = monotonic_ns();
  EXPECT_EQ(serve(5.0), 3) << output();
  EXPECT_LT(monotonic_ns() - gone_ns, 800'000'000) << "not by its silence";
  EXPECT_THAT(output(), testing::HasSubstr("has ended"));
}

// By SIGABRT: a sanitizer would make an exit of its own of a SIGSEGV.
TEST_F(MainControllerProcess, AfterACrashItIsStartedAgainWithoutThePluginThatWasBeingStepped) {
  configure("  - {name: stepped, library: crashes.so, parameters: {after_ticks: 20, signal: 6}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(20.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'stepped', the process was ended by signal 6"));
  EXPECT_THAT(output(), testing::HasSubstr("started again, without 'stepped'"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

// A plug-in that is being changed beside the ticks may take the process down, too: whoever is being stepped
// at that moment has no part in it.
TEST_F(MainControllerProcess, AfterACrashInAChangeItIsStartedAgainWithEveryPlugin) {
  const std::string meeting = "library: crashes_when_it_leaves.so, parameters: {meeting: " + folder.string();
  configure("  - {name: stepped, " + meeting + "}}\n  - {name: leaver, " + meeting + ", leaves: true}}\n");
  launch_supervised();
  msgclient::Client other = served->block.local_client("ctl");
  msgclient::Reader<PluginStatistics> statistics = other.read<PluginStatistics>("plugin_statistics");
  PluginStatistics seen{};
  ASSERT_EQ(serve(20.0, [&] { return statistics.read(seen) && seen.steps[1] > 0; }), -1) << output();
  PluginRequest unload{};
  unload.number = 1;
  unload.verb = 2;
  std::strcpy(reinterpret_cast<char*>(unload.plugin), "leaver");
  ASSERT_TRUE(other.write_queue<PluginRequest>("plugin_request").push(unload, 0));
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(20.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("while plug-in 'leaver' was changed, the process was ended by "
                                           "signal 6"));
  EXPECT_THAT(output(), testing::HasSubstr("started again\n"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

// Before the first tick, too, a plug-in that takes the process down is stopped at the next start.
TEST_F(MainControllerProcess, AfterACrashInActivateItIsStartedAgainWithoutThatPlugin) {
  configure("  - {name: active, library: crashes.so, parameters: {in_activate: true, signal: 6}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(60.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'active', the process was ended by signal 6"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

TEST_F(MainControllerProcess, AfterAHangInActivateItIsStartedAgainWithoutThatPlugin) {
  configure("  - {name: active, library: crashes.so, parameters: {in_activate: true, hangs: true}}\n");
  launch_supervised();
  const auto is_back = [this] { return output().find("back after") != std::string::npos; };
  ASSERT_EQ(serve(60.0, is_back), -1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("in plug-in 'active', the process made no tick for 5000 ms"));
  EXPECT_THAT(output(), testing::HasSubstr("started again, without 'active'"));
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << output();
}

}  // namespace
}  // namespace gaitway::core
