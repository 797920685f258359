// docs/plugin-interface.md says all that the interface has, and shows only what is built; the plug-ins that
// it shows run.
#include <gmock/gmock.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>

#include "plugin_fixture.hpp"
#include "reference/topics.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::SizeIs;
using Words = std::set<std::string>;

std::string text_of(const std::string& file) {
  std::ifstream in(std::filesystem::path(GAITWAY_SOURCE_DIR) / file);
  std::string text{std::istreambuf_iterator<char>(in), {}};
  EXPECT_FALSE(text.empty()) << file;
  return text;
}

std::string document() {
  return text_of("docs/plugin-interface.md");
}

std::vector<std::string> matches(const std::string& text, const std::string& pattern) {
  const std::regex wanted(pattern);
  std::vector<std::string> found;
  for (std::sregex_iterator at(text.begin(), text.end(), wanted), end; at != end; ++at) {
    found.push_back((*at)[1].str());
  }
  return found;
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
  return std::regex_replace(text, std::regex(pattern), by);
}

std::string plain(const std::string& text, std::string_view token, std::string_view by) {
  std::string result;
  std::size_t from = 0;
  for (std::size_t at = text.find(token); at != std::string::npos; at = text.find(token, from)) {
    result.append(text, from, at - from).append(by);
    from = at + token.size();
  }
  return result.append(text, from);
}

std::vector<std::string> blocks(const std::string& language) {
  const std::string text = document(), open = "\n```" + language + "\n";
  std::vector<std::string> found;
  for (std::size_t at = text.find(open); at != std::string::npos; at = text.find(open, at)) {
    at += open.size();
    found.push_back(text.substr(at, text.find("```", at) - at));
  }
  return found;
}

// What stands between backticks, in the text and in the snippets.
std::string code() {
  const std::string text = document();
  std::string result;
  for (const std::string& piece : matches(replaced(text, "```", "\n"), "`([^`\n]+)`")) {
    result += piece + "\n";
  }
  for (const char* const language : {"cpp", "c", "yaml", "cmake", "toml"}) {
    for (const std::string& block : blocks(language)) {
      result += block;
    }
  }
  return result;
}

Words words(const std::string& text) {
  const std::vector<std::string> found = matches(text, "([A-Za-z_][A-Za-z0-9_]*)");
  return {found.begin(), found.end()};
}

std::string section(const std::string& heading) {
  const std::string text = document();
  const std::size_t begin = text.find("\n### " + heading + "\n");
  return begin == std::string::npos ? std::string() : text.substr(begin, text.find("\n#", begin + 5) - begin);
}

std::string without_comments(const std::string& text) {
  return replaced(replaced(text, R"(/\*[^*]*\*+([^/*][^*]*\*+)*/)", ""), "//[^\n]*", "");
}

// What a header offers: the text of namespace and classes without private parts, bodies and details.
std::string public_text(const std::string& header) {
  const std::string text = plain(without_comments(text_of(header)), "operator()", "operator_call");
  std::string result;
  bool is_public = true;
  int depth = 0, detail = 0;
  std::size_t line_begin = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '\n') {
      line_begin = i + 1;
    }
    is_public = (is_public || text.compare(i, 7, "public:") == 0) && text.compare(i, 8, "private:") != 0;
    if (text[i] == '{') {
      ++depth;
      detail = text.compare(line_begin, 16, "namespace detail") == 0 ? depth : detail;
    }
    if (depth <= 2 && is_public && detail == 0) {
      result += text[i];
    }
    if (text[i] == '}') {
      detail = detail == depth ? 0 : detail;
      --depth;
      is_public = is_public || depth < 2;
    }
  }
  return result;
}

