// A folder of one's own, as long as one lives.
#include "gaitway/process/private_folder.hpp"

#include <gtest/gtest.h>

#include <fstream>
#include <optional>

namespace gaitway::process {
namespace {

TEST(PrivateFolder, IsItsUsersAloneAndGoesWithWhatIsInIt) {
  std::optional<PrivateFolder> folder(std::in_place, "gaitway_test");
  const PrivateFolder other("gaitway_test");
  const std::filesystem::path path = folder->path();
  EXPECT_NE(path, other.path());
  EXPECT_EQ(std::filesystem::status(path).permissions(), std::filesystem::perms::owner_all);
  std::filesystem::create_directory(path / "inner");
  std::ofstream(path / "inner" / "file") << "x";
  folder.reset();
  EXPECT_FALSE(std::filesystem::exists(path));
}

}  // namespace
}  // namespace gaitway::process
