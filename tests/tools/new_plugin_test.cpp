// The author's commands as a user meets them: `new-plugin`, `run --with`, `plugins`.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace gaitway::tools {
namespace {

using testing::HasSubstr;

class AuthorCommands : public ::testing::Test {
 protected:
  AuthorCommands()
      : folder_(std::filesystem::temp_directory_path() / ("gaitway_author_" + std::to_string(getpid()))) {
    std::filesystem::create_directories(folder_);
  }
  ~AuthorCommands() override { std::filesystem::remove_all(folder_); }

  // Runs the command in folder_; returns its exit code. What it says is in said_ and complaint_.
  int gaitway(const std::string& arguments) {
    const std::string line =
        "cd '" + folder_.string() + "' && " + GAITWAY_COMMAND + " " + arguments + " >said 2>complaint";
    const int status = std::system(line.c_str());
    said_ = text("said");
    complaint_ = text("complaint");
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }
  [[nodiscard]] std::string text(const std::string& file) const {
    std::ifstream in(folder_ / file);
    return {std::istreambuf_iterator<char>(in), {}};
  }
  void expect_refused(const std::string& arguments, const std::string& part) {
    EXPECT_EQ(gaitway(arguments), 1) << arguments;
    EXPECT_THAT(complaint_, HasSubstr(part)) << arguments;
  }
  static std::string shipped(const std::string& plugin) {
    return std::string(GAITWAY_PLUGIN_DIR) + "/libgaitway_plugin_" + plugin + ".so";
  }

  std::filesystem::path folder_;
  std::string said_, complaint_;
};

TEST_F(AuthorCommands, EveryKindGivesItsFilesUnderTheNewName) {
  for (const std::string kind :
       {"blank", "behaviour", "commander", "trajectory", "kinematics", "stability", "zmp", "vision"}) {
    const std::string name = "my_" + kind;
    ASSERT_EQ(gaitway("new-plugin " + name + " --kind " + kind), 0) << complaint_;
    EXPECT_THAT(said_, HasSubstr("cmake -S " + name + " -B " + name + "/build"));
    EXPECT_THAT(said_, HasSubstr("gaitway run --with " + name + "/build/lib" + name + ".so"));
    std::string all;
    for (const std::string& file : {name + ".cpp", name + "_test.cpp", std::string("CMakeLists.txt")}) {
      const std::string content = text(std::filesystem::path(name) / file);
      EXPECT_THAT(content, HasSubstr(name)) << file;
      all += content;
    }
    EXPECT_THAT(all, HasSubstr("class My"));
    EXPECT_THAT(all, Not(HasSubstr("PluginName")));
    EXPECT_THAT(all, Not(HasSubstr("plugin_name")));
    EXPECT_THAT(all, Not(HasSubstr("plugin_links")));
    EXPECT_THAT(all, Not(HasSubstr("plugin_tree")));
    const bool has_tree = kind == "behaviour";
    if (has_tree) {
      EXPECT_THAT(text(std::filesystem::path(name) / (name + ".xml")), HasSubstr("build/lib" + name + ".so"));
      EXPECT_THAT(said_, HasSubstr("gaitway behaviour check " + name + "/" + name + ".xml --with "));
    }
    const std::filesystem::directory_iterator files(folder_ / name);
    EXPECT_EQ(std::distance(begin(files), end(files)), has_tree ? 4 : 3) << kind;
  }
}

TEST_F(AuthorCommands, NamesThatAreNoIdentifiersAreRefused) {
  for (const char* const name :
       {"3legs", "my-gait", "a.b", "'two words'", "../up", "_hidden", "class", "test", "''"}) {
    expect_refused(std::string("new-plugin ") + name + " --dir out", "NAME '");
    EXPECT_FALSE(std::filesystem::exists(folder_ / "out")) << name;
  }
  expect_refused("new-plugin " + std::string(41, 'a'), "at most 40 characters");
  expect_refused("new-plugin gait --kind trajectori", "Did you mean 'trajectory'?");
  expect_refused("new-plugin", "NAME");
}

TEST_F(AuthorCommands, NothingIsOverwritten) {
  ASSERT_EQ(gaitway("new-plugin sway --dir project"), 0);
  std::ofstream(folder_ / "project" / "sway.cpp") << "mine";
  expect_refused("new-plugin sway --dir project", "project/sway.cpp: is there already");
  EXPECT_EQ(text("project/sway.cpp"), "mine");
  // Another plug-in's CMakeLists.txt counts, too; and nothing of the new one is left.
  expect_refused("new-plugin other --dir project", "project/CMakeLists.txt: is there already");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "project" / "other.cpp"));
  std::ofstream(folder_ / "file") << "x";
  expect_refused("new-plugin sway --dir file/below", "--dir file/below");
}

