// What happened is in the file at once, within bounds; a full disk costs lines, and says so.
#include "tools/robot/keeper/event_log.hpp"

#include <gmock/gmock.h>

#include <filesystem>

#include "command_run.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

TEST(EventFile, IsBoundedAndKeepsTheNewestLines) {
  const process::PrivateFolder folder("gaitway_events");
  const std::filesystem::path file = folder.path() / "events.log";
  EventFile events(file, 2'000);
  for (int line = 0; line < 500; ++line) {
    events.tell("event " + std::to_string(line));
    ASSERT_THAT(test::text_of(file), HasSubstr("event " + std::to_string(line) + "\n"))
        << "it is there at once";
  }
  EXPECT_LT(std::filesystem::file_size(file), 2'100u);
  EXPECT_LT(std::filesystem::file_size(file.string() + ".1"), 2'100u);
  EXPECT_THAT(test::text_of(file.string() + ".1") + test::text_of(file),
              testing::AllOf(HasSubstr("event 470\n"), HasSubstr("event 499\n")));
}

TEST(EventFile, AFullDiskCostsLinesWhichIsTold) {
  const process::PrivateFolder folder("gaitway_events");
  const std::filesystem::path file = folder.path() / "events.log";
  std::filesystem::create_symlink("/dev/full", file);  // takes nothing
  EventFile events(file);
  events.tell("one");
  events.tell("two");
  EXPECT_EQ(events.lost(), 2u);
  std::filesystem::remove(file);
  events.tell("three");
  EXPECT_EQ(events.lost(), 0u);
  EXPECT_THAT(test::text_of(file),
              testing::AllOf(HasSubstr(" 2 lines before this one could not be written\n"),
                             HasSubstr(" three\n"), testing::Not(HasSubstr("one\n"))));
}

}  // namespace
}  // namespace gaitway::tools
