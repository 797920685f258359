// The options of the three programs of a real robot: what is no number in range is refused before anything
// moves.
#include <gmock/gmock.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <string>

namespace gaitway::input {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::string kMessageController =
    GAITWAY_MESSAGE_CONTROLLER " --robot /nowhere --bus /nowhere --memory /nowhere ";
const std::string kVirtualRobot = GAITWAY_VIRTUAL_ROBOT " --robot /nowhere --bus /nowhere ";
const std::string kMainController =
    GAITWAY_MAIN_CONTROLLER " --robot /nowhere --config /nowhere --socket /nowhere ";

// What the program says; it must end with the exit code for bad input.
std::string complaint(const std::string& command) {
  FILE* const output = popen((command + " 2>&1").c_str(), "r");
  std::string text;
  std::array<char, 256> piece{};
  while (std::fgets(piece.data(), piece.size(), output) != nullptr) {
    text += piece.data();
  }
  const int status = pclose(output);
  EXPECT_TRUE(WIFEXITED(status) && WEXITSTATUS(status) == 1) << command << ": " << text;
  return text;
}

TEST(ProgramOptions, GoodOnesComeAsFarAsTheRobot) {
  const auto at_the_robot = HasSubstr("/nowhere/robot.urdf: the file is missing");
  EXPECT_THAT(complaint(kMessageController + "--walk 0.15,-0.1,0.2 --walk-after 2 --seconds 0"),
              at_the_robot);
  EXPECT_THAT(complaint(kVirtualRobot + "--seed 18446744073709551615 --mismatch 0.5"), at_the_robot);
}

TEST(ProgramOptions, AWalkIsMadeOfNumbersThatMayBeCommanded) {
  for (const char* const walk : {"nan,0,0", "0,inf,0", "500,0,0", "0,0,-2.1", "0,0,x", "0.1,0,1e999"}) {
    EXPECT_THAT(complaint(kMessageController + "--walk " + walk),
                AllOf(HasSubstr("--walk"), HasSubstr("must be a number from -2 to 2")))
        << walk;
  }
  EXPECT_THAT(complaint(kMessageController + "--walk 0.9,0.9,0"), HasSubstr("at most 1 m/s"));
  EXPECT_THAT(complaint(kMessageController + "--walk 0.1,0"), HasSubstr("wants VX,VY,WZ"));
}

TEST(ProgramOptions, TimesAndScalesAreFinite) {
  for (const char* const number : {"nan", "-nan", "inf", "-1", "1e7"}) {
    const auto refused = HasSubstr("must be a number from 0 to");
    for (const std::string option : {"--walk-after ", "--wait ", "--seconds "}) {
      EXPECT_THAT(complaint(kMessageController + option + number), refused) << option << number;
    }
    for (const std::string option : {"--mismatch ", "--seconds "}) {
      EXPECT_THAT(complaint(kVirtualRobot + option + number), refused) << option << number;
    }
    EXPECT_THAT(complaint(kMainController + "--seconds " + number), refused) << number;
  }
  EXPECT_THAT(complaint(kVirtualRobot + "--mismatch 0,5"),
              HasSubstr("with a decimal point, not with a comma"));
}

TEST(ProgramOptions, ASeedIsTakenWholeOrNotAtAll) {
  for (const char* const seed :
       {"1e20", "18446744073709551616", "99999999999999999999", "-1", "0.5", "one"}) {
    EXPECT_THAT(complaint(kVirtualRobot + "--seed " + seed), HasSubstr("must be a whole number from 0 to"))
        << seed;
  }
}

TEST(ProgramOptions, NamesOfFilesReachTheTerminalWithoutEscapeSequences) {
  const std::string file = "$(printf '/nowhere\\033[2J')";
  for (const std::string& program :
       {std::string(GAITWAY_VIRTUAL_ROBOT " --bus x --robot "),
        std::string(GAITWAY_MESSAGE_CONTROLLER " --bus x --memory y --robot ")}) {
    EXPECT_THAT(complaint(program + "\"" + file + "\""), HasSubstr("/nowhere\\x1B[2J/robot.urdf"));
  }
}

TEST(ProgramOptions, AWrongLineReachesTheTerminalWithoutEscapeSequences) {
  for (const std::string& program : {kMessageController, kVirtualRobot, kMainController}) {
    for (const char* const words : {"\"$(printf '\\033[2J')\"", "--seconds \"$(printf '1\\033[2J')\""}) {
      EXPECT_THAT(complaint(program + words), AllOf(HasSubstr("\\x1B[2J"), testing::Not(HasSubstr("\x1B"))))
          << program << words;
    }
  }
}

}  // namespace
}  // namespace gaitway::input
