// The prepared motions of a robot as a page wants them: what each is, and its postures, so that a page can
// show a motion without the robot's moving.
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <span>

#include "gaitway/page/asset_table.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::page {

inline constexpr std::chrono::milliseconds kPreviewPeriod{50};                  // between two postures
inline constexpr std::size_t kMostPreviewBytes = std::size_t{4} * 1024 * 1024;  // of all motions' postures

// Adds /motions.json (name, description, duration, start of each; why one cannot be shown) and
// /motion/NAME.json, its postures. Of `folders` the first that has a motion counts; one need not exist.
// Nothing is thrown for a file that is damaged, or made for another robot: the list says so.
void add_motions(AssetTable& table, const urdf::RobotModel& robot,
                 std::span<const std::filesystem::path> folders);

}  // namespace gaitway::page
