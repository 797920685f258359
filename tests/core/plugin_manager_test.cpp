// Order, values of this tick and of the one before, faults, statistics.
#include "gaitway/manager/plugin_manager.hpp"

#include <gmock/gmock.h>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class PluginManagerTest : public PluginFixture {
 protected:
  static std::vector<std::string> names(const PluginManager& manager) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < manager.size(); ++i) {
      result.push_back(manager.plugin(i).name());
    }
    return result;
  }
  double value(const std::string& topic) {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>(topic).read(correction));
    return correction.com_offset[0];
  }
};

TEST_F(PluginManagerTest, StepsReadersAfterWritersAndOtherwiseInConfigurationOrder) {
  const auto manager = load(relay("last", "from: b, to: c") + relay("free", "to: d") +
                            relay("middle", "from: a, to: b") + relay("first", "to: a"));
  EXPECT_THAT(names(*manager), ElementsAre("free", "first", "middle", "last"));
}

TEST_F(PluginManagerTest, ReadsGetsTheValueOfThisTick) {
  const auto manager = load(relay("reader", "from: a, to: b, add: 100") + relay("source", "to: a"));
  manager->step(tick(1));
  EXPECT_EQ(value("b"), 101.0);
  manager->step(tick(2));
  EXPECT_EQ(value("b"), 102.0);
}

// Whatever the order of the steps: here the writer is stepped before the reader.
TEST_F(PluginManagerTest, ReadsPreviousGetsTheValueOfTheTickBefore) {
  const auto manager =
      load(relay("source", "to: a") + relay("reader", "from: a, access: reads_previous, to: b"));
  manager->step(tick(1));
  EXPECT_EQ(value("b"), -1.0);  // there was none
  manager->step(tick(2));
  EXPECT_EQ(value("b"), 1.0);
  manager->step(tick(3));
  EXPECT_EQ(value("b"), 2.0);
}

TEST_F(PluginManagerTest, ReadsPreviousBreaksACycle) {
  const auto manager = load(relay("forward", "from: y, access: reads_previous, to: x, add: 1") +
                            relay("back", "from: x, to: y, add: 10"));
  manager->step(tick(1));
  EXPECT_EQ(value("x"), 0.0);  // -1 + 1
  EXPECT_EQ(value("y"), 10.0);
  manager->step(tick(2));
  EXPECT_EQ(value("x"), 11.0);
  EXPECT_EQ(value("y"), 21.0);
}

TEST_F(PluginManagerTest, OptionalInputOfTheTickBeforeMayBeMissingAndOrdersNothing) {
  EXPECT_EQ(refusal(relay("reader", "from: a, access: reads_previous_optional, to: b")), "");
  const auto manager =
      load(relay("reader", "from: a, access: reads_previous_optional, to: b") + relay("source", "to: a"));
  EXPECT_THAT(names(*manager), ElementsAre("reader", "source"));
  manager->step(tick(1));
  EXPECT_EQ(value("b"), -1.0);
  manager->step(tick(2));
  EXPECT_EQ(value("b"), 1.0);
  EXPECT_NO_THROW(static_cast<void>(manager->changes().prepare_removal("source")));
}

TEST_F(PluginManagerTest, OptionalInputMayBeMissingAndOrdersWhenItIsThere) {
  EXPECT_EQ(refusal(relay("reader", "from: a, access: reads_optional, to: b")), "");
  const auto manager =
      load(relay("reader", "from: a, access: reads_optional, to: b") + relay("source", "to: a"));
  EXPECT_THAT(names(*manager), ElementsAre("source", "reader"));
}

TEST_F(PluginManagerTest, TopicOfAnotherProcessIsRead) {
  auto writer = other.write<Correction>("a");
  const auto manager = load(relay("reader", "from: a, to: b"));
  Correction correction{};
  correction.com_offset[0] = 7.0;
  writer.publish(correction, 0);
  manager->step(tick(1));
  EXPECT_EQ(value("b"), 7.0);
}

