// Kills a process that writes, at many instants: what it leaves behind is whole lines without a gap, and a
// summary that is one of those that it wrote, whole.
#include <fcntl.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <random>
#include <string>

#include "gaitway/process/background_log.hpp"
#include "gaitway/process/log_file.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::process {
namespace {

// A counter that outlives the process that counts.
class SharedCount {
 public:
  SharedCount()
      : place_(mmap(nullptr, sizeof(std::atomic<std::uint64_t>), PROT_READ | PROT_WRITE,
                    MAP_SHARED | MAP_ANONYMOUS, -1, 0)),
        count_(new (place_) std::atomic<std::uint64_t>(0)) {}
  SharedCount(const SharedCount&) = delete;
  SharedCount& operator=(const SharedCount&) = delete;
  ~SharedCount() { munmap(place_, sizeof(std::atomic<std::uint64_t>)); }
  std::atomic<std::uint64_t>& operator*() const { return *count_; }

 private:
  void* place_;
  std::atomic<std::uint64_t>* count_;
};

class KilledWriter : public testing::Test {
 protected:
  // `write` goes on until it is killed, at a random instant of the first milliseconds after it said that it
  // has begun, by the count.
  void kill_while(const std::function<void(std::atomic<std::uint64_t>&)>& write) {
    *count = 0;
    const pid_t child = fork();
    ASSERT_GE(child, 0);
    if (child == 0) {
      write(*count);
      _exit(1);
    }
    const std::int64_t until_ns = monotonic_ns() + 10'000'000'000;
    while (*count == 0 && monotonic_ns() < until_ns) {
      wait_until(monotonic_ns() + 20'000, {});
    }
    wait_until(monotonic_ns() + std::uniform_int_distribution<std::int64_t>(0, 3'000'000)(random), {});
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "it ended by itself";
  }
  [[nodiscard]] static std::string content(const std::filesystem::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  // Of "N xxx…\n" lines that begin with `first`: how many whole ones; each other than it should be is a
  // failure.
  static std::uint64_t check_lines(const std::string& text, std::uint64_t first) {
    std::uint64_t lines = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = text.find('\n', at);
      if (end == std::string::npos) break;  // the last one, torn
      EXPECT_EQ(text.substr(at, end - at + 1), line(first + lines));
      if (testing::Test::HasFailure()) break;
      at = end + 1;
      ++lines;
    }
    return lines;
  }
  static std::string line(std::uint64_t number) {
    return std::to_string(number) + " " + std::string(number % 97, 'x') + "\n";
  }

  static constexpr int kKills = 25;
  PrivateFolder folder{"gaitway_log_kill"};
  std::filesystem::path file = folder.path() / "walk.log";
  SharedCount count;
  std::mt19937_64 random{20'261};
};

TEST_F(KilledWriter, LeavesEveryLineThatWasAppended) {
  for (int kill = 0; kill < kKills && !HasFailure(); ++kill) {
    kill_while([this](std::atomic<std::uint64_t>& appended) {
      LogFile log(file);
      for (std::uint64_t number = 0;; ++number) {
        log.append(line(number));
        appended = number + 1;
      }
    });
    EXPECT_GE(check_lines(content(file), 0), count.operator*()) << "kill " << kill;
  }
}

TEST_F(KilledWriter, LeavesWholeLinesOfALogInTheBackgroundAndGoesOnWithThem) {
  std::uint64_t first = 0;
  for (int kill = 0; kill < kKills && !HasFailure(); ++kill) {
    kill_while([this, first](std::atomic<std::uint64_t>& handed_over) {
      BackgroundLog log(LogFile(file, {.start = LogOptions::Start::go_on}));
      for (std::uint64_t number = first;;) {
        number += log.add(line(number)) ? 1U : 0U;
        handed_over = number + 1;
      }
    });
    first = check_lines(content(file), 0);
  }
  EXPECT_GT(first, static_cast<std::uint64_t>(kKills)) << "it has written, each time";
}

TEST_F(KilledWriter, KeepsTheBoundAndLosesNothingBetweenTwoFiles) {
  for (int kill = 0; kill < kKills && !HasFailure(); ++kill) {
    std::filesystem::remove(file);
    std::filesystem::remove(file.string() + ".1");
    kill_while([this](std::atomic<std::uint64_t>& appended) {
      LogFile log(file, {.most_bytes = 2'000});
      for (std::uint64_t number = 0;; ++number) {
        log.append(line(number));
        appended = number + 1;
      }
    });
    const std::string before = content(file.string() + ".1"), now = content(file);
    const std::string both = before + now;
    EXPECT_LE(both.size(), 4'000U);
    const std::uint64_t first = both.empty() ? 0 : std::stoull(both);
    EXPECT_GE(first + check_lines(both, first), count.operator*()) << "kill " << kill;
  }
}

TEST_F(KilledWriter, LeavesASummaryThatIsWhole) {
  const auto text = [](std::uint64_t number) {
    return std::to_string(number) + std::string(20'000 + number % 997, 'x') + " end\n";
  };
  for (int kill = 0; kill < kKills && !HasFailure(); ++kill) {
    kill_while([&](std::atomic<std::uint64_t>& written) {
      for (std::uint64_t number = 1;; ++number) {
        replace_text_file(file, text(number));
        written = number;
      }
    });
    const std::string left = content(file);
    const std::uint64_t number = std::stoull("0" + left);
    EXPECT_TRUE(number == *count || number == *count + 1) << "kill " << kill;
    EXPECT_EQ(left, text(number)) << "kill " << kill;
  }
}

}  // namespace
}  // namespace gaitway::process
