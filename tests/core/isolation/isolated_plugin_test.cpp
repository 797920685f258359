// Plug-ins in processes of their own: the same as in-process while all goes well, and every way to die or
// hang is survived, told, and followed by a new process.
#include "isolation/isolated_plugin.hpp"

#include <gmock/gmock.h>
#include <signal.h>

#include <string>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class IsolatedPluginTest : public PluginFixture {
 protected:
  static std::string isolated(const std::string& library, const std::string& parameters = "") {
    return "  - {name: it, library: " + library + ".so, isolation: process, parameters: {" + parameters +
           "}}\n";
  }
  // Its fault in tick 3; how many ticks after it is there again, and with which count.
  struct Survival {
    std::string fault;
    int ticks = 0;
    double count = 0.0;
  };
  Survival survive(const std::string& how) {
    const auto manager = load(isolated("misbehaves", "how: " + how));
    Survival result;
    for (std::uint32_t i = 1; i < 16; ++i) {
      const int failed = manager->step(tick(i));
      EXPECT_TRUE(i >= 3 || failed == 0);
      if (i == 3) {
        EXPECT_EQ(failed, 1);
        EXPECT_EQ(value(), 2.0);  // nothing of the bad step went out
        result.fault = manager->plugin(0).fault();
      }
      if (i > 3 && failed == 0) {
        result.ticks = static_cast<int>(i) - 3;
        result.count = value();
        return result;
      }
      manager->maintain(tick(i).now_ns);
    }
    return result;
  }
  double value() {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>("out").read(correction));
    return correction.com_offset[0];
  }
};

TEST_F(IsolatedPluginTest, RelayGivesWhatItGivesInProcess) {
  const std::string body = "library: relay.so, parameters: {from: a, add: 100, to: b}";
  const auto manager = load(relay("source", "to: a") + "  - {name: it, isolation: process, " + body + "}\n");
  for (std::uint32_t i = 1; i < 20; ++i) {
    ASSERT_EQ(manager->step(tick(i)), 0);
    Correction correction{};
    ASSERT_TRUE(other.read<Correction>("b").read(correction));
    ASSERT_EQ(correction.com_offset[0], 100.0 + i);
  }
  EXPECT_EQ(manager->plugin(0).version(), "1.0.0");
}

TEST_F(IsolatedPluginTest, ParametersAndReportsCross) {
  const auto manager = load(isolated("parameters", "step_time: 0.5 s, steps: 7, mirror: false, solver: kdl"));
  manager->step(tick(9));
  Correction c{};
  ASSERT_TRUE(other.read<Correction>("out").read(c));
  EXPECT_EQ(c.com_offset[0], 0.5);
  EXPECT_EQ(c.step_offset[0], 7.0);
  EXPECT_EQ(c.step_offset[1], 0.0);
  EXPECT_EQ(c.turn_rate_offset, 2.0);
  ASSERT_EQ(manager->events().total(), 1U);
  EXPECT_EQ(manager->events()[0].text(), "battery is low");
}

// More than it can pass on, step by step: the oldest are lost, and none comes twice or out of turn.
TEST_F(IsolatedPluginTest, ABurstOfReportsCrossesInItsOrder) {
  const auto manager = load(isolated("reports_from_a_thread"));
  for (std::uint32_t i = 1; i <= 10; ++i) {
    ASSERT_EQ(manager->step(tick(i)), 0);
  }
  const EventLog& events = manager->events();
  ASSERT_GT(events.total(), 100U);
  int last = 0;
  for (std::uint64_t i = events.first(); i < events.total(); ++i) {
    const int number = std::stoi(std::string(events[i].text()));
    EXPECT_GT(number, last);
    last = number;
  }
}

// Whatever is refused in-process is refused with the same words.
TEST_F(IsolatedPluginTest, ErrorsAreThoseOfAPluginInProcess) {
  for (const char* const entry :
       {"library: nowhere.so", "library: other_abi.so", "library: wrong_size.so",
        "library: missing_symbol.so", "library: throws_in_constructor.so", "library: throws_in_activate.so",
        "library: parameters.so, parameters: {step_time: 0.5 m}",
        "library: parameters.so, parameters: {stepp_time: 0.5}"}) {
    const std::string here = refusal(std::string("  - {name: it, ") + entry + "}\n");
    const std::string there = refusal(std::string("  - {name: it, isolation: process, ") + entry + "}\n");
    EXPECT_NE(here, "") << entry;
    EXPECT_EQ(here, there);
  }
}