TEST_F(PluginManagerTest, BatchPluginIsSteppedAtBatchTicksOnly) {
  const auto manager = load(relay("slow", "to: a, every_batch: true"));
  for (std::uint32_t i = 0; i < 24; ++i) {
    manager->step(tick(i));
  }
  EXPECT_EQ(manager->timings()[0].steps, 3U);
  EXPECT_EQ(value("a"), 22.0);
}

TEST_F(PluginManagerTest, ThrowInStepPublishesNothingAndIsReported) {
  const auto manager = load("  - {name: thrower, library: throws_in_step.so}\n");
  EXPECT_EQ(manager->step(tick(1)), 0);
  EXPECT_EQ(manager->step(tick(2)), 0);
  EXPECT_EQ(manager->fault_behind("out"), nullptr);
  EXPECT_EQ(manager->step(tick(3)), 1);
  EXPECT_EQ(value("out"), 2.0);  // what it published before it threw did not go out
  ASSERT_NE(manager->fault_behind("out"), nullptr);
  EXPECT_EQ(manager->step(tick(4)), 1);
  EXPECT_EQ(manager->step(tick(5)), 0);
  EXPECT_EQ(value("out"), 5.0);  // it is stepped on
  EXPECT_EQ(manager->timings()[0].faults, 2U);
  const EventLog& events = manager->events();
  ASSERT_EQ(events.total(), 2U);
  EXPECT_EQ(events[0].kind, EventKind::fault);
  EXPECT_EQ(events[0].source(), "thrower");
  EXPECT_EQ(events[0].tick, 3U);
  EXPECT_EQ(events[0].text(), "matrix is singular");
  EXPECT_THAT(events[1].text(), HasSubstr("no std::exception"));
}

TEST_F(PluginManagerTest, NonFiniteOutputIsNotPublished) {
  const auto manager = load("  - {name: nan, library: publishes_nan.so}\n");
  EXPECT_EQ(manager->step(tick(1)), 0);
  EXPECT_EQ(manager->step(tick(2)), 1);
  TrimCommand trim{};
  EXPECT_TRUE(other.read<TrimCommand>("out").read(trim));
  EXPECT_EQ(trim.channel_count, 1U);
  EXPECT_THAT(std::string(manager->events()[0].text()),
              HasSubstr("topic 'out': field 'gain'[1][27] is not finite"));
}

// A fault spoils what depends on it in the same tick, and nothing else.
TEST_F(PluginManagerTest, FaultIsBehindTheTopicsThatDependOnIt) {
  const auto manager =
      load("  - {name: thrower, library: throws_in_step.so}\n" + relay("reader", "from: out, to: b") +
           relay("next", "from: b, to: c") + relay("later", "from: c, access: reads_previous, to: d") +
           relay("free", "to: e"));
  manager->step(tick(3));
  ASSERT_NE(manager->fault_behind("c"), nullptr);
  EXPECT_EQ(manager->fault_behind("c")->name(), "thrower");
  EXPECT_EQ(manager->fault_behind("d"), nullptr);
  EXPECT_EQ(manager->fault_behind("e"), nullptr);
  manager->step(tick(5));
  EXPECT_EQ(manager->fault_behind("c"), nullptr);
}

TEST_F(PluginManagerTest, ParametersComeFromTheConfigurationOrTheDefault) {
  const auto manager = load(
      "  - {name: p, library: parameters.so, parameters: {step_time: 0.5 s, share: 0.2, steps: 7, mirror: "
      "false, solver: "
      "kdl}}\n");
  manager->step(tick(0));
  Correction c{};
  ASSERT_TRUE(other.read<Correction>("out").read(c));
  EXPECT_EQ(c.com_offset[0], 0.5);
  EXPECT_EQ(c.com_offset[1], 0.2);
  EXPECT_EQ(c.step_offset[0], 7.0);
  EXPECT_EQ(c.step_offset[1], 0.0);
  EXPECT_EQ(c.turn_rate_offset, 2.0);
  const auto& declared = manager->plugin(0).parameters().declared();
  ASSERT_EQ(declared.size(), 5U);
  EXPECT_EQ(declared[0].name, "step_time");
  EXPECT_EQ(declared[0].unit, "s");
  EXPECT_EQ(declared[0].fallback, "0.4");
  EXPECT_EQ(declared[0].value, "0.5");
}

