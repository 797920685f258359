// A running tree is changed: what goes on, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "random_tree.hpp"
#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class HotChange : public testing::Test {
 protected:
  Tree tree(const char* nodes) { return {described(nodes, script_), script_.registry()}; }
  Change change(Tree& tree, const char* nodes) {
    return tree.change(described(nodes, script_), script_.registry());
  }
  std::string next(Tree& tree, int ticks) {
    const std::string text = trace(tree, script_, ticks, tick_);
    tick_ += ticks;
    return text;
  }

  Script script_;
  int tick_ = 0;
};

TEST_F(HotChange, ARunningActionGoesOn) {
  Tree run = tree("<Sequence><A/><B does=\"RRS\"/></Sequence>");
  EXPECT_EQ(next(run, 1), "A+S B+R =R");
  const Change report = change(run, "<Sequence><A/><D/><B does=\"RRS\"/><C/></Sequence>");
  EXPECT_TRUE(report.done());
  EXPECT_EQ(report.kept, 3U);
  EXPECT_EQ(report.added, 2U);
  EXPECT_EQ(report.removed, 0U);
  EXPECT_TRUE(run.transitions().empty());
  EXPECT_EQ(next(run, 3), "B.R =R | B.S C+S =S | A+S D+S B+R =R")
      << "it goes on behind what is new before it";
}

TEST_F(HotChange, SoDoNodesThatHaveMoved) {
  Tree all =
      tree("<ParallelAll max_failures=\"2\"><A does=\"RRS\"/><B does=\"F\"/><C does=\"RF\"/></ParallelAll>");
  EXPECT_EQ(next(all, 1), "A+R B+F C+R =R");
  EXPECT_TRUE(change(all,
                     "<ParallelAll max_failures=\"2\"><C does=\"RF\"/><D/><B does=\"F\"/><A "
                     "does=\"RRS\"/></ParallelAll>")
                  .done());
  EXPECT_EQ(next(all, 2), "C.F D+S A.R =R | A.S =F") << "what has ended is not begun again, and counts";
}

TEST_F(HotChange, CountsOfWhatIsGoneDoNotStay) {
  Tree run =
      tree("<ParallelAll max_failures=\"2\"><A does=\"RS\"/><B does=\"F\"/><C does=\"F\"/></ParallelAll>");
  EXPECT_EQ(next(run, 1), "A+R B+F C+F =R");
  EXPECT_TRUE(
      change(run, "<ParallelAll max_failures=\"2\"><A does=\"RS\"/><C does=\"F\"/></ParallelAll>").done());
  EXPECT_EQ(next(run, 1), "A.S =S");
}

TEST_F(HotChange, CountersTimesAndMemoryGoOver) {
  Tree repeat = tree("<Repeat num_cycles=\"3\"><A/></Repeat>");
  EXPECT_EQ(next(repeat, 2), "A+S =R | A+S =R");
  EXPECT_TRUE(change(repeat, "<Repeat num_cycles=\"4\"><A/></Repeat>").done());
  EXPECT_EQ(next(repeat, 2), "A+S =R | A+S =S");

  Tree timeout = tree("<Timeout msec=\"20\"><A does=\"R\"/></Timeout>");
  EXPECT_EQ(next(timeout, 1), "A+R =R");
  EXPECT_TRUE(change(timeout, "<Timeout msec=\"20\"><A does=\"R\"/></Timeout>").done());
  EXPECT_EQ(next(timeout, 2), "A.R =R | A- =F");

  Tree once = tree("<RunOnce><A/></RunOnce>");
  EXPECT_EQ(next(once, 1), "A+S =S");
  EXPECT_TRUE(change(once, "<RunOnce then_skip=\"false\"><A/></RunOnce>").done());
  EXPECT_EQ(next(once, 1), "=S");

  Tree memory = tree("<SequenceWithMemory><A/><B does=\"F\"/></SequenceWithMemory>");
  EXPECT_EQ(next(memory, 2), "A+S =R | B+F =F");
  EXPECT_TRUE(change(memory, "<SequenceWithMemory><A/><C/><B does=\"F\"/></SequenceWithMemory>").done());
  EXPECT_EQ(next(memory, 1), "B+F =F");
  EXPECT_THAT(change(memory, "<SequenceWithMemory><A/></SequenceWithMemory>").refused,
              ElementsAre(HasSubstr("'T/SequenceWithMemory' goes on at 'B'")));
}

TEST_F(HotChange, WhatRunsMustStay) {
  Tree run = tree("<Sequence><P/><Inverter name=\"not\"><A does=\"R\"/></Inverter></Sequence>");
  EXPECT_EQ(next(run, 1), "P?S A+R =R");
  EXPECT_THAT(change(run, "<Sequence><P/><A does=\"R\"/></Sequence>").refused,
              ElementsAre("'T/Sequence/not' (Inverter) is running and is not in the new tree: wait for its "
                          "end, or halt the tree"));
  EXPECT_THAT(
      change(run, "<Sequence><P/><Inverter name=\"not\"><B does=\"R\"/></Inverter></Sequence>").refused,
      ElementsAre(HasSubstr("'T/Sequence/not/A' (A) is running")));
  EXPECT_THAT(
      change(run,
             "<Fallback name=\"Sequence\"><P/><Inverter name=\"not\"><A does=\"R\"/></Inverter></Fallback>")
          .refused,
      ElementsAre(HasSubstr("'T/Sequence' (Sequence) is running")));
  EXPECT_EQ(next(run, 1), "A.R =R") << "a refused change changes nothing";
}

