// What is no URDF is refused with file, line, element, value, rule and remedy.
#include "maker_folder.hpp"

namespace gaitway::importer {
namespace {

using test::joint;
using test::link;
using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;

struct Refusal {
  const char* name;
  std::string urdf;
  std::vector<std::string> parts;
};

void PrintTo(const Refusal& refusal, std::ostream* stream) {
  *stream << refusal.name;
}

std::string robot(const std::string& elements) {
  return "<robot name=\"r\">\n" + elements + "</robot>\n";
}

std::string two_links(const std::string& joints) {
  return robot(link("a") + link("b") + joints);
}

std::string inertial(const std::string& elements) {
  return robot(link("a", "<inertial>" + elements + "</inertial>"));
}

class BrokenMakerUrdf : public testing::TestWithParam<Refusal> {};

TEST_P(BrokenMakerUrdf, IsRefused) {
  const std::string complaint = test::MakerFolder().complaint(GetParam().urdf);
  EXPECT_THAT(complaint, HasSubstr("robot.urdf"));
  for (const std::string& part : GetParam().parts) {
    EXPECT_THAT(complaint, HasSubstr(part));
  }
}

INSTANTIATE_TEST_SUITE_P(
    Document, BrokenMakerUrdf,
    testing::Values(
        Refusal{"NoXml", "solid robot\n", {"malformed XML"}},
        Refusal{"AnUnclosedTag",
                "<robot name=\"r\">\n<link name=\"a\">\n</robot>",
                {"urdf:3: ", "malformed XML"}},
        Refusal{"AnotherFormat", "<sdf/>", {"urdf:1: ", "the outermost element must be <robot>"}},
        Refusal{"ADoctype", "<!DOCTYPE robot []>\n<robot name=\"r\"/>", {"urdf:1: ", "DOCTYPE", "Remove it"}},
        Refusal{"NoLinks", robot(""), {"urdf:1: robot 'r'", "there is no <link>"}},
        Refusal{
            "AXacroElement",
            robot("<xacro:leg side=\"left\"/>\n" + link("a")),
            {"urdf:2: xacro:leg", "must be expanded", "Expand it: xacro robot.urdf > robot_expanded.urdf"}},
        Refusal{"AXacroElementBelow",
                robot(link("a", "\n<xacro:if value=\"1\"/>")),
                {"urdf:3: link 'a' xacro:if", "must be expanded", "Expand it"}},
        Refusal{
            "AXacroExpression",
            inertial("<mass value=\"${m * 2}\"/>"),
            {"urdf:2: link 'a' inertial mass value = '${m * 2}'", "not an expression of xacro", "Expand it"}},
        Refusal{"ANameOfTwoLines",
                robot(link("imu&#10;evil: 1")),
                {"urdf:2: ", "must be one line of UTF-8", "another name"}},
        Refusal{"ANameThatTheTerminalObeys",
                robot(link("a&#27;[2J")),
                {"urdf:2: ", "without control characters"}},
        Refusal{"ANameInAnotherEncoding",
                robot(link("h\xfc"
                           "fte")),
                {"urdf:2: ", "UTF-8"}},
        Refusal{"AXacroArgument",
                robot(link("$(arg prefix)base")),
                {"urdf:2: ", "not an expression of xacro", "Expand it"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Numbers, BrokenMakerUrdf,
    testing::Values(
        Refusal{"AWord",
                inertial("<mass value=\"heavy\"/>"),
                {"urdf:2: link 'a' inertial mass value = 'heavy': must be a number", "SI units"}},
        Refusal{"NoNumberAtAll", inertial("<mass value=\" \"/>"), {"mass value = ' ': must be a number"}},
        Refusal{"NotANumber", inertial("<mass value=\"nan\"/>"), {"mass value = 'nan': must be a number"}},
        Refusal{"Infinity", inertial("<inertia ixx=\"inf\"/>"), {"inertia ixx = 'inf': must be a number"}},
        Refusal{"AComma", inertial("<mass value=\"1,5\"/>"), {"decimal point"}},
        Refusal{"TwoOfThree",
                inertial("<origin xyz=\"1 2\"/>"),
                {"link 'a' inertial origin xyz = '1 2': must be 3 numbers", "blanks"}},
        Refusal{"FourOfThree", inertial("<origin rpy=\"1 2 3 4\"/>"), {"rpy = '1 2 3 4': must be 3 numbers"}},
        Refusal{"BeyondReckoning",
                inertial("<origin xyz=\"0 -2e12 0\"/>"),
                {"xyz = '0 -2e12 0': must lie within +-1e+12", "SI units"}},
        Refusal{"NegativeMass",
                inertial("<mass value=\"-1\"/>"),
                {"urdf:2: link 'a' inertial mass value = '-1': must not be negative", "Correct"}},
        Refusal{"MissingValue", inertial("<mass/>"), {"the attribute 'value' is missing. Add it"}},
        Refusal{"ZeroAxis",
                two_links(joint("j", "revolute", "a", "b", "<axis xyz=\"0 0 0\"/>")),
                {"urdf:4: joint 'j' axis xyz = '0 0 0': the axis must not be zero", "Write a direction"}},
        Refusal{"CrossedLimits",
                two_links(joint("j", "revolute", "a", "b", "<limit lower=\"1\" upper=\"-1\"/>")),
                {"urdf:4: joint 'j' limit lower = '1': must not lie above upper, -1", "Exchange"}}),
    [](const auto& test) { return test.param.name; });

INSTANTIATE_TEST_SUITE_P(
    Structure, BrokenMakerUrdf,
    testing::Values(
        Refusal{"ALinkTwice",
                robot(link("a") + link("a")),
                {"urdf:3: link 'a'", "taken already in line 2", "a name of its own"}},
        Refusal{"AJointTwice",
                robot(link("a") + link("b") + link("c") + joint("j", "fixed", "a", "b") +
                      joint("j", "fixed", "b", "c")),
                {"urdf:6: joint 'j'", "taken already in line 5"}},
        Refusal{"ANamelessLink", robot("<link/>"), {"urdf:2: link", "'name' is missing"}},
        Refusal{"AnUnknownParent",
                two_links(joint("j", "fixed", "aa", "b")),
                {"urdf:4: joint 'j' parent = 'aa': there is no such link", "Did you mean 'a'?"}},
        Refusal{"AnUnknownChild",
                two_links(joint("j", "fixed", "a", "torso")),
                {"joint 'j' child = 'torso': there is no such link", "Known here: a, b"}},
        Refusal{"NoParent",
                two_links("<joint name=\"j\" type=\"fixed\"><child link=\"b\"/></joint>"),
                {"urdf:4: joint 'j'", "the element <parent> is missing"}},
        Refusal{"AnUnknownType",
                two_links(joint("j", "revolut", "a", "b")),
                {"urdf:4: joint 'j' type = 'revolut'", "Did you mean 'revolute'?"}},
        Refusal{"TwoRoots",
                robot(link("a") + link("b")),
                {"urdf:3: link 'b'", "one root, but no joint carries 'a', 'b'", "Fasten"}},
        Refusal{"TwoParents",
                robot(link("a") + link("b") + link("c") + joint("j", "fixed", "a", "c") +
                      joint("k", "fixed", "b", "c")),
                {"urdf:6: joint 'k' child = 'c'", "joint 'j' carries that link already", "cut the loop"}},
        Refusal{"NothingButALoop",
                two_links(joint("j", "fixed", "a", "b") + joint("k", "fixed", "b", "a")),
                {"must not be a loop, but 'k', 'j' are", "remove one"}},
        Refusal{"ALoopBesideTheRoot",
                robot(link("r") + link("a") + link("b") + link("c") + joint("j", "fixed", "a", "b") +
                      joint("k", "fixed", "b", "a") + joint("l", "fixed", "b", "c")),
                {"must not be a loop, but 'j', 'k' are"}},
        Refusal{"AFloatingLimb",
                robot(link("a", test::mass(1.0)) + link("b") + joint("j", "floating", "a", "b")),
                {"urdf:4: joint 'j' type", "floating or planar joint", "Make it fixed"}},
        Refusal{"TwoFloatingBodies",
                robot(link("a") + link("b") + link("c") + joint("j", "floating", "a", "b") +
                      joint("k", "planar", "a", "c")),
                {"urdf:5: joint 'j' type", "the only one of a root without mass"}}),
    [](const auto& test) { return test.param.name; });

TEST(BrokenMakerFile, MissingFileIsNamed) {
  const test::MakerFolder folder;
  try {
    (void)read_maker_urdf(folder.path() / "none.urdf", {});
    FAIL() << "it was read";
  } catch (const input::InputError& error) {
    EXPECT_THAT(error.what(),
                AllOf(HasSubstr("none.urdf: the file is missing"), HasSubstr("expanded if it is a xacro")));
  }
}

TEST(BrokenMakerFile, MoreLinksThanARobotHasAreRefused) {
  std::string links;
  for (int i = 0; i < 1001; ++i) {
    links += link("l" + std::to_string(i));
  }
  EXPECT_THAT(test::MakerFolder().complaint(robot(links)), HasSubstr("more than 1000 links or joints"));
}

TEST(BrokenMakerFile, MorePointsThanARobotNeedsAreRefused) {
  std::string spheres;
  for (int i = 0; i < 30'000; ++i) {
    spheres += "<collision><geometry><sphere radius=\"1\"/></geometry></collision>";
  }
  EXPECT_THAT(test::MakerFolder().complaint(robot(link("a", spheres))),
              HasSubstr("surfaces have more than 10000000 points and triangles"));
}

}  // namespace
}  // namespace gaitway::importer
