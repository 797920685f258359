// The joint's firmware on the emulated microcontroller: the same bits, within its memory, with real
// interrupts.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "emulator.hpp"
#include "synthetic_trace.hpp"

namespace gaitway::firmware {
namespace {

constexpr int kTrace_ms = 6000;
// Of an STM32F3-class part with 64 KiB of flash and 16 KiB of RAM: half for the joint, half for the builder's
// drivers.
constexpr int kFlashBudget_bytes = 32 * 1024;
constexpr int kRamBudget_bytes = 4 * 1024;
constexpr int kStackBudget_bytes = 2 * 1024;

class EmulatedFirmwareSeeds : public EmulatedFirmware, public testing::WithParamInterface<int> {};

TEST_P(EmulatedFirmwareSeeds, AnswersTheSameBitsAsTheHost) {
  report_cost(expect_same_bits(SyntheticTrace(static_cast<std::uint64_t>(GetParam())).write(kTrace_ms)));
}
INSTANTIATE_TEST_SUITE_P(Seeds, EmulatedFirmwareSeeds, testing::Range(1, 4));

TEST_F(EmulatedFirmware, TheComparisonSeesTheLastBitOfAGain) {
  SyntheticTrace original(7), mutated(7);
  mutated.config(3).stiffness_Nm_per_rad = std::nextafter(mutated.config(3).stiffness_Nm_per_rad, 1000.0);
  const Played here = play_here(original.write(kTrace_ms));
  const Emulated there = play_there(mutated.write(kTrace_ms));
  EXPECT_EQ(there.outcome.exit_code, 0) << there.outcome.text;
  EXPECT_EQ(here.output.size(), there.output.size());
  EXPECT_NE(first_difference(here.output, there.output), std::nullopt);
}

TEST_F(EmulatedFirmware, ATraceThatIsCutOffIsRefusedThereToo) {
  std::vector<std::uint8_t> trace = SyntheticTrace(8).write(20);
  trace.pop_back();
  EXPECT_EQ(play_there(trace).outcome.exit_code, static_cast<int>(ReplayResult::truncated));
}

TEST_F(EmulatedFirmware, ItsInterruptsServeABoard) {
  const CommandOutcome outcome = emulate("gaitway_interrupt_test.elf");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
}

// The number that stands before or after these words, or -1.
int number_before(const std::string& text, const std::string& words) {
  const std::size_t end = text.find(words);
  if (end == std::string::npos) {
    return -1;
  }
  const std::size_t space = text.find_last_of(' ', end - 1);
  return std::stoi(text.substr(space == std::string::npos ? 0 : space, end));
}
int number_after(const std::string& text, const std::string& words) {
  const std::size_t begin = text.find(words);
  return begin == std::string::npos ? -1 : std::stoi(text.substr(begin + words.size()));
}

TEST_F(EmulatedFirmware, FitsASmallMicrocontroller) {
  std::ifstream file(firmware_build() / "size.txt");
  std::string line;
  ASSERT_TRUE(std::getline(file, line));
  const int flash_bytes = number_before(line, " bytes of flash");
  const int ram_bytes = number_before(line, " bytes of RAM");
  EXPECT_GT(flash_bytes, 4096) << "there is a program: " << line;
  EXPECT_LE(flash_bytes, kFlashBudget_bytes);
  EXPECT_GT(ram_bytes, 256) << line;
  EXPECT_LE(ram_bytes, kRamBudget_bytes);
  const CommandOutcome interrupts = emulate("gaitway_interrupt_test.elf");
  const int stack_bytes = number_after(interrupts.text, "stack_bytes ");
  EXPECT_GT(stack_bytes, 0) << interrupts.text;
  EXPECT_LE(stack_bytes, kStackBudget_bytes);
}

TEST_F(EmulatedFirmware, LinksNoHeapNoExceptionsAndNoOperatingSystem) {
  const CommandOutcome symbols =
      run_command("arm-none-eabi-nm '" + (firmware_build() / "gaitway_joint.elf").string() + "'");
  ASSERT_EQ(symbols.exit_code, 0) << symbols.text;
  EXPECT_THAT(symbols.text, testing::HasSubstr(" T Reset_Handler"));
  EXPECT_THAT(
      symbols.text,
      testing::Not(testing::ContainsRegex(
          " [A-Za-z] (_*malloc|_*free|_*realloc|_sbrk|_Zn[wa]j|_Zd[la]Pv|__cxa_|_Unwind|__aeabi_unwind"
          "|__gxx|_ZSt9terminate|abort|_*exit|_*printf|_write|sin|cos|sqrt|pow)")));
}

TEST_F(EmulatedFirmware, CodeThatWantsAHeapOrThrowsDoesNotLink) {
  for (const char* const image : {"gaitway_wants_malloc", "gaitway_wants_new", "gaitway_wants_throw"}) {
    const CommandOutcome outcome =
        run_command("cmake --build '" + firmware_build().string() + "' --target " + image);
    EXPECT_NE(outcome.exit_code, 0) << image;
    EXPECT_THAT(outcome.text, testing::ContainsRegex("undefined reference to `(_sbrk|operator new|__cxa_)"))
        << image;
  }
}

}  // namespace
}  // namespace gaitway::firmware
