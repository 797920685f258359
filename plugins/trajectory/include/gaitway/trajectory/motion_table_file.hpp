// Files with prepared motions: `gaitway motion prepare` writes them, the plug-in reads them when it is
// constructed.
#pragma once

#include <filesystem>
#include <stdexcept>
#include <vector>

#include "gaitway/trajectory/motion_table.hpp"

namespace gaitway::trajectory {

inline constexpr const char* kMotionTableEnding = ".motion";

// The file is none, or of another layout; the message names it and what to do.
class MotionTableError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// For this machine's byte order. Both throw MotionTableError.
void write_motion_table(const MotionTable& table, const std::filesystem::path& file);
[[nodiscard]] MotionTable read_motion_table(const std::filesystem::path& file);

// Of a robot's description: a table holds for this one alone. Throws MotionTableError when it cannot be read.
[[nodiscard]] std::uint64_t robot_digest(const std::filesystem::path& robot_directory);

// The tables of a folder, in the order of their names; none if there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> motion_table_files(const std::filesystem::path& folder);

}  // namespace gaitway::trajectory