TEST_F(HotChange, WhatComesToItsEndMustStay) {
  Tree run = tree("<ReactiveSequence><P does=\"SF\"/><A does=\"R\" ends=\"2\"/></ReactiveSequence>");
  EXPECT_EQ(next(run, 2), "P?S A+R =R | P?F A~ =R");
  EXPECT_FALSE(change(run, "<ReactiveSequence><P does=\"SF\"/></ReactiveSequence>").done());
  EXPECT_TRUE(
      change(run, "<ReactiveSequence><P does=\"SF\"/><A does=\"R\" ends=\"2\"/><B/></ReactiveSequence>")
          .done());
  EXPECT_EQ(next(run, 2), "A~~ =R | A~- =F");
}

TEST_F(HotChange, AnIdleTreeBecomesAnyOther) {
  Tree run = tree("<Sequence><A/></Sequence>");
  EXPECT_EQ(next(run, 1), "A+S =S");
  const Change report = change(run, "<Fallback><B/></Fallback>");
  EXPECT_TRUE(report.done());
  EXPECT_EQ(report.kept, 0U);
  EXPECT_EQ(report.removed, 2U);
  EXPECT_EQ(next(run, 1), "B+S =S");
}

TEST_F(HotChange, EntriesKeepTheirValues) {
  Tree run = tree("<Sequence><A does=\"{how}\"/></Sequence>");
  ASSERT_TRUE(run.set_value(*run.entry("how"), Text("F")));
  EXPECT_TRUE(
      change(run, "<Sequence><SetBlackboard value=\"S\" output_key=\"other\"/><A does=\"{how}\"/></Sequence>")
          .done());
  EXPECT_EQ(next(run, 1), "A+F =F");
  EXPECT_THAT(change(run, "<Repeat num_cycles=\"{how}\"><A/></Repeat>").refused,
              ElementsAre("the entry 'how' holds text ('F') and would become whole number"));
  Tree unset = tree("<Sequence><A does=\"{how}\"/></Sequence>");
  EXPECT_TRUE(change(unset, "<Repeat num_cycles=\"{how}\"><A/></Repeat>").done()) << "it holds nothing";
}

TEST_F(HotChange, ConstantsOfSubTreesAreThoseOfTheNewFile) {
  const auto file = [](const char* how) {
    return std::string(
               "<root BTCPP_format=\"4\" main_tree_to_execute=\"M\"><BehaviorTree ID=\"M\"><SubTree ID=\"U\" "
               "how=\"") +
           how + "\"/></BehaviorTree><BehaviorTree ID=\"U\"><A does=\"{how}\"/></BehaviorTree></root>";
  };
  Tree run(parse_tree(file("S"), "t.xml", script_.registry()), script_.registry());
  EXPECT_EQ(next(run, 1), "A+S =S");
  EXPECT_TRUE(run.change(parse_tree(file("F"), "t.xml", script_.registry()), script_.registry()).done());
  EXPECT_EQ(next(run, 1), "A+F =F");
}

TEST_F(HotChange, IsPreparedBesideTheTicksAndAdoptedBetweenThem) {
  Tree run = tree("<Sequence><A does=\"RRS\"/><B/></Sequence>");
  EXPECT_EQ(next(run, 1), "A+R =R");
  PreparedChange other = run.prepare(described("<Sequence><C/><B/></Sequence>", script_), script_.registry());
  EXPECT_EQ(next(run, 1), "A.R =R");
  EXPECT_FALSE(run.adopt(other));
  EXPECT_THAT(run.refusals(other), ElementsAre(HasSubstr("'T/Sequence/A' (A) is running")));
  EXPECT_EQ(next(run, 1), "A.S B+S =S");
  PreparedChange late = run.prepare(described("<Sequence><D/></Sequence>", script_), script_.registry());
  EXPECT_TRUE(run.refusals(other).empty());
  EXPECT_TRUE(run.adopt(other));
  EXPECT_EQ(next(run, 1), "C+S B+S =S");
  EXPECT_FALSE(run.adopt(late)) << "the tree is another by now";
  EXPECT_FALSE(run.adopt(other)) << "it holds what the tree was before";
  EXPECT_THAT(run.refusals(late), ElementsAre(HasSubstr("prepare it anew")));
  EXPECT_EQ(next(run, 1), "C+S B+S =S");
}

// Changed into the same, random trees do what they do unchanged.
TEST(HotChangeOfRandomTrees, IntoTheSameChangesNothing) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomLeaves leaves(seed), others(seed);
    const std::string file = random_file(seed, 60);
    Tree changed(parse_tree(file, "r.xml", leaves.registry()), leaves.registry());
    Tree left(parse_tree(file, "r.xml", others.registry()), others.registry());
    for (int tick = 0; tick < 60; ++tick) {
      leaves.begin_tick();
      others.begin_tick();
      ASSERT_EQ(changed.tick(tick * kTick_ns), left.tick(tick * kTick_ns))
          << "seed " << seed << ", tick " << tick;
      ASSERT_TRUE(std::ranges::equal(changed.statuses(), left.statuses()))
          << "seed " << seed << ", tick " << tick;
      const Change report = changed.change(parse_tree(file, "r.xml", leaves.registry()), leaves.registry());
      ASSERT_TRUE(report.done()) << report.refused[0];
      ASSERT_EQ(report.kept, left.description().nodes.size());
      ASSERT_TRUE(std::ranges::equal(changed.statuses(), left.statuses()))
          << "seed " << seed << ", tick " << tick;
    }
    for (const auto& watch : leaves.watches()) EXPECT_EQ(watch->fault, "");
  }
}

}  // namespace
}  // namespace gaitway::behaviour::test
