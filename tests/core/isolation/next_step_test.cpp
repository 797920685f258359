// A plug-in whose answer comes with the next step: what meets its step while that is under way, and what
// becomes of its fault and of what it published.
#include <gmock/gmock.h>
#include <signal.h>

#include <string>

#include "gaitway/process/real_time.hpp"
#include "isolation/local_sockets_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// Ticks 6 and 14 prepare batches.
class NextStepTest : public PluginFixture {
 protected:
  static std::string beside(const std::string& library, const std::string& parameters = "") {
    return "  - {name: it, library: " + library +
           ".so, isolation: process, answer: next_step, budget: 80 ms, parameters: {" + parameters + "}}\n";
  }
  static PluginEntry entry(const std::string& plugin) {
    return parse_configuration("plugins:\n" + plugin, "new.yaml").plugins.front();
  }
  double value() {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>("out").read(correction));
    return correction.com_offset[0];
  }
  // The values of topic `out` after each of these ticks, none of which finds a fault.
  std::vector<double> run(PluginManager& manager, std::uint32_t first, std::uint32_t last) {
    std::vector<double> values;
    for (std::uint32_t number = first; number <= last; ++number) {
      EXPECT_EQ(manager.step(tick(number)), 0) << number << ": " << manager.plugin(0).fault();
      values.push_back(value());
    }
    return values;
  }
  static int times_told(const PluginManager& manager, const std::string& part) {
    int told = 0;
    for (std::uint64_t i = manager.events().first(); i < manager.events().total(); ++i) {
      told += manager.events()[i].text().find(part) != std::string_view::npos ? 1 : 0;
    }
    return told;
  }
};

// The same again, whatever the processes' times: published values, faults and events.
TEST_F(NextStepTest, InVirtualTimeEachRunDoesTheSame) {
  std::vector<std::string> first;
  for (int i = 0; i < 3; ++i) {
    const auto manager = load(beside("misbehaves", "how: segfault, at: 9"));
    std::vector<std::string> lines;
    for (std::uint32_t number = 1; number < 40; ++number) {
      if (number == 30) {
        ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("it")));
      }
      const int failed = manager->step(tick(number));
      lines.push_back(std::to_string(failed) + " " + std::to_string(number == 1 ? 0.0 : value()));
      manager->maintain(tick(number).now_ns);
    }
    for (std::uint64_t at = 0; at < manager->events().total(); ++at) {
      const std::string text(manager->events()[at].text());  // without the process's own addresses
      lines.push_back(std::to_string(manager->events()[at].stamp_ns) + text.substr(0, text.find(" (at")));
    }
    first = i == 0 ? lines : first;
    EXPECT_EQ(lines, first);
  }
  EXPECT_GT(first.size(), 41U);
}

TEST_F(NextStepTest, AFaultThatAParameterMeetsIsStillThatOfItsStep) {
  const auto manager = load(beside("counter", "failing_step: 2"));
  EXPECT_EQ(manager->step(tick(1)), 0);
  EXPECT_EQ(manager->step(tick(2)), 0);
  manager->changes().set_parameter("it", "offset", "10 m");
  EXPECT_EQ(manager->step(tick(3)), 1);
  EXPECT_EQ(manager->plugin(0).fault(), "cannot count");
  EXPECT_EQ(times_told(*manager, "cannot count"), 1);
  EXPECT_EQ(manager->timings()[0].faults, 1U);
  EXPECT_THAT(run(*manager, 4, 5), ElementsAre(13, 14));
}

TEST_F(NextStepTest, AParameterIsOfTheStepAfterTheOneThatItMeets) {
  const auto manager = load(beside("counter"));
  manager->step(tick(1));
  EXPECT_THAT(run(*manager, 2, 3), ElementsAre(1, 2));
  manager->changes().set_parameter("it", "offset", "10 m");
  manager->changes().set_parameter("it", "offset", "20 m");
  EXPECT_EQ(value(), 2);
  EXPECT_THAT(run(*manager, 4, 6), ElementsAre(3, 24, 25));
}

