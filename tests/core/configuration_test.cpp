// What a configuration may look like, and how precisely it is refused.
#include "gaitway/instance/configuration.hpp"

#include <gmock/gmock.h>

#include "gaitway/isolation/settings.hpp"

namespace gaitway::core {
namespace {

using testing::HasSubstr;

std::string refusal(const std::string& text) {
  try {
    parse_configuration(text, "walk.yaml");
  } catch (const ConfigurationError& error) {
    return error.what();
  }
  return {};
}

TEST(Configuration, KeepsOrderLinesAndParametersAsWritten) {
  const Configuration configuration = parse_configuration(
      "# comment\nplugins:\n  - name: zmp\n  - name: walk\n    library: libwalk.so\n    parameters:\n      "
      "step_time: 0.4 s\n",
      "walk.yaml");
  ASSERT_EQ(configuration.plugins.size(), 2U);
  EXPECT_EQ(configuration.plugins[0].name, "zmp");
  EXPECT_EQ(configuration.plugins[0].library, "libgaitway_plugin_zmp.so");
  EXPECT_EQ(configuration.plugins[1].library, "libwalk.so");
  EXPECT_EQ(configuration.plugins[1].line, 4);
  ASSERT_EQ(configuration.plugins[1].parameters.size(), 1U);
  EXPECT_EQ(configuration.plugins[1].parameters[0].text, "0.4 s");
  EXPECT_EQ(configuration.plugins[1].parameters[0].line, 7);
}

TEST(Configuration, TheDefaultOneListsThePluginsOfWalking) {
  const Configuration configuration = read_configuration(GAITWAY_DEFAULT_CONFIGURATION);
  std::vector<std::string> names;
  for (const PluginEntry& plugin : configuration.plugins) {
    names.push_back(plugin.name);
    EXPECT_EQ(plugin.library, "libgaitway_plugin_" + plugin.name + ".so");
  }
  EXPECT_THAT(names, testing::ElementsAre("zmp", "trajectory", "stability", "kinematics"));
}

TEST(Configuration, MorePluginsThanARobotCanUseAreRefused) {
  const auto of = [](int plugins) {
    std::string text = "plugins:\n";
    for (int i = 0; i < plugins; ++i) text += "  - name: p" + std::to_string(i) + "\n";
    return text;
  };
  EXPECT_EQ(refusal(of(64)), "");
  EXPECT_THAT(refusal(of(10'000)),
              HasSubstr("walk.yaml:2: plugins = a list of 10000: must be a list of at most 64 plug-ins"));
}

TEST(Configuration, ADecimalCommaIsTold) {
  EXPECT_THAT(
      refusal("plugins:\n  - name: a\n    period: 0,4 s\n"),
      HasSubstr("walk.yaml:3: plugins[0].period = '0,4 s': must be a number with a decimal point, not with "
                "a comma. Write '0.4 s'."));
}

TEST(Configuration, UnknownKeyNamesLineAndNearest) {
  EXPECT_THAT(refusal("plugins:\n  - name: a\n    libary: x.so\n"),
              testing::AllOf(HasSubstr("walk.yaml:3: plugins[0] key = 'libary': there is no such key"),
                             HasSubstr("Did you mean 'library'?")));
  EXPECT_THAT(refusal("plugin:\n  - name: a\n"),
              HasSubstr("walk.yaml:1: key = 'plugin': there is no such key. Did you mean 'plugins'?"));
}

TEST(Configuration, DuplicateNameNamesBothLines) {
  EXPECT_THAT(refusal("plugins:\n  - name: a\n  - name: b\n  - name: a\n"),
              HasSubstr("walk.yaml:4: plugins[2].name = 'a': is already the plug-in of line 2"));
}

TEST(Configuration, DuplicateKey) {
  EXPECT_THAT(refusal("plugins:\n  - name: a\n    parameters:\n      x: 1\n      x: 2\n"),
              HasSubstr("walk.yaml:5: plugins[0].parameters key = 'x': the key stands here twice"));
}

TEST(Configuration, MissingNameAndEmptyLists) {
  EXPECT_THAT(refusal("plugins:\n  - library: a.so\n"),
              HasSubstr("walk.yaml:2: plugins[0]: the key 'name' is missing"));
  EXPECT_THAT(refusal("plugins: []\n"), HasSubstr("must be a list with at least one plug-in"));
  EXPECT_THAT(refusal("{}\n"), HasSubstr("the key 'plugins' is missing"));
  EXPECT_THAT(refusal(""), HasSubstr("must be a map"));
}

TEST(Configuration, ParameterThatIsAList) {
  EXPECT_THAT(refusal("plugins:\n  - name: a\n    parameters: {gains: [1, 2]}\n"),
              HasSubstr("walk.yaml:3: plugins[0].parameters.gains = a list of 2: must be a plain text"));
}

TEST(Configuration, MalformedYamlNamesItsLine) {
  EXPECT_THAT(refusal("plugins:\n  - name: a\n    parameters: {x: 1\n"),
              testing::ContainsRegex("walk.yaml:[0-9]+: column [0-9]+: malformed YAML"));
}

PluginEntry entry_with(const std::string& keys) {
  return parse_configuration("plugins:\n  - {name: a, " + keys + "}\n", "/robot/walk.yaml").plugins.at(0);
}

TEST(Configuration, ReadsWhatAProcessMay) {
  const PluginEntry plain = entry_with("isolation: process");
  EXPECT_FALSE(plain.child.local_sockets);
  EXPECT_EQ(options_for(plain.child, {}).descriptor_limit, 64U);
  EXPECT_EQ(options_for(plain.child, {}).memory_limit_bytes, 512U << 20U);
  EXPECT_EQ(options_for(plain.child, {}).hang_ns, 100'000'000);
  const PluginEntry server =
      entry_with("isolation: process, sockets: local, descriptors: 4096, memory: 1 GiB");
  EXPECT_TRUE(server.child.local_sockets);
  EXPECT_EQ(options_for(server.child, {}).hang_ns, 500'000'000);
  EXPECT_EQ(options_for(server.child, {}).descriptor_limit, 4096U);
  EXPECT_EQ(options_for(server.child, {}).memory_limit_bytes, 1024U << 20U);
  EXPECT_TRUE(server.containment.give_up.never);
  EXPECT_FALSE(plain.containment.give_up.never);
  EXPECT_FALSE(
      entry_with("isolation: process, sockets: local, give_up_after: {faults: 3}").containment.give_up.never);
  EXPECT_FALSE(entry_with("isolation: process, answer: this_step").child.answers_next_step);
  EXPECT_TRUE(entry_with("isolation: process, answer: next_step").child.answers_next_step);
  const PluginEntry none = entry_with("isolation: process, sockets: none");
  EXPECT_FALSE(none.child.local_sockets);
  EXPECT_FALSE(none.containment.give_up.never);
}

TEST(Configuration, APluginInPythonHasItsProcessUnasked) {
  const PluginEntry python = entry_with("library: ./sway.py, memory: 1 GiB");
  EXPECT_TRUE(has_own_process(python));
  EXPECT_EQ(python.child.memory_limit_bytes, 1024U << 20U);
  EXPECT_TRUE(has_own_process(entry_with("library: ./sway.py, isolation: process")));
  EXPECT_FALSE(has_own_process(entry_with("library: sway.py.so")));
  EXPECT_THAT(
      refusal("plugins:\n  - name: a\n    library: ./sway.py\n    isolation: none\n"),
      HasSubstr("walk.yaml:4: plugins[0].isolation = 'none': must be 'process' for a plug-in in Python"));
}

TEST(Configuration, RefusesWhatNoProcessMay) {
  const auto refused = [](const std::string& keys) {
    return refusal("plugins:\n  - name: a\n    " + keys + "\n");
  };
  EXPECT_THAT(
      refused("sockets: local"),
      testing::AllOf(HasSubstr("walk.yaml:3: plugins[0].sockets = 'local': is for plug-ins in processes of "
                               "their own alone"),
                     HasSubstr("Add 'isolation: process'")));
  for (const char* const key : {"sockets: none", "descriptors: 100", "memory: 1 GiB", "answer: next_step"}) {
    EXPECT_THAT(refused(key), HasSubstr("is for plug-ins in processes of their own alone")) << key;
  }
  const std::string process = "isolation: process\n    ";
  EXPECT_THAT(refused(process + "answer: never"),
              testing::AllOf(HasSubstr("walk.yaml:4: plugins[0].answer = 'never': must be 'this_step' or "
                                       "'next_step'"),
                             HasSubstr("'next_step': it works beside the tick")));
  for (const char* const value : {"serve", "Local", "true", "unix"}) {
    EXPECT_THAT(refused(process + "sockets: " + value),
                testing::AllOf(HasSubstr("walk.yaml:4: plugins[0].sockets = '" + std::string(value) +
                                         "': must be 'local' or 'none'"),
                               HasSubstr("'local' lets the plug-in use Unix sockets"),
                               HasSubstr("beside the user interface module, as its client")))
        << value;
  }
  EXPECT_THAT(refused(process + "sockets: [local]"),
              HasSubstr("walk.yaml:4: plugins[0].sockets = a list of 1: must be a plain text"));
  for (const char* const key : {"network: serve", "writes: here"}) {
    EXPECT_THAT(refused(process + key), HasSubstr("there is no such key")) << key;
  }
  EXPECT_THAT(refused(process + "descriptors: 5000"), HasSubstr("16..4096"));
  EXPECT_THAT(refused(process + "memory: 512"), HasSubstr("with its unit: KiB, MiB or GiB"));
  EXPECT_THAT(refused(process + "memory: 1 MiB"), HasSubstr("must lie between 64 MiB and 64 GiB"));
  EXPECT_THAT(refused(process + "memory: 18446744073709551615 GiB"), HasSubstr("must lie between"));
}

TEST(Configuration, MissingFile) {
  try {
    read_configuration("/nowhere/walk.yaml");
    FAIL() << "was accepted";
  } catch (const ConfigurationError& error) {
    EXPECT_THAT(error.what(), HasSubstr("/nowhere/walk.yaml: the file is missing or cannot be read"));
  }
}

}  // namespace
}  // namespace gaitway::core