// Before any memory is taken for them.
TEST_F(IsolatedPluginTest, ValuesLargerThanAMemoryBlockAreRefused) {
  for (const std::string where : {"", "isolation: process, "}) {
    const auto complaint = [&](const std::string& bytes) {
      return refusal("  - {name: it, library: huge_topic.so, " + where + "parameters: {bytes: " + bytes +
                     "}}\n");
    };
    EXPECT_THAT(complaint("4294967295"), HasSubstr("opens topic 'first' with values of 4294967295 bytes"));
    EXPECT_THAT(complaint("16777217"), HasSubstr("opens topic 'first' with values of 16777217 bytes"));
    EXPECT_THAT(complaint("16777216"),
                HasSubstr("opens topic 'second', and its values have 33554432 bytes together"));
    EXPECT_THAT(complaint("8388608"), HasSubstr("nobody refused it"));
  }
}

TEST_F(IsolatedPluginTest, ThrowsAndNonFiniteOutputsAreFaultsOfOneStep) {
  const auto manager = load(isolated("throws_in_step"));
  EXPECT_EQ(manager->step(tick(2)), 0);
  EXPECT_EQ(manager->step(tick(3)), 1);
  EXPECT_EQ(value(), 2.0);
  EXPECT_EQ(manager->plugin(0).fault(), "matrix is singular");
  EXPECT_EQ(manager->step(tick(5)), 0);
}

TEST_F(IsolatedPluginTest, NonFiniteOutputIsNotPublished) {
  const auto manager = load(isolated("publishes_nan"));
  EXPECT_EQ(manager->step(tick(1)), 0);
  EXPECT_EQ(manager->step(tick(2)), 1);
  EXPECT_THAT(std::string(manager->plugin(0).fault()), HasSubstr("field 'gain'[1][27] is not finite"));
}

// 40 ms later, always; and from the state of the last good step, the second.
TEST_F(IsolatedPluginTest, CrashIsSurvivedAndFollowedByANewProcess) {
  const Survival segfault = survive("segfault");
  EXPECT_THAT(segfault.fault, AllOf(HasSubstr("was ended by SIGSEGV in its step"),
                                    HasSubstr("at 0x0, from misbehaves.so+0x")));
  EXPECT_EQ(segfault.ticks, 5);
  EXPECT_EQ(segfault.count, 3.0);
}
TEST_F(IsolatedPluginTest, AbortIsSurvived) {
  const Survival abort = survive("abort");
  EXPECT_THAT(abort.fault, HasSubstr("was ended by SIGABRT in its step"));
  EXPECT_EQ(abort.ticks, 5);
}
TEST_F(IsolatedPluginTest, ExitIsSurvived) {
  const Survival exit = survive("exit");
  EXPECT_THAT(exit.fault, HasSubstr("exited with code 7 in its step"));
  EXPECT_EQ(exit.ticks, 5);
}
TEST_F(IsolatedPluginTest, EndlessLoopIsEnded) {
  const Survival loop = survive("loop");
  EXPECT_THAT(loop.fault, HasSubstr("did not answer within 2000 ms of wall time: its process was ended"));
  EXPECT_EQ(loop.ticks, 5);
}
TEST_F(IsolatedPluginTest, GarbageInTheSegmentIsSurvived) {
  const Survival garbage = survive("garbage");
  EXPECT_THAT(garbage.fault, HasSubstr("wrote over the memory that it shares with the manager"));
  EXPECT_EQ(garbage.ticks, 5);
}
TEST_F(IsolatedPluginTest, DescriptorLeakIsBounded) {
  const Survival leak = survive("descriptors");
  EXPECT_THAT(leak.fault, AllOf(HasSubstr("cannot open the camera: Too many open files"),
                                HasSubstr("used up its file descriptors")));
  EXPECT_EQ(leak.ticks, 5);
}
TEST_F(IsolatedPluginTest, ForkIsRefusedAndTold) {
  const Survival fork = survive("fork");
  EXPECT_THAT(fork.fault, HasSubstr("called clone, which a plug-in in a process of its own may not"));
  EXPECT_EQ(fork.ticks, 1);  // its process lives on
}
TEST_F(IsolatedPluginTest, SocketsAreRefusedAndTold) {
  EXPECT_THAT(survive("socketpair").fault, HasSubstr("called socketpair, which"));
}
#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
TEST_F(IsolatedPluginTest, MemoryLeakIsBounded) {
  const Survival leak = survive("memory");
  EXPECT_THAT(leak.fault, AllOf(HasSubstr("bad_alloc"), HasSubstr("used up its memory")));
  EXPECT_EQ(leak.ticks, 5);
}
#endif

