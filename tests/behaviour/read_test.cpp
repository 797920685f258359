// Files that are accepted, and what is made of them.
#include "gaitway/behaviour/read.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <memory>

#include "scripted_leaves.hpp"

namespace gaitway::behaviour::test {
namespace {

TEST(Reading, ExplicitAndCompactSyntaxAreTheSame) {
  Script script;
  const Description compact =
      described("<Sequence name=\"s\"><P/><Inverter><A does=\"F\"/></Inverter></Sequence>", script);
  const Description verbose = described(
      "<Control ID=\"Sequence\" name=\"s\"><Condition ID=\"P\"/><Decorator ID=\"Inverter\"><Action ID=\"A\" "
      "does=\"F\"/></Decorator></Control>",
      script);
  ASSERT_EQ(compact.nodes.size(), 4U);
  ASSERT_EQ(verbose.nodes.size(), 4U);
  for (NodeIndex i = 0; i < 4; ++i) {
    EXPECT_EQ(compact.path(i), verbose.path(i));
    EXPECT_EQ(compact.nodes[static_cast<std::size_t>(i)].type,
              verbose.nodes[static_cast<std::size_t>(i)].type);
  }
}

TEST(Reading, NodesLieInPreOrderAndHavePathsOfTheirOwn) {
  Script script;
  const Description tree = described(
      "<Sequence><A/><A/><Fallback name=\"try\">\n<P/><A name=\"A#2\"/></Fallback><A/></Sequence>", script);
  const char* const paths[] = {"T/Sequence",       "T/Sequence/A",       "T/Sequence/A#2", "T/Sequence/try",
                               "T/Sequence/try/P", "T/Sequence/try/A#2", "T/Sequence/A#3"};
  ASSERT_EQ(tree.nodes.size(), std::size(paths));
  for (std::size_t i = 0; i < std::size(paths); ++i)
    EXPECT_EQ(tree.path(static_cast<NodeIndex>(i)), paths[i]);
  EXPECT_EQ(tree.nodes[0].end, 7);
  EXPECT_EQ(tree.nodes[0].children, 4);
  EXPECT_EQ(tree.nodes[2].next_sibling, 3);
  EXPECT_EQ(tree.nodes[3].end, 6);
  EXPECT_EQ(tree.nodes[3].next_sibling, 6);
  EXPECT_EQ(tree.nodes[6].next_sibling, kNoNode);
  EXPECT_EQ(tree.nodes[5].depth, 2);
  EXPECT_EQ(tree.nodes[4].line, 2);
}

TEST(Reading, SubTreesArePutInWhereTheyAreUsed) {
  Script script;
  const Description tree = parse_tree(R"(<root BTCPP_format="4" main_tree_to_execute="M">
    <BehaviorTree ID="U"><Sequence><A/><B/></Sequence></BehaviorTree>
    <BehaviorTree ID="M"><Sequence><SubTree ID="U" name="first"/><SubTree ID="U"/></Sequence></BehaviorTree></root>)",
                                      "t.xml", script.registry());
  ASSERT_EQ(tree.nodes.size(), 9U);
  EXPECT_EQ(tree.main_tree, "M");
  EXPECT_EQ(tree.path(4), "M/Sequence/first/Sequence/B");
  EXPECT_EQ(tree.path(8), "M/Sequence/U/Sequence/B");
  EXPECT_EQ(tree.nodes[1].next_sibling, 5);
}

TEST(Reading, WhatEditorsWriteIsPassedOver) {
  Script script;
  const Description tree = parse_tree(R"(<?xml version="1.0" encoding="UTF-8"?>
<root BTCPP_format="4" main_tree_to_execute="M" project_name="p">
  <BehaviorTree ID="M" _fullpath="m.xml"><A _description="does &quot;it&quot;" _uid="4" name="it"/></BehaviorTree>
  <TreeNodesModel>
    <Action ID="A" editable="true"><input_port name="does" type="std::string" default="S">what it answers</input_port><Metadata><Metadata x="y"/></Metadata></Action>
    <Action ID="OfAnotherRobot"><output_port name="x"/></Action>
  </TreeNodesModel>
</root>)",
                                      "t.xml", script.registry());
  EXPECT_EQ(tree.path(0), "M/it");
}

TEST(Reading, TheSubTreesModelHasStandardValues) {
  Script script;
  Tree tree(parse_tree(R"(<root BTCPP_format="4" main_tree_to_execute="M">
    <BehaviorTree ID="M"><Sequence><SubTree ID="U"/><SubTree ID="U" how="F"/></Sequence></BehaviorTree>
    <BehaviorTree ID="U"><A does="{how}"/></BehaviorTree>
    <TreeNodesModel><SubTree ID="U"><input_port name="how" default="RS"/></SubTree></TreeNodesModel></root>)",
                       "t.xml", script.registry()),
            script.registry());
  EXPECT_EQ(trace(tree, script, 2), "A+R =R | A.S A+F =F");
}

TEST(Reading, FilesAreRead) {
  Script script;
  const auto file = std::filesystem::temp_directory_path() / "gaitway_behaviour_read_test.xml";
  std::ofstream(file) << file_of("<A/>");
  EXPECT_EQ(read_tree(file, script.registry()).nodes.size(), 1U);
  std::filesystem::remove(file);
}

class Idle final : public Condition {
 public:
  bool holds(Call&) noexcept override { return true; }
};
ConditionMaker idle() {
  return [] { return std::make_unique<Idle>(); };
}

TEST(ARegistry, RefusesLeavesThatNoFileCouldUse) {
  Registry registry;
  registry.add_condition({.id = "Known"}, idle());
  const PortSpec port{.name = "p"};
  for (const LeafSpec& bad : std::initializer_list<LeafSpec>{
           {.id = "Known"},
           {.id = "Sequence"},
           {.id = "Script"},
           {.id = "SubTree"},
           {.id = "two words"},
           {.id = ""},
           {.id = "X", .ports = {port, port}},
           {.id = "X", .ports = {{.name = "name"}}},
           {.id = "X", .ports = {{.name = "_p"}}},
           {.id = "X", .ports = {{.name = "p", .type = {.kind = ValueKind::number, .unit = "furlong"}}}},
           {.id = "X", .ports = {{.name = "p", .type = {.kind = ValueKind::integer, .unit = "m"}}}},
           {.id = "X", .ports = {{.name = "p", .type = {.kind = ValueKind::choice}}}},
           {.id = "X", .ports = {{.name = "p", .type = {.kind = ValueKind::integer}, .standard = "many"}}},
           {.id = "X", .ports = {{.name = "p", .direction = PortDirection::output, .standard = "1"}}}}) {
    EXPECT_THROW(registry.add_condition(bad, idle()), std::invalid_argument) << bad.id;
  }
  EXPECT_THROW(registry.add_condition({.id = "X"}, {}), std::invalid_argument) << "without a maker";
  EXPECT_EQ(registry.leaves().size(), 1U);
}

TEST(ATree, IsMadeWithTheRegistryThatItWasCheckedAgainst) {
  Script script;
  const Description description = described("<A/>", script);
  EXPECT_THROW(Tree(description, Registry{}), std::invalid_argument);
  EXPECT_THROW(Tree(Description{}, script.registry()), std::invalid_argument);
}

}  // namespace
}  // namespace gaitway::behaviour::test