Words public_names(const std::string& header) {
  const std::string text = public_text(header);
  Words names;
  // Types; functions; members with a value; enumerators.
  for (const char* const pattern :
       {R"((?:enum class|class|struct) ([A-Z]\w*)\s*(?:final)?\s*[:{])", R"((?:^|[ &*])([a-z]\w*[a-z])\()",
        R"([ ]([a-z]\w*[a-z]) = [^;{}]*;)", R"(#define (\w+)\()"}) {
    for (const std::string& name : matches(text, pattern)) {
      names.insert(name);
    }
  }
  for (const std::string& list : matches(text, R"(enum class \w+ : [\w:]+ \{([^}]*)\})")) {
    names.merge(Words(words(replaced(list, "=[^,]*", ""))));
  }
  for (const char* const other : {"requires", "operator_call", "noexcept", "explicit"}) {
    names.erase(other);
  }
  return names;
}

TEST(PluginInterfaceDocument, EverySnippetIsBuilt) {
  const auto expect_parts = [](const std::string& language, const std::string& file, std::size_t least) {
    const std::vector<std::string> snippets = blocks(language);
    EXPECT_GE(snippets.size(), least) << language;
    for (const std::string& snippet : snippets) {
      EXPECT_NE(file.find(snippet), std::string::npos) << snippet;
    }
  };
  std::string project = text_of("tools/new_plugin/templates/CMakeLists.txt");
  for (const auto& [token, by] : {std::pair{"plugin_components", "plugin simulator"},
                                  {" plugin_links", ""},
                                  {"plugin_tree\n", ""},
                                  {"plugin_name", "sway"}}) {
    project = plain(project, token, by);
  }
  expect_parts("cpp", text_of("docs/examples/reference.cpp"), 10);
  expect_parts("c", text_of("docs/examples/reference.c"), 5);
  expect_parts("yaml", text_of("docs/examples/reference.yaml"), 1);
  expect_parts("toml", text_of("docs/examples/reference.toml"), 1);
  expect_parts("cmake", text_of("docs/examples/CMakeLists.txt") + project, 2);
}

TEST(PluginInterfaceDocument, NamesEverythingPublic) {
  const Words known = words(code());
  std::size_t count = 0;
  for (const char* const header : {"plugin.hpp", "number_parameter.hpp", "state_archive.hpp"}) {
    for (const std::string& name :
         public_names(std::string("core/plugin/include/gaitway/plugin/") + header)) {
      EXPECT_TRUE(known.contains(name)) << header << ": " << name;
      ++count;
    }
  }
  EXPECT_GE(count, 50U);
  const Words names = public_names("core/plugin/include/gaitway/plugin/plugin.hpp");
  for (const char* const expected : {"Setup", "reads_previous", "live_parameter", "age_ns", "highest",
                                     "warning", "state_version", "GAITWAY_PLUGIN"}) {
    EXPECT_TRUE(names.contains(expected)) << expected;  // the search above finds what it should
  }
}

TEST(PluginInterfaceDocument, HasASectionForEachStructOfTheAbiWithAllItsFields) {
  const std::string header = without_comments(text_of("core/plugin/include/gaitway/plugin/abi.h"));
  const std::regex wanted(R"(typedef struct (\w+) \{([^}]*)\})");
  int structs = 0;
  for (std::sregex_iterator at(header.begin(), header.end(), wanted), end; at != end; ++at, ++structs) {
    const Words known = words(section((*at)[1]));
    const std::string functions = (*at)[2];
    std::vector<std::string> fields = matches(functions, R"(\(\*(\w+)\))");
    for (const std::string& field :
         matches(replaced(functions, R"(\(\*\w+\)\([^)]*\))", ""), R"((\w+)\s*[,;])")) {
      fields.push_back(field);
    }
    EXPECT_GE(fields.size(), 2U) << (*at)[1];
    for (const std::string& field : fields) {
      const bool a_type = field == "gaitway_status" || field == "void" || field == "char";
      EXPECT_TRUE(a_type || known.contains(field)) << (*at)[1] << "." << field;
    }
  }
  EXPECT_EQ(structs, 13);
  const Words known = words(code());
  for (const std::string& name : matches(header, R"(\b(GAITWAY_(?!PLUGIN_ABI_H)[A-Z_]+)\b)")) {
    EXPECT_TRUE(known.contains(name)) << name;
  }
}

