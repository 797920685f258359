// Whatever is wrong with a file is told with file, line, node, field, value, rule and remedy, and all at
// once.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <ostream>
#include <string>

#include "deep_tree.hpp"
#include "scripted_leaves.hpp"
#include "xml_document.hpp"

namespace gaitway::behaviour::test {
namespace {

class NeverCalled final : public Action {
 public:
  Outcome on_start(Call&) noexcept override { return Outcome::failure; }
  Outcome on_running(Call&) noexcept override { return Outcome::failure; }
  Halt on_halt(Call&) noexcept override { return Halt::ended; }
};

// GoTo has a port of each type.
const Registry& registry() {
  static Script script;
  static const bool kAdded = [] {
    script.registry().add_action(
        {.id = "GoTo",
         .ports = {{.name = "x",
                    .type = {.kind = ValueKind::number, .unit = "m", .lowest = -5.0, .highest = 5.0}},
                   {.name = "turn", .type = {.kind = ValueKind::number, .unit = "rad"}, .standard = "0 deg"},
                   {.name = "gait",
                    .type = {.kind = ValueKind::choice, .choices = {"slow", "fast"}},
                    .standard = "slow"},
                   {.name = "steps", .type = {.kind = ValueKind::integer, .lowest = 1.0}, .standard = "1"},
                   {.name = "backwards", .type = {.kind = ValueKind::boolean}, .standard = "false"},
                   {.name = "within", .type = {.kind = ValueKind::duration}, .standard = "5 s"},
                   {.name = "why", .type = {.kind = ValueKind::text}, .standard = ""},
                   {.name = "gone",
                    .type = {.kind = ValueKind::number, .unit = "m"},
                    .direction = PortDirection::output}}},
        [] { return std::make_unique<NeverCalled>(); });
    script.registry().add_action(
        {.id = "Far",
         .ports = {{.name = "x", .type = {.kind = ValueKind::number, .unit = "m", .lowest = 6.0}}}},
        [] { return std::make_unique<NeverCalled>(); });
    return true;
  }();
  (void)kAdded;
  return script.registry();
}

std::string complaint_of(const std::string& text) {
  try {
    (void)parse_tree(text, "t.xml", registry());
  } catch (const BadTree& bad) {
    return bad.what();
  }
  return "";
}

struct Bad {
  const char* name;
  std::string text;
  const char* complaint;
};
std::ostream& operator<<(std::ostream& stream, const Bad& bad) {
  return stream << bad.name;
}

class BadTrees : public testing::TestWithParam<Bad> {};

TEST_P(BadTrees, AreRefusedByName) {
  EXPECT_EQ(complaint_of(GetParam().text), GetParam().complaint) << GetParam().text;
}

std::string several(const char* outer) {
  return fmt::format("<root BTCPP_format=\"4\" main_tree_to_execute=\"T\">\n{}</root>", outer);
}

INSTANTIATE_TEST_SUITE_P(
    Nodes, BadTrees,
    testing::Values(
        Bad{"UnknownNode", file_of("<Sequence>\n<Gotoo x=\"1 m\"/></Sequence>"),
            "t.xml:2: T/Sequence/Gotoo: no node 'Gotoo' is known. Did you mean 'GoTo'?"},
        Bad{"UnknownNodeThatIsATree",
            several("<BehaviorTree ID=\"T\"><Sequence><U/></Sequence></BehaviorTree>\n<BehaviorTree "
                    "ID=\"U\"><A/></BehaviorTree>"),
            "t.xml:2: T/Sequence/U: no node 'U' is known. To use the tree of this name, write <SubTree "
            "ID=\"U\"/>."},
        Bad{"WrongKind", file_of("<Condition ID=\"A\"/>"),
            "t.xml:1: T/A <Condition> = A: is of the kind Action. Write <Action>."},
        Bad{"ExplicitWithoutId", file_of("<Action/>"),
            "t.xml:1: T/Action ID: <Action> needs it. Name the node."},
        Bad{"CompactWithId", file_of("<A ID=\"B\"/>"),
            "t.xml:1: T/A ID = B: stands only in <Action>, <Condition>, <Control>, <Decorator> and "
            "<SubTree>. Remove it; a name is given as name=\"...\"."},
        Bad{"LeafWithChild", file_of("<A><B/></A>"),
            "t.xml:1: T/A children = 1: must have no child. Remove what is too much."},
        Bad{"DecoratorWithoutChild", file_of("<Inverter/>"),
            "t.xml:1: T/Inverter children = 0: must have 1 child. Add what is missing."},
        Bad{"DecoratorWithTwo", file_of("<Inverter><A/><B/></Inverter>"),
            "t.xml:1: T/Inverter children = 2: must have 1 child. Put them below a Sequence or another "
            "control node."},
        Bad{"ControlWithoutChild", file_of("<Sequence/>"),
            "t.xml:1: T/Sequence children = 0: must have at least 1 child. Add what is missing."},
        Bad{"IfWithFour", file_of("<IfThenElse><P/><A/><B/><C/></IfThenElse>"),
            "t.xml:1: T/IfThenElse children = 4: must have 2 or 3 children. Remove what is too much."},
        Bad{"SwitchWithTooFew",
            file_of("<Switch2 variable=\"{v}\" case_1=\"a\" case_2=\"b\"><A/><B/></Switch2>"),
            "t.xml:1: T/Switch2 children = 2: must have 3 children. Add what is missing."},
        Bad{"SubTreeWithChild",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"U\"><A/></SubTree></BehaviorTree><BehaviorTree "
                    "ID=\"U\"><A/></BehaviorTree>"),
            "t.xml:2: T/U children = 1: must have no child. Remove what is too much."},
        Bad{"TwoNodesInATree", file_of("<A/><B/>"),
            "t.xml:1: T = 2 nodes: must hold exactly one node. Put several below a Sequence or another "
            "control node."},
        Bad{"NoNodeInATree", file_of(""),
            "t.xml:1: T = 0 nodes: must hold exactly one node. Put several below a Sequence or another "
            "control node."},
        Bad{"TextInANode", file_of("<Sequence>first <A/></Sequence>"),
            "t.xml:1: T/Sequence: has text in it. Write values as attributes."},
        Bad{"LongName", file_of(fmt::format("<A name=\"{}\"/>", std::string(128, 'n'))),
            "t.xml:1: T/nnnnnnnnnnnnnnnnnnnn... name = "
            "nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn"
            "nnnnnnnnnnnnnnnnnnnnnnnnnnnnnnnn: must have at most 127 bytes. Shorten it."},
        Bad{"Script", file_of("<Script code=\"a := 1\"/>"),
            "t.xml:1: T/Script: Script is not supported. Register a condition or an action, and connect it "
            "with the blackboard."},
        Bad{"Precondition", file_of("<A _skipIf=\"x == 1\"/>"),
            "t.xml:1: T/A _skipIf = x == 1: scripts before and after nodes are not supported. Put a "
            "condition before the node: in a Sequence, or, where it must hold all the time, in a "
            "ReactiveSequence."},
        Bad{"Postcondition", file_of("<A _onHalted=\"x = 1\"/>"),
            "t.xml:1: T/A _onHalted = x = 1: scripts before and after nodes are not supported. Put an action "
            "behind the node, or do it in on_halt()."},
        Bad{"MisspeltAttribute", file_of("<A _skipif=\"x\"/>"),
            "t.xml:1: T/A _skipif = x: is no port of A. Known here: does, ends."},
        Bad{"AsyncSequence", file_of("<AsyncSequence><A/></AsyncSequence>"),
            "t.xml:1: T/AsyncSequence: AsyncSequence is not supported. Use Sequence: nothing blocks here."},
        Bad{"TooHighThreshold", file_of("<Parallel success_count=\"3\"><A/><B/></Parallel>"),
            "t.xml:1: T/Parallel success_count = 3: must be at most 2, the number of children. -1 means all "
            "of them."}),
    [](const auto& row) { return std::string(row.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Ports, BadTrees,
    testing::Values(
        Bad{"Missing", file_of("<GoTo/>"),
            "t.xml:1: T/GoTo x: must be given (number in m). Write x=\"...\" or x=\"{key}\"."},
        Bad{"Unknown", file_of("<GoTo x=\"1 m\" gate=\"fast\"/>"),
            "t.xml:1: T/GoTo gate = fast: is no port of GoTo. Did you mean 'gait'?"},
        Bad{"NumberWithoutUnit", file_of("<GoTo x=\"0.5\"/>"),
            "t.xml:1: T/GoTo x = 0.5: must be a number with one of the units m, cm, mm. Write '0.5 m' or "
            "'0.5 cm' or '0.5 mm', as it is meant."},
        Bad{"NumberWithAnotherUnit", file_of("<GoTo x=\"0.5 s\"/>"),
            "t.xml:1: T/GoTo x = 0.5 s: must be a number with one of the units m, cm, mm."},
        Bad{"NumberThatIsNone", file_of("<GoTo x=\"far\"/>"),
            "t.xml:1: T/GoTo x = far: must be a number (in m)."},
        Bad{"NumberWithComma", file_of("<GoTo x=\"0,5 m\"/>"),
            "t.xml:1: T/GoTo x = 0,5 m: must be a number with a decimal point, not with a comma (in m). "
            "Write '0.5 m'."},
        Bad{"NumberOutOfRange", file_of("<GoTo x=\"700 cm\"/>"),
            "t.xml:1: T/GoTo x = 700 cm: must be -5..5 m."},
        Bad{"NotANumber", file_of("<GoTo x=\"nan m\"/>"),
            "t.xml:1: T/GoTo x = nan m: must be a number (in m)."},
        Bad{"Choice", file_of("<GoTo x=\"1 m\" gait=\"fsat\"/>"),
            "t.xml:1: T/GoTo gait = fsat: must be one of slow, fast. Did you mean 'fast'?"},
        Bad{"Integer", file_of("<GoTo x=\"1 m\" steps=\"1.5\"/>"),
            "t.xml:1: T/GoTo steps = 1.5: must be a whole number."},
        Bad{"IntegerOutOfRange", file_of("<GoTo x=\"1 m\" steps=\"0\"/>"),
            "t.xml:1: T/GoTo steps = 0: must be at least 1."},
        Bad{"Boolean", file_of("<GoTo x=\"1 m\" backwards=\"yes\"/>"),
            "t.xml:1: T/GoTo backwards = yes: must be true or false."},
        Bad{"Duration", file_of("<GoTo x=\"1 m\" within=\"5 m\"/>"),
            "t.xml:1: T/GoTo within = 5 m: must be a number with its unit: ns, us, ms or s. Write it like "
            "'200 ms'."},
        Bad{"NegativeDuration", file_of("<Timeout msec=\"-5\"><A/></Timeout>"),
            "t.xml:1: T/Timeout msec = -5: must be a number with its unit: ns, us, ms or s. Write it like "
            "'200 ms'."},
        Bad{"LongText", file_of(fmt::format("<GoTo x=\"1 m\" why=\"{}\"/>", std::string(128, 'w'))),
            "t.xml:1: T/GoTo why = "
            "wwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwwww"
            "wwwwwwwwwwwwwwwwwwwwwwwwwwwwwwww: must have at most 127 bytes. Shorten it."},
        Bad{"OutputWithoutEntry", file_of("<GoTo x=\"1 m\" gone=\"distance\"/>"),
            "t.xml:1: T/GoTo gone = distance: is an output: must name an entry of the blackboard. Write "
            "{distance}."},
        Bad{"EmptyKey", file_of("<GoTo x=\"{}\"/>"),
            "t.xml:1: T/GoTo x = {}: a key has 1 to 127 bytes, no blanks, braces or @ inside. Rename it."},
        Bad{"KeyWithBlank", file_of("<GoTo x=\"{my x}\"/>"),
            "t.xml:1: T/GoTo x = {my x}: a key has 1 to 127 bytes, no blanks, braces or @ inside. Rename "
            "it."},
        Bad{"KeyWrittenWithBraces", file_of("<SetBlackboard value=\"1\" output_key=\"{x}\"/>"),
            "t.xml:1: T/SetBlackboard output_key = {x}: must be the entry's name, without braces. Write "
            "'x'."},
        Bad{"TwoTypesOfOneEntry",
            file_of("<Sequence>\n<GoTo x=\"1 m\" gone=\"{d}\"/>\n<GoTo x=\"1 m\" turn=\"{d}\"/></Sequence>"),
            "t.xml:3: T/Sequence/GoTo#2 turn = {d}: takes number in rad, but line 2 has this entry as number "
            "in m. Use two entries, or ports of one type."},
        Bad{"RangesWithoutACommonValue",
            file_of("<Sequence><GoTo x=\"{d}\"/>\n<GoTo x=\"1 m\" turn=\"0 rad\" gone=\"{d}\"/>\n<Far "
                    "x=\"{d}\"/></Sequence>"),
            "t.xml:3: T/Sequence/Far x = {d}: takes no value that the other ports of this entry take (line "
            "1). "
            "Use two entries."},
        Bad{"ConstantForTypedEntry",
            file_of(
                "<Sequence><SetBlackboard value=\"half\" output_key=\"d\"/>\n<GoTo x=\"{d}\"/></Sequence>"),
            "t.xml:1: T/Sequence/SetBlackboard value = half: must be a number (in m)."},
        Bad{"CaseThatIsNoValue",
            file_of("<Sequence><GoTo x=\"1 m\" gait=\"{g}\"/><Switch2 variable=\"{g}\" case_1=\"slow\" "
                    "case_2=\"quick\"><A/><B/><C/></Switch2></Sequence>"),
            "t.xml:1: T/Sequence/Switch2 case_2 = quick: must be one of slow, fast. Known here: slow, fast."},
        Bad{"CaseThatIsAKey",
            file_of("<Switch2 variable=\"{g}\" case_1=\"{a}\" case_2=\"b\"><A/><B/><C/></Switch2>"),
            "t.xml:1: T/Switch2 case_1 = {a}: must be a value. Cases are fixed: only the variable changes."}),
    [](const auto& row) { return std::string(row.param.name); });

INSTANTIATE_TEST_SUITE_P(
    Trees, BadTrees,
    testing::Values(
        Bad{"AnotherRoot", "<tree/>",
            "t.xml:1: <tree>: the root element must be <root>. Write <root BTCPP_format=\"4\">."},
        Bad{"NoFormat", "<root><BehaviorTree ID=\"T\"><A/></BehaviorTree></root>",
            "t.xml:1: <root> BTCPP_format: must be \"4\". Trees of version 3 are brought to 4 by "
            "BehaviorTree.CPP's own script."},
        Bad{"FormatOfVersion3", "<root BTCPP_format=\"3\"><BehaviorTree ID=\"T\"><A/></BehaviorTree></root>",
            "t.xml:1: <root> BTCPP_format = 3: must be \"4\". Trees of version 3 are brought to 4 by "
            "BehaviorTree.CPP's own script."},
        Bad{"UnknownRootAttribute",
            "<root BTCPP_format=\"4\" main_tree=\"T\"><BehaviorTree ID=\"T\"><A/></BehaviorTree></root>",
            "t.xml:1: <root> main_tree = T: is no attribute here. Known here: BTCPP_format, "
            "main_tree_to_execute, project_name."},
        Bad{"NoTree", several(""), "t.xml:1: <root>: must hold a <BehaviorTree>. Add one."},
        Bad{"Include", several("<include path=\"b.xml\"/><BehaviorTree ID=\"T\"><A/></BehaviorTree>"),
            "t.xml:2: <include>: other files are not read. Put their trees into this file."},
        Bad{"UnknownOuterElement",
            several("<BehaviourTree ID=\"T\"><A/></BehaviourTree><BehaviorTree ID=\"T\"><A/></BehaviorTree>"),
            "t.xml:2: <BehaviourTree>: is no element of <root>. Did you mean 'BehaviorTree'?"},
        Bad{"TreeWithoutId",
            several("<BehaviorTree><A/></BehaviorTree><BehaviorTree ID=\"T\"><A/></BehaviorTree>"),
            "t.xml:2: <BehaviorTree> ID: must be given. Give the tree a name."},
        Bad{"TwoTreesOfOneName",
            several("<BehaviorTree ID=\"T\"><A/></BehaviorTree>\n<BehaviorTree ID=\"T\"><B/></BehaviorTree>"),
            "t.xml:3: <BehaviorTree> ID = T: line 2 has a tree of this name. Rename one of them."},
        Bad{"TreeNamedAsANode",
            several(
                "<BehaviorTree ID=\"T\"><A/></BehaviorTree>\n<BehaviorTree ID=\"GoTo\"><B/></BehaviorTree>"),
            "t.xml:3: <BehaviorTree> ID = GoTo: is the name of a node. Choose another."},
        Bad{"UnknownMainTree",
            "<root BTCPP_format=\"4\" main_tree_to_execute=\"Mian\"><BehaviorTree "
            "ID=\"Main\"><A/></BehaviorTree></root>",
            "t.xml:1: <root> main_tree_to_execute = Mian: is no tree of this file. Did you mean 'Main'?"},
        Bad{"NoMainTree",
            "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\"><A/></BehaviorTree><BehaviorTree "
            "ID=\"U\"><A/></BehaviorTree></root>",
            "t.xml:1: <root> main_tree_to_execute: must be given where there are several trees. Name the one "
            "that is run."},
        Bad{"UnknownSubTree",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"Patrl\"/></BehaviorTree><BehaviorTree "
                    "ID=\"Patrol\"><A/></BehaviorTree>"),
            "t.xml:2: T/Patrl ID = Patrl: is no tree of this file. Did you mean 'Patrol'?"},
        Bad{"SubTreeInItself",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"U\"/></BehaviorTree>\n<BehaviorTree "
                    "ID=\"U\"><Sequence><A/><SubTree ID=\"V\"/></Sequence></BehaviorTree>\n<BehaviorTree "
                    "ID=\"V\"><SubTree ID=\"U\"/></BehaviorTree>"),
            "t.xml:4: V/U ID = U: the sub-tree contains itself: U > V > U. Use Repeat or "
            "KeepRunningUntilFailure for what shall go on."},
        Bad{"PortThatNobodyUses",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"U\" gaol=\"{g}\"/></BehaviorTree><BehaviorTree "
                    "ID=\"U\"><GoTo x=\"{goal}\"/></BehaviorTree>"),
            "t.xml:2: T/U gaol = g: no node of the sub-tree uses this key. Did you mean 'goal'?"},
        Bad{"ConstantOfAnotherType",
            several("<BehaviorTree ID=\"T\">\n<SubTree ID=\"U\" goal=\"far\"/></BehaviorTree><BehaviorTree "
                    "ID=\"U\"><GoTo x=\"{goal}\"/></BehaviorTree>"),
            "t.xml:3: T/U goal = far: must be a number (in m)."},
        Bad{"PortThatTheModelWants",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"U\"/></BehaviorTree><BehaviorTree ID=\"U\"><GoTo "
                    "x=\"{goal}\"/></BehaviorTree><TreeNodesModel><SubTree ID=\"U\"><input_port "
                    "name=\"goal\"/></SubTree></TreeNodesModel>"),
            "t.xml:2: T/U goal: the sub-tree U needs it. Write goal=\"{key}\"."},
        Bad{"PortThatTheModelDoesNotKnow",
            several("<BehaviorTree ID=\"T\"><SubTree ID=\"U\" gaol=\"{g}\" "
                    "goal=\"{g}\"/></BehaviorTree><BehaviorTree ID=\"U\"><GoTo "
                    "x=\"{goal}\"/></BehaviorTree><TreeNodesModel><SubTree ID=\"U\"><input_port "
                    "name=\"goal\"/></SubTree></TreeNodesModel>"),
            "t.xml:2: T/U gaol = g: is no port of the sub-tree U. Did you mean 'goal'?"},
        Bad{"ModelOfAnotherKind",
            several("<BehaviorTree ID=\"T\"><A/></BehaviorTree><TreeNodesModel><Condition "
                    "ID=\"A\"/></TreeNodesModel>"),
            "t.xml:2: <Condition> ID = A: is registered as Action. Write <Action>."},
        Bad{"ModelWithAnotherPort",
            several("<BehaviorTree ID=\"T\"><A/></BehaviorTree><TreeNodesModel><Action "
                    "ID=\"GoTo\"><input_port name=\"y\"/></Action></TreeNodesModel>"),
            "t.xml:2: <input_port> name = y: is no port of the registered GoTo. Known here: x, turn, gait, "
            "steps, backwards, within, why, gone."}),
    [](const auto& row) { return std::string(row.param.name); });

