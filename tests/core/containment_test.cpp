// Fallbacks in the same tick, budgets, limits, service and stand-ins.
#include <gmock/gmock.h>

#include <algorithm>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::HasSubstr;

constexpr const char* kFailsAsTold = "  - {name: balance, library: fails_as_told.so";

class ContainmentTest : public PluginFixture {
 protected:
  void start(const std::string& settings = {}) {
    PluginManagerOptions options;
    options.robot_directory = GAITWAY_TEST_ROBOT;
    options.plugin_path = {GAITWAY_TEST_PLUGINS};
    options.injected_faults = &faults;
    orders.publish(WalkCommand{}, 0);
    manager = std::make_unique<PluginManager>(
        parse_configuration("plugins:\n" + std::string(kFailsAsTold) + settings + "}\n" +
                                relay("reader", "from: correction, to: copy"),
                            "test.yaml"),
        options, client);
  }
  void order(bool throws, double number = 0.0) {
    WalkCommand command{};
    command.walk = throws ? 1 : 0;
    command.velocity[0] = number;
    orders.publish(command, 0);
  }
  int step() { return manager->step(tick(next++)); }
  TrimCommand trim() {
    TrimCommand value{};
    EXPECT_TRUE(other.read<TrimCommand>("trim").read(value));
    return value;
  }
  Correction correction() {
    Correction value{};
    EXPECT_TRUE(other.read<Correction>("correction").read(value));
    return value;
  }
  std::vector<std::string> texts(EventKind kind) const {
    std::vector<std::string> result;
    for (std::uint64_t i = 0; i < manager->events().total(); ++i) {
      if (manager->events()[i].kind == kind) {
        result.emplace_back(manager->events()[i].text());
      }
    }
    return result;
  }

  PluginFaultTable faults;
  msgclient::Writer<WalkCommand> orders = other.write<WalkCommand>("orders");
  std::unique_ptr<PluginManager> manager;
  std::uint32_t next = 1;
};

TEST_F(ContainmentTest, TrimsAndCorrectionFadeFromTheTickOfTheFaultOn) {
  start(", fallback: trims_to_zero");
  EXPECT_EQ(step(), 0);
  EXPECT_DOUBLE_EQ(trim().angle[0], 0.1);
  order(true);
  for (int i = 1; i <= 30; ++i) {
    if (i <= 19) {
      EXPECT_EQ(step(), 1);
      EXPECT_EQ(manager->fault_behind("copy"), nullptr) << "its fallback wrote all";
    } else {
      step();
    }
    EXPECT_EQ(trim().stamp_ns, tick(next - 1).now_ns) << "in the same tick";
    EXPECT_NEAR(trim().angle[0], 0.1 * (1.0 - i / 30.0), 1e-12);
    EXPECT_NEAR(correction().turn_rate_offset, 0.2 * (1.0 - i / 30.0), 1e-12);
    EXPECT_EQ(trim().gain[2][4][1], 0.25) << "for the message controller's own trims";
  }
  EXPECT_NEAR(trim().angle[0], 0.0, 1e-12);
}

TEST_F(ContainmentTest, TrimsGoOverToWhatTheLastGainsMakeOfTheEstimate) {
  start();
  step();
  auto estimates = other.write<Estimate>("estimate");
  Estimate estimate{};
  estimate.contact[0] = estimate.contact[1] = 1;
  estimate.attitude[1] = 0.2;
  order(true);
  for (int i = 1; i <= 40; ++i) {
    estimate.stamp_ns = tick(next).now_ns;
    estimates.publish(estimate, estimate.stamp_ns);
    step();
    const double share = std::max(1.0 - i / 30.0, 0.0);
    EXPECT_NEAR(trim().angle[0], 0.1 * share, 1e-9);
    EXPECT_NEAR(trim().angle[4], 0.05 * (1.0 - share), 1e-9) << "gain 0.25 of 0.2 rad of pitch";
  }
}

TEST_F(ContainmentTest, ItsOutputIsTakenAgainWhenItWorksAgain) {
  start();
  step();
  order(true);
  for (int i = 0; i < 5; ++i) {
    step();
  }
  order(false);
  EXPECT_EQ(step(), 0);
  EXPECT_DOUBLE_EQ(trim().angle[0], 0.1);
  EXPECT_EQ(texts(EventKind::fault).size(), 5U);
  EXPECT_THAT(texts(EventKind::warning), testing::ElementsAre("fallback 'trims_from_gains' stands in"));
  EXPECT_THAT(texts(EventKind::info),
              testing::ElementsAre(HasSubstr("works again, after 5 faults since 0.024 s")));
}

TEST_F(ContainmentTest, NumberBeyondItsLimitsIsRefusedByFieldValueAndLimit) {
  start();
  step();
  order(false, 101.0);
  EXPECT_EQ(step(), 1);
  EXPECT_EQ(trim().angle[3], 0.0);
  EXPECT_EQ(texts(EventKind::fault).at(0),
            "topic 'trim': field 'angle'[3][0] is 101; it must lie between -0.35 and 0.35");
}

