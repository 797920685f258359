// Plug-ins are replaced, loaded and unloaded between two batches; what goes wrong leaves the old one in
// place.
#include <gmock/gmock.h>

#include <atomic>
#include <map>
#include <thread>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

// Ticks 6 and 14 prepare batches.
class PluginChangeTest : public PluginFixture {
 protected:
  static std::string counter(const std::string& name, const std::string& parameters) {
    return "  - {name: " + name + ", library: counter.so, parameters: {" + parameters + "}}\n";
  }
  static PluginEntry entry(const std::string& plugin) {
    return parse_configuration("plugins:\n" + plugin, "new.yaml").plugins.front();
  }
  double value(const std::string& topic) {
    Correction correction{};
    EXPECT_TRUE(other.read<Correction>(topic).read(correction));
    return correction.com_offset[0];
  }
  // The values of topic `out` after each of these ticks.
  std::vector<double> run(PluginManager& manager, std::uint32_t first, std::uint32_t last,
                          const std::string& topic = "out") {
    std::vector<double> values;
    for (std::uint32_t number = first; number <= last; ++number) {
      manager.step(tick(number));
      values.push_back(value(topic));
    }
    return values;
  }
  static std::vector<std::string> names(const PluginManager& manager) {
    std::vector<std::string> result;
    for (std::size_t i = 0; i < manager.size(); ++i) {
      result.push_back(manager.plugin(i).name());
    }
    return result;
  }
  template <class Action>
  static std::string complaint(const Action& action) {
    try {
      action();
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "nothing";
  }
};

TEST_F(PluginChangeTest, TheNewOneGoesOnFromTheStateOfTheOldAtABatchEdge) {
  const auto manager = load(counter("c", "") + relay("r", "from: out, to: copy"));
  EXPECT_THAT(run(*manager, 4, 4), ElementsAre(1));
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry(counter("c", "offset: 100 m")))));
  EXPECT_THAT(run(*manager, 5, 7), ElementsAre(2, 103, 104));
  EXPECT_EQ(value("copy"), 104) << "those that depend on it see the new one's value in the same tick";
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->done) << result->text;
  EXPECT_THAT(result->text, HasSubstr("8 bytes of state handed on"));
  EXPECT_THAT(run(*manager, 8, 8), ElementsAre(105));
}

TEST_F(PluginChangeTest, AHundredTimesInARow) {
  const auto manager = load(counter("c", ""));
  for (std::uint32_t batch = 0; batch < 100; ++batch) {
    ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_replacement(entry(counter("c", "")))));
    const std::uint32_t first = batch * 8;
    ASSERT_EQ(run(*manager, first, first + 7).back(), first + 8.0);
    ASSERT_TRUE(manager->changes().take_result()->done);
  }
}

TEST_F(PluginChangeTest, StateOfAnotherVersionOrSizeIsRefusedAndTheOldOneGoesOn) {
  const auto manager = load(counter("c", ""));
  for (const auto& [parameters, reason] :
       {std::pair{"state_version: 2", "takes over state of version 2, but was handed version 1"},
        std::pair{"longer_state: true", "is too short"}}) {
    const double before = run(*manager, 5, 5).front();
    ASSERT_TRUE(
        manager->changes().schedule(manager->changes().prepare_replacement(entry(counter("c", parameters)))));
    EXPECT_THAT(run(*manager, 6, 7), ElementsAre(before + 1, before + 2));
    const auto result = manager->changes().take_result();
    ASSERT_TRUE(result);
    EXPECT_FALSE(result->done);
    EXPECT_THAT(result->text, AllOf(HasSubstr("refuses the state"), HasSubstr(reason)));
  }
}

TEST_F(PluginChangeTest, EveryVersionMayReportUntilItIsDestroyed) {
  const auto manager = load(counter("c", ""));
  const auto told = [&] {
    std::vector<std::string> texts;
    for (std::uint64_t i = manager->events().first(); i < manager->events().total(); ++i) {
      if (manager->events()[i].source() == "c" && manager->events()[i].kind == EventKind::info) {
        texts.emplace_back(manager->events()[i].text());
      }
    }
    return texts;
  };
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry(counter("c", "state_version: 2, reports: true")))));
  run(*manager, 6, 6);
  EXPECT_FALSE(manager->changes().take_result()->done) << "it is destroyed here, and has its say";
  run(*manager, 7, 7);
  EXPECT_THAT(told(), ElementsAre("activated", "deactivated", "destroyed"));
}