TEST(BadTree, AllIsToldAtOnceInTheFilesOrder) {
  const std::string text = file_of(
      "<Sequence>\n<Foo/>\n<GoTo x=\"far\" steps=\"0\"/>\n<Inverter/>\n<SubTree ID=\"X\"/></Sequence>");
  try {
    (void)parse_tree(text, "t.xml", registry());
    FAIL() << "accepted";
  } catch (const BadTree& bad) {
    ASSERT_EQ(bad.complaints().size(), 5U) << bad.what();
    const TreeComplaint& second = bad.complaints()[1];
    EXPECT_EQ(second.file, "t.xml");
    EXPECT_EQ(second.line, 3);
    EXPECT_EQ(second.path, "T/Sequence/GoTo");
    EXPECT_EQ(second.field, "x");
    EXPECT_EQ(second.value, "far");
    EXPECT_EQ(second.rule, "must be a number (in m)");
  }
}

TEST(BadTree, ATreeOfMoreNodesThanAllowedIsRefused) {
  std::string most = "<Sequence>";
  for (std::size_t i = 1; i < kMostNodes; ++i) most += "<A/>";
  EXPECT_EQ(complaint_of(file_of(most + "</Sequence>")), "");
  EXPECT_EQ(complaint_of(file_of(most + "<A/></Sequence>")),
            "t.xml:1: T nodes = 10001: with its sub-trees, must have at most 10000 nodes. Make it smaller.");
}