TEST_F(ContainmentTest, DeclaredCostOverBudgetIsAnOverrun) {
  start(", budget: 300 us, fallback: trims_to_zero");
  step();
  faults.inject("balance", {PluginFaultKind::overruns, 300'000});
  EXPECT_EQ(step(), 0);
  faults.inject("balance", {PluginFaultKind::overruns, 301'000});
  EXPECT_EQ(step(), 1);
  EXPECT_NEAR(trim().angle[0], 0.1 * 29 / 30, 1e-12);
  EXPECT_EQ(manager->timings()[0].overruns, 1U);
  EXPECT_EQ(texts(EventKind::fault).at(0), "took 301 us; its budget is 300 us");
}

TEST_F(ContainmentTest, WallTimeNeverDecidesInVirtualTime) {
  start(", budget: 1 us");
  for (int i = 0; i < 100; ++i) {
    EXPECT_EQ(step(), 0);
  }
}

TEST_F(ContainmentTest, OutOfServiceAfterTwentyFaultsInTwoSeconds) {
  start();
  step();
  order(true);
  for (int i = 0; i < 25; ++i) {
    step();
  }
  EXPECT_EQ(manager->timings()[0].faults, 20U);
  EXPECT_EQ(manager->timings()[0].state, ServiceState::out_of_service);
  ASSERT_EQ(texts(EventKind::error).size(), 1U);
  EXPECT_EQ(texts(EventKind::error)[0],
            "out of service after 20 faults since 0.024 s (20 since start); fallback: trims_from_gains; "
            "the last fault: as told");
  order(false);
  for (int i = 0; i < 20; ++i) {
    step();
  }
  EXPECT_EQ(manager->timings()[0].steps, 21U) << "it is not stepped any more";
  EXPECT_EQ(trim().stamp_ns, tick(next - 1).now_ns) << "its fallback stays";
  EXPECT_EQ(manager->fault_behind("copy"), nullptr);
  PluginStatistics statistics{};
  ASSERT_TRUE(other.read<PluginStatistics>("plugin_statistics").read(statistics));
  EXPECT_EQ(statistics.state[0], 2U);
  EXPECT_EQ(statistics.faults[0], 20U);
  EXPECT_EQ(statistics.budget_ns[0], 2'000'000);
}

TEST_F(ContainmentTest, FaultsThatAreFarApartAreForgiven) {
  start();
  for (int i = 0; i < 100; ++i) {
    order(i % 11 == 0);
    step();
  }
  EXPECT_EQ(manager->timings()[0].faults, 10U);
  EXPECT_EQ(manager->timings()[0].state, ServiceState::failing);  // in the last step
}

TEST_F(ContainmentTest, GivingUpNamesTheFaultsThatWereTooMany) {
  start(", give_up_after: {faults: 3, within: 60 ms}");
  for (int i = 0; i < 5; ++i) {
    order(i % 2 == 0);
    step();
  }
  ASSERT_EQ(texts(EventKind::error).size(), 1U);
  EXPECT_THAT(texts(EventKind::error)[0], HasSubstr("out of service after 3 faults since 0.014 s (3 since"));
}

TEST_F(ContainmentTest, GiveUpRuleComesFromTheConfiguration) {
  start(", give_up_after: {faults: 3, within: 30 ms}");
  order(true);
  for (int i = 0; i < 3; ++i) {
    step();
  }
  EXPECT_EQ(manager->timings()[0].state, ServiceState::out_of_service);
}

TEST_F(ContainmentTest, OfBatchPluginsEightInARowAreTooMany) {
  start(", parameters: {every_batch: true}");
  order(true);
  for (int i = 0; i < 80; ++i) {
    step();
  }
  EXPECT_EQ(manager->timings()[0].faults, 8U);
  EXPECT_EQ(manager->timings()[0].state, ServiceState::out_of_service);
}

TEST_F(ContainmentTest, FallbackNoneHoldsBackWhatDependsOnIt) {
  start(", fallback: none");
  order(true);
  step();
  ASSERT_NE(manager->fault_behind("copy"), nullptr);
  EXPECT_EQ(manager->fault_behind("copy")->name(), "balance");
}

TEST_F(ContainmentTest, FallbackThatWritesNoneOfItsTopicsIsRefused) {
  try {
    start(", fallback: estimate");
    FAIL();
  } catch (const PluginError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr("test.yaml:2): fallback 'estimate' writes the topic 'estimate', which"));
  }
}

TEST_F(ContainmentTest, SettingsAreReadStrictly) {
  EXPECT_THAT(refusal(std::string(kFailsAsTold) + ", fallback: stopp}\n"), HasSubstr("'stop'"));
  EXPECT_THAT(refusal(std::string(kFailsAsTold) + ", budget: 200}\n"), HasSubstr("with its unit"));
  EXPECT_THAT(refusal(std::string(kFailsAsTold) + ", budget: 2 s}\n"), HasSubstr("between 1 us and 80 ms"));
  EXPECT_THAT(refusal(std::string(kFailsAsTold) + ", give_up_after: {faults: 0}}\n"), HasSubstr("faults"));
  EXPECT_THAT(refusal(std::string(kFailsAsTold) + ", give_up_after: {fault: 1}}\n"), HasSubstr("faults"));
}

TEST_F(ContainmentTest, FaultOfASlowerPluginCountsUntilItsNextTurn) {
  start(", fallback: none, period: 40 ms");
  order(true);
  for (; next <= 6;) {
    step();
  }
  ASSERT_NE(manager->fault_behind("copy"), nullptr) << "tick 6, the batch's, is none of its turns";
  order(false);
  for (; next <= 8;) {
    step();
  }
  EXPECT_EQ(manager->fault_behind("copy"), nullptr);
}

TEST_F(ContainmentTest, PluginThatFailedBeforeIsNotBlamedOnAChange) {
  start(", fallback: none");
  order(true);
  for (; next <= 5;) {
    step();
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("reader")));
  step();
  ASSERT_NE(manager->fault_behind("copy"), nullptr);
  EXPECT_FALSE(manager->changes().is_trial_to_blame("copy"));
  order(false);
  step();
  (void)manager->changes().take_result();
  for (; next <= 13;) {
    step();
  }
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("reader")));
  order(true);
  step();
  EXPECT_TRUE(manager->changes().is_trial_to_blame("copy")) << "it fails for the first time with the new one";
}