class PluginInterfaceTest : public PluginFixture {
 protected:
  // The keys that a refusal lists.
  Words keys(const std::string& configuration) {
    std::string complaint;
    try {
      parse_configuration(configuration, "test.yaml");
    } catch (const ConfigurationError& error) {
      complaint = error.what();
    }
    EXPECT_THAT(complaint, HasSubstr("Known here: "));
    return words(complaint.substr(std::min(complaint.find("Known here: ") + 12, complaint.size())));
  }
};

TEST_F(PluginInterfaceTest, DocumentHasEveryConfigurationKey) {
  const std::string unknown = "zzzzzzzzzzzzzzzzzzzzzzzzzzzzzz: 1";
  const Words of_entry = keys("plugins: [{name: a, " + unknown + "}]");
  const Words of_rule = keys("plugins: [{name: a, give_up_after: {" + unknown + "}}]");
  EXPECT_THAT(of_entry, SizeIs(13));
  EXPECT_THAT(of_rule, SizeIs(3));
  const std::string text = document();
  for (const Words& all : {of_entry, of_rule}) {
    for (const std::string& key : all) {
      EXPECT_TRUE(std::regex_search(text, std::regex("\n\\| (… )?`" + key + "` \\|"))) << key;
    }
  }
  for (const FallbackKind kind : {FallbackKind::none, FallbackKind::estimate, FallbackKind::trims_from_gains,
                                  FallbackKind::trims_to_zero, FallbackKind::stop, FallbackKind::safe_tail}) {
    EXPECT_THAT(section("Fallbacks"), HasSubstr("\n| `" + std::string(fallback_kind_name(kind)) + "` |"));
  }
}

TEST_F(PluginInterfaceTest, DocumentHasEveryStandardTopic) {
  const std::string text = document();
  for (const StandardTopic& topic : kStandardTopics) {
    const std::int64_t period_ms = topic.period_ns / 1'000'000;
    const std::string every = period_ms == 0 ? "change" : std::to_string(period_ms) + " ms";
    EXPECT_THAT(text, HasSubstr("\n| `" + std::string(topic.name) + "` | `" + std::string(topic.type->name) +
                                "` | `" + std::string(topic.writer) + "` | " + every + " |\n"));
  }
}

// The texts of the tables of refusals are in the code: between the ellipses, word by word.
TEST_F(PluginInterfaceTest, EveryRefusalIsOneOfTheCode) {
  std::string sources;
  for (const char* const folder : {"core", "input", "msgclient", "tools", "urdf"}) {
    for (const auto& file :
         std::filesystem::recursive_directory_iterator(std::filesystem::path(GAITWAY_SOURCE_DIR) / folder)) {
      const std::string extension = file.path().extension();
      if (extension == ".cpp" || extension == ".hpp") {
        sources += text_of(std::filesystem::relative(file.path(), GAITWAY_SOURCE_DIR));
      }
    }
  }
  std::string joined;  // literals that were broken into lines are one
  for (std::size_t i = 0; i < sources.size(); ++i) {
    const std::size_t next = sources[i] == '"' ? sources.find_first_not_of(" \n", i + 1) : std::string::npos;
    if (next != std::string::npos && next > i + 1 && sources[next] == '"') {
      i = next;
    } else {
      joined += sources[i];
    }
  }
  const std::string text = document();
  const std::vector<std::string> refusals =
      matches(text.substr(text.find("\n## Refusals")), "\n\\| `([^`]+)` \\|");
  EXPECT_GE(refusals.size(), 90U);
  for (const std::string& refusal : refusals) {
    for (const std::string& part : matches(plain(refusal, "…", "\n"), "([^\n]+)")) {
      EXPECT_NE(joined.find(part), std::string::npos) << refusal << ": '" << part << "'";
    }
  }
}