TEST_F(NextStepTest, WhatTheOldOneGaveLastIsPublishedWhenANewOneComes) {
  for (const auto& [parameters, then] :
       {std::pair{"offset: 100 m", std::vector<double>{103, 103, 104}},
        std::pair{"failing_step: 1", std::vector<double>{2, 3, 4}},  // taken back
        std::pair{"longer_state: true", std::vector<double>{2, 3, 4}}}) {
    const auto manager = load(beside("counter"));
    manager->step(tick(4));
    EXPECT_THAT(run(*manager, 5, 5), ElementsAre(1));
    const auto before = other.read<Correction>("out").newest_sequence();
    ASSERT_TRUE(manager->changes().schedule(
        manager->changes().prepare_replacement(entry(beside("counter", parameters)))));
    EXPECT_EQ(run(*manager, 6, 8), then) << parameters;
    EXPECT_EQ(other.read<Correction>("out").newest_sequence(), before + 3) << "each once";
    EXPECT_EQ(manager->changes().take_result()->done, then[0] == 103) << parameters;
  }
}

TEST_F(NextStepTest, ANewOneThatFailsInItsFirstStepIsTakenBackWithinTheTick) {
  isolation.watchdog_ns = 100'000'000;
  const std::pair<const char*, const char*> ways[] = {
      {"fork", "called clone"}, {"segfault", "was ended by SIGSEGV"}, {"loop", "did not answer within"}};
  for (const bool lock_step : {true, false}) {
    isolation.lock_step = lock_step;
    for (const auto& [how, fault] : ways) {
      const auto manager = load(beside("misbehaves"));
      manager->step(tick(5));
      ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_replacement(
          entry(beside("misbehaves", std::string("at: 6, how: ") + how)))));
      EXPECT_EQ(manager->step(tick(6)), 0);
      EXPECT_EQ(value(), 1.0) << "the old one takes its turn";
      manager->end_trial(tick(6));
      const auto result = manager->changes().take_result();
      ASSERT_TRUE(result.has_value());
      EXPECT_FALSE(result->done);
      EXPECT_THAT(result->text, AllOf(HasSubstr("the new one failed in its first step"), HasSubstr(fault)));
      EXPECT_TRUE(!lock_step || run(*manager, 7, 7).front() == 2.0) << "and goes on";
    }
  }
}

TEST_F(NextStepTest, AStepThatEndedItsProcessKeepsNoNewOneAway) {
  const auto manager = load(beside("misbehaves", "how: segfault, at: 5"));
  manager->step(tick(4));
  manager->step(tick(5));
  ASSERT_TRUE(
      manager->changes().schedule(manager->changes().prepare_replacement(entry(beside("misbehaves")))));
  EXPECT_EQ(manager->step(tick(6)), 0);
  manager->end_trial(tick(6));
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->done) << result->text;
  EXPECT_EQ(times_told(*manager, "was ended by SIGSEGV in its step"), 1);
}

TEST_F(NextStepTest, AFaultOfItsLastStepIsToldThoughItIsNotSteppedAnyMore) {
  using Prepare = std::unique_ptr<PluginChange> (*)(ChangeControl&);
  for (const Prepare prepare : {Prepare([](ChangeControl& to) { return to.prepare_removal("it"); }),
                                Prepare([](ChangeControl& to) { return to.prepare_stop("it"); }),
                                Prepare([](ChangeControl& to) { return to.prepare_reload("it"); })}) {
    const auto manager = load(beside("counter", "failing_step: 2"));
    manager->step(tick(4));
    manager->step(tick(5));
    ASSERT_TRUE(manager->changes().schedule(prepare(manager->changes())));
    manager->step(tick(6));
    manager->end_trial(tick(6));
    EXPECT_TRUE(manager->changes().take_result()->done);
    manager->step(tick(7));
    EXPECT_EQ(times_told(*manager, "cannot count"), 1);
  }
}

