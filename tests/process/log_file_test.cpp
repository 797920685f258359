// Whatever becomes of the disk: what stands in a log is whole lines, what is missing was counted, and the
// file keeps its bound.
#include "gaitway/process/log_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "gaitway/process/private_folder.hpp"

namespace gaitway::process {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

class LogFileTest : public testing::Test {
 protected:
  [[nodiscard]] static std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }

  PrivateFolder folder{"gaitway_log_file"};
  std::filesystem::path file = folder.path() / "walk.log";
};

// No file of this process may become larger.
class SizeLimit {
 public:
  explicit SizeLimit(rlim_t bytes) {
    getrlimit(RLIMIT_FSIZE, &before_);
    set(bytes);
  }
  SizeLimit(const SizeLimit&) = delete;
  SizeLimit& operator=(const SizeLimit&) = delete;
  ~SizeLimit() { setrlimit(RLIMIT_FSIZE, &before_); }
  void set(rlim_t bytes) {
    const rlimit limit{bytes, before_.rlim_max};
    setrlimit(RLIMIT_FSIZE, &limit);
  }

 private:
  rlimit before_{};
};

TEST_F(LogFileTest, LinesAreThereAsSoonAsTheyAreAppended) {
  LogFile log(file, {.head = "a,b\n"});
  EXPECT_EQ(content(file), "a,b\n");
  EXPECT_TRUE(log.append("1,2\n3,4\n"));
  EXPECT_EQ(content(file), "a,b\n1,2\n3,4\n");
  EXPECT_EQ(log.lines(), 2U);
  EXPECT_EQ(log.lost(), 0U);
}

TEST_F(LogFileTest, BeginsAnewOrGoesOnAfterTheLastWholeLine) {
  std::ofstream(file) << "one\ntwo\nthr";
  { EXPECT_TRUE(LogFile(file, {.start = LogOptions::Start::go_on}).append("four\n")); }
  EXPECT_EQ(content(file), "one\ntwo\nfour\n");
  std::ofstream(file) << std::string(10'000, 'x');  // a torn line alone
  { EXPECT_TRUE(LogFile(file, {.start = LogOptions::Start::go_on, .head = "h\n"}).append("five\n")); }
  EXPECT_EQ(content(file), "h\nfive\n");
  { EXPECT_TRUE(LogFile(file).append("six\n")); }
  EXPECT_EQ(content(file), "six\n");
}

TEST_F(LogFileTest, AFullDiskTakesTheLinesThatFitAndTheOthersAreCounted) {
  LogFile log(file);
  {
    SizeLimit disk(23);
    EXPECT_TRUE(log.append("0123456789\n"));
    EXPECT_FALSE(log.append("abcdefghij\nklm\nnop\n")) << "of which the first one fits";
    EXPECT_EQ(content(file), "0123456789\nabcdefghij\n");
    EXPECT_FALSE(log.append("qrs\n"));
    EXPECT_EQ(log.lines(), 2U);
    EXPECT_EQ(log.lost(), 3U);
    EXPECT_THAT(log.error(), HasSubstr("File too large"));
    EXPECT_EQ(content(file), "0123456789\nabcdefghij\n") << "no part of a line is left";
  }
  EXPECT_TRUE(log.append("tuv\n")) << "there is room again";
  EXPECT_EQ(content(file), "0123456789\nabcdefghij\ntuv\n");
  EXPECT_EQ(log.lost(), 3U);
}

TEST_F(LogFileTest, TheHeadIsMadeUpForWhenTheDiskWasFullAtTheBeginning) {
  SizeLimit disk(0);
  LogFile log(file, {.head = "a,b\n"});
  EXPECT_FALSE(log.append("1,2\n"));
  disk.set(100);
  EXPECT_TRUE(log.append("3,4\n"));
  EXPECT_EQ(content(file), "a,b\n3,4\n");
}

TEST_F(LogFileTest, AnErrorOfTheSystemIsOneOfTheLogAndNothingElse) {
  LogFile log("/dev/full");
  EXPECT_FALSE(log.append("one\ntwo\n"));
  EXPECT_EQ(log.lost(), 2U);
  EXPECT_THAT(log.error(), HasSubstr("No space left"));
}

TEST_F(LogFileTest, KeepsItsBoundInTwoFiles) {
  LogFile log(file, {.most_bytes = 40, .head = "number\n"});
  for (int i = 100; i < 150; ++i) {
    EXPECT_TRUE(log.append(std::to_string(i) + "\n"));
    EXPECT_LE(std::filesystem::file_size(file), 40U);
  }
  EXPECT_EQ(log.lines(), 50U);
  const std::string before = content(file.string() + ".1"), now = content(file);
  EXPECT_THAT(before, AllOf(testing::StartsWith("number\n"), EndsWith("147\n")));
  EXPECT_EQ(now, "number\n148\n149\n");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder.path()), {}), 2);
}

TEST_F(LogFileTest, AFullFolderKeepsTheLogThatThereIs) {
  LogFile log(file, {.most_bytes = 40, .head = "number\n"});
  EXPECT_TRUE(log.append("0123456789\n0123456789\n0123456789\n"));
  {
    const SizeLimit disk(3);  // not even the head of the next file fits
    EXPECT_FALSE(log.append("abc\n"));
  }
  EXPECT_EQ(content(file), "number\n0123456789\n0123456789\n0123456789\n");
  EXPECT_TRUE(log.append("def\n"));
  EXPECT_EQ(content(file), "number\ndef\n");
}

// As after a kill between the two renames.
TEST_F(LogFileTest, GoesOnWhereBeginningTheNextFileWasCutOff) {
  std::ofstream(file.string() + ".1") << "old\n";
  std::ofstream(file.string() + ".new") << "head\n";
  LogFile log(file, {.start = LogOptions::Start::go_on, .most_bytes = 40});
  EXPECT_TRUE(log.append("new\n"));
  EXPECT_EQ(content(file), "new\n");
  EXPECT_EQ(content(file.string() + ".1"), "old\n");
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".new"));
}

TEST_F(LogFileTest, NamesFileAndReasonOfWhatCannotBeWritten) {
  try {
    const LogFile log("/nowhere/at/all.log");
    FAIL() << "a file in a missing folder was made";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("/nowhere/at/all.log: cannot be created: No such file"),
                                    HasSubstr("is the folder there")));
  }
  const LogFile log(file);
  try {
    const LogFile second(file);
    FAIL() << "two wrote one log";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr(file.string() + ": is being written by another process")));
  }
}

TEST_F(LogFileTest, WhatWritesElsewhereIsNeitherCutOffNorRenamed) {
  const FileDescriptor others(::open(file.c_str(), O_WRONLY | O_CREAT | O_APPEND, 0600));
  ASSERT_EQ(::write(others.get(), "theirs\n", 7), 7);
  LogFile log(others.get(), "standard error");
  EXPECT_TRUE(log.append("ours\n"));
  EXPECT_EQ(content(file), "theirs\nours\n");
}

}  // namespace
}  // namespace gaitway::process