// As in the main controller: one thread ticks, the other prepares and destroys.
TEST_F(PluginChangeTest, WhoLeavesReportsFromTheOtherThreadAndNoEventIsLost) {
  constexpr int kChanges = 20;
  const auto manager = load(counter("c", "reports: true"));
  std::atomic<PluginChange*> prepared = nullptr;
  std::atomic<PluginChange*> remains = nullptr;
  std::thread workshop([&] {
    for (int i = 0; i < kChanges; ++i) {
      prepared.store(manager->changes().prepare_reload("c").release());
      prepared.notify_one();
      remains.wait(nullptr);
      delete remains.exchange(nullptr);
    }
  });
  std::map<std::string, int> told;
  std::uint64_t next = 0;
  const auto listen = [&] {
    for (; next < manager->events().total(); ++next) {
      ++told[std::string(manager->events()[next].text())];
    }
  };
  int done = 0;
  for (std::uint32_t number = 1; done < kChanges; ++number) {
    manager->step(tick(number));
    if (PluginChange* const change = prepared.exchange(nullptr)) {
      ASSERT_TRUE(manager->changes().schedule(std::unique_ptr<PluginChange>(change)));
    }
    if (auto result = manager->changes().take_result()) {
      EXPECT_TRUE(result->done) << result->text;
      ++done;
      remains.store(result->remains.release());
      remains.notify_one();
    }
    manager->events().add(0, number, EventKind::warning, "tick", "ticks");
    listen();
    told.erase("stepped");
  }
  workshop.join();
  manager->step(tick(0));
  listen();
  EXPECT_EQ(told["activated"], kChanges + 1);
  EXPECT_EQ(told["deactivated"], kChanges);
  EXPECT_EQ(told["destroyed"], kChanges);
}

TEST_F(PluginChangeTest, OneThatFailsInItsFirstStepIsTakenBackInTheSameTick) {
  const auto manager = load(counter("c", "") + relay("r", "from: out, to: copy"));
  run(*manager, 5, 5);
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry(counter("c", "failing_step: 1, offset: 100 m")))));
  EXPECT_THAT(run(*manager, 6, 7), ElementsAre(2, 3)) << "no step of the old one is left out";
  EXPECT_EQ(value("copy"), 3);
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result);
  EXPECT_FALSE(result->done);
  EXPECT_THAT(result->text, HasSubstr("the new one failed in its first step: cannot count"));
  EXPECT_THAT(run(*manager, 8, 8), ElementsAre(4));
}

TEST_F(PluginChangeTest, OneWhoseWorkIsOfNoUseIsTakenBackWithAllThatDependsOnIt) {
  const auto manager = load(counter("c", "") + relay("r", "from: out, to: copy") + counter("other", "to: x"));
  run(*manager, 5, 5);
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry(counter("c", "offset: 100 m")))));
  manager->step(tick(6));
  EXPECT_EQ(value("copy"), 102);
  EXPECT_TRUE(manager->take_trial_back(tick(6), "the plan breaks a rule"));
  EXPECT_EQ(value("copy"), 2);
  EXPECT_EQ(value("x"), 2) << "who does not depend on it is not stepped again";
  const auto result = manager->changes().take_result();
  ASSERT_TRUE(result);
  EXPECT_THAT(result->text, HasSubstr("the plan breaks a rule"));
  EXPECT_FALSE(manager->take_trial_back(tick(7), "nothing is on trial"));
  EXPECT_THAT(run(*manager, 7, 8, "copy"), ElementsAre(3, 4));
}

TEST_F(PluginChangeTest, WhatCannotBePreparedChangesNothing) {
  const auto manager = load(counter("c", "") + relay("r", "from: out, to: copy"));
  const auto prepare = [&](const std::string& plugin) {
    return complaint([&] { (void)manager->changes().prepare_replacement(entry(plugin)); });
  };
  EXPECT_THAT(prepare(counter("c", "throws: true")), HasSubstr("no room for a counter"));
  EXPECT_THAT(prepare(counter("c", "offest: 1 m")), HasSubstr("Did you mean 'offset'?"));
  EXPECT_THAT(prepare(counter("c", "offset: 11000 m")), HasSubstr("must be from -10 to 10000 m"));
  EXPECT_THAT(prepare("  - {name: c, library: other_abi.so}\n"), HasSubstr("ABI"));
  EXPECT_THAT(prepare("  - {name: c, library: missing_symbol.so}\n"), HasSubstr("gaitway_plugin_entry"));
  EXPECT_THAT(prepare("  - {name: c, library: throws_in_activate.so}\n"), HasSubstr("nobody writes it"));
  EXPECT_THAT(prepare(counter("c", "to: elsewhere")),
              HasSubstr("'r' reads topic 'out', but nobody writes it"));
  EXPECT_THAT(prepare(counter("second", "")), HasSubstr("two writers"));
  EXPECT_THAT(complaint([&] { (void)manager->changes().prepare_removal("c"); }),
              HasSubstr("nobody writes it"));
  EXPECT_THAT(complaint([&] { (void)manager->changes().prepare_removal("d"); }), HasSubstr("no plug-in 'd'"));
  EXPECT_THAT(run(*manager, 5, 7, "copy"), ElementsAre(1, 2, 3));
}