TEST_F(NextStepTest, WhatItPublishedBeforeItDiedGoesOut) {
  for (const bool lock_step : {true, false}) {
    isolation.lock_step = lock_step;
    const auto manager = load(beside("counter"));
    manager->step(tick(1));
    wait_until_idle(child_process());
    EXPECT_THAT(run(*manager, 2, 2), ElementsAre(1));
    wait_until_idle(child_process());
    ASSERT_EQ(kill(child_process(), SIGKILL), 0);
    wait_until_ended(child_process());
    manager->maintain(tick(2).now_ns);
    EXPECT_THAT(run(*manager, 3, 3), ElementsAre(2)) << lock_step;
    EXPECT_EQ(manager->step(tick(4)), 1);
    EXPECT_THAT(std::string(manager->plugin(0).fault()),
                HasSubstr(lock_step ? "in its step" : "in between two steps"));
    EXPECT_EQ(manager->timings()[0].faults, 1U);
  }
}

// Its turn comes once in 80 ms; after 40 ms it has a new process.
TEST_F(NextStepTest, InRealTimeACrashIsToldThoughItIsThereAgainWhenItsTurnComes) {
  isolation.lock_step = false;
  std::string plugin = beside("misbehaves", "how: segfault, at: 16");
  plugin.insert(plugin.find("budget"), "period: 80 ms, ");
  const auto manager = load(plugin);
  EXPECT_EQ(manager->step(tick(16)), 0);
  for (int i = 0; i < 100'000 && times_told(*manager, "runs in a new process") == 0; ++i) {
    manager->maintain(tick(23).now_ns + i / 1000 * facts::kSlot_ns);
  }
  ASSERT_EQ(manager->plugin(0).recovery(), Recovery::not_needed);
  EXPECT_EQ(manager->step(tick(160'000)), 1);
  EXPECT_EQ(manager->timings()[0].faults, 1U);
  EXPECT_EQ(times_told(*manager, "was ended by SIGSEGV in its step"), 1);
}

// A second of the robot's passes in microseconds: the process gets its budget by the wall clock.
TEST_F(NextStepTest, InASimulatorThatRunsAheadOfTheClockItIsNotLate) {
  isolation.lock_step = false;
  const auto manager = load(relay("source", "to: a") +
                            "  - {name: it, library: relay.so, isolation: process, answer: next_step, "
                            "budget: 80 ms, parameters: {from: a, add: 100, to: b}}\n");
  for (std::uint32_t i = 1; i <= 50; ++i) {
    ASSERT_EQ(manager->step(tick(100 * i)), 0) << manager->plugin(1).fault();
  }
}

class NextStepOfAServer : public LocalSockets {};

TEST_F(NextStepOfAServer, InRealTimeNoTickWaitsForOneThatAnswersNextStep) {
  isolation.lock_step = false;
  manager = load(relays() + server(", answer: next_step, budget: 25 ms"));
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 0);
  while (ask("waits") != 1) {  // its thread tells when its step has begun
  }
  for (int i = 0; i < 2; ++i) {
    EXPECT_EQ(step(), 0) << "within its budget it is left alone";
    EXPECT_EQ(relayed(), 100.0 + number);
  }
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("did not answer within 25 ms"));
  EXPECT_EQ(step(), 1);
  EXPECT_THAT(fault(), HasSubstr("has not answered for 40 ms"));
  EXPECT_EQ(relayed(), 100.0 + number);
  EXPECT_EQ(service(), ServiceState::failing);
}

TEST_F(NextStepOfAServer, InRealTimeAParameterIsRefusedWhileAStepIsUnderWayAndTheStepGoesOn) {
  isolation.lock_step = false;
  manager = load(server(", answer: next_step, budget: 80 ms"));
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 0);
  EXPECT_THAT(parameter_refusal(), HasSubstr("its step is under way"));
  EXPECT_EQ(step(), 0) << fault();
  ASSERT_EQ(ask("go on"), 0);
  wait_until_idle(ask("process"));
  EXPECT_EQ(parameter_refusal(), "");
  EXPECT_EQ(step(), 0) << fault();
  EXPECT_EQ(newest("did not answer"), "");
}

TEST_F(NextStepOfAServer, InRealTimeAParameterIsRefusedWhileItIsLate) {
  isolation.lock_step = false;
  manager = load(server(", budget: 1 ms"));
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 1);
  EXPECT_THAT(parameter_refusal(), HasSubstr("its step is under way"));
}

