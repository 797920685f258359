// Blocks are allocated, not written.
#include "gaitway/process/spare_room.hpp"

#include <fcntl.h>
#include <stdlib.h>
#include <unistd.h>

#include <string>
#include <utility>

namespace gaitway::process {

SpareRoom::SpareRoom(std::filesystem::path folder, std::uint64_t bytes) noexcept
    : folder_(std::move(folder)), bytes_(bytes) {
  take();
}

void SpareRoom::take() noexcept {
  if (file_) return;
  std::string name = (folder_ / ".room.XXXXXX").string();
  FileDescriptor file(mkostemp(name.data(), O_CLOEXEC));
  if (!file) return;
  ::unlink(name.c_str());
  if (fallocate(file.get(), 0, 0, static_cast<off_t>(bytes_)) == 0) file_ = std::move(file);
}

}  // namespace gaitway::process
