// What keys mean: each use of a sub-tree has a blackboard of its own, and sees of others what it is given.
#include <gtest/gtest.h>

#include <memory>
#include <string>

#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

// Writes its port `what` into its port `to`.
class Put final : public Action {
 public:
  Outcome on_start(Call& call) noexcept override {
    return call.set(1, call.value(0)) ? Outcome::success : Outcome::failure;
  }
  Outcome on_running(Call&) noexcept override { return Outcome::failure; }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }
};

class Blackboards : public testing::Test {
 protected:
  Blackboards() {
    const ValueType metres{.kind = ValueKind::number, .unit = "m", .lowest = 0.0, .highest = 9.0};
    script_.registry().add_action(
        {.id = "Put",
         .ports = {{.name = "what", .type = metres},
                   {.name = "to", .type = metres, .direction = PortDirection::output}}},
        [] { return std::make_unique<Put>(); });
  }

  Tree tree(const std::string& trees) {
    return {parse_tree("<root BTCPP_format=\"4\" main_tree_to_execute=\"M\">" + trees + "</root>", "t.xml",
                       script_.registry()),
            script_.registry()};
  }
  static double number(const Tree& tree, const char* key) {
    const auto entry = tree.entry(key);
    return entry ? std::get<double>(tree.values()[*entry]) : -1.0;
  }

  Script script_;
};

TEST_F(Blackboards, ASubTreeSeesOnlyWhatItIsGiven) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="S" output_key="how"/><SubTree ID="U"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><Sequence><SetBlackboard value="F" output_key="how"/><A does="{how}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+F =F");
  EXPECT_EQ(std::get<Text>(run.values()[*run.entry("how")]).view(), "S");
}

TEST_F(Blackboards, PortsOfASubTreeAreEntriesAroundIt) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="F" output_key="outer"/><SubTree ID="U" inner="{outer}"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><SubTree ID="V" how="{inner}"/></BehaviorTree>
    <BehaviorTree ID="V"><A does="{how}"/></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+F =F");
}

TEST_F(Blackboards, WhatASubTreeWritesGoesOut) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SubTree ID="U" to="{there}" far="2 m"/><Put what="{there}" to="{copy}"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><Put what="{far}" to="{to}"/></BehaviorTree>)");
  EXPECT_EQ(run.tick(0), NodeStatus::success);
  EXPECT_EQ(number(run, "copy"), 2.0);
}

TEST_F(Blackboards, AutoremapSharesAllButPrivateKeys) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="S" output_key="how"/><SetBlackboard value="S" output_key="_how"/>
      <SubTree ID="U" _autoremap="true"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><Sequence><A does="{how}"/><SetBlackboard value="F" output_key="_how"/><A does="{_how}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+S A+F =F");
  EXPECT_EQ(std::get<Text>(run.values()[*run.entry("_how")]).view(), "S");
}

TEST_F(Blackboards, TheMainTreesEntriesAreReachedFromEverywhere) {
  Tree run =
      tree(R"(<BehaviorTree ID="M"><Sequence><SubTree ID="U"/><A does="{how}"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><SetBlackboard value="F" output_key="@how"/></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+F =F");
}

TEST_F(Blackboards, AnEqualsSignIsThePortsOwnName) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="F" output_key="does"/><A does="{=}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+F =F");
}

TEST_F(Blackboards, TheOwnerOfTheTreeSetsAndReadsEntries) {
  Tree run = tree(R"(<BehaviorTree ID="M"><Put what="{goal}" to="{seen}"/></BehaviorTree>)");
  EXPECT_EQ(run.tick(0), NodeStatus::failure) << "nothing is set";
  const auto goal = run.entry("goal");
  ASSERT_TRUE(goal);
  EXPECT_FALSE(run.entry("gaol"));
  EXPECT_FALSE(run.set_value(*goal, Text("far"))) << "of another type";
  EXPECT_FALSE(run.set_value(*goal, 10.0)) << "beyond what the port takes";
  EXPECT_FALSE(run.set_value(99, 1.0)) << "no entry";
  EXPECT_TRUE(run.set_value(*goal, 3.0));
  EXPECT_EQ(run.tick(1), NodeStatus::success);
  EXPECT_EQ(number(run, "seen"), 3.0);
}

TEST_F(Blackboards, ASwitchComparesValuesOfTheEntrysType) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><Put what="50 cm" to="{d}"/><Switch2 variable="{d}" case_1="500 mm" case_2="2 m"><A/><B/><C/></Switch2></Sequence></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 1), "A+S =S");
}

TEST_F(Blackboards, CopiesGiveEntriesOneType) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="70 cm" output_key="a"/><SetBlackboard value="{a}" output_key="b"/>
      <SetBlackboard value="{b}" output_key="c"/><Put what="{c}" to="{d}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(run.tick(0), NodeStatus::success);
  EXPECT_DOUBLE_EQ(number(run, "d"), 0.7);
}

// Succeeds where its port holds the text "7" or the number 7.
class Seven final : public Condition {
 public:
  bool holds(Call& call) noexcept override {
    return call.value(0) == Value(Text("7")) || call.value(0) == Value(7.0);
  }
};

TEST_F(Blackboards, APortOfAnyTypeHasWhatItsEntryHolds) {
  script_.registry().add_condition({.id = "Seven", .ports = {{.name = "x"}}},
                                   [] { return std::make_unique<Seven>(); });
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><Seven x="7"/><Put what="7 m" to="{x}"/><Seven x="{x}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(run.tick(0), NodeStatus::success);
}

TEST_F(Blackboards, CountsAndTimesComeFromEntriesToo) {
  Tree run = tree(
      R"(<BehaviorTree ID="M"><Sequence><SetBlackboard value="2" output_key="n"/><Repeat num_cycles="{n}"><A/></Repeat>
      <SetBlackboard value="0.01 s" output_key="t"/><Sleep msec="{t}"/></Sequence></BehaviorTree>)");
  EXPECT_EQ(trace(run, script_, 3), "A+S =R | A+S =R | =S");
}

}  // namespace
}  // namespace gaitway::behaviour::test
