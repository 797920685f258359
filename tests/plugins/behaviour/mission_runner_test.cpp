// A mission from its start to its end over topics that tests write: what people ask meanwhile, who takes the
// command, what a successor goes on from.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include <algorithm>
#include <condition_variable>
#include <fstream>
#include <mutex>

#include "gaitway/behaviour_leaves/mission_runner.hpp"
#include "scripted_robot.hpp"

namespace gaitway::behaviour_leaves {
namespace {

using behaviour::Call;
using behaviour::Outcome;
using ::testing::Contains;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
namespace states = behaviour_state::state;
namespace verbs = behaviour_request::verb;

std::string mission_file(const std::string& name, std::string_view nodes) {
  const auto* const test = testing::UnitTest::GetInstance()->current_test_info();
  const std::string file = testing::TempDir() + test->test_suite_name() + test->name() + name + ".xml";
  std::ofstream(file) << file_of(nodes);
  return file;
}

// What the leaves below and their test share.
struct Gate {
  std::mutex mutex;
  std::condition_variable changed;
  bool is_open = false, is_waited_at = false, has_tree_gone = false, had_tree_gone = false;

  void open() {
    const std::scoped_lock lock(mutex);
    is_open = true;
    changed.notify_all();
  }
  void wait_for_visitor() {
    std::unique_lock lock(mutex);
    changed.wait(lock, [&] { return is_waited_at; });
  }
};

class Lingers final : public behaviour::Action {
 public:
  explicit Lingers(const bool& may_end) : may_end_(may_end) {}
  Outcome on_start(Call&) noexcept override { return Outcome::running; }
  Outcome on_running(Call&) noexcept override { return Outcome::running; }
  Halt on_halt(Call&) noexcept override { return Halt::ending; }
  Halt on_halting(Call&) noexcept override { return may_end_ ? Halt::ended : Halt::ending; }

 private:
  const bool& may_end_;
};

class TellsItsEnd final : public behaviour::Condition {
 public:
  explicit TellsItsEnd(Gate& gate) : gate_(gate) {}
  ~TellsItsEnd() override {
    const std::scoped_lock lock(gate_.mutex);
    gate_.has_tree_gone = true;
    gate_.changed.notify_all();
  }
  bool holds(Call&) noexcept override { return true; }

 private:
  Gate& gate_;
};

class RunnerRun : public ScriptedRobot, public MissionRunner::Listener {
 public:
  explicit RunnerRun(MissionDesk::Where where = MissionDesk::Where::in_step) {
    registry.add_action({.id = "Lingers"}, [this] { return std::make_unique<Lingers>(may_end); });
    registry.add_condition({.id = "TellsItsEnd"}, [this] { return std::make_unique<TellsItsEnd>(gate); });
    // Whoever makes it waits at the gate.
    registry.add_condition({.id = "Gated"}, [this] {
      std::unique_lock lock(gate.mutex);
      gate.is_waited_at = true;
      gate.changed.notify_all();
      gate.changed.wait(lock, [this] { return gate.is_open; });
      return std::make_unique<TellsItsEnd>(gate);
    });
    runner.emplace(registry, *robot, where, *this);
  }

  void on_line(bool, const char* text) noexcept override { lines.emplace_back(text); }

  void step() {
    now_ns += facts::kCycle_ns;
    look();
    runner->ask(request, now_ns);
    static_cast<void>(runner->step(true, enabled));
    runner->tell(state);
  }
  void step_for(double seconds) {
    for (double s = 0.0; s < seconds; s += 0.08) step();
  }
  void ask(std::uint32_t verb, std::string_view mission = {}) {
    request = {};
    request.stamp_ns = now_ns;
    request.number = ++number_;
    request.verb = verb;
    std::ranges::copy(mission, request.mission);
  }
  [[nodiscard]] std::string said() const { return reinterpret_cast<const char*>(state.text); }

  Gate gate;
  bool may_end = false, enabled = true;
  std::vector<std::string> lines;
  BehaviourRequest request{};
  BehaviourState state{};
  std::optional<MissionRunner> runner;

