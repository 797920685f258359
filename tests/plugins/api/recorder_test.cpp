// Recordings: names, limits, what is left of them when something goes wrong. What is in them is checked with
// the MCAP project's own reader in tests/clients.
#include "gaitway/api/recorder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "gaitway/api/ros_messages.hpp"
#include "mcap_outline.hpp"

namespace gaitway::api {
namespace {

namespace fs = std::filesystem;
using test::McapOutline;

class RecorderTest : public ::testing::Test {
 protected:
  RecorderTest() {
    std::string pattern = (fs::temp_directory_path() / "gaitway_recordings_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
  }
  ~RecorderTest() override { fs::remove_all(folder); }

  static void clocks(Recorder& recorder, int count, std::int64_t from_ns = 0) {
    for (int i = 0; i < count; ++i) {
      const std::int64_t now_ns = from_ns + std::int64_t{i} * 10'000'000;
      recorder.publish(Topic::clock, ros::Clock{ros_time(now_ns)}, now_ns);
    }
  }
  static std::string refusal(Recorder& recorder, std::string_view name) {
    try {
      recorder.start(name, 0);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder;
};

TEST_F(RecorderTest, MakesAFileWithAllThatWasPublished) {
  Recorder recorder(folder);
  EXPECT_EQ(recorder.start("walk-1", 5), (folder / "walk-1.mcap").string());
  clocks(recorder, 250);
  recorder.publish(Topic::events, ros::Log{}, 2'500'000'000);
  EXPECT_EQ(recorder.stop(), (folder / "walk-1.mcap").string());
  const McapOutline outline(folder / "walk-1.mcap");
  EXPECT_TRUE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 250U);
  EXPECT_EQ(outline.messages("/events"), 1U);
}

TEST_F(RecorderTest, BeginsWithTheLastMessageOfEachLatchedTopic) {
  Recorder recorder(folder);
  EXPECT_TRUE(recorder.wants(Topic::robot_description));
  EXPECT_FALSE(recorder.wants(Topic::joint_states));
  recorder.publish(Topic::robot_description, ros::String{"<robot/>"}, 0);
  recorder.publish(Topic::footsteps, ros::PoseArray{}, 0);
  recorder.publish(Topic::footsteps, ros::PoseArray{}, 1);
  recorder.publish(Topic::clock, ros::Clock{}, 1);
  recorder.start("a", 7);
  EXPECT_TRUE(recorder.wants(Topic::joint_states));
  recorder.stop();
  const McapOutline outline(folder / "a.mcap");
  EXPECT_EQ(outline.messages("/robot_description"), 1U);
  EXPECT_EQ(outline.messages("/footsteps"), 1U);
  EXPECT_EQ(outline.messages("/clock"), 0U);
}

TEST_F(RecorderTest, TakesPlainNamesOnly) {
  Recorder recorder(folder);
  for (const std::string name :
       {"", ".", "..", ".hidden", "a/b", "../a", "/etc/passwd", "a b", "a\n", "ä", "a;b"}) {
    EXPECT_NE(refusal(recorder, name).find("no name for a recording"), std::string::npos) << name;
  }
  EXPECT_NE(refusal(recorder, std::string("a\0b", 3)), "");
  EXPECT_NE(refusal(recorder, std::string(101, 'a')), "");
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(refusal(recorder, std::string(100, 'a')), "");
}

TEST_F(RecorderTest, OverwritesNothing) {
  std::ofstream(folder / "kept.mcap") << "precious";
  fs::create_symlink(folder / "elsewhere", folder / "link.mcap");
  Recorder recorder(folder);
  EXPECT_NE(refusal(recorder, "kept").find("already"), std::string::npos);
  EXPECT_NE(refusal(recorder, "link"), "");
  EXPECT_FALSE(fs::exists(folder / "elsewhere"));
  EXPECT_EQ(fs::file_size(folder / "kept.mcap"), 8U);
  EXPECT_FALSE(recorder.recording());
}

TEST_F(RecorderTest, ListsTheFoldersRecordingsNewestFirst) {
  Recorder recorder(folder);
  EXPECT_EQ(recorder.list(10).count, 0U);
  for (const char* const name : {"c", "a", "b"}) {
    recorder.start(name, 0);
    clocks(recorder, 3);
    recorder.stop();
  }
  // None of these is a recording.
  std::ofstream(folder / "notes.txt") << "notes";
  std::ofstream(folder / ".hidden.mcap") << "hidden";
  std::ofstream(folder / "a b.mcap") << "space";
  fs::create_directory(folder / "folder.mcap");
  fs::create_symlink(folder / "a.mcap", folder / "link.mcap");
  const RecordingList all = recorder.list(10);
  ASSERT_EQ(all.count, 3U);
  ASSERT_EQ(all.newest.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(all.newest[i].bytes, fs::file_size(all.newest[i].file)) << all.newest[i].file;
    if (i > 0) {
      EXPECT_GE(all.newest[i - 1].start_ns, all.newest[i].start_ns);
    }
  }
  const RecordingList two = recorder.list(2);
  EXPECT_EQ(two.count, 3U);
  ASSERT_EQ(two.newest.size(), 2U);
  EXPECT_EQ(two.newest[1].file, all.newest[1].file);
  fs::remove(folder / "a.mcap");
  EXPECT_EQ(recorder.list(10).count, 2U) << "the folder as it is now";
}

TEST_F(RecorderTest, RecordsOneFileAtATime) {
  Recorder recorder(folder);
  EXPECT_THROW(recorder.stop(), std::runtime_error);
  recorder.start("a", 0);
  EXPECT_NE(refusal(recorder, "b").find("a.mcap"), std::string::npos);
  recorder.stop();
  recorder.start("b", 0);
  clocks(recorder, 3);
  recorder.stop();
  EXPECT_EQ(McapOutline(folder / "a.mcap").messages("/clock"), 0U);
  EXPECT_EQ(McapOutline(folder / "b.mcap").messages("/clock"), 3U);
}

TEST_F(RecorderTest, RefusesAFolderThatIsNotThere) {
  EXPECT_THROW(Recorder(folder / "missing"), std::runtime_error);
}

TEST_F(RecorderTest, WritesWhatWaitsOnceASecond) {
  Recorder recorder(folder);
  recorder.start("live", 0);
  recorder.step(0);
  clocks(recorder, 10);
  recorder.step(900'000'000);
  EXPECT_EQ(McapOutline(folder / "live.mcap").messages("/clock"), 0U);
  recorder.step(1'000'000'000);
  clocks(recorder, 5);  // wait when the process is killed
  const McapOutline outline(folder / "live.mcap");
  EXPECT_FALSE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 10U);
}

TEST_F(RecorderTest, WritesAChunkWhenItIsLarge) {
  Recorder recorder(folder);
  recorder.start("large", 0);
  for (int i = 0; i < 25; ++i) {
    recorder.publish(Topic::robot_description, ros::String{std::string(100'000, 'x')}, i);
  }
  const McapOutline outline(folder / "large.mcap");
  EXPECT_EQ(outline.chunks(), 2U);
  EXPECT_EQ(outline.messages("/robot_description"), 22U);
}

TEST_F(RecorderTest, EndsByItselfAtItsLimitWithAFileThatIsWhole) {
  constexpr std::uint64_t kLimit_bytes = 300'000;
  Recorder recorder(folder, kLimit_bytes);
  recorder.start("limited", 0);
  for (int i = 0; i < 100 && recorder.recording(); ++i) {
    clocks(recorder, 100, std::int64_t{i} * 1'000'000'000);
    recorder.step(std::int64_t{i} * 1'000'000'000);
  }
  EXPECT_FALSE(recorder.recording());
  const std::optional<std::string> report = recorder.take_report();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("limit of 300000 bytes"), std::string::npos) << *report;
  EXPECT_FALSE(recorder.take_report());
  EXPECT_LE(fs::file_size(folder / "limited.mcap"), kLimit_bytes);
  EXPECT_GT(fs::file_size(folder / "limited.mcap"), kLimit_bytes / 2);
  EXPECT_TRUE(McapOutline(folder / "limited.mcap").complete());
}

// While it lives, files of this process may not grow beyond so many bytes: what a full disk does.
class FileSizeLimit {
 public:
  explicit FileSizeLimit(rlim_t bytes) : handler_(std::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  FileSizeLimit(const FileSizeLimit&) = delete;
  FileSizeLimit& operator=(const FileSizeLimit&) = delete;
  ~FileSizeLimit() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    std::signal(SIGXFSZ, handler_);
  }

 private:
  rlimit before_{};
  void (*handler_)(int);
};

TEST_F(RecorderTest, AFullDiskEndsTheRecordingAndLeavesWhatWasWritten) {
  Recorder recorder(folder);
  recorder.start("full", 0);
  clocks(recorder, 100);
  recorder.step(0);
  recorder.step(1'000'000'000);
  const auto so_far = fs::file_size(folder / "full.mcap");
  {
    const FileSizeLimit limit(so_far + 1000);
    clocks(recorder, 1000);
    recorder.step(2'000'000'000);
  }
  EXPECT_FALSE(recorder.recording());
  const std::optional<std::string> report = recorder.take_report();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("File too large"), std::string::npos) << *report;
  const McapOutline outline(folder / "full.mcap");
  EXPECT_EQ(outline.messages("/clock"), 100U);
  EXPECT_EQ(fs::file_size(folder / "full.mcap"), so_far) << "nothing incomplete is left";
  clocks(recorder, 10);  // goes nowhere
}

TEST_F(RecorderTest, AFileThatCannotHoldItsBeginningIsRefused) {
  Recorder recorder(folder);
  {
    const FileSizeLimit limit(100);
    EXPECT_NE(refusal(recorder, "none").find("File too large"), std::string::npos);
  }
  EXPECT_FALSE(recorder.recording());
  EXPECT_EQ(refusal(recorder, "some"), "");
}

TEST(McapWriterTest, NeverClaimsLessThanTheFileWillMeasure) {
  std::string path = (fs::temp_directory_path() / "gaitway_mcap_XXXXXX").string();
  const int file = ::mkstemp(path.data());
  McapWriter writer(
      file, {{"/a", "std_msgs/msg/String", "string data\n"}, {"/b", "std_msgs/msg/String", "string data\n"}},
      {.chunk_bytes = 500});
  std::uint64_t claimed = 0;
  for (int i = 0; i < 1000; ++i) {
    writer.write(static_cast<std::size_t>(i % 2), std::string(static_cast<std::size_t>(i % 37), 'x'), i, i);
    claimed = writer.size_bytes();
  }
  EXPECT_TRUE(writer.finish());
  EXPECT_FALSE(writer.write(0, "x", 0, 0)) << "it is closed";
  EXPECT_LE(fs::file_size(path), claimed);
  EXPECT_GT(fs::file_size(path), claimed * 9 / 10);
  EXPECT_TRUE(McapOutline(path).complete());
  fs::remove(path);
}

TEST(McapWriterTest, TellsWhatTheDeviceSaysAndGoesOnToTell) {
  McapWriter writer(::open("/dev/full", O_WRONLY | O_CLOEXEC),
                    {{"/a", "std_msgs/msg/String", "string data\n"}});
  EXPECT_EQ(writer.error(), "No space left on device");
  EXPECT_FALSE(writer.write(0, "x", 0, 0));
  EXPECT_FALSE(writer.flush());
  EXPECT_FALSE(writer.finish());
}

}  // namespace
}  // namespace gaitway::api
