// Every way to be unfit is refused by its own error, before anything moves.
#include <gmock/gmock.h>

#include <fstream>

#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PluginRefusal : public PluginFixture {};

TEST_F(PluginRefusal, MissingFileNamesThePlacesTried) {
  EXPECT_THAT(refusal("  - {name: sway, library: libsway.so}\n"),
              AllOf(HasSubstr("plug-in 'sway' (test.yaml:2)"), HasSubstr("no library 'libsway.so'"),
                    HasSubstr(GAITWAY_TEST_PLUGINS "/libsway.so"), HasSubstr("/lib/libsway.so")));
}

TEST_F(PluginRefusal, FileThatIsNoLibraryIsNotLoadable) {
  const auto file = std::filesystem::path(testing::TempDir()) / "gaitway_no_library.so";
  std::ofstream(file) << "text";
  EXPECT_THAT(refusal("  - {name: sway, library: " + file.string() + "}\n"),
              AllOf(HasSubstr(file.string()), HasSubstr("cannot be loaded")));
  std::filesystem::remove(file);
}

TEST_F(PluginRefusal, MissingEntrySymbol) {
  EXPECT_THAT(refusal("  - {name: a, library: missing_symbol.so}\n"),
              HasSubstr("has no symbol 'gaitway_plugin_entry'"));
}

TEST_F(PluginRefusal, OtherAbi) {
  EXPECT_THAT(refusal("  - {name: a, library: other_abi.so}\n"),
              AllOf(HasSubstr("built for plug-in ABI 3"), HasSubstr("speaks ABI 2")));
}

TEST_F(PluginRefusal, OtherStructSize) {
  EXPECT_THAT(refusal("  - {name: a, library: wrong_size.so}\n"),
              AllOf(HasSubstr("its gaitway_tick has"), HasSubstr("Build the plug-in anew")));
}

TEST_F(PluginRefusal, ConstructorThatThrows) {
  EXPECT_THAT(refusal("  - {name: a, library: throws_in_constructor.so}\n"),
              AllOf(HasSubstr("plug-in 'a' (test.yaml:2)"),
                    HasSubstr("its constructor failed: no calibration file")));
}

TEST_F(PluginRefusal, ActivationThatThrowsUnloadsTheOthers) {
  EXPECT_THAT(refusal(relay("a", "to: a") + "  - {name: b, library: throws_in_activate.so}\n"),
              AllOf(HasSubstr("plug-in 'b'"), HasSubstr("activation failed: the camera does not answer")));
  EXPECT_EQ(refusal(relay("a", "to: a")), "");  // the topic is free again
}

TEST_F(PluginRefusal, TwoWritersOfOneTopic) {
  EXPECT_THAT(refusal(relay("a", "to: x") + relay("b", "to: x")),
              HasSubstr("topic 'x' has two writers: plug-ins 'a' and 'b'"));
}

TEST_F(PluginRefusal, TopicThatAnotherProcessWrites) {
  const auto writer = other.write<Correction>("x");
  EXPECT_THAT(refusal(relay("a", "to: x")), HasSubstr("two writers: plug-in 'a', and 'other_process'"));
}

TEST_F(PluginRefusal, CycleNamesItsPath) {
  EXPECT_THAT(
      refusal(relay("a", "from: z, to: x") + relay("b", "from: x, to: y") + relay("c", "from: y, to: z")),
      AllOf(HasSubstr("'a' -> x -> 'b' -> y -> 'c' -> z -> 'a'"), HasSubstr("reads_previous")));
}

TEST_F(PluginRefusal, MissingInputNamesTheNearestTopic) {
  EXPECT_THAT(refusal(relay("a", "to: motion_plan") + relay("b", "from: motion_plam, to: y")),
              AllOf(HasSubstr("plug-in 'b' reads topic 'motion_plam', but nobody writes it"),
                    HasSubstr("Did you mean 'motion_plan'?")));
}

TEST_F(PluginRefusal, MissingPreviousInput) {
  EXPECT_THAT(refusal(relay("b", "from: x, access: reads_previous, to: y")),
              HasSubstr("reads topic 'x', but nobody"));
}

TEST_F(PluginRefusal, OtherTypeHashThanThePluginThatWrites) {
  EXPECT_THAT(refusal(relay("a", "to: out") + "  - {name: b, library: other_type_hash.so}\n"),
              AllOf(HasSubstr("topic 'out': plug-in 'a' means a Correction (type hash"),
                    HasSubstr("but 'b' a Correction")));
}

TEST_F(PluginRefusal, OtherTypeHashThanAnotherProcess) {
  const auto writer = other.write<Correction>("out");
  EXPECT_THAT(
      refusal("  - {name: b, library: other_type_hash.so}\n"),
      AllOf(HasSubstr("plug-in 'b' (test.yaml:2)"), HasSubstr("topic 'out'"), HasSubstr("type hash")));
}

TEST_F(PluginRefusal, UnknownParameterNamesTheNearest) {
  EXPECT_THAT(refusal("  - name: p\n    library: parameters.so\n    parameters:\n      step_tme: 0.5\n"),
              AllOf(HasSubstr("test.yaml:5"), HasSubstr("plug-in 'p' has no parameter 'step_tme'"),
                    HasSubstr("Did you mean 'step_time'?")));
}

TEST_F(PluginRefusal, ParameterInAnotherUnit) {
  EXPECT_THAT(refusal("  - {name: p, library: parameters.so, parameters: {step_time: 400 ms}}\n"),
              AllOf(HasSubstr("test.yaml:2: parameter 'step_time' of 'p' = '400 ms'"),
                    HasSubstr("is in 'ms'"), HasSubstr("must be in 's'")));
}

}  // namespace
}  // namespace gaitway::core
