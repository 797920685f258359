// Made by mkdtemp, among the temporary files.
#include "gaitway/process/private_folder.hpp"

#include <stdlib.h>

#include <cerrno>
#include <system_error>

namespace gaitway::process {

PrivateFolder::PrivateFolder(const std::string& name) {
  std::string path = (std::filesystem::temp_directory_path() / (name + ".XXXXXX")).string();
  if (mkdtemp(path.data()) == nullptr) {
    throw std::system_error(errno, std::generic_category(), path + ": cannot be made");
  }
  path_ = path;
}

PrivateFolder::~PrivateFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace gaitway::process