// By how often its process ended, not by how many steps were missed meanwhile.
TEST_F(IsolatedPluginTest, ThirdReplacementIsTheLast) {
  const auto manager = load(isolated("misbehaves", "how: always"));
  for (std::uint32_t i = 1; i < 60; ++i) {
    manager->step(tick(i));
    manager->maintain(tick(i).now_ns);
    const bool before_last = manager->timings()[0].faults < 16;
    EXPECT_EQ(manager->timings()[0].state == ServiceState::out_of_service, !before_last) << i;
  }
  EXPECT_EQ(manager->plugin(0).recovery(), Recovery::given_up);
  int told = 0;
  std::vector<std::string> errors;
  for (std::uint64_t i = 0; i < manager->events().total(); ++i) {
    told += manager->events()[i].kind == EventKind::fault ? 1 : 0;
    if (manager->events()[i].kind == EventKind::error) {
      errors.emplace_back(manager->events()[i].text());
    }
  }
  EXPECT_EQ(told, 4) << "each end once";
  ASSERT_EQ(errors.size(), 1U);
  EXPECT_THAT(errors[0],
              AllOf(HasSubstr("out of service after 16 faults since 0."),
                    HasSubstr("its process was replaced 3 times within 10 s"), HasSubstr("SIGABRT")));
}

TEST_F(IsolatedPluginTest, InRealTimeAHostThatHangsIsEndedThoughNobodyStepsIt) {
  isolation.lock_step = false;
  const auto manager = load(isolated("misbehaves", "how: loop"));
  for (std::uint32_t i = 1; i <= 3; ++i) {
    manager->step(tick(i));
    manager->maintain(tick(i).now_ns);
  }
  EXPECT_THAT(std::string(manager->plugin(0).fault()), HasSubstr("did not answer within 2 ms"));
  manager->maintain(tick(14).now_ns);
  EXPECT_THAT(std::string(manager->plugin(0).fault()),
              HasSubstr("has not answered for 110 ms: its process was ended"));
}

TEST_F(IsolatedPluginTest, AParameterThatIsSetWhenItsProcessHasJustDiedIsRefused) {
  for (const bool lock_step : {true, false}) {
    isolation.lock_step = lock_step;
    const auto manager = load(isolated("counter"));
    ASSERT_EQ(manager->step(tick(1)), 0);
    const pid_t child = child_process();
    ASSERT_EQ(kill(child, SIGKILL), 0);
    wait_until_ended(child);
    for (const char* const fault : {"was ended by SIGKILL in set_parameter", "is being replaced since"}) {
      try {
        manager->changes().set_parameter("it", "offset", "1 m");
        ADD_FAILURE() << "nobody refused it";
      } catch (const PluginError& error) {
        EXPECT_THAT(error.what(), HasSubstr(fault));
      }
    }
    EXPECT_EQ(manager->step(tick(2)), 1);
    std::uint32_t at = 2;
    for (; at < 2000 && manager->plugin(0).recovery() != Recovery::not_needed; ++at) {
      manager->maintain(tick(at).now_ns);
    }
    manager->changes().set_parameter("it", "offset", "1 m");
    EXPECT_EQ(manager->step(tick(at)), 0);
  }
}

// --- Whose answer comes with the next step.

