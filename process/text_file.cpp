// Writes a whole text file: one that could not be written to its last byte is an error.
#include "gaitway/process/text_file.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <stdexcept>
#include <string>

#include "gaitway/process/file_descriptor.hpp"

namespace gaitway::process {
namespace {

[[noreturn]] void refuse_text(const std::filesystem::path& path) {
  throw std::runtime_error(path.string() + ": cannot be written: " + std::strerror(errno) +
                           "; is the folder there and writable, is the disk full?");
}

bool put_text(int file, std::string_view text) noexcept {
  while (!text.empty()) {
    const ssize_t count = ::write(file, text.data(), text.size());
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(count));
  }
  return true;
}

}  // namespace

void write_text_file(const std::filesystem::path& path, std::string_view text) {
  errno = 0;
  std::ofstream out(path, std::ios::binary);
  out.write(text.data(), static_cast<std::streamsize>(text.size()));
  out.close();
  if (!out) {
    refuse_text(path);
  }
}

void replace_text_file(const std::filesystem::path& path, std::string_view text) {
  std::error_code none;
  if (std::filesystem::exists(path, none) && !std::filesystem::is_regular_file(path, none)) {
    return write_text_file(path, text);
  }
  // Of a link, what it leads to.
  const std::filesystem::path file = std::filesystem::weakly_canonical(path, none);
  const std::filesystem::path& target = file.empty() ? path : file;
  const std::string draft = target.string() + ".new";
  constexpr mode_t kMode = 0666;  // as of every file, less the user's mask
  FileDescriptor out(::open(draft.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, kMode));
  if (!out || !put_text(out.get(), text) || fdatasync(out.get()) != 0 ||
      ::rename(draft.c_str(), target.c_str()) != 0) {
    const int why = errno;
    if (out) ::unlink(draft.c_str());
    errno = why;
    refuse_text(path);
  }
}

}  // namespace gaitway::process