// Each is tried in a process of its own before its code runs in this one.
TEST_F(PluginChangeTest, OneThatCrashesOrHangsIsRefusedAndTheOldOneGoesOn) {
  isolation.start_limit_ns = isolation.watchdog_ns = 300'000'000;
  const auto manager = load(counter("c", ""));
  const auto prepare = [&](const std::string& library, const std::string& parameters) {
    return complaint([&] {
      (void)manager->changes().prepare_replacement(
          entry("  - {name: c, library: " + library + ".so, parameters: {" + parameters + "}}\n"));
    });
  };
  EXPECT_THAT(prepare("crashes_in_constructor", ""),
              HasSubstr("was ended by SIGABRT while it constructed the plug-in"));
  EXPECT_THAT(prepare("hangs_in_constructor", ""), HasSubstr("has not constructed the plug-in within 0.3 s"));
  for (const char* const how : {"segfault", "abort", "exit", "loop"}) {
    EXPECT_THAT(prepare("misbehaves", std::string("at: 6, how: ") + how),
                HasSubstr("tried in a process of its own: "))
        << how;
  }
  EXPECT_THAT(run(*manager, 5, 7), ElementsAre(1, 2, 3));
}

TEST_F(PluginChangeTest, AtTheStartTooOneThatCrashesOrHangsIsRefusedWhenAskedFor) {
  isolation.start_limit_ns = 300'000'000;
  try_at_start = true;
  for (const char* const library : {"crashes_in_constructor", "hangs_in_constructor"}) {
    EXPECT_THAT(refusal(std::string("  - {name: c, library: ") + library + ".so}\n"),
                AllOf(HasSubstr("plug-in 'c' (test.yaml:2)"), HasSubstr("constructed the plug-in")));
  }
  EXPECT_EQ(refusal(counter("c", "")), "");
}

TEST_F(PluginChangeTest, PlugInsComeAndGo) {
  const auto manager = load(counter("c", ""));
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry(relay("r", "from: out, to: copy")))));
  EXPECT_FALSE(manager->changes().schedule(manager->changes().prepare_removal("c")))
      << "one change at a time";
  run(*manager, 5, 6);
  EXPECT_EQ(value("copy"), 2);
  EXPECT_FALSE(manager->changes().take_result()) << "on trial";
  run(*manager, 7, 7);
  EXPECT_TRUE(manager->changes().take_result()) << "the trial ends with the next step at the latest";
  EXPECT_THAT(names(*manager), ElementsAre("c", "r"));
}

TEST_F(PluginChangeTest, LiveParametersChangeBetweenTwoSteps) {
  const auto manager = load(counter("c", ""));
  run(*manager, 1, 1);
  manager->changes().set_parameter("c", "offset", "0.5 m");
  EXPECT_THAT(run(*manager, 2, 2), ElementsAre(2.5));
  ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload("c")));
  EXPECT_THAT(run(*manager, 6, 6), ElementsAre(3.5)) << "a reload keeps it";
  ASSERT_TRUE(manager->changes().take_result() ||
              (manager->end_trial(tick(6)), manager->changes().take_result()));
  EXPECT_THAT(complaint([&] { (void)manager->changes().prepare_addition(entry(counter("c", ""))); }),
              HasSubstr("there is a plug-in 'c' already"));
  EXPECT_THAT(complaint([&] { manager->changes().set_parameter("c", "offset", "11000 m"); }),
              HasSubstr("must be from -10 to 10000 m"));
  EXPECT_THAT(complaint([&] { manager->changes().set_parameter("c", "offset", "50 ms"); }),
              HasSubstr("is in 'ms', but must be in 'm'"));
  EXPECT_THAT(complaint([&] { manager->changes().set_parameter("c", "offst", "1"); }), HasSubstr("'offset'"));
  EXPECT_THAT(complaint([&] { manager->changes().set_parameter("c", "throws", "true"); }),
              HasSubstr("does not change while the plug-in runs (offset may)"));
  EXPECT_THAT(complaint([&] { manager->changes().set_parameter("d", "offset", "1"); }),
              HasSubstr("no plug-in 'd'"));
  EXPECT_THAT(run(*manager, 7, 7), ElementsAre(4.5));
}

TEST_F(PluginChangeTest, TheFileMayBeOverwrittenAndCutOffWhileItIsInUse) {
  const std::filesystem::path file =
      std::filesystem::path(testing::TempDir()) / ("gaitway_overwritten_" + std::to_string(getpid()) + ".so");
  std::filesystem::copy_file(GAITWAY_TEST_PLUGINS "/counter.so", file);
  const auto manager = load("  - {name: c, library: " + file.string() + "}\n");
  std::filesystem::resize_file(file, 100);
  EXPECT_THAT(run(*manager, 1, 3), ElementsAre(1, 2, 3));
  EXPECT_THAT(complaint([&] {
                (void)manager->changes().prepare_replacement(
                    entry("  - {name: c, library: " + file.string() + "}\n"));
              }),
              HasSubstr("is cut off"));
  std::filesystem::copy_file(GAITWAY_TEST_PLUGINS "/counter.so", file,
                             std::filesystem::copy_options::overwrite_existing);
  ASSERT_TRUE(manager->changes().schedule(
      manager->changes().prepare_replacement(entry("  - {name: c, library: " + file.string() + "}\n"))));
  EXPECT_THAT(run(*manager, 5, 6), ElementsAre(4, 5));
  std::filesystem::remove(file);
}

}  // namespace
}  // namespace gaitway::core
