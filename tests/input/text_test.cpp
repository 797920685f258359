// Files up to a size, and text that a terminal may show.
#include "gaitway/input/text.hpp"
#include "gaitway/input/complaint.hpp"

#include <gmock/gmock.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace gaitway::input {
namespace {

using namespace std::string_literals;
using testing::HasSubstr;

std::filesystem::path file_of(std::size_t bytes) {
  auto file = std::filesystem::temp_directory_path() / ("gaitway-text-" + std::to_string(getpid()));
  std::ofstream(file) << std::string(bytes, '#');
  return file;
}
std::string refusal(const std::filesystem::path& file, std::size_t largest_bytes) {
  try {
    (void)read_text_file(file, "Look for it", largest_bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "(read)";
}

TEST(TextFile, IsReadUpToItsLimit) {
  const std::filesystem::path file = file_of(100'000);
  EXPECT_EQ(read_text_file(file, "", 100'000).size(), 100'000U);
  EXPECT_THAT(refusal(file, 99'999), HasSubstr(file.string() + ": the file is larger than"));
  std::filesystem::remove(file);
}

TEST(TextFile, WithoutAnEndIsRefused) {
  EXPECT_THAT(refusal("/dev/zero", 1U << 20U), HasSubstr("/dev/zero: the file is larger than 1 MiB"));
}

TEST(TextFile, MissingOrAFolderIsRefused) {
  EXPECT_EQ(refusal("/nowhere/x", 1), "/nowhere/x: the file is missing or cannot be read. Look for it.");
  EXPECT_EQ(refusal("/tmp", 1), "/tmp: the file is missing or cannot be read. Look for it.");
}

TEST(TerminalText, KeepsWhatPeopleWrite) {
  const std::string text = "Zähler µs, 位置, 🤖: 3 m/s²\n\tindented \"quoted\" \\x";
  EXPECT_EQ(terminal_text(text), text);
}

TEST(TerminalText, ShowsWhatATerminalWouldObey) {
  EXPECT_EQ(terminal_text("a\x1B[2Jb\rc\0d\x7F"s), "a\\x1B[2Jb\\x0Dc\\x00d\\x7F");
  EXPECT_EQ(terminal_text("\xC2\x9B"
                          "31m"),
            "\\x9B31m")
      << "CSI in one character";
  EXPECT_EQ(terminal_text("a\u202Eb\u2066c\u2028"), "a\\u202Eb\\u2066c\\u2028");
}

TEST(TerminalText, ShowsBytesThatAreNoUtf8) {
  EXPECT_EQ(terminal_text("\x9B"), "\\x9B");
  EXPECT_EQ(terminal_text("\xC3"), "\\xC3");
  EXPECT_EQ(terminal_text("\xC0\x9B"), "\\xC0\\x9B") << "longer than needed";
  EXPECT_EQ(terminal_text("\xE0\x82\x9B"), "\\xE0\\x82\\x9B") << "longer than needed";
  EXPECT_EQ(terminal_text("\xE2\x28\xA1"), "\\xE2(\\xA1");
  EXPECT_EQ(terminal_text("\xF5\x80\x80\x80"), "\\xF5\\x80\\x80\\x80");
}

TEST(Complaint, IsSafeForTheTerminalAndShort) {
  try {
    refuse({"robot\x1B]0;x\x07.yaml", 3, "name", std::string(100'000, 'x'), "must be shorter", "Cut it"});
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("robot\\x1B]0;x\\x07.yaml:3: name = xxx"));
    EXPECT_THAT(error.what(), HasSubstr("... (100000 bytes): must be shorter. Cut it."));
    EXPECT_LT(std::string(error.what()).size(), 400U);
  }
}

}  // namespace
}  // namespace gaitway::input
