// Writes a whole text file: one that could not be written to its last byte is an error.
#include "gaitway/process/text_file.hpp"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>

namespace gaitway::process {

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno) +
                             "; is the folder there and writable, is the disk full?");
  }
}

}  // namespace gaitway::process
