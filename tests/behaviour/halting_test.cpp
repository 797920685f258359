// Actions that take several ticks to come to their end: who waits for them, and that on_halt() comes once.
#include <gtest/gtest.h>

#include <string>

#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

std::string trace_of(const char* nodes, int ticks) {
  Script script;
  Tree tree(described(nodes, script), script.registry());
  return trace(tree, script, ticks);
}

TEST(Halting, ANodeHasItsResultOnceAllBelowItHaveEnded) {
  EXPECT_EQ(trace_of(R"(<ReactiveSequence><P does="SFS"/><A does="R" ends="2"/></ReactiveSequence>)", 5),
            "P?S A+R =R | P?F A~ =R | A~~ =R | A~- =F | P?S A+R =R");
}

TEST(Halting, SoWhatComesNextBeginsAfterThat) {
  EXPECT_EQ(
      trace_of(R"(<Fallback><Timeout msec="10"><A does="R" ends="1"/></Timeout><B does="RS"/></Fallback>)",
               4),
      "A+R =R | A~ =R | A~- B+R =R | B.S =S");
}

TEST(Halting, TheLongestDecides) {
  EXPECT_EQ(
      trace_of(
          R"(<Parallel><A does="R" ends="3"/><B does="RF"/><C does="R" ends="1"/><D does="R"/></Parallel>)",
          5),
      "A+R B+R C+R D+R =R | A.R B.F A~ C~ D- =R | A~~ C~- =R | A~~ =R | A~- =F");
}

TEST(Halting, BranchesGiveWayBeforeTheOtherBegins) {
  EXPECT_EQ(trace_of(R"(<WhileDoElse><P does="SFF"/><A does="R" ends="1"/><B does="R"/></WhileDoElse>)", 4),
            "P?S A+R =R | P?F A~ =R | A~- P?F B+R =R | P?S B- A+R =R");
  EXPECT_EQ(trace_of(R"(<WhileDoElse><P does="SFSS"/><A does="R" ends="3"/><B does="R"/></WhileDoElse>)", 6),
            "P?S A+R =R | P?F A~ =R | A~~ P?S =R | A~~ P?S =R | A~- P?S A+R =R | P?F A~ =R")
      << "a branch that is chosen again while it ends begins anew after that";
}

TEST(Halting, ASwitchGivesWayToo) {
  Script script;
  Tree tree(
      described(
          R"(<Switch2 variable="{v}" case_1="a" case_2="b"><A does="R" ends="2"/><B does="R"/><C does="R"/></Switch2>)",
          script),
      script.registry());
  const auto v = tree.entry("v");
  ASSERT_TRUE(v);
  ASSERT_TRUE(tree.set_value(*v, Text("a")));
  EXPECT_EQ(trace(tree, script, 1), "A+R =R");
  ASSERT_TRUE(tree.set_value(*v, Text("b")));
  EXPECT_EQ(trace(tree, script, 3, 1), "A~ =R | A~~ =R | A~- B+R =R");
  ASSERT_TRUE(tree.set_value(*v, Text("neither")));
  EXPECT_EQ(trace(tree, script, 1, 4), "B- C+R =R");
}

TEST(Halting, AReactiveNodeGoesOnWhileWhatItHaltedEnds) {
  EXPECT_EQ(
      trace_of(
          R"(<ReactiveFallback><Sequence><P does="FSSF"/><A does="RS"/></Sequence><B does="R" ends="4"/></ReactiveFallback>)",
          3),
      "P?F B+R =R | P?S A+R B~ =R | B~~ A.S =R")
      << "and has its result once that has ended";
}

TEST(Halting, WhatEndsIsNotBegunAgain) {
  EXPECT_EQ(trace_of(R"(<ReactiveSequence><A does="SRS"/><B does="R" ends="3"/></ReactiveSequence>)", 6),
            "A+S B+R =R | A+R B~ =R | B~~ A.S =R | B~~ A+S =R | B~- A+R =R | A.S B+R =R");
}

TEST(Halting, AHaltOfTheTreeIsCalledUntilItIsDone) {
  Script script;
  Tree tree(
      described(R"(<Parallel><A does="R" ends="2"/><Sequence><B does="R"/></Sequence></Parallel>)", script),
      script.registry());
  EXPECT_EQ(trace(tree, script, 1), "A+R B+R =R");
  EXPECT_FALSE(tree.halt(kTick_ns));
  EXPECT_EQ(script.take(), "A~ B- ");
  EXPECT_EQ(tree.statuses()[0], NodeStatus::idle);
  EXPECT_EQ(tree.statuses()[1], NodeStatus::halting);
  EXPECT_FALSE(tree.halt(2 * kTick_ns));
  EXPECT_TRUE(tree.halt(3 * kTick_ns));
  EXPECT_EQ(script.take(), "A~~ A~- ");
  EXPECT_TRUE(tree.halt(4 * kTick_ns));
  EXPECT_EQ(script.take(), "") << "there is nothing left to halt";
  EXPECT_EQ(trace(tree, script, 1, 5), "A+R B+R =R");
}

TEST(Halting, ATickWaitsForAHaltThatIsNotDone) {
  Script script;
  Tree tree(described(R"(<Sequence><A does="R" ends="2"/></Sequence>)", script), script.registry());
  EXPECT_EQ(trace(tree, script, 1), "A+R =R");
  EXPECT_FALSE(tree.halt(kTick_ns));
  EXPECT_EQ(script.take(), "A~ ");
  EXPECT_EQ(trace(tree, script, 2, 2), "A~~ =R | A~- A+R =R");
}

TEST(Halting, AHaltForgetsAResultThatWaits) {
  Script script;
  Tree tree(described(R"(<ReactiveSequence><P does="SF"/><A does="R" ends="3"/></ReactiveSequence>)", script),
            script.registry());
  EXPECT_EQ(trace(tree, script, 2), "P?S A+R =R | P?F A~ =R");
  EXPECT_EQ(tree.statuses()[0], NodeStatus::halting);
  EXPECT_FALSE(tree.halt(2 * kTick_ns));
  EXPECT_EQ(script.take(), "A~~ ") << "on_halt() comes once";
  EXPECT_FALSE(tree.halt(3 * kTick_ns));
  EXPECT_TRUE(tree.halt(4 * kTick_ns));
  EXPECT_EQ(trace(tree, script, 1, 5), "A~~ A~- P?S A+R =R");
}

TEST(Halting, WhatASubTreeDoesIsHalted) {
  Script script;
  Tree tree(parse_tree(R"(<root BTCPP_format="4" main_tree_to_execute="M">
      <BehaviorTree ID="M"><ReactiveSequence><P does="SF"/><SubTree ID="U"/></ReactiveSequence></BehaviorTree>
      <BehaviorTree ID="U"><Parallel><A does="R"/><Inverter><B does="R"/></Inverter></Parallel></BehaviorTree></root>)",
                       "t.xml", script.registry()),
            script.registry());
  EXPECT_EQ(trace(tree, script, 2), "P?S A+R B+R =R | P?F A- B- =F");
}

}  // namespace
}  // namespace gaitway::behaviour::test
