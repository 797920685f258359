// What holds of every tree, whatever its leaves answer: on trees made at random.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

#include "random_tree.hpp"

namespace gaitway::behaviour::test {
namespace {

constexpr std::int64_t kTick_ns = 10'000'000;

class WatchedTree {
 public:
  WatchedTree(std::uint64_t seed, int nodes)
      : leaves_(seed),
        tree_(parse_tree(random_file(seed, nodes), "random.xml", leaves_.registry()), leaves_.registry()) {
    const Description& description = tree_.description();
    for (std::size_t i = 0; i < description.nodes.size(); ++i) {
      if (description.nodes[i].id == "Act") actions_.push_back(static_cast<NodeIndex>(i));
    }
  }

  NodeStatus tick(int count) {
    leaves_.begin_tick();
    return tree_.tick(count * kTick_ns);
  }
  bool halt(int count) {
    leaves_.begin_tick();
    return tree_.halt(count * kTick_ns);
  }

  // Everything that must hold between two ticks; empty: it does.
  [[nodiscard]] std::string fault() const {
    if (leaves_.conditions_seen_twice() > 0) return "a condition was asked twice in a tick";
    for (std::size_t i = 0; i < actions_.size(); ++i) {
      const Watch& watch = *leaves_.watches()[i];
      if (!watch.fault.empty()) return watch.fault;
      const bool open = watch.state == Watch::State::running;
      if (watch.started != watch.ended + watch.halted + (open ? 1 : 0)) return "not each start has one end";
      if (status(actions_[i]) == NodeStatus::running && !open) return "running without having been started";
      if (open != (status(actions_[i]) == NodeStatus::running))
        return "the status of an action is not its state";
      if ((watch.state == Watch::State::halting) != (status(actions_[i]) == NodeStatus::halting))
        return "halting";
    }
    return fault_of_structure();
  }

  [[nodiscard]] std::string digest() const {
    std::string text;
    for (const NodeStatus status : tree_.statuses())
      text += static_cast<char>('0' + static_cast<int>(status));
    return text;
  }
  [[nodiscard]] const Tree& tree() const { return tree_; }
  [[nodiscard]] bool all_idle() const {
    for (const auto& watch : leaves_.watches()) {
      if (watch->state != Watch::State::idle) return false;
    }
    return true;
  }
  [[nodiscard]] int halts() const {
    int count = 0;
    for (const auto& watch : leaves_.watches()) count += watch->halted;
    return count;
  }

 private:
  [[nodiscard]] NodeStatus status(NodeIndex node) const {
    return tree_.statuses()[static_cast<std::size_t>(node)];
  }

  // Nothing is active below what has ended or is idle, and nothing halts below what has ended.
  [[nodiscard]] std::string fault_of_structure() const {
    const std::vector<DescribedNode>& nodes = tree_.description().nodes;
    for (std::size_t i = 1; i < nodes.size(); ++i) {
      const NodeStatus below = status(static_cast<NodeIndex>(i)), above = status(nodes[i].parent);
      const bool ended =
          above == NodeStatus::success || above == NodeStatus::failure || above == NodeStatus::skipped;
      if (above == NodeStatus::idle && below != NodeStatus::idle && below != NodeStatus::halting) {
        return fmt::format("node {} is {} below an idle one", i, name(below));
      }
      if (ended && (below == NodeStatus::running || below == NodeStatus::halting)) {
        return fmt::format("node {} is {} below one that has ended", i, name(below));
      }
    }
    return "";
  }

  RandomLeaves leaves_;
  Tree tree_;
  std::vector<NodeIndex> actions_;
};

TEST(RandomTrees, KeepTheContractOfTheirLeaves) {
  int halts = 0;
  std::size_t nodes = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    WatchedTree run(seed, 10 + static_cast<int>(seed % 90));
    nodes += run.tree().description().nodes.size();
    for (int tick = 0; tick < 120; ++tick) {
      if (tick % 37 == 36) {
        (void)run.halt(tick);
      } else {
        (void)run.tick(tick);
      }
      ASSERT_EQ(run.fault(), "") << "seed " << seed << ", tick " << tick;
    }
    int tick = 120;
    for (; !run.halt(tick) && tick < 200; ++tick) ASSERT_EQ(run.fault(), "") << "seed " << seed;
    EXPECT_TRUE(run.all_idle()) << "seed " << seed;
    halts += run.halts();
  }
  EXPECT_GT(halts, 5000) << "these trees test halting";
  EXPECT_GT(nodes, 50'000U);
}

TEST(RandomTrees, DoTheSameWhenRunAgain) {
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    WatchedTree one(seed, 60), two(seed, 60);
    for (int tick = 0; tick < 60; ++tick) {
      ASSERT_EQ(one.tick(tick), two.tick(tick)) << "seed " << seed;
      ASSERT_EQ(one.digest(), two.digest()) << "seed " << seed << ", tick " << tick;
    }
  }
}

// A tick's transitions are the difference between what was seen before and after it.
TEST(RandomTrees, TellEveryTransition) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    WatchedTree run(seed, 60);
    std::string seen = run.digest();
    for (int tick = 0; tick < 60; ++tick) {
      (void)run.tick(tick);
      for (const Transition& change : run.tree().transitions()) {
        char& status = seen[static_cast<std::size_t>(change.node)];
        ASSERT_EQ(status, static_cast<char>('0' + static_cast<int>(change.from)));
        ASSERT_NE(change.from, change.to);
        status = static_cast<char>('0' + static_cast<int>(change.to));
      }
      ASSERT_EQ(seen, run.digest()) << "seed " << seed << ", tick " << tick;
    }
  }
}

// What the structure rules out does not come, whatever the leaves answer.
TEST(RandomTrees, SucceedOnlyWhereTheyMay) {
  int endless = 0, have_succeeded = 0;
  for (std::uint64_t seed = 0; seed < 2000; ++seed) {
    WatchedTree run(seed, 3 + static_cast<int>(seed % 40));
    const bool may = run.tree().description().may_succeed;
    endless += may ? 0 : 1;
    bool has = false;
    for (int tick = 0; tick < 120; ++tick) has = run.tick(tick) == NodeStatus::success || has;
    have_succeeded += has ? 1 : 0;
    EXPECT_TRUE(may || !has) << "seed " << seed;
  }
  EXPECT_GT(endless, 50) << "these trees test what can't succeed";
  EXPECT_GT(have_succeeded, 300);
}

}  // namespace
}  // namespace gaitway::behaviour::test
