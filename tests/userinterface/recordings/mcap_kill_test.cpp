// Kills a process that records, at many instants, and fills its disk: what it leaves can be read up to its
// last whole chunk, and no message of those is missing.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <new>
#include <random>
#include <string>

#include "gaitway/api/mcap_reader.hpp"
#include "gaitway/api/mcap_writer.hpp"
#include "gaitway/process/private_folder.hpp"

namespace gaitway::api {
namespace {

std::string data_of(std::uint64_t number) {
  return std::to_string(number) + " " + std::string(number % 301, 'x');
}

class McapKillTest : public testing::Test {
 protected:
  McapKillTest()
      : place_(mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                    MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
        written_(*new (place_) std::atomic<std::uint64_t>(0)) {}
  ~McapKillTest() override { munmap(place_, sizeof(std::atomic<std::uint64_t>)); }

  [[nodiscard]] McapWriter writer() const {
    return McapWriter(open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0600),
                      {{"/a", "std_msgs/msg/String", "string data"}}, {.chunk_bytes = 20'000});
  }
  // Messages that the file holds, numbered from 0 without a gap.
  [[nodiscard]] std::uint64_t read(bool& has_end) const {
    std::uint64_t count = 0;
    has_end = read_mcap(file, [&count](const McapMessage& message) {
      EXPECT_EQ(message.data, data_of(count));
      ++count;
    });
    return count;
  }

  process::PrivateFolder folder{"gaitway_mcap_kill"};
  std::filesystem::path file = folder.path() / "walk.mcap";

 private:
  void* place_;

 protected:
  std::atomic<std::uint64_t>& written_;  // messages of whole chunks, as the other process knows
};

TEST_F(McapKillTest, AKilledRecorderLeavesAllItsWholeChunks) {
  std::mt19937_64 random(7);
  for (int kills = 0; kills < 25 && !HasFailure(); ++kills) {
    written_ = 0;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      McapWriter mcap = writer();
      for (std::uint64_t number = 0;; ++number) {
        mcap.write(0, data_of(number), static_cast<std::int64_t>(number), 0);
        if (!mcap.waits()) written_ = number + 1;
      }
    }
    const auto sleep_us = [](std::uint64_t us) {
      const timespec time{0, static_cast<long>(us) * 1000};
      nanosleep(&time, nullptr);
    };
    for (int tries = 0; written_ == 0 && tries < 100'000; ++tries) sleep_us(20);
    sleep_us(random() % 5'000);
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status));
    bool has_end = true;
    EXPECT_GE(read(has_end), written_.load()) << "kill " << kills;
    EXPECT_FALSE(has_end);
  }
}

TEST_F(McapKillTest, AFullDiskLeavesAFileThatHasItsEndWhereThereIsRoomForIt) {
  const auto ignored = signal(SIGXFSZ, SIG_IGN);
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  rlimit limit{110'000, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::uint64_t number = 0;
  {
    McapWriter mcap = writer();
    while (mcap.write(0, data_of(number), static_cast<std::int64_t>(number), 0)) ++number;
    EXPECT_EQ(mcap.error(), "File too large");
    limit.rlim_cur = 120'000;  // somebody has made a little room
    setrlimit(RLIMIT_FSIZE, &limit);
    EXPECT_FALSE(mcap.finish());
    EXPECT_EQ(mcap.error(), "File too large") << "what was lost stays said";
  }
  setrlimit(RLIMIT_FSIZE, &before);
  signal(SIGXFSZ, ignored);
  bool has_end = false;
  EXPECT_GT(read(has_end), 100U);
  EXPECT_TRUE(has_end);
}

}  // namespace
}  // namespace gaitway::api