// The plug-ins of the document beside writers of what they read.
class ReferencePlugins : public PluginFixture {
 protected:
  std::unique_ptr<PluginManager> load_reference(bool isolated) {
    PluginManagerOptions options;
    options.robot_directory = GAITWAY_TEST_ROBOT;
    options.plugin_path = {GAITWAY_PLUGIN_DIR};
    Configuration configuration =
        read_configuration(std::filesystem::path(GAITWAY_SOURCE_DIR) / "docs/examples/reference.yaml");
    EXPECT_THAT(configuration.plugins, SizeIs(5));
    configuration.plugins.erase(configuration.plugins.begin(), configuration.plugins.begin() + 3);
    EXPECT_EQ(configuration.plugins[0].isolation, Isolation::process);
    configuration.plugins[0].isolation = isolated ? Isolation::process : Isolation::none;
    return std::make_unique<PluginManager>(configuration, options, client);
  }
  int step(PluginManager& manager, std::uint32_t number, double pitch_rad) {
    Estimate estimate{};
    estimate.attitude[1] = pitch_rad;
    MotionPlan plan{};
    estimate_.publish(estimate, tick(number).now_ns);
    plan_.publish(plan, tick(number).now_ns);
    return manager.step(tick(number));
  }
  template <class T>
  T value(const std::string& topic) {
    T result{};
    EXPECT_TRUE(other.read<T>(topic).read(result)) << topic;
    return result;
  }

  msgclient::Writer<Estimate> estimate_ = other.write<Estimate>("estimate");
  msgclient::Writer<MotionPlan> plan_ = other.write<MotionPlan>("motion_plan");
};

TEST_F(ReferencePlugins, Work) {
  for (const bool isolated : {false, true}) {
    const auto manager = load_reference(isolated);
    for (std::uint32_t i = 1; i <= 10; ++i) {
      ASSERT_EQ(step(*manager, i, 0.09), 0) << manager->plugin(0).fault() << manager->plugin(1).fault();
    }
    EXPECT_NEAR(value<LeanState>("lean").lean[1], 0.09, 1e-9);
    EXPECT_EQ(value<LeanState>("lean").warnings, 1U);
    EXPECT_NEAR(value<TrimCommand>("trim").angle[4], 0.2 * 0.09, 1e-9);
    manager->changes().set_parameter("lean", "gain", "0.5 rad/rad");
    manager->changes().set_parameter("pace", "speed", "0.2 m/s");
    ASSERT_EQ(step(*manager, 11, 0.09), 0);
    EXPECT_NEAR(value<TrimCommand>("trim").angle[4], 0.5 * 0.09, 1e-9);
    EXPECT_GT(value<WalkCommand>("walk_command").velocity[0], 0.0);
    EXPECT_THROW(manager->changes().set_parameter("lean", "share", "0.1"), ConfigurationError);
    EXPECT_THROW(manager->changes().set_parameter("pace", "speed", "300 mm"), ConfigurationError);
  }
}

TEST_F(ReferencePlugins, HandTheirStateOn) {
  for (const char* const name : {"lean", "pace"}) {
    const auto manager = load_reference(false);
    std::uint32_t number = 0;
    while (++number < 6) {
      ASSERT_EQ(step(*manager, number, 0.09), 0);
    }
    const double speed = value<WalkCommand>("walk_command").velocity[0];
    ASSERT_TRUE(manager->changes().schedule(manager->changes().prepare_reload(name)));
    for (; number < 8; ++number) {
      ASSERT_EQ(step(*manager, number, 0.09), 0);
    }
    const auto result = manager->changes().take_result();
    ASSERT_TRUE(result && result->done);
    EXPECT_THAT(result->text, HasSubstr("bytes of state handed on"));
    EXPECT_EQ(value<LeanState>("lean").warnings, 1U);
    EXPECT_GE(value<WalkCommand>("walk_command").velocity[0], speed);
  }
}

}  // namespace
}  // namespace gaitway::core