TEST(BadTree, ATreeDeeperThanAllowedIsRefused) {
  EXPECT_EQ(complaint_of(deep_file(kMostDepth, "<A/>")), "");
  EXPECT_EQ(complaint_of(deep_file(kMostDepth + 1, "<A/>")),
            "t.xml:1: T depth = 1001: with its sub-trees, must be at most 1000 nodes deep. Make it flatter.");
}

TEST(BadTree, ElementsDeeperThanTheReaderGoesAreRefused) {
  std::string open, close;
  for (int i = 0; i < 1'000; ++i) {
    open += "<Inverter>\n";
    close += "</Inverter>";
  }
  EXPECT_EQ(
      complaint_of(file_of(open + "<A/>" + close)),
      fmt::format("t.xml:{}: <Inverter>: malformed XML: more than {} levels of elements. Use sub-trees.",
                  kMostLevels - 1, kMostLevels));
}

// Ten levels of sub-trees, each used ten times: a small file, 10^10 nodes.
TEST(BadTree, SubTreesThatGrowBeyondAllBoundsAreRefused) {
  std::string trees = "<BehaviorTree ID=\"T\"><SubTree ID=\"L0\"/></BehaviorTree>";
  for (int level = 0; level < 10; ++level) {
    trees += fmt::format("<BehaviorTree ID=\"L{}\"><Sequence>", level);
    for (int i = 0; i < 10; ++i) trees += fmt::format("<SubTree ID=\"L{}\"/>", level + 1);
    trees += "</Sequence></BehaviorTree>";
  }
  EXPECT_EQ(
      complaint_of(several((trees + "<BehaviorTree ID=\"L10\"><A/></BehaviorTree>").c_str())),
      "t.xml:2: T nodes = 1000000000: with its sub-trees, must have at most 10000 nodes. Make it smaller.");
}

TEST(BadTree, ComplaintsAreCountedUpToABound) {
  std::string many = "<Sequence>";
  for (int i = 0; i < 5000; ++i) many += "<Unknown/>";
  try {
    (void)parse_tree(file_of(many + "</Sequence>"), "t.xml", registry());
    FAIL() << "accepted";
  } catch (const BadTree& bad) {
    EXPECT_EQ(bad.complaints().size(), kMostComplaints);
  }
}

TEST(BadTree, AFileThatIsNotThereIsNamed) {
  try {
    (void)read_tree("/nowhere/tree.xml", registry());
    FAIL() << "accepted";
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("/nowhere/tree.xml"));
  }
}

}  // namespace
}  // namespace gaitway::behaviour::test
