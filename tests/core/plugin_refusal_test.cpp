// Every way to be unfit is refused by its own error, before anything moves.
#include <elf.h>
#include <gmock/gmock.h>
#include <unistd.h>

#include <cstddef>
#include <fstream>
#include <iterator>

#include "gaitway/instance/topic_port.hpp"
#include "plugin_fixture.hpp"

namespace gaitway::core {
namespace {

using testing::AllOf;
using testing::HasSubstr;

class PluginRefusal : public PluginFixture {
 protected:
  static std::string bytes_of(const std::string& library) {
    std::ifstream in(std::string(GAITWAY_TEST_PLUGINS "/") + library, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
  }
};

// A file that claims to be a plug-in's library.
class LibraryFile {
 public:
  explicit LibraryFile(const std::string& bytes) { std::ofstream(path_, std::ios::binary) << bytes; }
  LibraryFile(const LibraryFile&) = delete;
  LibraryFile& operator=(const LibraryFile&) = delete;
  ~LibraryFile() { std::filesystem::remove(path_); }
  [[nodiscard]] const std::string& path() const { return path_; }
  [[nodiscard]] std::string entry() const { return "  - {name: sway, library: " + path_ + "}\n"; }

 private:
  std::string path_ = testing::TempDir() + "gaitway_library_" + std::to_string(getpid()) + ".so";
};

TEST_F(PluginRefusal, MissingFileNamesThePlacesTried) {
  EXPECT_THAT(
      refusal("  - {name: sway, library: libsway.so}\n"),
      AllOf(HasSubstr("plug-in 'sway' (test.yaml:2)"), HasSubstr("no library 'libsway.so'"),
            HasSubstr(GAITWAY_TEST_PLUGINS "/libsway.so"), HasSubstr("/lib/gaitway/plugins/libsway.so")));
}

TEST_F(PluginRefusal, FileThatIsNoLibrary) {
  const LibraryFile file("text");
  EXPECT_THAT(refusal(file.entry()), AllOf(HasSubstr(file.path()), HasSubstr("is no shared library"),
                                           HasSubstr("4 bytes"), HasSubstr("Was it built to its end?")));
}

TEST_F(PluginRefusal, LibraryForAnotherMachine) {
  std::string bytes = bytes_of("relay.so");
  bytes[offsetof(Elf64_Ehdr, e_machine)] = static_cast<char>(EM_RISCV);
  const LibraryFile file(bytes);
  EXPECT_THAT(refusal(file.entry()),
              AllOf(HasSubstr(file.path()), HasSubstr("is a library for RISC-V"), HasSubstr("Build it for")));
}

TEST_F(PluginRefusal, LibraryOfAnotherWidthOrByteOrderIsNotCalledOneOfThisMachine) {
  std::string bytes = bytes_of("relay.so");
  bytes[EI_CLASS] = ELFCLASS32;
  EXPECT_THAT(refusal(LibraryFile(bytes).entry()), HasSubstr("with 32-bit addresses"));
  bytes[offsetof(Elf64_Ehdr, e_machine)] = static_cast<char>(EM_386);
  EXPECT_THAT(refusal(LibraryFile(bytes).entry()), HasSubstr("is a library for 32-bit x86"));
  bytes[EI_DATA] = bytes[EI_DATA] == ELFDATA2LSB ? ELFDATA2MSB : ELFDATA2LSB;
  EXPECT_THAT(refusal(LibraryFile(bytes).entry()), HasSubstr("of the other byte order"));
}

TEST_F(PluginRefusal, LibraryThatIsCutOff) {
  const std::string bytes = bytes_of("relay.so");
  const LibraryFile file(bytes.substr(0, bytes.size() / 2));
  EXPECT_THAT(refusal(file.entry()), AllOf(HasSubstr(file.path()), HasSubstr("is cut off")));
}

TEST_F(PluginRefusal, ProgramInsteadOfALibrary) {
  std::string bytes = bytes_of("relay.so");
  bytes[offsetof(Elf64_Ehdr, e_type)] = static_cast<char>(ET_REL);
  const LibraryFile file(bytes);
  EXPECT_THAT(refusal(file.entry()), HasSubstr("is an ELF file, but no shared library"));
}

TEST_F(PluginRefusal, UnresolvedSymbolIsNamed) {
  EXPECT_THAT(refusal("  - {name: a, library: unresolved_symbol.so}\n"),
              AllOf(HasSubstr("unresolved_symbol.so cannot be loaded"),
                    HasSubstr("undefined symbol: gaitway_test_defined_nowhere")));
}

TEST_F(PluginRefusal, MissingEntrySymbol) {
  EXPECT_THAT(refusal("  - {name: a, library: missing_symbol.so}\n"),
              HasSubstr("has no symbol 'gaitway_plugin_entry'"));
}

TEST_F(PluginRefusal, OtherAbi) {
  EXPECT_THAT(refusal("  - {name: a, library: other_abi.so}\n"),
              AllOf(HasSubstr("built for plug-in ABI 6"), HasSubstr("speaks ABI 5.")));
}

// A plug-in of a lower minor number is loaded, one of a higher is not.
TEST_F(PluginRefusal, MinorNumberOfTheAbi) {
  const PluginLibrary library("plain_c.so", {}, {GAITWAY_TEST_PLUGINS});
  const gaitway_plugin& ours = library.entry();
  EXPECT_NO_THROW(check_border(ours, "plain_c.so", GAITWAY_PLUGIN_ABI_MINOR + 1));
  gaitway_plugin newer = ours;
  ++newer.abi_minor;
  EXPECT_NO_THROW(check_border(newer, "newer.so", GAITWAY_PLUGIN_ABI_MINOR + 1));
  try {
    check_border(newer, "newer.so");
    FAIL() << "it knows more than its host";
  } catch (const PluginError& error) {
    EXPECT_THAT(error.what(),
                HasSubstr(std::string("newer.so: built for plug-in ABI 5.") +
                          std::to_string(newer.abi_minor) + ", but this main controller speaks"));
  }
}

// Built against the header as it was when the major number was given.
TEST_F(PluginRefusal, NoneForTheFirstMinorNumber) {
  const auto manager = load("  - {name: old, library: plain_c_5_0.so, parameters: {fail_at: 3}}\n");
  EXPECT_EQ(manager->step(tick(1)), 0);
  EXPECT_EQ(manager->step(tick(2)), 0);
  EXPECT_EQ(manager->step(tick(3)), 1);
  WalkCommand count{};
  ASSERT_TRUE(other.read<WalkCommand>("count").read(count));
  EXPECT_EQ(count.walk, 2U);
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
  EXPECT_THAT(
      refusal(relay("a", "to: out") + "  - {name: b, library: other_type_hash.so}\n"),
      AllOf(HasSubstr("topic 'out': plug-in 'a' means a Correction (type hash"),
            HasSubstr("but 'b' a Correction"),
            HasSubstr("\n  'a': com_offset 2 x float64 at 8, base_attitude_offset 2 x float64 at 24,"),
            HasSubstr("\n  'b': com_offset_mm 2 x float64 at 8")));
}

TEST_F(PluginRefusal, OtherTypeHashThanAnotherProcess) {
  const auto writer = other.write<Correction>("out");
  EXPECT_THAT(
      refusal("  - {name: b, library: other_type_hash.so}\n"),
      AllOf(HasSubstr("plug-in 'b' (test.yaml:2)"), HasSubstr("topic 'out'"), HasSubstr("type hash")));
}

// Numbers past the last whole row would escape the check of what is published.
TEST_F(PluginRefusal, RowsThatDoNotDivideTheNumbersOfTheirField) {
  for (const std::uint32_t rows : {0U, 2U, 4U}) {
    const gaitway_float_field field{
        .name = "angle", .offset = 0, .count = 3, .bytes = 8, .rows = rows, .lowest = 0.0, .highest = 0.0};
    const gaitway_topic topic{.name = "arm",
                              .type_name = "Arm",
                              .type_hash = 1,
                              .size = 24,
                              .float_field_count = 1,
                              .float_fields = &field};
    try {
      const TopicPort port(topic, Access::write);
      ADD_FAILURE() << rows << " rows were taken";
    } catch (const PluginError& error) {
      EXPECT_THAT(error.what(), AllOf(HasSubstr("topic 'arm'"), HasSubstr("'angle'"),
                                      HasSubstr(std::to_string(rows) + " rows")));
    }
  }
}

TEST_F(PluginRefusal, UnknownParameterNamesTheNearest) {
  EXPECT_THAT(refusal("  - name: p\n    library: parameters.so\n    parameters:\n      step_tme: 0.5\n"),
              AllOf(HasSubstr("test.yaml:5"), HasSubstr("plug-in 'p' has no parameter 'step_tme'"),
                    HasSubstr("Did you mean 'step_time'?")));
}

TEST_F(PluginRefusal, ParameterInAnotherUnit) {
  EXPECT_THAT(refusal("  - {name: p, library: parameters.so, parameters: {step_time: 400 mm}}\n"),
              AllOf(HasSubstr("test.yaml:2: parameter 'step_time' of 'p' = '400 mm'"),
                    HasSubstr("is in 'mm'"), HasSubstr("must be in 's'")));
}

}  // namespace
}  // namespace gaitway::core
