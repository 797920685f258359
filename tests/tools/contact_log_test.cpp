// Contacts of single milliseconds become episodes.
#include "tools/run/contact_log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

namespace gaitway::tools {
namespace {

using simulator::BodyContact;

constexpr std::int64_t kMs = 1'000'000;

TEST(ContactLogTest, JoinsWhatIsNotBrokenForLong) {
  ContactLog log;
  for (std::int64_t ms = 101; ms <= 110; ++ms) log.add(ms * kMs, std::array{BodyContact{3, 1, 2.0}});
  log.add(150 * kMs, std::array{BodyContact{3, 1, 7.0}});
  ASSERT_EQ(log.total(), 1U);
  const ContactEpisode& episode = log.episodes()[0];
  EXPECT_EQ(episode.from_ns, 100 * kMs);
  EXPECT_EQ(episode.to_ns, 150 * kMs);
  EXPECT_EQ(episode.peak_N, 7.0);
  EXPECT_NEAR(episode.impulse_Ns, 0.001 * (10 * 2.0 + 7.0), 1e-12);
  log.add(250 * kMs, std::array{BodyContact{3, 1, 1.0}});
  EXPECT_EQ(log.total(), 1U) << "a break of 100 ms is none";
  log.add(351 * kMs, std::array{BodyContact{3, 1, 1.0}});
  EXPECT_EQ(log.total(), 2U);
}

TEST(ContactLogTest, TellsLinksAndSolidsApart) {
  ContactLog log;
  log.add(1 * kMs, std::array{BodyContact{3, 1, 2.0}, BodyContact{4, 1, 2.0}, BodyContact{3, 2, 2.0},
                              BodyContact{3, BodyContact::kFloor, 2.0}});
  log.add(2 * kMs, std::array{BodyContact{3, 2, 5.0}, BodyContact{3, 1, 1.0}});
  ASSERT_EQ(log.total(), 4U);
  EXPECT_EQ(log.episodes()[0].to_ns, 2 * kMs);
  EXPECT_EQ(log.episodes()[1].to_ns, 1 * kMs);
  EXPECT_EQ(log.episodes()[2].peak_N, 5.0);
}

TEST(ContactLogTest, CountsOnBeyondWhatItKeeps) {
  ContactLog log;
  const std::int64_t count = static_cast<std::int64_t>(ContactLog::kMost) + 50;
  for (std::int64_t i = 1; i <= count; ++i) {
    log.add(i * 200 * kMs, std::array{BodyContact{0, 0, 1.0}});
    log.add((i * 200 + 1) * kMs, std::array{BodyContact{0, 0, 1.0}});
  }
  EXPECT_EQ(log.total(), static_cast<std::uint64_t>(count));
  EXPECT_EQ(log.episodes().size(), ContactLog::kMost);
}

}  // namespace
}  // namespace gaitway::tools