TEST_F(NextStepOfAServer, InRealTimeOneThatDiesAfterItsStepDiesBetweenTwoAndIsHeardOnce) {
  isolation.lock_step = false;
  for (const char* const answer : {"this_step", "next_step"}) {
    manager.reset();
    manager = load(server(std::string(", budget: 80 ms, answer: ") + answer));
    const std::uint64_t before = manager->events().total();
    ASSERT_EQ(ask("step unix"), 0);
    manager->step(tick(++number));
    wait_until_idle(ask("process"));
    const int process = ask("process");
    ASSERT_EQ(ask("die"), -2);
    wait_until_ended(process);
    manager->maintain(tick(number).now_ns);
    manager->step(tick(++number));  // of next_step it takes what it published
    EXPECT_EQ(manager->step(tick(++number)), 1);
    EXPECT_THAT(fault(), HasSubstr("was ended by SIGABRT in between two steps")) << answer;
    int told = 0;
    for (std::uint64_t i = before; i < manager->events().total(); ++i) {
      told += manager->events()[i].text() == "unix: error 0" ? 1 : 0;
    }
    EXPECT_EQ(told, 1) << answer;
  }
}

TEST_F(NextStepOfAServer, InRealTimeOneThatIsAlwaysLateIsGivenUpHoweverItAnswers) {
  isolation.lock_step = false;
  for (const char* const answer : {"this_step", "next_step"}) {
    manager.reset();
    manager =
        load(server(std::string(", give_up_after: {batches: 3}, answer: ") + answer, ", every_batch: true"));
    for (number = 6; number < 100 && service() != ServiceState::out_of_service; number += 8) {
      ASSERT_EQ(ask("step wait"), 0);
      manager->step(tick(number));
      while (ask("waits") != 1) {
      }
      if (std::string(answer) == "next_step") {
        manager->step(tick(number += 8));
      }
      EXPECT_THAT(fault(), HasSubstr("did not answer")) << answer;
      ASSERT_EQ(ask("go on"), 0);
      wait_until_idle(ask("process"));
    }
    EXPECT_EQ(service(), ServiceState::out_of_service) << answer;
    EXPECT_THAT(newest("out of service"), HasSubstr("out of service after 3 faults")) << answer;
  }
}

TEST_F(NextStepOfAServer, InRealTimeOneWhoseStepDoesNotEndIsRemovedWithoutATickThatWaits) {
  isolation.lock_step = false;
  manager = load(relays() + server(", answer: next_step, budget: 80 ms"));
  number = 4;
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 0);
  while (ask("waits") != 1) {
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_removal("server")));
  const std::int64_t began_ns = process::monotonic_ns();
  EXPECT_EQ(step(), 0);
  EXPECT_LT(process::monotonic_ns() - began_ns, 50'000'000) << "its budget is 80 ms";
  manager->end_trial(tick(number));
  EXPECT_TRUE(manager->changes().take_result()->done);
  EXPECT_EQ(step(), 0);
  EXPECT_EQ(newest("its step"), "its step did not end within 1 s: its process was ended");
}

TEST_F(NextStepOfAServer, InRealTimeAReloadIsRefusedWhileAStepIsUnderWayAndTheStepGoesOn) {
  isolation.lock_step = false;
  manager = load(server(", answer: next_step, budget: 80 ms"));
  std::string newcomer = server();
  newcomer.replace(newcomer.find("/door"), 5, "/other");
  number = 4;
  ASSERT_EQ(ask("step wait"), 0);
  ASSERT_EQ(step(), 0);
  while (ask("waits") != 1) {
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_replacement(
      parse_configuration("plugins:\n" + newcomer, "new.yaml").plugins.front())));
  EXPECT_EQ(step(), 0) << fault();
  manager->end_trial(tick(number));
  EXPECT_THAT(manager->changes().take_result()->text,
              HasSubstr("not changed: the running one cannot hand its state on: its step is under way"));
  ASSERT_EQ(ask("go on"), 0);
  wait_until_idle(ask("process"));
  EXPECT_EQ(step(), 0) << fault();
  EXPECT_EQ(service(), ServiceState::works);
}

}  // namespace
}  // namespace gaitway::core
