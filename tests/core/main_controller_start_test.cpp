// The process at its start: what it waits for, and what it refuses.
#include <gmock/gmock.h>

#include "main_controller_process_fixture.hpp"

namespace gaitway::core {
namespace {

TEST_F(MainControllerProcess, SupervisedItWaitsForAMessageControllerThatIsNotThereYet) {
  served.reset();
  launch_supervised();
  ASSERT_EQ(serve(20.0, [this] { return times_told("waiting for the message controller") == 1; }), -1)
      << output();
  serve(0.3);
  EXPECT_EQ(times_told("cannot connect to"), 1) << "said once " << output();
  renew_block();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  served.reset();
  ASSERT_EQ(serve(5.0, [this] { return times_told("waiting for the message") == 2; }), -1);
  kill(process, SIGTERM);
  EXPECT_EQ(serve(10.0), 0) << "also while it waits " << output();
}

TEST_F(MainControllerProcess, ASecondOneIsRefusedByName) {
  launch_normally();
  ASSERT_EQ(serve(20.0, [this] { return batches >= 1; }), -1) << output();
  const pid_t first = std::exchange(process, 0);
  launch_supervised();
  EXPECT_EQ(serve(20.0), 1) << output();
  EXPECT_THAT(output(), testing::HasSubstr("another main controller"));
  process = first;
}

TEST_F(MainControllerProcess, BadConfigurationIsNamedAndNothingMoves) {
  configure("  - {name: planner, library: nowhere.so}\n");
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("test.yaml:2): no library 'nowhere.so'"));
  EXPECT_EQ(batches, 0);
}

// A message controller that has hardware on its bus, or does not say, has a robot of metal.
TEST_F(MainControllerProcess, APluginInPythonIsForSimulatedRobotsAlone) {
  configure("  - {name: sway, library: ./nowhere.py}\n");
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("test.yaml:2: plug-in 'sway' is written in Python (./nowhere.py), "
                                           "which is for simulated robots alone"));
  {
    const msgclient::TopicGrant mark = msgclient::mark_simulated(served->client);
    launch_normally();
    EXPECT_EQ(serve(20.0), 1);
    EXPECT_THAT(output(), testing::Not(testing::HasSubstr("for simulated robots alone")));
    EXPECT_THAT(output(), testing::HasSubstr("plug-in 'sway'"));  // where it runs at all, its file is missing
  }
  launch_normally();
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("for simulated robots alone"));
  EXPECT_EQ(batches, 0);
}

TEST_F(MainControllerProcess, MissingSocketIsNamed) {
  launch({"--socket", "/nowhere/s.sock", "--robot", GAITWAY_TEST_ROBOT, "--config",
          (folder / "test.yaml").string()});
  EXPECT_EQ(serve(20.0), 1);
  EXPECT_THAT(output(), testing::HasSubstr("cannot connect to '/nowhere/s.sock'"));
}

TEST_F(MainControllerProcess, HelpShowsExamples) {
  launch({"--help"});
  EXPECT_EQ(serve(20.0), 0);
  EXPECT_THAT(output(), testing::HasSubstr("Examples:"));
}

}  // namespace
}  // namespace gaitway::core
