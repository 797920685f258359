// `gaitway behaviour` as a user meets it: shipped missions, trees with everything wrong, pictures, the list
// of leaves, and leaves of a library.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include "command_run.hpp"

namespace gaitway::tools {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;
using ::testing::StartsWith;

class BehaviourCommand : public ::testing::Test {
 protected:
  BehaviourCommand()
      : folder_(fs::temp_directory_path() / ("gaitway_behaviour_" + std::to_string(::getpid()))) {
    fs::create_directories(folder_);
  }
  ~BehaviourCommand() override { fs::remove_all(folder_); }

  // A file with one tree in it; nodes begin in line 2.
  [[nodiscard]] std::string tree(const std::string& name, const std::string& nodes) const {
    return write(name,
                 "<root BTCPP_format=\"4\"><BehaviorTree ID=\"T\">\n" + nodes + "</BehaviorTree></root>\n");
  }
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
    return (folder_ / name).string();
  }
  static test::CommandRun behaviour(const std::string& arguments) {
    return test::run_command(std::string(GAITWAY_BEHAVIOUR_COMMAND) + " behaviour " + arguments);
  }

  fs::path folder_;
};

TEST_F(BehaviourCommand, ShippedMissionsAreFine) {
  const test::CommandRun run = behaviour("check find_and_walk_to_tag patrol follow_tag stand_up_after_falls");
  EXPECT_EQ(run.code, 0) << run.all();
  EXPECT_THAT(run.said, AllOf(HasSubstr("patrol.xml: Patrol, "), HasSubstr("WalkToTag")));
}

TEST_F(BehaviourCommand, EverythingWrongIsToldOfEveryFile) {
  const std::string bad = tree("bad.xml", "<Sequence>\n<WalkTo x=\"1\" y=\"2 m\"/>\n<Wlak/></Sequence>");
  const std::string good = tree("good.xml", "<Stands/>");
  const test::CommandRun run = behaviour("check " + bad + " " + good + " nowhere.xml");
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.said, StartsWith(good + ": T, 1 node, 1 deep; leaves: Stands"));
  EXPECT_THAT(
      run.complaint,
      AllOf(HasSubstr(bad + ":3: T/Sequence/WalkTo x = 1: must be a number"), HasSubstr("Write '1 m'"),
            HasSubstr(bad + ":4: T/Sequence/Wlak: no node 'Wlak' is known. Did you mean 'Walk'?"),
            HasSubstr("nowhere.xml: ")));
}

TEST_F(BehaviourCommand, TheSameAsJson) {
  const std::string bad = tree("bad.xml", "<Sequence>\n<WalkTo x=\"1\" y=\"2 m\"/></Sequence>");
  const test::CommandRun run = behaviour("check --json " + bad + " patrol");
  EXPECT_EQ(run.code, 1);
  const json told = json::parse(run.said);
  ASSERT_EQ(told.size(), 2U);
  EXPECT_FALSE(told[0].at("fine"));
  const json& complaint = told[0].at("complaints").at(0);
  EXPECT_EQ(complaint.at("file"), bad);
  EXPECT_EQ(complaint.at("line"), 3);
  EXPECT_EQ(complaint.at("node"), "T/Sequence/WalkTo");
  EXPECT_EQ(complaint.at("field"), "x");
  EXPECT_EQ(complaint.at("value"), "1");
  EXPECT_TRUE(told[1].at("fine"));
  EXPECT_EQ(told[1].at("tree"), "Patrol");
  EXPECT_TRUE(told[1].at("stands_up_under_a_person"));
}

TEST_F(BehaviourCommand, ATreeIsDrawn) {
  const fs::path picture = folder_ / "t.svg";
  const test::CommandRun run = behaviour("draw patrol --out " + picture.string());
  EXPECT_EQ(run.code, 0) << run.all();
  std::ifstream in(picture);
  const std::string svg{std::istreambuf_iterator<char>(in), {}};
  EXPECT_THAT(svg, AllOf(StartsWith("<svg"), HasSubstr("WalkTo"), HasSubstr("heading = 90 deg")));
  EXPECT_EQ(behaviour("draw " + tree("bad.xml", "<Wlak/>") + " --out " + (folder_ / "n.svg").string()).code,
            1);
  EXPECT_FALSE(fs::exists(folder_ / "n.svg"));
}

TEST_F(BehaviourCommand, LeavesAreListedWithPortsUnitsAndMeaning) {
  const test::CommandRun run = behaviour("leaves");
  EXPECT_EQ(run.code, 0);
  EXPECT_THAT(run.said, AllOf(HasSubstr("WalkTo (action): "), HasSubstr("Fallen (condition): "),
                              HasSubstr("number in m"), HasSubstr("must be given"), HasSubstr("= 3 ")));
  const json told = json::parse(behaviour("leaves --json").said);
  ASSERT_GT(told.size(), 15U);
  for (const json& leaf : told) {
    EXPECT_FALSE(leaf.at("meaning").get<std::string>().empty()) << leaf;
    for (const json& port : leaf.at("ports"))
      EXPECT_FALSE(port.at("meaning").get<std::string>().empty()) << leaf;
  }
}

// What editors are given can be put into a file as it is.
TEST_F(BehaviourCommand, TheModelIsReadBack) {
  const std::string model = behaviour("leaves --model").said;
  const std::size_t end = model.rfind("</root>");
  ASSERT_NE(end, std::string::npos);
  const std::string file =
      write("model.xml", model.substr(0, end) +
                             "<BehaviorTree ID=\"T\"><Cooldown msec=\"1 s\"><Stands/></Cooldown>"
                             "</BehaviorTree></root>");
  const test::CommandRun run = behaviour("check " + file);
  EXPECT_EQ(run.code, 0) << run.all();
}

TEST_F(BehaviourCommand, LeavesOfALibrary) {
  const std::string file = tree("own.xml", "<CountTo most=\"12\"/>");
  const std::string with = std::string(" --with ") + GAITWAY_OWN_LEAVES;
  EXPECT_THAT(behaviour("check " + file).complaint, HasSubstr("no node 'CountTo' is known"));
  const test::CommandRun run = behaviour("check " + file + with);
  EXPECT_EQ(run.code, 1);
  EXPECT_THAT(run.complaint, HasSubstr(":2: T/CountTo most = 12: must be 1..9"));
  const std::string good = tree("good.xml", "<Sequence><CountTo most=\"2\"/><Stands/></Sequence>");
  EXPECT_EQ(behaviour("check " + good + with).code, 0);
  EXPECT_THAT(behaviour("leaves" + with).said, HasSubstr("CountTo (action): Counts\n  most"));
  EXPECT_THAT(behaviour("leaves --model" + with).said, HasSubstr("<Action ID=\"CountTo\">"));
}

TEST_F(BehaviourCommand, ALibraryThatIsNoneIsRefused) {
  EXPECT_THAT(behaviour("leaves --with nowhere.so").complaint,
              HasSubstr("--with nowhere.so: cannot be loaded: "));
  const test::CommandRun other = behaviour(std::string("leaves --with ") + GAITWAY_NO_LEAVES);
  EXPECT_EQ(other.code, 1);
  EXPECT_THAT(other.complaint, HasSubstr("has no behaviour leaves"));
  EXPECT_THAT(behaviour(std::string("leaves --with ") + GAITWAY_TAKEN_LEAVES).complaint,
              AllOf(HasSubstr("--with "), HasSubstr("WalkTo")));
}

}  // namespace
}  // namespace gaitway::tools
