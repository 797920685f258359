// Turns by a clock that only work moves.
#include "fair_turns.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace gaitway::api {
namespace {

std::int64_t clock_ns = 0;

class FairTurnsTest : public testing::Test {
 protected:
  struct Worker final : FairTurns::Worker {
    Worker(std::int64_t each_ns, int count) : piece_ns(each_ns), left(count) {}
    bool work() override {
      clock_ns += piece_ns;
      return --left > 0;
    }
    std::int64_t piece_ns;
    int left;
  };
  std::shared_ptr<Worker> add(std::int64_t piece_ns, int count) {
    auto worker = std::make_shared<Worker>(piece_ns, count);
    turns.add(worker);
    return worker;
  }
  FairTurns turns{{.each_ns = 200, .all_ns = 1000}, []() noexcept { return clock_ns; }};
};

TEST_F(FairTurnsTest, AllIsDoneWithinTheBudget) {
  const auto a = add(100, 3), b = add(50, 5);
  EXPECT_FALSE(turns.run());
  EXPECT_EQ(a->left + b->left, 0);
}

TEST_F(FairTurnsTest, ARunEndsWithThePieceThatSpendsTheBudget) {
  const auto worker = add(300, 10);
  const std::int64_t begin_ns = clock_ns;
  EXPECT_TRUE(turns.run());
  EXPECT_EQ(clock_ns - begin_ns, 1200);
  EXPECT_EQ(worker->left, 6);
  EXPECT_TRUE(turns.run());
  EXPECT_FALSE(turns.run());
  EXPECT_EQ(worker->left, 0);
}

TEST_F(FairTurnsTest, WhoNeedsLittleWaitsForNobodysDearWork) {
  std::vector<std::shared_ptr<Worker>> dear;
  for (int count = 0; count < 10; ++count) {
    dear.push_back(add(1000, 100));
  }
  const auto cheap = add(10, 100);
  int runs = 0;
  while (cheap->left > 0) {
    turns.run();
    ++runs;
  }
  int dear_done = 0;
  for (const auto& worker : dear) {
    dear_done += 100 - worker->left;
  }
  // 1000 ns of cheap work, 20 pieces of it a turn: five of his turns, of which each dear one has one.
  EXPECT_LE(dear_done, 30) << runs;
  EXPECT_GE(dear_done, 10);
}

TEST_F(FairTurnsTest, EqualsShareEqually) {
  const auto a = add(100, 1000), b = add(100, 1000);
  for (int count = 0; count < 10; ++count) {
    turns.run();
  }
  EXPECT_NEAR(a->left, b->left, 2);
}

}  // namespace
}  // namespace gaitway::api
