// A child that was taken over says what it likes, in any order, and hears nothing: the manager refuses it, by
// name, and goes on.
#include <gmock/gmock.h>

#include <array>
#include <chrono>
#include <cstdlib>
#include <fstream>
#include <random>
#include <string_view>
#include <thread>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class HostileChild : public PluginFixture {
 protected:
  HostileChild() {
    isolation.lock_step = false;
    setenv("GAITWAY_PLUGIN_CHILD", GAITWAY_SCRIPTED_CHILD, 1);
    setenv("GAITWAY_TEST_SCRIPT", script_.c_str(), 1);
  }
  ~HostileChild() override {
    unsetenv("GAITWAY_PLUGIN_CHILD");
    unsetenv("GAITWAY_TEST_SCRIPT");
    std::filesystem::remove(script_);
  }
  void script(const std::string& lines) const { std::ofstream(script_) << lines; }
  // What the manager complains about when it loads a plug-in whose child says this.
  std::string complaint(const std::string& lines) {
    script(lines);
    return refusal("  - {name: it, library: relay.so, isolation: process}\n");
  }
  // A plug-in whose child is a real one until it aborts in tick 3, or in the first one after it that it gets;
  // the next one says `lines`.
  std::unique_ptr<PluginManager> load_until_it_ends(const std::string& lines) {
    script("REAL " GAITWAY_PLUGIN_CHILD_PROGRAM "\n" + lines);
    auto manager =
        load("  - {name: it, library: misbehaves.so, isolation: process, parameters: {how: always}}\n");
    for (std::uint32_t i = 1; i <= 3; ++i) {
      manager->step(tick(i));
    }
    return manager;
  }
  // The last error of `it` that contains `part`, after at most so many ticks.
  static std::string error_with(PluginManager& manager, std::string_view part, std::uint32_t ticks) {
    for (std::uint32_t i = 4; i < 4 + ticks; ++i) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // the child needs time, not ticks
      manager.step(tick(i));
      manager.maintain(tick(i).now_ns);
      const EventLog& events = manager.events();
      for (std::uint64_t e = events.first(); e < events.total(); ++e) {
        if (events[e].kind == EventKind::error && events[e].text().find(part) != std::string_view::npos) {
          return std::string(events[e].text());
        }
      }
    }
    return {};
  }

 private:
  std::filesystem::path script_ =
      std::filesystem::path(testing::TempDir()) / ("gaitway_script_" + std::to_string(getpid()));
};

TEST_F(HostileChild, AttachedBeforeCreatedIsRefused) {
  EXPECT_THAT(complaint("attached\nstay\n"),
              AllOf(HasSubstr("plug-in 'it' (test.yaml:2)"), HasSubstr("at the wrong time in its start")));
}

TEST_F(HostileChild, WhatComesAtTheWrongTimeIsRefused) {
  for (const char* const lines :
       {"created\ncreated\n", "created\nhear\nhear\nopen_topic\n", "created\nparameter\n",
        "created\nset_period\n", "created\nconstructor_failed\n"}) {
    EXPECT_THAT(complaint(std::string(lines) + "stay\n"), HasSubstr("at the wrong time in its start"))
        << lines;
  }
  EXPECT_THAT(complaint("1\nstay\n"), HasSubstr("that no plug-in's process sends"));
  EXPECT_THAT(complaint("77\nstay\n"), HasSubstr("that no plug-in's process sends"));
}

TEST_F(HostileChild, WhateverItSaysInWhateverOrderIsSurvived) {
  constexpr std::array<const char*, 10> kWords{"open_topic", "parameter",         "set_period", "report",
                                               "created",    "library_failed",    "attached",   "3",
                                               "4000000000", "constructor_failed"};
  for (unsigned seed = 1; seed <= 100; ++seed) {
    SCOPED_TRACE("seed " + std::to_string(seed));
    std::mt19937 random(seed);
    std::string lines = "hear\n";
    for (unsigned i = 0; i < 1 + seed % 8; ++i) {
      lines += std::string(kWords[random() % kWords.size()]) + "\n";
    }
    EXPECT_THAT(complaint(lines), HasSubstr("plug-in 'it' (test.yaml:2)")) << lines;
  }
}

TEST_F(HostileChild, OneThatHearsNoAnswerKeepsNoTickWaiting) {
  const auto manager = load_until_it_ends("hear\nask 100000\nstay\n");
  EXPECT_THAT(error_with(*manager, "cannot be replaced", 5000),
              HasSubstr("does not read what it is answered"));
}

TEST_F(HostileChild, OneThatHangsUpAndLivesOnIsRefused) {
  isolation.start_limit_ns = 3'000'000'000;
  EXPECT_THAT(complaint("hear\nhang up\n"), HasSubstr("closed its connection to the manager"));
}

TEST_F(HostileChild, OneThatDeclaresWithoutEndIsRefused) {
  std::string lines = "hear\n";
  for (int i = 0; i < 1025; ++i) {
    lines += "parameter\nhear\n";
  }
  const auto manager = load_until_it_ends(lines + "created\nhear\nattached\nstay\n");
  EXPECT_THAT(error_with(*manager, "cannot be replaced", 5000), HasSubstr("more than 1024"));
}

}  // namespace
}  // namespace gaitway::core
