// Closes what it owns.
#include "gaitway/process/file_descriptor.hpp"

#include <unistd.h>

namespace gaitway::process {

FileDescriptor::~FileDescriptor() {
  if (fd_ >= 0) {
    close(fd_);
  }
}

}  // namespace gaitway::process
