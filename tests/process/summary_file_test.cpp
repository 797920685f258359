// The newest summary is on the disk while the work goes on, and the last one at the end; a full disk is told,
// and leaves the one before.
#include "gaitway/process/summary_file.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <sys/resource.h>
#include <sys/stat.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

#include "gaitway/process/log_file.hpp"
#include "gaitway/process/private_folder.hpp"
#include "gaitway/process/real_time.hpp"
#include "gaitway/process/spare_room.hpp"
#include "gaitway/process/text_file.hpp"

namespace gaitway::process {
namespace {

using testing::HasSubstr;

// Words that all say the same, unless they were torn.
struct Figures {
  std::array<std::uint64_t, 400> word{};
};

std::string content_of(const std::filesystem::path& file) {
  std::ifstream in(file);
  return {std::istreambuf_iterator<char>(in), {}};
}

TEST(NewestValue, IsWholeAndNeverOlderThanTheOneBefore) {
  constexpr std::uint64_t kLast = 50'000;
  const auto newest = std::make_unique<NewestValue<Figures>>();
  EXPECT_EQ(newest->take(), nullptr);
  std::thread offers([&newest] {
    Figures figures;
    for (std::uint64_t number = 1; number <= kLast; ++number) {
      figures.word.fill(number);
      newest->offer(figures);
    }
  });
  std::uint64_t seen = 0;
  bool torn = false;
  while (seen < kLast) {
    const Figures* const taken = newest->take();
    if (taken == nullptr) continue;
    torn = torn || taken->word[0] <= seen || taken->word.front() != taken->word.back() ||
           taken->word[200] != taken->word[0];
    seen = taken->word[0];
    if (torn) break;
  }
  offers.join();
  EXPECT_FALSE(torn) << seen;
}

TEST(SummaryFile, IsThereBeforeTheEndAndSaysAtTheEndThatItIsTheEnd) {
  const PrivateFolder folder("gaitway_summary_file");
  const std::filesystem::path file = folder.path() / "summary.json";
  SummaryFile<int> summary(file, [](const int& value) { return std::to_string(value) + ", not ended\n"; },
                           {});
  summary.offer(6);
  summary.offer(7);
  const std::int64_t until_ns = monotonic_ns() + 10'000'000'000;
  while (!std::filesystem::exists(file) && monotonic_ns() < until_ns) {
    wait_until(monotonic_ns() + 5'000'000, {});
  }
  EXPECT_EQ(content_of(file), "7, not ended\n");
  EXPECT_EQ(summary.end("8, ended\n"), "");
  EXPECT_EQ(content_of(file), "8, ended\n");
}

// Nobody else's file can have the room that is kept; and it goes with the process.
TEST(SpareRoom, BelongsToItsKeeperUntilItIsGivenBack) {
  const PrivateFolder folder("gaitway_spare_room");
  constexpr std::uint64_t kRoom_bytes = std::uint64_t{64} << 20;
  const auto available = [&folder] { return std::filesystem::space(folder.path()).available; };
  const auto near = [](std::uint64_t one, std::uint64_t other) {
    return (one > other ? one - other : other - one) < kRoom_bytes / 2;  // others use this disk as well
  };
  const std::uint64_t before = available();
  if (before < 4 * kRoom_bytes) GTEST_SKIP() << "this disk is too full to tell";
  SpareRoom room(folder.path(), kRoom_bytes);
  EXPECT_TRUE(near(available(), before - kRoom_bytes));
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  room.give_back();
  EXPECT_TRUE(near(available(), before));
  room.take();
  EXPECT_TRUE(near(available(), before - kRoom_bytes));
}

TEST(SummaryFile, SaysWhyItsEndIsNotWritten) {
  SummaryFile<int> summary("/nowhere/at/all.json", [](const int&) { return std::string("x"); }, {});
  EXPECT_THAT(summary.end("end"), HasSubstr("/nowhere/at/all.json: cannot be written: No such file"));
}

TEST(ReplacedTextFile, KeepsTheOneBeforeWhereTheDiskIsFull) {
  const PrivateFolder folder("gaitway_replaced_file");
  const std::filesystem::path file = folder.path() / "summary.json";
  replace_text_file(file, "before\n");
  const LogFile ignores_the_signal(folder.path() / "log");
  rlimit before{};
  getrlimit(RLIMIT_FSIZE, &before);
  const rlimit limit{10, before.rlim_max};
  setrlimit(RLIMIT_FSIZE, &limit);
  std::string error;
  try {
    replace_text_file(file, std::string(100, 'x'));
  } catch (const std::runtime_error& problem) {
    error = problem.what();
  }
  setrlimit(RLIMIT_FSIZE, &before);
  EXPECT_THAT(error, HasSubstr("summary.json: cannot be written: File too large"));
  EXPECT_EQ(content_of(file), "before\n");
  EXPECT_FALSE(std::filesystem::exists(file.string() + ".new"));
}

TEST(ReplacedTextFile, DevicesAndLinksStayWhatTheyAre) {
  replace_text_file("/dev/null", "x");
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
  EXPECT_THROW(replace_text_file("/dev/full", "x"), std::runtime_error);
  const PrivateFolder folder("gaitway_replaced_file");
  std::filesystem::create_symlink("real.json", folder.path() / "link.json");
  replace_text_file(folder.path() / "real.json", "a");
  replace_text_file(folder.path() / "link.json", "b");
  EXPECT_TRUE(std::filesystem::is_symlink(folder.path() / "link.json"));
  EXPECT_EQ(content_of(folder.path() / "real.json"), "b");
}

}  // namespace
}  // namespace gaitway::process