// What the topics' schema says of a standard one holds whatever the plug-in says of it.
TEST_F(ContainmentTest, AStandardTopicsLimitsHoldWithoutTheWritersFieldTable) {
  for (const char* const where : {"none", "process"}) {
    const auto alone =
        load("  - {name: c, library: no_field_table.so, isolation: " + std::string(where) + "}\n");
    EXPECT_EQ(alone->step(tick(1)), 1);
    EXPECT_THAT(alone->plugin(0).fault(), HasSubstr("topic 'walk_command': field 'velocity'[0]"));
    EXPECT_EQ(alone->step(tick(2)), 0) << alone->plugin(0).fault();
  }
}

TEST_F(ContainmentTest, WhoeverIsLeftOutHasAStandInWhateverItsFallback) {
  for (const char* const fallback : {"trims_to_zero", "trims_from_gains", "none", "safe_tail"}) {
    msgclient::MemoryBlock own_block;
    msgclient::Client own_client = own_block.local_client("main_controller");
    PluginManagerOptions options;
    options.robot_directory = GAITWAY_TEST_ROBOT;
    options.plugin_path = {GAITWAY_TEST_PLUGINS};
    options.stopped = {"balance"};
    PluginManager alone(
        parse_configuration("plugins:\n  - {name: balance, library: nowhere.so, fallback: " +
                                std::string(fallback) + "}\n" + relay("reader", "from: correction, to: copy"),
                            "test.yaml"),
        options, own_client);
    const bool writes = std::string_view(fallback).starts_with("trims");
    EXPECT_EQ(alone.step(tick(1)), writes ? 0 : 1) << fallback;
    EXPECT_EQ(alone.fault_behind("copy") == nullptr, writes) << fallback;
  }
}

TEST_F(ContainmentTest, LeftOutPluginIsStoodInForFromTheStart) {
  PluginManagerOptions options;
  options.robot_directory = GAITWAY_TEST_ROBOT;
  options.plugin_path = {GAITWAY_TEST_PLUGINS};
  options.stopped = {"balance"};
  manager = std::make_unique<PluginManager>(
      parse_configuration("plugins:\n  - {name: balance, library: nowhere.so}\n" +
                              relay("reader", "from: correction, to: copy"),
                          "test.yaml"),
      options, client);
  EXPECT_EQ(step(), 0);
  EXPECT_EQ(correction().stamp_ns, tick(1).now_ns);
  EXPECT_EQ(correction().turn_rate_offset, 0.0);
  EXPECT_EQ(manager->timings()[0].state, ServiceState::stopped);
  EXPECT_THAT(texts(EventKind::warning), testing::ElementsAre("stopped; fallbacks write correction, trim"));
  options.stopped = {"balanc"};
  msgclient::MemoryBlock empty;
  msgclient::Client alone = empty.local_client("main_controller");
  EXPECT_THROW(PluginManager(parse_configuration("plugins:\n  - {name: balance, library: nowhere.so}\n", "t"),
                             options, alone),
               PluginError);
}

}  // namespace
}  // namespace gaitway::core
