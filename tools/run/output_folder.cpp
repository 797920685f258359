// Makes the folder, and tries whether a file can be made in it.
#include "tools/run/output_folder.hpp"

#include <fmt/format.h>

#include <fstream>
#include <stdexcept>

namespace gaitway::tools {

void prepare_output(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  const std::filesystem::path probe = folder / ".gaitway_writable";
  const bool writable = !error && std::ofstream(probe).is_open();
  if (!writable) {
    throw std::invalid_argument(
        fmt::format("--out {}: must be a folder that can be written to{}. Choose another one",
                    folder.string(), error ? " (" + error.message() + ")" : ""));
  }
  std::filesystem::remove(probe, error);
}

}  // namespace gaitway::tools
