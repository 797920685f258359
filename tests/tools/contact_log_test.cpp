// Contacts of single milliseconds become episodes.
#include "tools/run/contact_log.hpp"

#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

namespace gaitway::tools {
namespace {

using simulator::BodyContact;

constexpr std::int64_t kMs = 1'000'000;

world::World three_boxes() {
  world::World world;
  for (const char* name : {"first", "second", "third"}) world.solids.emplace_back().name = name;
  return world;
}

void add(ContactLog& log, std::int64_t now_ns, std::span<const BodyContact> contacts,
         std::uint32_t geometry = 1) {
  log.add(now_ns, contacts, three_boxes(), geometry);
}

TEST(ContactLogTest, JoinsWhatIsNotBrokenForLong) {
  ContactLog log;
  for (std::int64_t ms = 101; ms <= 110; ++ms) add(log, ms * kMs, std::array{BodyContact{3, 1, 2.0}});
  add(log, 150 * kMs, std::array{BodyContact{3, 1, 7.0}});
  ASSERT_EQ(log.total(), 1U);
  const ContactEpisode& episode = log.episodes()[0];
  EXPECT_EQ(episode.from_ns, 100 * kMs);
  EXPECT_EQ(episode.to_ns, 150 * kMs);
  EXPECT_EQ(episode.peak_N, 7.0);
  EXPECT_NEAR(episode.impulse_Ns, 0.001 * (10 * 2.0 + 7.0), 1e-12);
  add(log, 250 * kMs, std::array{BodyContact{3, 1, 1.0}});
  EXPECT_EQ(log.total(), 1U) << "a break of 100 ms is none";
  add(log, 351 * kMs, std::array{BodyContact{3, 1, 1.0}});
  EXPECT_EQ(log.total(), 2U);
}

TEST(ContactLogTest, TellsLinksAndSolidsApart) {
  ContactLog log;
  add(log, 1 * kMs,
      std::array{BodyContact{3, 1, 2.0}, BodyContact{4, 1, 2.0}, BodyContact{3, 2, 2.0},
                 BodyContact{3, BodyContact::kFloor, 2.0}});
  add(log, 2 * kMs, std::array{BodyContact{3, 2, 5.0}, BodyContact{3, 1, 1.0}});
  ASSERT_EQ(log.total(), 4U);
  EXPECT_EQ(log.episodes()[0].to_ns, 2 * kMs);
  EXPECT_EQ(log.episodes()[1].to_ns, 1 * kMs);
  EXPECT_EQ(log.episodes()[2].peak_N, 5.0);
}

TEST(ContactLogTest, CountsOnBeyondWhatItKeeps) {
  ContactLog log;
  const std::int64_t count = static_cast<std::int64_t>(ContactLog::kMost) + 50;
  for (std::int64_t i = 1; i <= count; ++i) {
    add(log, i * 200 * kMs, std::array{BodyContact{0, 0, 1.0}});
    add(log, (i * 200 + 1) * kMs, std::array{BodyContact{0, 0, 1.0}});
  }
  EXPECT_EQ(log.total(), static_cast<std::uint64_t>(count));
  EXPECT_EQ(log.episodes().size(), ContactLog::kMost);
}

TEST(ContactLogTest, NamesTheSolidsOfTheWorldAsItWas) {
  ContactLog log;
  add(log, 1 * kMs, std::array{BodyContact{3, 1, 2.0}, BodyContact{3, BodyContact::kFloor, 2.0}});
  world::World without_first = three_boxes();
  without_first.solids.erase(without_first.solids.begin());
  log.add(2 * kMs, std::array{BodyContact{3, 1, 2.0}}, without_first, 2);
  ASSERT_EQ(log.total(), 3U) << "the number means another solid now";
  EXPECT_EQ(log.episodes()[0].with, "second");
  EXPECT_EQ(log.episodes()[1].with, "floor");
  EXPECT_EQ(log.episodes()[2].with, "third");
}

TEST(ContactLogTest, NamesBothLinksOfARobotThatHitsItself) {
  urdf::RobotModel robot;
  for (const char* name : {"pelvis", "left_foot", "right_foot"}) robot.links.emplace_back().name = name;
  ContactLog log;
  const auto hit = [](int link, int other) {
    return BodyContact{.link = link, .force_N = 2.0, .other_link = other};
  };
  for (std::int64_t ms = 1; ms <= 3; ++ms) {
    const std::array contacts{hit(1, 2), hit(0, 2), BodyContact{.link = 1, .force_N = 2.0}};
    log.add(ms * kMs, contacts, std::nullopt, 1);
  }
  ASSERT_EQ(log.total(), 3U);
  const nlohmann::ordered_json told = contacts_json(log, robot)["first"];
  EXPECT_EQ(told[0]["link"], "left_foot");
  EXPECT_EQ(told[0]["kind"], "link");
  EXPECT_EQ(told[0]["with"], "right_foot");
  EXPECT_EQ(told[1]["link"], "pelvis");
  EXPECT_EQ(told[2]["with"], "floor");
}

}  // namespace
}  // namespace gaitway::tools
