// The emulated microcontroller: runs an image of the firmware and tells what it said.
#pragma once

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <optional>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "trace_output.hpp"
#include "trace_writer.hpp"

namespace gaitway::firmware {

struct CommandOutcome {
  int exit_code = -1;
  std::string text;
};

inline CommandOutcome run_command(const std::string& command) {
  CommandOutcome outcome;
  FILE* const pipe = popen((command + " 2>&1").c_str(), "r");  // NOLINT(cert-env33-c): fixed commands
  std::array<char, 4096> chunk{};
  while (pipe != nullptr && std::fgets(chunk.data(), chunk.size(), pipe) != nullptr) {
    outcome.text += chunk.data();
  }
  const int status = pipe == nullptr ? -1 : pclose(pipe);
  outcome.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return outcome;
}

inline std::filesystem::path firmware_build() {
  return GAITWAY_FIRMWARE_BUILD;
}

// Skips where firmware cannot be built or emulated, unless GAITWAY_REQUIRE_FIRMWARE=1 makes that a failure.
class EmulatedFirmware : public testing::Test {
 protected:
  void SetUp() override {
    std::string missing;
    if (!std::filesystem::exists(firmware_build() / "gaitway_joint.elf")) {
      missing =
          "no compiler for the Cortex-M4 when the build was configured: install gcc-arm-none-eabi and "
          "libstdc++-arm-none-eabi-newlib";
    }
#ifndef GAITWAY_ARM_EMULATOR
    missing = "no emulator when the build was configured: install qemu-system-arm";
#endif
    if (missing.empty()) {
      return;
    }
    const char* const required = std::getenv("GAITWAY_REQUIRE_FIRMWARE");
    if (required != nullptr && std::string(required) == "1") {
      FAIL() << missing;
    }
    GTEST_SKIP() << missing;
  }

  // Every instruction takes so long by the emulated clock: a run is the same each time, and a duration is a
  // number of instructions.
  static constexpr int kInstruction_ns = 8;
  static_assert(kInstruction_ns == 1 << 3, "as emulate() has it");
  static CommandOutcome emulate(const std::string& image, const std::vector<std::string>& arguments = {}) {
#ifdef GAITWAY_ARM_EMULATOR
    std::string command = "timeout 250 " GAITWAY_ARM_EMULATOR
                          " -machine netduinoplus2 -nodefaults -display none -monitor none -serial none "
                          "-icount shift=3 -semihosting-config enable=on,target=native,arg=" +
                          image;
    for (const std::string& argument : arguments) {
      command += ",arg=" + argument;
    }
    return run_command(command + " -kernel '" + (firmware_build() / image).string() + "'");
#else
    static_cast<void>(arguments);
    return {-1, image};
#endif
  }

  // A trace played on the microcontroller.
  struct Emulated {
    CommandOutcome outcome;
    std::vector<std::uint8_t> output;
    std::map<std::string, int> figures;  // what the image measured
    // Of the processor's clock, 168 MHz, at kInstruction_ns.
    [[nodiscard]] int instructions(const std::string& name) const {
      return static_cast<int>(std::lround(figures.at(name) / 168e6 * 1e9 / kInstruction_ns));
    }
  };
  static Emulated play_there(std::span<const std::uint8_t> trace) {
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("gaitway_firmware_" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::filesystem::path input = folder / "input", output = folder / "output";
    std::ofstream(input, std::ios::binary)
        .write(reinterpret_cast<const char*>(trace.data()), static_cast<std::streamsize>(trace.size()));
    Emulated emulated;
    emulated.outcome = emulate("gaitway_replay.elf", {input.string(), output.string()});
    std::ifstream file(output, std::ios::binary);
    emulated.output.assign(std::istreambuf_iterator<char>(file), {});
    std::istringstream words(emulated.outcome.text);
    std::string name;
    for (int value = 0; words >> name >> value;) {
      emulated.figures[name] = value;
    }
    std::filesystem::remove_all(folder);
    return emulated;
  }

  // Both machines play the trace and answer the same bytes.
  static Emulated expect_same_bits(std::span<const std::uint8_t> trace) {
    const Played here = play_here(trace);
    Emulated there = play_there(trace);
    EXPECT_EQ(here.result, ReplayResult::complete);
    EXPECT_EQ(there.outcome.exit_code, 0) << there.outcome.text;
    EXPECT_EQ(there.output.size(), here.output.size());
    if (const auto at = first_difference(here.output, there.output)) {
      ADD_FAILURE() << "output byte " << *at << " differs: " << where(trace, here.output, *at);
    }
    return there;
  }

  static void report_cost(const Emulated& there) {
    ASSERT_TRUE(there.figures.contains("stack_bytes")) << there.outcome.text;
    std::cout << "a servo step: " << there.instructions("step_mean_ticks") << " instructions on average, "
              << there.instructions("step_largest_ticks")
              << " at most; a received frame: " << there.instructions("frame_mean_ticks") << " and "
              << there.instructions("frame_largest_ticks")
              << "; stack of the replay: " << there.figures.at("stack_bytes") << " bytes\n";
    // A third of the servo period at 72 MHz, if each took two clocks.
    EXPECT_LE(there.instructions("step_largest_ticks"), 12'000);
  }

  static std::string where(std::span<const std::uint8_t> trace, std::span<const std::uint8_t> output,
                           std::size_t byte) {
    AnswerReader answers(trace, output);
    for (int record = 1; const auto answer = answers.next(); ++record) {
      if (answer->end > byte) {
        return "answer " + std::to_string(record) + " (kind " + static_cast<char>(answer->kind) + ", joint " +
               std::to_string(answer->joint) + ")";
      }
    }
    return "past the end";
  }

  static std::optional<std::size_t> first_difference(std::span<const std::uint8_t> one,
                                                     std::span<const std::uint8_t> other) {
    const auto [at, unused] = std::mismatch(one.begin(), one.end(), other.begin(), other.end());
    if (at == one.end() && one.size() == other.size()) {
      return std::nullopt;
    }
    return static_cast<std::size_t>(at - one.begin());
  }
};

}  // namespace gaitway::firmware
