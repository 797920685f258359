// What one sees of a running tree: statuses after each tick, and what a tick has changed.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <string>

#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

std::string statuses(const Tree& tree) {
  std::string text;
  for (const NodeStatus status : tree.statuses()) text += "-RSFKH"[static_cast<std::size_t>(status)];
  return text;
}
std::string transitions(const Tree& tree) {
  std::string text;
  for (const Transition& change : tree.transitions()) {
    text += fmt::format("{}{}>{}@{} ", change.node, "-RSFKH"[static_cast<std::size_t>(change.from)],
                        "-RSFKH"[static_cast<std::size_t>(change.to)], change.time_ns / kTick_ns);
  }
  return text;
}

TEST(Statuses, StayUntilTheNodeAboveBeginsAnew) {
  Script script;
  Tree tree(
      described("<Sequence><P/><Inverter><A does=\"RF\"/></Inverter><B does=\"RS\"/></Sequence>", script),
      script.registry());
  EXPECT_EQ(statuses(tree), "-----");
  (void)tree.tick(0);
  EXPECT_EQ(statuses(tree), "RSRR-");
  (void)tree.tick(kTick_ns);
  EXPECT_EQ(statuses(tree), "RSSFR");
  (void)tree.tick(2 * kTick_ns);
  EXPECT_EQ(statuses(tree), "SSSFS") << "a result stays to be seen";
  (void)tree.tick(3 * kTick_ns);
  EXPECT_EQ(statuses(tree), "RSRR-");
  EXPECT_TRUE(tree.halt(4 * kTick_ns));
  EXPECT_EQ(statuses(tree), "-----");
}

TEST(Statuses, OfWhatComesToItsEnd) {
  Script script;
  Tree tree(described("<ReactiveSequence><P does=\"SF\"/><Inverter><A does=\"R\" "
                      "ends=\"1\"/></Inverter></ReactiveSequence>",
                      script),
            script.registry());
  (void)tree.tick(0);
  EXPECT_EQ(statuses(tree), "RSRR");
  (void)tree.tick(kTick_ns);
  EXPECT_EQ(statuses(tree), "HF-H");
  (void)tree.tick(2 * kTick_ns);
  EXPECT_EQ(statuses(tree), "FF--");
}

TEST(Transitions, TellWhatATickHasChanged) {
  Script script;
  Tree tree(described("<Sequence><P does=\"SF\"/><A does=\"RS\"/></Sequence>", script), script.registry());
  (void)tree.tick(0);
  EXPECT_EQ(transitions(tree), "1->S@0 2->R@0 0->R@0 ");
  (void)tree.tick(kTick_ns);
  EXPECT_EQ(transitions(tree), "2R>S@1 0R>S@1 ");
  (void)tree.tick(2 * kTick_ns);
  EXPECT_EQ(transitions(tree), "1S>F@2 2S>-@2 0S>F@2 ");
  (void)tree.tick(3 * kTick_ns);
  EXPECT_EQ(transitions(tree), "1F>S@3 2->R@3 0F>R@3 ");
}

TEST(Transitions, AreNoneWhereNothingIsNew) {
  Script script;
  Tree tree(described("<ReactiveSequence><P/><A does=\"R\"/></ReactiveSequence>", script), script.registry());
  (void)tree.tick(0);
  (void)tree.tick(kTick_ns);
  EXPECT_EQ(transitions(tree), "");
  Tree failing(described("<Sequence><P does=\"F\"/><A/></Sequence>", script), script.registry());
  (void)failing.tick(0);
  (void)failing.tick(kTick_ns);
  EXPECT_EQ(transitions(failing), "") << "it fails as it did before";
}

TEST(Time, DoesNotGoBack) {
  Script script;
  Tree tree(described("<Sequence><A does=\"RS\"/><Timeout msec=\"20\"><B does=\"R\"/></Timeout></Sequence>",
                      script),
            script.registry());
  EXPECT_EQ(tree.tick(5 * kTick_ns), NodeStatus::running);
  EXPECT_EQ(tree.tick(-kTick_ns), NodeStatus::running);
  EXPECT_EQ(transitions(tree), "1R>S@5 3->R@5 2->R@5 ");
  EXPECT_EQ(tree.tick(6 * kTick_ns), NodeStatus::running) << "the timeout began at 5, not before";
  EXPECT_EQ(tree.tick(7 * kTick_ns), NodeStatus::failure);
}

TEST(Time, MayBeAnyNumber) {
  Script script;
  Tree tree(described("<Timeout msec=\"1000\"><A does=\"R\"/></Timeout>", script), script.registry());
  EXPECT_EQ(tree.tick(std::numeric_limits<std::int64_t>::min()), NodeStatus::running);
  EXPECT_EQ(tree.tick(std::numeric_limits<std::int64_t>::max()), NodeStatus::failure);
}

}  // namespace
}  // namespace gaitway::behaviour::test
