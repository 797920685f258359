// Which world somebody wants: a file, or the name of one that is shipped.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/world/world.hpp"

namespace gaitway::world {

struct WorldChoice {
  std::string name;                          // as written
  std::optional<std::uint64_t> random_seed;  // in place of those of the file's random courses
  // Where it is written, for complaints: a file and its line, or an option of a command line.
  std::filesystem::path written_in;
  int line = 0;
};

// The name counts from the folder of the file that it is written in; where no file is, it is a shipped
// world's. Throws input::InputError.
[[nodiscard]] World load_world(const WorldChoice& choice);

// Their names, in alphabetical order.
[[nodiscard]] std::vector<std::string> shipped_worlds();

}  // namespace gaitway::world
