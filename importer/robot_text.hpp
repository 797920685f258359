// What the files of a robot's folder say in the same words.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <string>

#include "gaitway/importer/import.hpp"

namespace gaitway::importer {

[[nodiscard]] std::string network_text(const ImportedRobot& imported);

// Roll, pitch and yaw as a URDF counts them [rad].
[[nodiscard]] Eigen::Vector3d rpy_of(const Eigen::Matrix3d& rotation);

// The file's name on one line, without what would end an XML comment.
[[nodiscard]] std::string in_comment(const std::filesystem::path& file);

}  // namespace gaitway::importer
