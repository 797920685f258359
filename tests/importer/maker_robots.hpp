// Published descriptions of humanoids, which `./dev test` fetches: the wheel example-robot-data.
#pragma once

#include <cstdlib>
#include <filesystem>
#include <optional>

namespace gaitway::importer::test {

// The folder that holds talos_data, romeo_description and the others: GAITWAY_EXAMPLE_ROBOTS of the
// environment, or what ./dev unpacked. Nothing where neither is there: then a test is skipped.
inline std::optional<std::filesystem::path> maker_robots() {
  const char* const named = std::getenv("GAITWAY_EXAMPLE_ROBOTS");
  const std::filesystem::path folder =
      named ? named : std::filesystem::path(GAITWAY_EXAMPLE_ROBOTS_DIR) / "share/example-robot-data/robots";
  return std::filesystem::is_directory(folder / "talos_data") ? std::optional(folder) : std::nullopt;
}

}  // namespace gaitway::importer::test

#define GAITWAY_SKIP_WITHOUT_MAKER_ROBOTS()                                          \
  if (!gaitway::importer::test::maker_robots())                                      \
  GTEST_SKIP() << "no published descriptions here: ./dev test fetches them, or set " \
                  "GAITWAY_EXAMPLE_ROBOTS to example-robot-data's folder robots"
