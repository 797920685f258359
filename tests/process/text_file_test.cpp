// A file is written whole, or the error says which one could not be and why.
#include "gaitway/process/text_file.hpp"

#include <gmock/gmock.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

namespace gaitway::process {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(TextFile, ReplacesTheWholeFile) {
  const std::filesystem::path file = std::filesystem::path(testing::TempDir()) / "gaitway_text_file.txt";
  write_text_file(file, std::string(100, 'x'));
  write_text_file(file, "one\nline");
  std::ifstream in(file);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(in), {}), "one\nline");
  std::filesystem::remove(file);
}

TEST(TextFile, SaysWhichFileAndWhy) {
  try {
    write_text_file("/nowhere/at/all.txt", "x");
    FAIL() << "a file in a missing folder was written";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("/nowhere/at/all.txt"), HasSubstr("No such file"),
                                    HasSubstr("is the folder there")));
  }
}

TEST(TextFile, AFullDiskIsAnError) {
  EXPECT_THROW(write_text_file("/dev/full", "x"), std::runtime_error);
}

}  // namespace
}  // namespace gaitway::process
