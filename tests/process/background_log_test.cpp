// Who adds lines never waits, whatever the disk does; what is lost is counted and told, when it begins and
// when it is over.
#include "gaitway/process/background_log.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <mutex>
#include <stdexcept>
#include <string>
#include <vector>

#include "gaitway/process/duration_histogram.hpp"
#include "gaitway/process/file_descriptor.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"

namespace gaitway::process {
namespace {

using testing::HasSubstr;

// What a log tells, in its own thread.
class News {
 public:
  [[nodiscard]] auto teller() {
    return [this](const std::string& text) {
      const std::scoped_lock lock(mutex_);
      told_.push_back(text);
      changed_.notify_all();
    };
  }
  [[nodiscard]] std::vector<std::string> wait_for(std::size_t count) {
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, std::chrono::seconds(20), [&] { return told_.size() >= count; });
    return told_;
  }

 private:
  std::mutex mutex_;
  std::condition_variable changed_;
  std::vector<std::string> told_;
};

class BackgroundLogTest : public testing::Test {
 protected:
  [[nodiscard]] std::string content() const {
    std::ifstream in(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  static std::string line(int number) { return "line " + std::to_string(number) + "\n"; }

  PrivateFolder folder{"gaitway_background_log"};
  std::filesystem::path file = folder.path() / "walk.log";
};

TEST_F(BackgroundLogTest, EachLineComesOnceAndInItsOrder) {
  constexpr int kLines = 20'000;
  std::string all;
  int refused = 0;
  {
    BackgroundLog log(LogFile(file), {.waiting_bytes = 1 << 20});
    for (int i = 0; i < kLines; ++i) {
      refused += log.add(line(i)) ? 0 : 1;
      all += line(i);
    }
    const LogCount count = log.close();
    EXPECT_EQ(count.lines, static_cast<std::uint64_t>(kLines));
    EXPECT_EQ(count.lost, 0U);
  }
  EXPECT_EQ(refused, 0);
  EXPECT_EQ(content(), all);
}

// A line is on its way to the disk without anybody asking for it.
TEST_F(BackgroundLogTest, ALineArrivesByItself) {
  BackgroundLog log{LogFile(file)};
  for (int i = 1; i <= 20; ++i) {
    ASSERT_TRUE(log.add("now\n"));
    const std::int64_t until_ns = monotonic_ns() + 10'000'000'000;
    while (log.count().lines != static_cast<std::uint64_t>(i) && monotonic_ns() < until_ns) {
      wait_until(monotonic_ns() + 100'000, {});
    }
    ASSERT_EQ(log.count().lines, static_cast<std::uint64_t>(i));
  }
}

// A process that is started again writes where the one before ended.
TEST_F(BackgroundLogTest, ItsFileIsFreeOnceItIsClosed) {
  BackgroundLog log{LogFile(file)};
  log.add(line(1));
  EXPECT_THROW(LogFile{file}, std::runtime_error) << "two may not write it";
  EXPECT_EQ(log.close().lines, 1U);
  EXPECT_NO_THROW(LogFile(file, {.start = LogOptions::Start::go_on}));
}

// A pipe that nobody reads, as a disk that takes nothing for minutes, or a terminal that was halted.
TEST_F(BackgroundLogTest, ADiskThatTakesNothingDoesNotHoldWhoAdds) {
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  const FileDescriptor reader(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  constexpr int kLines = 30'000;  // 12 times what pipe and ring take
  DurationHistogram took;
  int refused = 0;
  {
    BackgroundLog log(LogFile(file), {.waiting_bytes = 1 << 16});
    std::string text(64, 'x');
    text.back() = '\n';
    for (int i = 0; i < kLines; ++i) {
      const std::int64_t begin_ns = monotonic_ns();
      refused += log.add(text) ? 0 : 1;
      took.add(monotonic_ns() - begin_ns);
    }
    EXPECT_GT(refused, kLines / 2);
    EXPECT_LT(took.percentile_ns(0.99), 200'000.0) << "a machine with other work may hold it longer";
    const std::int64_t begin_ns = monotonic_ns();
    const LogCount count = log.close();
    EXPECT_LT(monotonic_ns() - begin_ns, 5'000'000'000) << "nor whoever ends";
    EXPECT_EQ(count.lines + count.lost, static_cast<std::uint64_t>(kLines));
    EXPECT_GE(count.lost, static_cast<std::uint64_t>(refused));
  }
  std::array<char, 4096> rest{};
  while (::read(reader.get(), rest.data(), rest.size()) > 0) {  // lets the log's thread go
  }
}

TEST_F(BackgroundLogTest, LossesAreToldOnceAndStandInTheLogWhenTheyAreOver) {
  ASSERT_EQ(mkfifo(file.c_str(), 0600), 0);
  const FileDescriptor reader(::open(file.c_str(), O_RDONLY | O_NONBLOCK | O_CLOEXEC));
  News news;
  BackgroundLog log(LogFile(file), {.waiting_bytes = 1 << 12,
                                    .gap_line =
                                        [](std::uint64_t lost, const std::string& reason) {
                                          return std::to_string(lost) + " " + reason + "\n";
                                        },
                                    .tell = news.teller()});
  std::uint64_t refused = 0;
  std::string text(64, 'x');
  text.back() = '\n';
  for (int i = 0; i < 5'000; ++i) {
    refused += log.add(text) ? 0U : 1U;
  }
  ASSERT_GT(refused, 1'000U);
  std::string all;
  std::array<char, 4096> piece{};
  const std::int64_t until_ns = monotonic_ns() + 20'000'000'000;
  while (all.find("too slow\n") == std::string::npos && monotonic_ns() < until_ns) {
    pollfd readable{reader.get(), POLLIN, 0};
    wait_until(monotonic_ns() + 100'000'000, {&readable, 1});
    const ssize_t count = ::read(reader.get(), piece.data(), piece.size());
    if (count > 0) all.append(piece.data(), static_cast<std::size_t>(count));
  }
  EXPECT_THAT(all, testing::EndsWith("x\n" + std::to_string(refused) + " the disk is too slow\n"));
  const std::vector<std::string> told = news.wait_for(2);
  ASSERT_EQ(told.size(), 2U) << testing::PrintToString(told);
  EXPECT_THAT(told[0], HasSubstr(file.string() + ": lines are being lost: the disk is too slow"));
  EXPECT_THAT(told[1], HasSubstr("is written again; " + std::to_string(refused) + " lines were lost"));
}

TEST_F(BackgroundLogTest, AFullDiskIsToldByItsReason) {
  News news;
  BackgroundLog log(LogFile("/dev/full"), {.tell = news.teller()});
  for (int i = 0; i < 100; ++i) EXPECT_TRUE(log.add(line(i)));
  EXPECT_THAT(news.wait_for(1),
              testing::ElementsAre(HasSubstr("lines are being lost: No space left on device")));
  const LogCount count = log.close();
  EXPECT_EQ(count.lines, 0U);
  EXPECT_EQ(count.lost, 100U);
}

}  // namespace
}  // namespace gaitway::process