 private:
  std::uint32_t number_ = 0;
};

TEST(MissionRunner, IsDestroyedAfterWhatReadsItsTree) {
  RunnerRun run(MissionDesk::Where::beside);
  run.runner->load(mission_file("", "<Sequence><TellsItsEnd/><Lingers/></Sequence>"));
  run.step();
  static_cast<void>(mission_file("", "<Sequence><TellsItsEnd/><Watches/><Lingers/></Sequence>"));
  bool tree_went_first = false;
  run.registry.add_condition({.id = "Watches"}, [&] {
    std::unique_lock lock(run.gate.mutex);
    run.gate.is_waited_at = true;
    run.gate.changed.notify_all();
    // Nothing happens in the good case: then this is how long it is given.
    tree_went_first = run.gate.changed.wait_for(lock, std::chrono::milliseconds(300),
                                                [&] { return run.gate.has_tree_gone; });
    return std::make_unique<TellsItsEnd>(run.gate);
  });
  run.ask(verbs::change);
  run.step();
  run.gate.wait_for_visitor();
  run.runner.reset();
  EXPECT_FALSE(tree_went_first);
}

TEST(MissionRunner, APipeIsRefusedAndNotWaitedFor) {
  RunnerRun run;
  const std::string pipe = testing::TempDir() + "mission_pipe.xml";
  ::unlink(pipe.c_str());
  ASSERT_EQ(::mkfifo(pipe.c_str(), 0600), 0);
  run.ask(verbs::start, pipe);
  run.step();
  EXPECT_EQ(run.state.refused, 1U);
  EXPECT_THAT(run.said(), HasSubstr("no regular file"));
}

TEST(MissionRunner, AnEndIsHeardWhileAMissionIsRead) {
  RunnerRun run(MissionDesk::Where::beside);
  run.may_end = true;
  run.runner->load(mission_file("first", "<Lingers/>"));
  run.step();
  run.ask(verbs::start, mission_file("second", "<Sequence><Gated/><Lingers/></Sequence>"));
  run.step();
  run.gate.wait_for_visitor();
  run.ask(verbs::end);
  run.step_for(0.3);
  EXPECT_EQ(run.state.answered, run.request.number);
  EXPECT_EQ(run.state.state, states::none);
  run.gate.open();
  // The desk is free again when it answers the next request.
  run.ask(verbs::start, "no such mission");
  while (run.state.answered != run.request.number) run.step();
  EXPECT_EQ(run.state.refused, 1U);
  EXPECT_EQ(run.state.state, states::none) << "what was being read does not begin";
}

TEST(MissionRunner, WhatBeginsAnewRemembersNothing) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Sequence><RunOnce><Say text="first of all"/></RunOnce>
                                       <Walk forward="0.1 m/s"/></Sequence>)"));
  run.step_for(1.0);
  run.command.commander = command_state::commander::person;
  run.step_for(7.0);
  EXPECT_EQ(run.state.state, states::waits);
  run.lines.clear();
  run.command.commander = command_state::commander::nobody;
  run.step();
  run.step();
  EXPECT_THAT(run.lines, Contains("first of all"));
}

TEST(MissionRunner, ACommandThatWasTakenAndLetGoBetweenTwoLooksCounts) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Walk forward="0.1 m/s"/>)"));
  run.command.commander = command_state::commander::behaviour;
  run.command.changes = 1;
  run.step_for(1.0);
  run.command.commander = command_state::commander::nobody;
  run.command.reason = command_state::reason::person_lets_go;
  run.command.changes = 4;
  run.lines.clear();
  run.step();
  EXPECT_FALSE(run.robot->orders.walking()) << "it was ended by the person";
  run.step_for(1.0);
  EXPECT_THAT(run.lines, Contains(HasSubstr("begins anew")));
  EXPECT_TRUE(run.robot->orders.walking());
}

TEST(MissionRunner, SoDoesOneAfterWhichAnOrderCameLate) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Walk forward="0.1 m/s"/>)"));
  run.command.commander = command_state::commander::behaviour;
  run.command.reason = command_state::reason::behaviour_orders;
  run.command.changes = 1;
  run.step_for(1.0);
  run.command.changes = 4;  // to the person, to nobody, back by an order of before
  run.lines.clear();
  run.step();
  run.step_for(1.0);
  EXPECT_THAT(run.lines, Contains(HasSubstr("begins anew")));
}

