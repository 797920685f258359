// A copy of the process is heard, and its failures are handed on.
#include "gaitway/process/working_copy.hpp"

#include <gmock/gmock.h>
#include <signal.h>
#include <unistd.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace gaitway::process {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

TEST(WorkingCopy, IsHeardUntilItIsDone) {
  const std::string text(100'000, 'x');  // more than a pipe holds
  WorkingCopy copy([&](const WorkingCopy::Tell& tell) {
    tell("first");
    tell(text);
  });
  std::vector<std::string> heard;
  while (!copy.done()) {
    for (std::string& line : copy.listen()) heard.push_back(std::move(line));
  }
  EXPECT_THAT(heard, ElementsAre("first", text));
}

// What listen() throws in the end.
std::string failure_of(WorkingCopy copy) {
  try {
    while (!copy.done()) (void)copy.listen();
  } catch (const std::runtime_error& error) {
    return error.what();
  }
  return {};
}

TEST(WorkingCopy, HandsOnWhatItsWorkThrowsAndHowItsProcessEnds) {
  const auto throws = [](const WorkingCopy::Tell&) {
    throw std::invalid_argument("line 3:\n  no such joint");
  };
  EXPECT_EQ(failure_of(WorkingCopy(throws)), "line 3:\n  no such joint");
  EXPECT_THAT(failure_of(WorkingCopy([](const WorkingCopy::Tell&) { raise(SIGKILL); })), HasSubstr("Killed"));
  EXPECT_THAT(failure_of(WorkingCopy([](const WorkingCopy::Tell&) { _exit(7); })), HasSubstr("code 7"));
}

TEST(WorkingCopy, EndsWithItsOwner) {
  pid_t process = 0;
  {
    WorkingCopy copy([](const WorkingCopy::Tell& tell) {
      tell(std::to_string(getpid()));
      pause();
    });
    process = std::stoi(copy.listen().at(0));
    EXPECT_EQ(kill(process, 0), 0);
  }
  EXPECT_NE(kill(process, 0), 0);
}

}  // namespace
}  // namespace gaitway::process
