// A loaded tree asks for no memory, whatever happens in it.
#include "allocation_count.hpp"

#include <gtest/gtest.h>

#include <memory>

#include "random_tree.hpp"

namespace gaitway::behaviour::test {
namespace {

using gaitway::test::allocation_count;

TEST(Allocation, NoneInTicksAndHalts) {
  long allocations = 0;
  std::size_t transitions = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomLeaves leaves(seed);
    Tree tree(parse_tree(random_file(seed, 80), "random.xml", leaves.registry()), leaves.registry());
    const auto v = tree.entry("v");
    const long before = allocation_count();
    for (int tick = 0; tick < 200; ++tick) {
      leaves.begin_tick();
      if (v) (void)tree.set_value(*v, Text("a text that does not fit into the place of a small one"));
      if (tick % 50 == 49) {
        (void)tree.halt(tick * 10'000'000LL);
      } else {
        (void)tree.tick(tick * 10'000'000LL);
      }
      transitions += tree.transitions().size();
    }
    allocations += allocation_count() - before;
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(transitions, 40'000U) << "much has happened";
}

TEST(Allocation, NoneInAChangeThatIsPrepared) {
  long allocations = 0;
  int adopted = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomLeaves leaves(seed);
    const std::string file = random_file(seed, 80);
    Tree tree(parse_tree(file, "random.xml", leaves.registry()), leaves.registry());
    for (int tick = 0; tick < 20; ++tick) {
      leaves.begin_tick();
      PreparedChange same =
          tree.prepare(parse_tree(file, "random.xml", leaves.registry()), leaves.registry());
      PreparedChange other = tree.prepare(
          parse_tree(random_file(seed + 1, 80), "random.xml", leaves.registry()), leaves.registry());
      const long before = allocation_count();
      (void)tree.tick(tick * 10'000'000LL);
      adopted += tree.adopt(tick % 2 == 0 ? same : other) ? 1 : 0;
      allocations += allocation_count() - before;
    }
  }
  EXPECT_EQ(allocations, 0);
  EXPECT_GT(adopted, 1000);
  EXPECT_LT(adopted, 2000) << "some are refused, which asks for no memory either";
}

TEST(Allocation, IsCounted) {
  const long before = allocation_count();
  const auto something = std::make_unique<int>(1);
  EXPECT_EQ(allocation_count() - before, 1 + (*something - 1));
}

}  // namespace
}  // namespace gaitway::behaviour::test