TEST(MissionRunner, DisabledAndEnabledBeforeItsEndItBeginsAnew) {
  RunnerRun run;
  run.runner->load(mission_file("", "<Lingers/>"));
  run.step();
  run.enabled = false;
  run.step();
  EXPECT_EQ(run.state.state, states::halts);
  run.enabled = true;
  run.step();
  EXPECT_EQ(run.state.state, states::halts);
  run.may_end = true;
  run.step_for(0.2);
  EXPECT_EQ(run.state.state, states::runs);
}

TEST(MissionRunner, WhatAPersonHasEndedDoesNotBeginByBeingEnabled) {
  RunnerRun run;
  run.runner->load(mission_file("", "<Lingers/>"));
  run.step();
  run.ask(verbs::end);
  run.step();
  run.enabled = false;
  run.step();
  run.enabled = true;
  run.step();
  run.may_end = true;
  run.step_for(0.2);
  EXPECT_EQ(run.state.state, states::none);
}

// A process that is started anew finds the last request still there.
TEST(MissionRunner, AnOldRequestIsNotObeyedByAFreshOne) {
  RunnerRun run;
  run.ask(verbs::start, mission_file("", "<Lingers/>"));
  run.now_ns += 2'000'000'000;
  run.step();
  EXPECT_EQ(run.state.state, states::none);
  EXPECT_EQ(run.state.answered, run.request.number);
  EXPECT_EQ(run.state.refused, 1U) << "who still waits for it is told";
  EXPECT_THAT(run.lines, testing::IsEmpty()) << "but it is no news at each start";
  run.ask(verbs::start, mission_file("", "<Lingers/>"));
  run.step();
  EXPECT_EQ(run.state.state, states::runs);
}

TEST(MissionRunner, AfterAPersonsMissionItsOwnDoesNotBeginByItself) {
  RunnerRun run;
  run.may_end = true;
  run.runner->load(mission_file("own", "<Lingers/>"));
  run.ask(verbs::start, mission_file("persons", "<Lingers/>"));
  run.now_ns += 2'000'000'000;
  run.step_for(0.3);
  EXPECT_EQ(run.state.state, states::none);
  RunnerRun same;
  same.runner->load(mission_file("own", "<Lingers/>"));
  same.ask(verbs::start, mission_file("own", "<Lingers/>"));
  same.now_ns += 2'000'000'000;
  same.step_for(0.3);
  EXPECT_EQ(same.state.state, states::runs);
}

TEST(MissionRunner, AnOldEndIsObeyedByAFreshOne) {
  RunnerRun run;
  run.may_end = true;
  run.runner->load(mission_file("", "<Lingers/>"));
  run.ask(verbs::end);
  run.now_ns += 2'000'000'000;
  run.step_for(0.3);
  EXPECT_EQ(run.state.state, states::none);
}

TEST(MissionRunner, TheReasonOfARefusalStaysWhereItIsRead) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Repeat num_cycles="-1"><Delay delay_msec="100">
                                       <SetBlackboard output_key="x" value="1"/></Delay></Repeat>)"));
  run.step();
  run.ask(verbs::start, "patrole");
  run.command.commander = command_state::commander::person;  // the mission says that it waits
  run.step();
  EXPECT_EQ(run.state.refused, 1U);
  EXPECT_THAT(run.said(), HasSubstr("patrole"));
  run.step_for(1.5);
  EXPECT_THAT(run.said(), HasSubstr("the mission waits")) << "told when the answer has been read";
}

TEST(MissionRunner, TheCauseOfAFailureIsToldBeforeIt) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Sequence><Say text="on the way"/><WalkToTag id="7"/></Sequence>)"));
  run.step();
  EXPECT_THAT(run.lines,
              ElementsAre("on the way", HasSubstr("WalkToTag: the tag"),
                          testing::MatchesRegex("mission '.*' has failed: WalkToTag: the tag has not.*")));
}

TEST(MissionRunner, AFailureOfWhichNoLeafSaysAnythingNamesItsNode) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Sequence><Timeout name="soon" msec="100">
                                       <WaitUntil what="fallen"/></Timeout></Sequence>)"));
  run.step_for(0.5);
  EXPECT_THAT(run.lines, Contains(testing::MatchesRegex("mission '.*' has failed: .*soon")));
}

