// The supervisor with parts that are no robot's: they end, hang and refuse to end in every way, and come back
// with a reason that people can read.
#include "tools/robot/keeper/robot_keeper.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstring>
#include <functional>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "page_of_another.hpp"

namespace gaitway::tools {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

constexpr const char* kWorks = "while :; do sleep 0.01; done";

class RobotKeeperTest : public testing::Test {
 protected:
  ~RobotKeeperTest() override {
    if (supervisor > 0) kill_supervisor();
    for (const PartPlan& plan : plans) {
      PartProcess process(plan.name, {}, {.folder = folders.folder, .log = folders.log});
      if (process.take_over_whatever()) process.end_group();
    }
  }
  void add(const std::string& name, const std::string& script, const std::string& needs = "") {
    plans.push_back({.name = name,
                     .words = {"/bin/sh", "-c", script},
                     .patience = {.start_ns = 5'000'000'000, .hang_ns = 400'000'000},
                     .needs = needs,
                     .end_ns = 300'000'000});
  }
  // In a process of its own, as it is in life.
  void begin() {
    supervisor = fork();
    if (supervisor != 0) return;
    int code = 9;
    try {
      const SupervisorLock lock(folders.folder);
      process::stop_on_signals();
      RobotKeeper keeper(plans, {.folders = folders,
                                 .probe_address = "127.0.0.1",
                                 .probe_port = probe_port,
                                 .quiet = true,
                                 .on_ready = {}});
      code = keeper.run() ? 0 : 2;
    } catch (const std::exception& error) {
      EventFile(folders.event_file()).tell(error.what());
    }
    _exit(code);
  }
  int end() {
    kill(supervisor, SIGTERM);
    int status = 0;
    waitpid(supervisor, &status, 0);
    supervisor = 0;
    return WIFEXITED(status) ? WEXITSTATUS(status) : 1000 + WTERMSIG(status);
  }
  void kill_supervisor() {
    kill(supervisor, SIGKILL);
    waitpid(supervisor, nullptr, 0);
    supervisor = 0;
  }
  [[nodiscard]] std::string events() const { return test::text_of(folders.event_file()); }
  [[nodiscard]] PartStatus status(const std::string& name) const {
    if (const auto whole = read_status(folders.status_file())) {
      for (const PartStatus& part : whole->parts) {
        if (part.name == name) return part;
      }
    }
    return {};
  }
  [[nodiscard]] bool comes(const std::function<bool()>& true_at_last) const {
    const std::int64_t until_ns = process::monotonic_ns() + 20'000'000'000;
    while (!true_at_last()) {
      if (process::monotonic_ns() > until_ns) return false;
      usleep(5'000);
    }
    return true;
  }
  [[nodiscard]] bool is_told(const std::string& text) const {
    return comes([&] { return events().find(text) != std::string::npos; });
  }

  process::PrivateFolder own{"gaitway_keeper"};
  RobotFolders folders{.folder = own.path(), .log = own.path()};
  std::vector<PartPlan> plans;
  pid_t supervisor = 0;
  int probe_port = 0;
};

TEST_F(RobotKeeperTest, WhateverEndsAPartItIsBackAndTheReasonIsTold) {
  const std::string once = (own.path() / "once").string();
  for (const char* const how : {"exit 1", "exit 3", "exit 4", "exit 0", "kill -SEGV $$"}) {
    const std::string name = std::string("part_") + std::to_string(plans.size());
    const std::string mark = once + name;
    add(name, "if ! [ -e " + mark + " ]; then touch " + mark +
                  "; for i in 1 2 3 4 5 6 7 8 9 10 11 12 13 14 15 16 17 18 "
                  "19 20; do sleep 0.02; done; echo '" +
                  name + ": for a reason' >&2; " + how + "; fi; " + kWorks);
  }
  begin();
  for (std::size_t i = 0; i < plans.size(); ++i) {
    EXPECT_TRUE(is_told("part_" + std::to_string(i) + ": works again")) << events();
  }
  EXPECT_THAT(events(), HasSubstr("part_0: ended with code 1: for a reason. It is started again at once"));
  EXPECT_THAT(events(), HasSubstr("part_1: ended with code 3: for a reason"));
  EXPECT_THAT(events(), HasSubstr("part_2: ended with code 4: for a reason"));
  EXPECT_THAT(events(), HasSubstr("part_3: ended with code 0: for a reason"));
  EXPECT_THAT(events(), HasSubstr("part_4: was ended by signal 11 (Segmentation fault): for a reason"));
  EXPECT_TRUE(comes([&] { return status("part_4").restarts == 1 && status("part_4").state == "works"; }));
  EXPECT_THAT(status("part_1").reason, HasSubstr("ended with code 3: for a reason"));
  EXPECT_EQ(end(), 0) << events();
  EXPECT_EQ(status("part_0").state, "off");
}

TEST_F(RobotKeeperTest, APartThatIsStoppedIsEndedAndStartedAgain) {
  add("dummy", kWorks);
  begin();
  ASSERT_TRUE(is_told("dummy: works"));
  ASSERT_TRUE(comes([&] { return status("dummy").process > 0; }));
  const pid_t first = status("dummy").process;
  kill(first, SIGSTOP);
  EXPECT_TRUE(is_told("dummy: works again")) << events();
  EXPECT_THAT(events(),
              ContainsRegex("dummy: made no progress for [0-9]+ ms and was ended: it was stopped "));
  EXPECT_TRUE(comes([&] { return status("dummy").process != first; }));
  EXPECT_EQ(end(), 0);
}

TEST_F(RobotKeeperTest, StartsInOrderAndEndsInTheReverse) {
  add("last", kWorks, "first");
  add("first", "sleep 0.2; " + std::string(kWorks));
  std::swap(plans[0], plans[1]);
  begin();
  ASSERT_TRUE(is_told("last: works"));
  EXPECT_EQ(end(), 0);
  const std::string told = events();
  EXPECT_LT(told.find("first: works"), told.find("last: works"));
  EXPECT_LT(told.find("last: ended"), told.find("first: ended")) << told;
}

TEST_F(RobotKeeperTest, WhoDoesNotEndIsKilledWhichIsTold) {
  add("stubborn", "trap '' TERM; " + std::string(kWorks));
  begin();
  ASSERT_TRUE(is_told("stubborn: works"));
  EXPECT_EQ(end(), 2);
  EXPECT_THAT(events(), HasSubstr("stubborn: did not end within 0.3 s when it was told to and was killed"));
}

TEST_F(RobotKeeperTest, PartsOutliveTheirSupervisorAndTheNextOneTakesThemOver) {
  add("dummy", kWorks);
  begin();
  ASSERT_TRUE(comes([&] { return status("dummy").state == "works"; }));
  const pid_t part = status("dummy").process;
  kill_supervisor();
  EXPECT_EQ(kill(part, 0), 0);
  EXPECT_EQ(SupervisorLock::holder(folders.folder), 0);
  begin();
  EXPECT_TRUE(is_told("parts are taken over: dummy (process " + std::to_string(part) + ")")) << events();
  ASSERT_TRUE(comes([&] { return status("dummy").state == "works"; }));
  EXPECT_EQ(status("dummy").process, part);
  kill(part, SIGKILL);
  EXPECT_TRUE(is_told("dummy: works again")) << events();
  EXPECT_EQ(end(), 0);
}

// Its port is another robot's: a page that answers there is no sign of this part's work.
TEST_F(RobotKeeperTest, AnotherProgramsPageIsNoWorkOfTheInterface) {
  const test::PageOfAnother other;
  probe_port = other.port();
  add("interface", kWorks);
  plans[0].progress = Progress::answers;
  plans[0].patience = {.start_ns = 1'500'000'000, .hang_ns = 1'500'000'000};
  begin();
  ASSERT_TRUE(is_told("interface: made no progress")) << events();
  EXPECT_THAT(events(), testing::Not(HasSubstr("interface: works")));
  const std::string owner = "process " + std::to_string(getpid()) + " (robot_keeper_tests)";
  EXPECT_THAT(events(), HasSubstr("interface: port " + std::to_string(probe_port) + " is taken: " + owner));
  const std::string why = ". Port " + std::to_string(probe_port) + " is taken by " + owner;
  EXPECT_TRUE(comes([&] { return status("interface").reason.find(why) != std::string::npos; }))
      << status("interface").reason;
  EXPECT_EQ(end(), 0);
}

TEST_F(RobotKeeperTest, ASecondSupervisorIsRefusedByName) {
  add("dummy", kWorks);
  begin();
  ASSERT_TRUE(is_told("dummy: works"));
  try {
    const SupervisorLock second(folders.folder);
    FAIL() << "there are two";
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), HasSubstr("its supervisor is process " + std::to_string(supervisor)));
    EXPECT_THAT(error.what(), HasSubstr("gaitway robot down"));
  }
  EXPECT_EQ(end(), 0);
}

TEST(RobotStatus, IsReadAsItWasWritten) {
  const process::PrivateFolder folder("gaitway_status");
  const std::filesystem::path file = folder.path() / "status.json";
  EXPECT_FALSE(read_status(file));
  RobotStatus status{.supervisor = 7,
                     .written_ns = 5,
                     .may_be_commanded = true,
                     .why_not = "",
                     .commander = "",
                     .events = "e",
                     .parts = {}};
  status.parts.push_back(
      {.name = "a", .state = "works", .process = 8, .restarts = 3, .reason = "by \xFF signal"});
  ASSERT_TRUE(write_status(file, status));
  const auto read = read_status(file);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->all_work());
  EXPECT_EQ(read->parts.at(0).restarts, 3u);
  EXPECT_THAT(status_table(*read, true, 5'000'000'005), HasSubstr("may be commanded, for 5.0 s"));
  EXPECT_THAT(status_table(*read, false, 5), HasSubstr("supervisor         GONE"));
  EXPECT_THAT(status_text(*read, true, 5), HasSubstr("\"supervised\": true"));
}

TEST(RobotStatus, SaysWhyTheRobotMayNotBeCommandedAndWhenAPartEndedLast) {
  RobotStatus status{.written_ns = 5,
                     .why_not = "an emergency stop is in force",
                     .commander = "a person",
                     .events = "",
                     .parts = {}};
  status.parts.push_back(
      {.name = "a", .state = "works", .process = 8, .reason = "hung", .last_end_ns = 1'000'000'000});
  const process::PrivateFolder folder("gaitway_status");
  ASSERT_TRUE(write_status(folder.path() / "status.json", status));
  const auto read = read_status(folder.path() / "status.json");
  ASSERT_TRUE(read);
  const std::string table = status_table(*read, true, 4'200'000'000);
  EXPECT_THAT(table, HasSubstr("may NOT be commanded now: an emergency stop is in force\n"));
  EXPECT_THAT(table, HasSubstr("command            a person\n"));
  EXPECT_THAT(table, HasSubstr(" 3.2 s ago: hung\n"));
  const std::string text = status_text(*read, true, 4'200'000'000);
  EXPECT_THAT(text, HasSubstr("\"last_end_age_s\": 3.2"));
  EXPECT_THAT(text, ContainsRegex("\"last_end\": \"20[0-9-]+T[0-9:.]+Z\""));
}

}  // namespace
}  // namespace gaitway::tools
