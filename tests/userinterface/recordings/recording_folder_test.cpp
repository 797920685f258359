// Recordings: names, limits, what is left of them when something goes wrong. What is in them is checked with
// the MCAP project's own reader in tests/clients.
#include "gaitway/api/recording_folder.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "gaitway/api/cdr_codec.hpp"
#include "gaitway/api/ros_messages.hpp"
#include "mcap_outline.hpp"

namespace gaitway::api {
namespace {

namespace fs = std::filesystem;
using test::McapOutline;

class RecordingFolderTest : public ::testing::Test {
 protected:
  RecordingFolderTest() {
    std::string pattern = (fs::temp_directory_path() / "gaitway_recordings_XXXXXX").string();
    folder = ::mkdtemp(pattern.data());
  }
  ~RecordingFolderTest() override { fs::remove_all(folder); }

  template <class Message>
  static void write(RecordingFolder& recordings, Topic topic, const Message& message, std::int64_t now_ns) {
    std::string encoded;
    append_cdr(encoded, message);
    recordings.write(topic, encoded, now_ns);
  }
  static void clocks(RecordingFolder& recordings, int count, std::int64_t from_ns = 0) {
    for (int i = 0; i < count; ++i) {
      const std::int64_t now_ns = from_ns + std::int64_t{i} * 10'000'000;
      write(recordings, Topic::clock, ros::Clock{ros_time(now_ns)}, now_ns);
    }
  }
  static std::string refusal(RecordingFolder& recordings, std::string_view name) {
    try {
      recordings.start(name);
    } catch (const std::runtime_error& error) {
      return error.what();
    }
    return "";
  }

