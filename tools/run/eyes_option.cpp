// Pairs of pictures into a folder.
#include "tools/run/eyes_option.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace gaitway::tools {

EyeFiles::EyeFiles(const std::optional<std::filesystem::path>& folder,
                   const simulator::Cosimulation& cosimulation)
    : folder_(folder) {
  if (!folder_) return;
  if (cosimulation.camera() == nullptr) {
    throw std::invalid_argument(
        fmt::format("--eyes: the robot '{}' has no camera. Give it a camera.yaml (urdf/README.md), or leave "
                    "--eyes out",
                    cosimulation.robot().name));
  }
  std::filesystem::create_directories(*folder_);
}

void EyeFiles::look(const simulator::Cosimulation& cosimulation) {
  if (!folder_) return;
  const simulator::PicturePair& pair = cosimulation.camera()->newest();
  if (pair.number == written_) return;
  written_ = pair.number;
  try {
    simulator::write_pair((*folder_ / fmt::format("{:06}.png", pair.number)).string(), pair);
  } catch (const std::runtime_error& error) {  // a full disk, say, which costs pictures and never the run
    ++lost_;
    failure_ = error.what();
  }
}

void EyeFiles::finish(const simulator::Cosimulation& cosimulation) const {
  if (folder_ && !cosimulation.camera()->failure().empty()) {
    throw std::runtime_error(cosimulation.camera()->failure());
  }
}

void EyeFiles::require_all() const {
  if (lost_ != 0) {
    throw std::runtime_error(fmt::format("--eyes: {} pairs of pictures are missing: {}", lost_, failure_));
  }
}

}  // namespace gaitway::tools