TEST(MissionRunner, WhoStartsAMissionIsToldThatItWaitsForTheCommand) {
  RunnerRun run;
  run.command.commander = command_state::commander::person;
  run.ask(verbs::start, mission_file("", "<Lingers/>"));
  run.step();
  EXPECT_EQ(run.state.refused, 0U);
  EXPECT_EQ(run.said(), "the mission begins when the command is let go of");
}

TEST(MissionRunner, WhatIsSaidInEachTickIsToldEveryFiveSeconds) {
  RunnerRun run;
  run.runner->load(mission_file("", R"(<Repeat num_cycles="-1"><Sequence><Say text="one"/><Say text="two"/>
                                       <Sleep msec="80"/></Sequence></Repeat>)"));
  run.step_for(14.0);
  EXPECT_EQ(std::ranges::count(run.lines, "one"), 3);
  EXPECT_EQ(std::ranges::count(run.lines, "two"), 3);
}

// ---- A successor

TEST(MissionRunner, AMissionThatWaitsForTheEndOfTheOneBeforeIsHandedOn) {
  RunnerRun before;
  before.runner->load(mission_file("first", "<Lingers/>"));
  before.step();
  const std::string second = mission_file("second", "<Lingers/>");
  before.ask(verbs::start, second);
  before.step();
  ASSERT_EQ(before.state.state, states::halts);
  RunnerRun after;
  after.runner->load(mission_file("first", "<Lingers/>"));
  after.runner->go_on_from(before.runner->state());
  after.step_for(0.3);
  EXPECT_EQ(after.state.state, states::runs);
  EXPECT_STREQ(after.runner->state().mission.data(), second.c_str());
}

RunnerState handed_on(const std::string& mission, std::uint32_t state) {
  RunnerState result;
  result.state = state;
  mission.copy(result.mission.data(), result.mission.size() - 1);
  return result;
}

TEST(MissionRunner, NothingRunsUntilTheMissionOfTheOneBeforeIsRead) {
  RunnerRun run(MissionDesk::Where::beside);
  run.runner->load(mission_file("of_the_parameter", R"(<Walk forward="0.1 m/s"/>)"));
  run.runner->go_on_from(
      handed_on(mission_file("second", "<Sequence><Gated/><Lingers/></Sequence>"), states::runs));
  run.gate.wait_for_visitor();
  for (int i = 0; i < 5; ++i) {
    run.step();
    EXPECT_FALSE(run.robot->orders.walking());
  }
  const std::uint32_t revision = run.state.revision;
  run.gate.open();
  while (run.state.revision == revision) run.step();
  EXPECT_EQ(run.state.state, states::runs);
}

TEST(MissionRunner, AMissionThatIsStillToBeReadIsHandedOnAgain) {
  RunnerRun run(MissionDesk::Where::beside);
  run.runner->load(mission_file("of_the_parameter", "<Lingers/>"));
  const std::string second = mission_file("second", "<Sequence><Gated/><Lingers/></Sequence>");
  run.runner->go_on_from(handed_on(second, states::runs));
  run.gate.wait_for_visitor();
  run.step();
  const RunnerState again = run.runner->state();
  run.gate.open();
  EXPECT_STREQ(again.mission.data(), second.c_str());
  EXPECT_EQ(again.state, states::runs);
}

TEST(MissionRunner, AnEndWhileTheInheritedMissionIsReadLeavesNothingBehind) {
  RunnerRun run(MissionDesk::Where::beside);
  run.runner->go_on_from(
      handed_on(mission_file("second", "<Sequence><Gated/><Lingers/></Sequence>"), states::runs));
  run.gate.wait_for_visitor();
  run.ask(verbs::end);
  run.step_for(0.3);
  EXPECT_EQ(run.state.state, states::none);
  run.gate.open();
}

TEST(MissionRunner, AMissionThatCannotBeReadAnyMoreLeavesNothingBehind) {
  RunnerRun run;
  const std::string first = mission_file("first", "<Lingers/>");
  run.runner->load(first);
  run.runner->go_on_from(handed_on("gone.xml", states::succeeded));
  run.step();
  EXPECT_EQ(run.state.state, states::none);
  EXPECT_THAT(run.lines, Contains(HasSubstr("gone.xml")));
  run.ask(verbs::start, first);
  run.step();
  run.step();
  EXPECT_EQ(run.state.state, states::runs);
}

}  // namespace
}  // namespace gaitway::behaviour_leaves
