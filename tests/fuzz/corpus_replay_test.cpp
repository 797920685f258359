// Every fuzz target over its checked-in inputs, in the ordinary test suite and with the ordinary compiler:
// the seeds in corpus/ and what fuzzing has found in findings/. Also over each of them cut short, which is
// what truncated messages look like.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <ostream>
#include <span>
#include <string>
#include <vector>

#include "fuzz_input.hpp"
#include "fuzz_targets.hpp"

namespace gaitway::fuzz {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes bytes_of(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

std::vector<std::filesystem::path> inputs_of(const std::string& target) {
  std::vector<std::filesystem::path> files;
  for (const char* const kind : {"corpus", "findings"}) {
    const auto folder = std::filesystem::path(GAITWAY_FUZZ_DIRECTORY) / kind / target;
    if (std::filesystem::is_directory(folder)) {
      for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        files.push_back(entry.path());
      }
    }
  }
  std::sort(files.begin(), files.end());
  return files;
}

void run(const Target& target, std::span<const std::uint8_t> bytes, const std::string& name) {
  try {
    target.function(bytes);
  } catch (const BrokenProperty& broken) {
    ADD_FAILURE() << name << ": " << broken.what;
  }
}

class FuzzTarget : public testing::TestWithParam<Target> {};

TEST_P(FuzzTarget, KeepsItsPropertiesOnEveryKnownInput) {
  const auto files = inputs_of(GetParam().name);
  ASSERT_FALSE(files.empty()) << "tests/fuzz/corpus/" << GetParam().name << " holds no seed";
  for (const std::filesystem::path& file : files) {
    run(GetParam(), bytes_of(file), file.string());
  }
}

TEST_P(FuzzTarget, KeepsItsPropertiesOnKnownInputsCutShort) {
  constexpr std::size_t kCuts = 16;
  for (const std::filesystem::path& file : inputs_of(GetParam().name)) {
    const Bytes bytes = bytes_of(file);
    for (std::size_t cut = 0; cut < kCuts; ++cut) {
      const std::size_t length = bytes.size() * cut / kCuts;
      // In memory of its own, so that the address sanitizer sees every read past the end.
      const Bytes shorter(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(length));
      run(GetParam(), shorter, file.string() + ", first " + std::to_string(length) + " bytes");
    }
  }
}

INSTANTIATE_TEST_SUITE_P(All, FuzzTarget, testing::ValuesIn(kTargets),
                         [](const auto& target) { return std::string(target.param.name); });

}  // namespace
}  // namespace gaitway::fuzz