  fs::path folder;
};

TEST_F(RecordingFolderTest, MakesAFileWithAllThatWasPublished) {
  RecordingFolder recordings(folder);
  EXPECT_EQ(recordings.start("walk-1"), (folder / "walk-1.mcap").string());
  clocks(recordings, 250);
  write(recordings, Topic::events, ros::Log{}, 2'500'000'000);
  EXPECT_EQ(recordings.stop(), (folder / "walk-1.mcap").string());
  const McapOutline outline(folder / "walk-1.mcap");
  EXPECT_TRUE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 250U);
  EXPECT_EQ(outline.messages("/events"), 1U);
}

TEST_F(RecordingFolderTest, TakesPlainNamesOnly) {
  RecordingFolder recordings(folder);
  for (const std::string name :
       {"", ".", "..", ".hidden", "a/b", "../a", "/etc/passwd", "a b", "a\n", "ä", "a;b"}) {
    EXPECT_NE(refusal(recordings, name).find("no name for a recording"), std::string::npos) << name;
  }
  EXPECT_NE(refusal(recordings, std::string("a\0b", 3)), "");
  EXPECT_NE(refusal(recordings, std::string(101, 'a')), "");
  EXPECT_TRUE(fs::is_empty(folder));
  EXPECT_EQ(refusal(recordings, std::string(100, 'a')), "");
}

TEST_F(RecordingFolderTest, OverwritesNothing) {
  std::ofstream(folder / "kept.mcap") << "precious";
  fs::create_symlink(folder / "elsewhere", folder / "link.mcap");
  RecordingFolder recordings(folder);
  EXPECT_NE(refusal(recordings, "kept").find("already"), std::string::npos);
  EXPECT_NE(refusal(recordings, "link"), "");
  EXPECT_FALSE(fs::exists(folder / "elsewhere"));
  EXPECT_EQ(fs::file_size(folder / "kept.mcap"), 8U);
  EXPECT_FALSE(recordings.recording());
}

TEST_F(RecordingFolderTest, ListsTheFoldersRecordingsNewestFirst) {
  RecordingFolder recordings(folder);
  EXPECT_EQ(recordings.list(10).count, 0U);
  for (const char* const name : {"c", "a", "b"}) {
    recordings.start(name);
    clocks(recordings, 3);
    recordings.stop();
  }
  // None of these is a recording.
  std::ofstream(folder / "notes.txt") << "notes";
  std::ofstream(folder / ".hidden.mcap") << "hidden";
  std::ofstream(folder / "a b.mcap") << "space";
  fs::create_directory(folder / "folder.mcap");
  fs::create_symlink(folder / "a.mcap", folder / "link.mcap");
  const RecordingList all = recordings.list(10);
  ASSERT_EQ(all.count, 3U);
  ASSERT_EQ(all.newest.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(all.newest[i].bytes, fs::file_size(all.newest[i].file)) << all.newest[i].file;
    if (i > 0) {
      EXPECT_GE(all.newest[i - 1].start_ns, all.newest[i].start_ns);
    }
  }
  const RecordingList two = recordings.list(2);
  EXPECT_EQ(two.count, 3U);
  ASSERT_EQ(two.newest.size(), 2U);
  EXPECT_EQ(two.newest[1].file, all.newest[1].file);
  fs::remove(folder / "a.mcap");
  EXPECT_EQ(recordings.list(10).count, 2U) << "the folder as it is now";
}

TEST_F(RecordingFolderTest, RecordsOneFileAtATime) {
  RecordingFolder recordings(folder);
  EXPECT_THROW(recordings.stop(), std::runtime_error);
  recordings.start("a");
  EXPECT_NE(refusal(recordings, "b").find("a.mcap"), std::string::npos);
  recordings.stop();
  recordings.start("b");
  clocks(recordings, 3);
  recordings.stop();
  EXPECT_EQ(McapOutline(folder / "a.mcap").messages("/clock"), 0U);
  EXPECT_EQ(McapOutline(folder / "b.mcap").messages("/clock"), 3U);
}

TEST_F(RecordingFolderTest, RefusesAFolderThatIsNotThere) {
  EXPECT_THROW(RecordingFolder(folder / "missing"), std::runtime_error);
}

TEST_F(RecordingFolderTest, WritesWhatWaitsWhenToldTo) {
  RecordingFolder recordings(folder);
  recordings.start("live");
  clocks(recordings, 10);
  EXPECT_EQ(McapOutline(folder / "live.mcap").messages("/clock"), 0U);
  recordings.flush();
  clocks(recordings, 5);  // wait when the process is killed
  const McapOutline outline(folder / "live.mcap");
  EXPECT_FALSE(outline.complete());
  EXPECT_EQ(outline.messages("/clock"), 10U);
}

TEST_F(RecordingFolderTest, WritesAChunkWhenItIsLarge) {
  RecordingFolder recordings(folder);
  recordings.start("large");
  for (int i = 0; i < 25; ++i) {
    write(recordings, Topic::robot_description, ros::String{std::string(100'000, 'x')}, i);
  }
  const McapOutline outline(folder / "large.mcap");
  EXPECT_EQ(outline.chunks(), 2U);
  EXPECT_EQ(outline.messages("/robot_description"), 22U);
}

TEST_F(RecordingFolderTest, EndsByItselfAtItsLimitWithAFileThatIsWhole) {
  constexpr std::uint64_t kLimit_bytes = 300'000;
  RecordingFolder recordings(folder, {.file_bytes = kLimit_bytes});
  recordings.start("limited");
  for (int i = 0; i < 100 && recordings.recording(); ++i) {
    clocks(recordings, 100, std::int64_t{i} * 1'000'000'000);
    recordings.flush();
  }
  EXPECT_FALSE(recordings.recording());
  const std::optional<std::string> report = recordings.take_report();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("limit of 300000 bytes"), std::string::npos) << *report;
  EXPECT_FALSE(recordings.take_report());
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

TEST_F(RecordingFolderTest, AFullDiskEndsTheRecordingAndLeavesWhatWasWritten) {
  RecordingFolder recordings(folder);
  recordings.start("full");
  clocks(recordings, 100);
  recordings.flush();
  const auto so_far = fs::file_size(folder / "full.mcap");
  {
    const FileSizeLimit limit(so_far + 1000);
    clocks(recordings, 1000);
    recordings.flush();
  }
  EXPECT_FALSE(recordings.recording());
  const std::optional<std::string> report = recordings.take_report();
  ASSERT_TRUE(report);
  EXPECT_NE(report->find("File too large"), std::string::npos) << *report;
  const McapOutline outline(folder / "full.mcap");
  EXPECT_EQ(outline.messages("/clock"), 100U);
  EXPECT_EQ(fs::file_size(folder / "full.mcap"), so_far) << "nothing incomplete is left";
  clocks(recordings, 10);  // goes nowhere
}

TEST_F(RecordingFolderTest, AFileThatCannotHoldItsBeginningIsRefused) {
  RecordingFolder recordings(folder);
  {
    const FileSizeLimit limit(100);
    EXPECT_NE(refusal(recordings, "none").find("File too large"), std::string::npos);
  }
  EXPECT_FALSE(recordings.recording());
  EXPECT_EQ(refusal(recordings, "some"), "");
}

TEST_F(RecordingFolderTest, AFolderHoldsSoManyRecordingsAndNoMore) {
  RecordingFolder recordings(folder, {.files = 3});
  for (const char* const name : {"a", "b", "c"}) {
    EXPECT_EQ(refusal(recordings, name), "");
    recordings.stop();
  }
  EXPECT_NE(refusal(recordings, "d").find("holds 3 recordings"), std::string::npos);
  EXPECT_FALSE(fs::exists(folder / "d.mcap"));
  EXPECT_TRUE(recordings.list(2).complete);
  fs::remove(folder / "b.mcap");
  EXPECT_EQ(refusal(recordings, "d"), "");
}

TEST_F(RecordingFolderTest, ListsSoManyAndSaysWhenThereAreMore) {
  for (const char* const name : {"a.mcap", "b.mcap", "c.mcap", "d.mcap"}) {
    std::ofstream(folder / name) << name;
  }
  const RecordingList list = RecordingFolder(folder, {.files = 3}).list(2);
  EXPECT_EQ(list.count, 3U);
  EXPECT_EQ(list.newest.size(), 2U);
  EXPECT_FALSE(list.complete);
}

TEST_F(RecordingFolderTest, LeavesTheDiskItsReserve) {
  std::uint64_t free_bytes = 9'000'000;
  RecordingDisk disk = RecordingDisk::real();
  disk.free_bytes = [&free_bytes](int) { return free_bytes; };
  RecordingFolder recordings(folder, {.reserve_bytes = 10 << 20}, disk);
  EXPECT_NE(refusal(recordings, "early").find("less than 10 MiB are free"), std::string::npos);
  EXPECT_TRUE(fs::is_empty(folder));
  free_bytes = 11'000'000;
  for (const bool by_flush : {true, false}) {
    const std::string name = by_flush ? "flushed" : "chunk";
    free_bytes = 11'000'000;
    EXPECT_EQ(refusal(recordings, name), "");
    clocks(recordings, 100);
    recordings.flush();
    EXPECT_TRUE(recordings.recording());
    free_bytes = 10'000'000;
    write(recordings, Topic::robot_description, ros::String{std::string(by_flush ? 9 : 1 << 20, 'x')}, 0);
    if (by_flush) recordings.flush();
    EXPECT_FALSE(recordings.recording());
    const std::optional<std::string> report = recordings.take_report();
    ASSERT_TRUE(report);
    EXPECT_NE(report->find("less than 10 MiB are free"), std::string::npos) << *report;
    const McapOutline outline(folder / (name + ".mcap"));
    EXPECT_TRUE(outline.complete());
    EXPECT_EQ(outline.messages("/clock"), 100U);
  }
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
