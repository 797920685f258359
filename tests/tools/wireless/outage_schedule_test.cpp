#include "tools/wireless/outage_schedule.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

namespace gaitway::tools {
namespace {

constexpr std::int64_t kMillisecond_ns = 1'000'000;

TEST(OutageSchedule, OverlappingAndTouchingOutagesAreOne) {
  OutageSchedule schedule;
  schedule.add({50, 60});
  schedule.add({10, 20});
  schedule.add({20, 30});
  schedule.add({25, 28});
  schedule.add({40, 40});
  EXPECT_EQ(schedule.all(), (std::vector<Outage>{{10, 30}, {50, 60}}));
  schedule.add({15, 55});
  EXPECT_EQ(schedule.all(), (std::vector<Outage>{{10, 60}}));
}

TEST(OutageSchedule, TheEndIsUpAgain) {
  OutageSchedule schedule;
  schedule.add({10, 20});
  EXPECT_FALSE(schedule.covering(9));
  EXPECT_TRUE(schedule.covering(10));
  EXPECT_TRUE(schedule.covering(19));
  EXPECT_FALSE(schedule.covering(20));
  EXPECT_TRUE(schedule.overlapping(0, 10));
  EXPECT_FALSE(schedule.overlapping(0, 9));
  EXPECT_FALSE(schedule.overlapping(20, 30));
}

TEST(OutageSchedule, EdgesComeInOrder) {
  OutageSchedule schedule;
  schedule.add({10, 20});
  schedule.add({30, 40});
  std::vector<std::int64_t> instants;
  bool down = false;
  for (auto edge = schedule.edge_after(0); edge; edge = schedule.edge_after(edge->at_ns)) {
    instants.push_back(edge->at_ns);
    EXPECT_NE(edge->down, down);
    down = edge->down;
  }
  EXPECT_EQ(instants, (std::vector<std::int64_t>{10, 20, 30, 40}));
}

TEST(OutageSchedule, DrawsSoManyOfSoLong) {
  const RandomOutages wanted{2000, 300 * kMillisecond_ns, 10'000 * kMillisecond_ns, 100 * kMillisecond_ns,
                             500 * kMillisecond_ns};
  const std::vector<Outage> outages = draw_outages(wanted, 7, 1000);
  ASSERT_EQ(outages.size(), wanted.count);
  std::int64_t up_since_ns = 1000;
  double length_sum = 0.0, up_sum = 0.0;
  for (const Outage& outage : outages) {
    EXPECT_GE(outage.begin_ns - up_since_ns, wanted.shortest_up_ns);
    EXPECT_LE(outage.begin_ns - up_since_ns, wanted.longest_up_ns);
    EXPECT_GE(outage.end_ns - outage.begin_ns, wanted.shortest_ns);
    EXPECT_LE(outage.end_ns - outage.begin_ns, wanted.longest_ns);
    up_sum += static_cast<double>(outage.begin_ns - up_since_ns);
    length_sum += static_cast<double>(outage.end_ns - outage.begin_ns);
    up_since_ns = outage.end_ns;
  }
  const double mean_length_ns =
      (10'000.0 - 300.0) / std::log(10'000.0 / 300.0) * kMillisecond_ns;  // log-uniform
  EXPECT_NEAR(length_sum / 2000.0, mean_length_ns, 0.1 * mean_length_ns);
  EXPECT_NEAR(up_sum / 2000.0, 300.0 * kMillisecond_ns, 12.0 * kMillisecond_ns);
  EXPECT_EQ(draw_outages(wanted, 7, 1000), outages);
  EXPECT_NE(draw_outages(wanted, 8, 1000), outages);
}

TEST(OutageSchedule, RefusesLengthsThatAreNone) {
  EXPECT_THROW(static_cast<void>(draw_outages({1, 0, 5, 1, 1}, 1, 0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(draw_outages({1, 6, 5, 1, 1}, 1, 0)), std::invalid_argument);
  EXPECT_THROW(static_cast<void>(draw_outages({1, 5, 5, 2, 1}, 1, 0)), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::tools