TEST_F(PluginManagerTest, PluginReportsEvents) {
  const auto manager = load("  - {name: p, library: parameters.so}\n");
  manager->step(tick(9));
  ASSERT_EQ(manager->events().total(), 1U);
  EXPECT_EQ(manager->events()[0].kind, EventKind::warning);
  EXPECT_EQ(manager->events()[0].source(), "p");
  EXPECT_EQ(manager->events()[0].text(), "battery is low");
  EXPECT_EQ(manager->events()[0].stamp_ns, tick(9).now_ns);
}

TEST_F(PluginManagerTest, PluginInPlainC) {
  const auto manager = load("  - {name: c, library: plain_c.so, parameters: {fail_at: 2}}\n");
  EXPECT_EQ(manager->step(tick(0)), 0);
  EXPECT_EQ(manager->step(tick(1)), 1);
  EXPECT_EQ(manager->step(tick(2)), 0);
  WalkCommand count{};
  ASSERT_TRUE(other.read<WalkCommand>("count").read(count));
  EXPECT_EQ(count.walk, 3U);
  EXPECT_EQ(manager->events()[0].text(), "step 2 of C failed");
}

TEST_F(PluginManagerTest, PeriodAndPhaseSayWhoseTurnItIs) {
  const auto manager = load("  - {name: slow, library: counter.so, period: 40 ms, phase: 20 ms}\n" +
                            relay("fast", "from: out, to: copy"));
  std::vector<double> values;
  for (std::uint32_t i = 0; i < 12; ++i) {
    manager->step(tick(i));
    Correction correction{};
    other.read<Correction>("copy").read(correction);
    values.push_back(correction.com_offset[0]);
  }
  EXPECT_THAT(values, testing::ElementsAre(-1, -1, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3));
}

TEST_F(PluginManagerTest, PeriodThatCannotBeKeptIsRefused) {
  const auto complaint = [&](const std::string& keys) {
    return refusal("  - {name: slow, library: counter.so, " + keys + "}\n");
  };
  EXPECT_THAT(complaint("period: 15 ms"), testing::HasSubstr("must be a multiple of the tick of 10 ms"));
  EXPECT_THAT(complaint("period: 2 s"), testing::HasSubstr("must lie between 10 ms and 1 s"));
  EXPECT_THAT(complaint("period: 40"), testing::HasSubstr("with its unit"));
  EXPECT_THAT(complaint("period: 40 ms, phase: 40 ms"), testing::HasSubstr("must be less than the period"));
  EXPECT_THAT(
      refusal("  - {name: slow, library: relay.so, period: 40 ms, parameters: {to: a, every_batch: true}}\n"),
      testing::HasSubstr("plug-in 'slow' (test.yaml:2): is stepped once a batch"));
}

TEST_F(PluginManagerTest, StatisticsGoOutEveryBatch) {
  const auto manager =
      load("  - {name: thrower, library: throws_in_step.so}\n" + relay("slow", "to: a, every_batch: true"));
  for (std::uint32_t i = 0; i < 8; ++i) {
    manager->step(tick(i));
  }
  PluginStatistics statistics{};
  ASSERT_TRUE(other.read<PluginStatistics>("plugin_statistics").read(statistics));
  EXPECT_EQ(statistics.plugin_count, 2U);
  EXPECT_STREQ(reinterpret_cast<const char*>(statistics.name[0]), "thrower");
  EXPECT_STREQ(reinterpret_cast<const char*>(statistics.name[1]), "slow");
  EXPECT_EQ(statistics.steps[0], 7U);   // ticks 0 to 6
  EXPECT_EQ(statistics.faults[0], 4U);  // 0, 3, 4, 6
  EXPECT_EQ(statistics.steps[1], 1U);
  EXPECT_GT(statistics.worst_step_ns[0], 0);
}

}  // namespace
}  // namespace gaitway::core