TEST_F(AuthorCommands, HelpShowsKindsAndExamples) {
  EXPECT_EQ(gaitway("new-plugin --help"), 0);
  EXPECT_THAT(said_, HasSubstr("Examples:"));
  EXPECT_THAT(said_, HasSubstr("stability"));
}

TEST_F(AuthorCommands, WithTakesThePlaceOfThoseWhoseTopicsItWrites) {
  ASSERT_EQ(gaitway("run --seconds 6 --no-pictures --out out --with " + shipped("nod")), 0) << complaint_;
  EXPECT_THAT(said_, testing::StartsWith("nod (" + shipped("nod") + ") replaces stability\n"));
  EXPECT_THAT(text("out/report.html"), HasSubstr("nod"));
}

TEST_F(AuthorCommands, WithRefusesWhatIsNoPlugin) {
  expect_refused("run --seconds 1 --with nowhere.so", "nowhere.so");
  std::ofstream(folder_ / "text.so") << "no library";
  expect_refused("run --seconds 1 --with text.so", "text.so");
  expect_refused("run --seconds 1 --with " + std::string(GAITWAY_TEST_PLUGINS) + "/throws_in_constructor.so",
                 "its constructor failed");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
}

TEST_F(AuthorCommands, APluginThatCommandsTheWalkIsNotContradicted) {
  const std::string with = "run --no-pictures --out out --with " + std::string(GAITWAY_TEMPLATES) +
                           "/libgaitway_plugin_template_commander.so";
  expect_refused(with + " --walk 0.1",
                 "'plugin_name' commands the robot, and a person's walk would keep it from that");
  EXPECT_FALSE(std::filesystem::exists(folder_ / "out"));
  ASSERT_EQ(gaitway(with + " --seconds 8"), 0) << complaint_;
  const nlohmann::json summary = nlohmann::json::parse(text("out/summary.json"));
  EXPECT_GT(summary["distance_m"], 0.3);
  EXPECT_GT(summary["mean_speed_m_s"], 0.02) << "measured from the plug-in's own command";
}

TEST_F(AuthorCommands, PluginsAreListedWithWhatTheyDeclare) {
  ASSERT_EQ(gaitway("plugins --json"), 0) << complaint_;
  const nlohmann::json list = nlohmann::json::parse(said_);
  const auto find = [](const nlohmann::json& among, const char* name) {
    const auto found =
        std::find_if(among.begin(), among.end(), [name](const auto& item) { return item["name"] == name; });
    return found == among.end() ? nlohmann::json() : *found;
  };
  const nlohmann::json trajectory = find(list, "trajectory");
  EXPECT_EQ(trajectory["period"], "batch");
  EXPECT_EQ(find(trajectory["topics"], "motion_plan")["access"], "write");
  EXPECT_EQ(find(trajectory["topics"], "correction")["access"], "read_previous");
  EXPECT_EQ(find(trajectory["parameters"], "step_time")["unit"], "s");
  EXPECT_EQ(find(trajectory["parameters"], "step_time")["default"], "0.32");
  ASSERT_EQ(gaitway("plugins"), 0);
  EXPECT_THAT(said_, HasSubstr("writes      trim, correction"));
}

TEST_F(AuthorCommands, PluginsNamesThoseThatAreNotUsable) {
  EXPECT_EQ(gaitway(std::string("plugins --plugin-path ") + GAITWAY_TEST_PLUGINS), 1);
  EXPECT_THAT(complaint_, HasSubstr("other_abi.so"));
  EXPECT_THAT(said_, HasSubstr("plain_c"));
  expect_refused("plugins --plugin-path nowhere", "--plugin-path nowhere");
  EXPECT_EQ(gaitway(std::string("plugins ") + GAITWAY_TEST_PLUGINS + "/other_abi.so"), 1);
  EXPECT_THAT(complaint_, HasSubstr("other_abi.so"));
  EXPECT_EQ(said_, "") << "nothing else is asked";
  expect_refused("plugins nowhere.so", "'nowhere.so': is no file");
}

}  // namespace
}  // namespace gaitway::tools