TEST_F(IsolatedPluginTest, WithItsAnswerNextStepItsOutputsComeOneStepLater) {
  const auto manager = load(relay("source", "to: a") +
                            "  - {name: it, library: relay.so, isolation: process, answer: next_step, "
                            "parameters: {from: a, add: 100, to: b}}\n");
  for (std::uint32_t i = 1; i < 20; ++i) {
    ASSERT_EQ(manager->step(tick(i)), 0);
    Correction correction{};
    ASSERT_EQ(static_cast<bool>(other.read<Correction>("b").read(correction)), i > 1);
    ASSERT_EQ(correction.com_offset[0], i > 1 ? 99.0 + i : 0.0);
  }
}

TEST_F(IsolatedPluginTest, WithItsAnswerNextStepAFaultIsTheNextStepsAndSurvived) {
  const std::pair<const char*, const char*> ways[] = {{"segfault", "was ended by SIGSEGV in its step"},
                                                      {"exit", "exited with code"},
                                                      {"loop", "did not answer"}};
  isolation.watchdog_ns = 50'000'000;
  for (const auto& [how, fault] : ways) {
    const auto manager = load(
        "  - {name: it, library: misbehaves.so, isolation: process, answer: next_step, "
        "parameters: {how: " +
        std::string(how) + "}}\n");
    std::uint32_t at = 1;
    for (; at <= 3; ++at) {
      ASSERT_EQ(manager->step(tick(at)), 0);
      manager->maintain(tick(at).now_ns);
    }
    ASSERT_EQ(manager->step(tick(at)), 1) << how;
    EXPECT_THAT(std::string(manager->plugin(0).fault()), HasSubstr(fault));
    EXPECT_EQ(value(), 2.0) << "nothing of the bad step went out";
    do {
      manager->maintain(tick(at).now_ns);
      ASSERT_LT(++at, 20U) << how;
    } while (manager->step(tick(at)) != 0);
    EXPECT_EQ(value(), 3.0) << "it goes on from the state of its last good step";
  }
}

TEST_F(IsolatedPluginTest, WithItsAnswerNextStepParametersAndReloadsComeBetweenTwoSteps) {
  for (const bool lock_step : {true, false}) {
    isolation.lock_step = lock_step;
    const auto manager =
        load("  - {name: it, library: counter.so, isolation: process, answer: next_step, budget: 80 ms}\n");
    ASSERT_EQ(manager->step(tick(1)), 0);
    manager->changes().set_parameter("it", "offset", "1 m");
    ASSERT_EQ(manager->step(tick(2)), 0);
    ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("it")));
    ASSERT_EQ(manager->step(tick(6)), 0);
    manager->end_trial(tick(6));
    const auto result = manager->changes().take_result();
    ASSERT_TRUE(result.has_value());
    EXPECT_TRUE(result->done) << result->text;
    ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_stop("it")));
    manager->step(tick(14));
    manager->end_trial(tick(14));
    EXPECT_TRUE(manager->changes().take_result()->done);
  }
}

TEST_F(IsolatedPluginTest, WhatHasNoProcessCanBeStoppedAndReloaded) {
  const auto manager = load(isolated("misbehaves", "how: abort"));
  for (std::uint32_t i = 1; i <= 5; ++i) {
    manager->step(tick(i));  // its process ended in tick 3, and nobody maintains it
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("it")));
  EXPECT_EQ(manager->step(tick(6)), 0);
  EXPECT_EQ(value(), 1.0) << "it starts afresh";
  manager->end_trial(tick(6));
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->done) << result->text;
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_stop("it")));
  manager->step(tick(14));
  manager->end_trial(tick(14));
  EXPECT_TRUE(manager->changes().take_result()->done);
}

TEST_F(IsolatedPluginTest, ChangeTakesTheStateFromOneProcessToTheOther) {
  const auto manager = load(isolated("misbehaves"));
  for (std::uint32_t i = 1; i < 6; ++i) {
    ASSERT_EQ(manager->step(tick(i)), 0);
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("it")));
  EXPECT_EQ(manager->step(tick(6)), 0);
  EXPECT_EQ(value(), 6.0);
  manager->end_trial(tick(6));
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result.has_value());
  EXPECT_TRUE(result->done) << result->text;
}

}  // namespace
}  // namespace gaitway::core
