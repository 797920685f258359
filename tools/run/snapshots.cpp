// Poses in, one picture out.
#include "tools/run/snapshots.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace gaitway::tools {
namespace {

constexpr int kPictureWidth_px = 320, kPictureHeight_px = 360;

}  // namespace

void Snapshots::look(const simulator::Plant& plant) {
  if (plant.time_s() < next_s_ || (!open_end_ && poses_.size() == kPictures)) return;
  if (poses_.size() == kPictures) {
    for (std::size_t i = 1; 2 * i < poses_.size(); ++i) poses_[i] = std::move(poses_[2 * i]);
    poses_.resize(kPictures / 2);
    interval_s_ *= 2.0;
  }
  next_s_ += interval_s_;
  poses_.push_back({{plant.positions().begin(), plant.positions().end()}, {}});
}

void Snapshots::draw_before_change(const simulator::Plant& plant) noexcept {
  try {
    draw(plant);
  } catch (const std::exception& error) {
    failure_ = error.what();
  }
}

void Snapshots::write(const simulator::Plant& plant, const std::filesystem::path& file) {
  if (!failure_.empty()) throw std::runtime_error(failure_);
  draw(plant);
  std::vector<simulator::Image> images;
  for (const Pose& pose : poses_) images.push_back(pose.image);
  simulator::write_film_strip(file.string(), images, kPictures);
}

void Snapshots::draw(const simulator::Plant& plant) {
  if (std::ranges::none_of(poses_, [](const Pose& pose) { return pose.image.rgb.empty(); })) return;
  simulator::Camera camera(plant, kPictureWidth_px, kPictureHeight_px);
  for (Pose& pose : poses_) {
    if (pose.image.rgb.empty()) pose.image = camera.render(pose.positions);
  }
}

}  // namespace gaitway::tools
