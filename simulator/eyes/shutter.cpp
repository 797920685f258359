// Rows, bands and what each pixel sees of a drawing.
#include "shutter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace gaitway::simulator {
namespace {

constexpr double kTravelOfBand_m = 0.0008;  // that a band's rows may see from a wrong place, all together
constexpr int kMostBands = 4;
constexpr int kMostSamples = 7;
constexpr double kBlurOfSample_px = 0.7;
constexpr double kMargin = 2.0;  // pixels of a drawing around what is seen of it
constexpr double kRoomForTurns = 1.25;
constexpr double kSunAhead_m = 1.2, kSunGrid_m = 0.5;

// The link's rotation between two instants.
Eigen::Quaterniond rotation_at(std::span<const PictureInstant> instants, double at_ns) {
  const auto behind = std::ranges::find_if(
      instants, [at_ns](const PictureInstant& one) { return static_cast<double>(one.at_ns) >= at_ns; });
  if (behind == instants.begin()) return Eigen::Quaterniond(instants.front().link.linear());
  if (behind == instants.end()) return Eigen::Quaterniond(instants.back().link.linear());
  const PictureInstant &before = *(behind - 1), &after = *behind;
  const double share =
      (at_ns - static_cast<double>(before.at_ns)) / static_cast<double>(after.at_ns - before.at_ns);
  return Eigen::Quaterniond(before.link.linear()).slerp(share, Eigen::Quaterniond(after.link.linear()));
}

const PictureInstant& nearest(std::span<const PictureInstant> instants, double at_ns) {
  return *std::ranges::min_element(instants, {}, [at_ns](const PictureInstant& one) {
    return std::abs(static_cast<double>(one.at_ns) - at_ns);
  });
}

// The shadow map stands still while the head does not go far.
Eigen::Vector3d sun_over(const Eigen::Isometry3d& optical) {
  Eigen::Vector3d ahead = optical.linear().col(2);
  ahead.z() = 0.0;
  Eigen::Vector3d place = optical.translation() + kSunAhead_m * ahead;
  for (double& value : place) value = kSunGrid_m * std::round(value / kSunGrid_m);
  place.z() = 0.0;
  return place;
}

}  // namespace

Shutter::Shutter(const urdf::Lens& lens, int width_px, int height_px, double oversampling)
    : width_px_(width_px), height_px_(height_px), scale_(oversampling * lens.parameters().fx_px) {
  direction_.reserve(static_cast<std::size_t>(width_px) * static_cast<std::size_t>(height_px));
  for (int row = 0; row < height_px; ++row) {
    for (int column = 0; column < width_px; ++column) {
      const auto direction = lens.unproject(Eigen::Vector2d(column, row));
      if (!direction) throw std::invalid_argument("a lens that does not see each pixel of its picture");
      direction_.emplace_back(direction->cast<float>());
      const double cosine_squared = 1.0 / (1.0 + direction->squaredNorm());
      vignetting_.push_back(static_cast<float>(cosine_squared * cosine_squared));
    }
  }
  Eigen::Vector2f least = direction_.front(), most = direction_.front();
  for (const Eigen::Vector2f& direction : direction_) {
    least = least.cwiseMin(direction);
    most = most.cwiseMax(direction);
  }
  const Eigen::Vector2d size_px = (most - least).cast<double>() * scale_ * kRoomForTurns;
  widest_px_ = static_cast<int>(size_px.x());
  highest_px_ = static_cast<int>(size_px.y());
}

std::vector<Shutter::Band> Shutter::bands_of(std::span<const PictureInstant> instants,
                                             const ShutterTimes& times,
                                             const Eigen::Isometry3d& in_link) const {
  const Eigen::Vector3d travel_m =
      (instants.back().link * in_link).translation() - (instants.front().link * in_link).translation();
  const int count = std::clamp(static_cast<int>(std::ceil(travel_m.norm() / kTravelOfBand_m)), 1, kMostBands);
  std::vector<Band> bands;
  for (int band = 0; band < count; ++band) {
    const int first = height_px_ * band / count, end = height_px_ * (band + 1) / count;
    const double at_ns = static_cast<double>(times.middle_ns) +
                         1e9 * 0.5 * (times.row_s(first, height_px_) + times.row_s(end - 1, height_px_));
    bands.push_back({first, end, &nearest(instants, at_ns)});
  }
  return bands;
}

// So many that two of them are less than a pixel apart.
int Shutter::blur_samples(std::span<const PictureInstant> instants, const ShutterTimes& times) const {
  const double whole_s = 1e-9 * static_cast<double>(instants.back().at_ns - instants.front().at_ns);
  if (!(whole_s > 0.0)) return 1;
  const double turn_rad = Eigen::Quaterniond(instants.front().link.linear())
                              .angularDistance(Eigen::Quaterniond(instants.back().link.linear()));
  const double blur_px = turn_rad * times.exposure_s / whole_s * scale_;
  return std::clamp(1 + static_cast<int>(blur_px / kBlurOfSample_px), 1, kMostSamples);
}

void Shutter::turn_rows(const Band& band, std::span<const PictureInstant> instants, const ShutterTimes& times,
                        const Eigen::Isometry3d& in_link) {
  const Eigen::Matrix3d into_drawing = (band.drawn->link.linear() * in_link.linear()).transpose();
  turn_.clear();
  for (int row = band.first_row; row < band.end_row; ++row) {
    for (int sample = 0; sample < samples_; ++sample) {
      const double off_s =
          times.row_s(row, height_px_) + times.exposure_s * ((sample + 0.5) / samples_ - 0.5);
      const Eigen::Quaterniond link =
          rotation_at(instants, static_cast<double>(times.middle_ns) + 1e9 * off_s);
      turn_.emplace_back((into_drawing * link.toRotationMatrix() * in_link.linear()).cast<float>());
    }
  }
}

// All directions of the band lie within those of its border.
PinholeWindow Shutter::window_of(const Band& band) const {
  constexpr float kFar = std::numeric_limits<float>::max();
  Eigen::Vector2f least(kFar, kFar), most(-kFar, -kFar);
  for (int row = band.first_row; row < band.end_row; ++row) {
    const bool whole = row == band.first_row || row == band.end_row - 1;
    for (int column = 0; column < width_px_; column += whole ? 1 : width_px_ - 1) {
      const Eigen::Vector2f& direction = direction_[static_cast<std::size_t>(row * width_px_ + column)];
      for (int sample = 0; sample < samples_; ++sample) {
        const Eigen::Vector3f seen =
            turn_[static_cast<std::size_t>((row - band.first_row) * samples_ + sample)] *
            direction.homogeneous();
        least = least.cwiseMin(seen.head<2>() / seen.z());
        most = most.cwiseMax(seen.head<2>() / seen.z());
      }
    }
  }
  PinholeWindow window;
  window.scale = scale_;
  window.left = static_cast<double>(least.x()) - kMargin / scale_;
  window.top = static_cast<double>(least.y()) - kMargin / scale_;
  const auto pixels = [this](float from, float to) {
    return static_cast<int>(std::ceil(static_cast<double>(to - from) * scale_ + 2.0 * kMargin));
  };
  window.width_px = std::min(pixels(least.x(), most.x()), widest_px_);
  window.height_px = std::min(pixels(least.y(), most.y()), highest_px_);
  return window;
}

void Shutter::sample(const Band& band, const PinholeWindow& window, std::vector<float>& light) const {
  const auto scale = static_cast<float>(scale_), left = static_cast<float>(window.left),
             top = static_cast<float>(window.top);
  const float right_px = static_cast<float>(window.width_px) - 1.001F;
  const float bottom_px = static_cast<float>(window.height_px) - 1.001F;
  const float share = 1.0F / (255.0F * static_cast<float>(samples_));
  const std::uint8_t* const grey = drawing_.grey.data();
  const auto stride = static_cast<std::size_t>(window.width_px);
  for (int row = band.first_row; row < band.end_row; ++row) {
    const Eigen::Matrix3f* const turns = &turn_[static_cast<std::size_t>((row - band.first_row) * samples_)];
    for (int column = 0; column < width_px_; ++column) {
      const auto pixel = static_cast<std::size_t>(row * width_px_ + column);
      const Eigen::Vector3f direction = direction_[pixel].homogeneous();
      float sum = 0.0F;
      for (int sample = 0; sample < samples_; ++sample) {
        const Eigen::Vector3f seen = turns[sample] * direction;
        const float u = std::clamp((seen.x() / seen.z() - left) * scale - 0.5F, 0.0F, right_px);
        const float v = std::clamp((seen.y() / seen.z() - top) * scale - 0.5F, 0.0F, bottom_px);
        const auto x = static_cast<std::size_t>(u), y = static_cast<std::size_t>(v);
        const float across = u - static_cast<float>(x), down = v - static_cast<float>(y);
        const std::uint8_t* const at = grey + y * stride + x;
        const float above = at[0] + across * static_cast<float>(at[1] - at[0]);
        const float below = at[stride] + across * static_cast<float>(at[stride + 1] - at[stride]);
        sum += above + down * (below - above);
      }
      light[pixel] = sum * share * vignetting_[pixel];
    }
  }
}

void Shutter::take(std::span<const PictureInstant> instants, const ShutterTimes& times,
                   const Eigen::Isometry3d& in_link, SceneView& view, std::vector<float>& light) {
  light.resize(direction_.size());
  samples_ = blur_samples(instants, times);
  const std::vector<Band> bands = bands_of(instants, times, in_link);
  bands_ = static_cast<int>(bands.size());
  for (const Band& band : bands) {
    turn_rows(band, instants, times, in_link);
    const PinholeWindow window = window_of(band);
    const Eigen::Isometry3d optical = band.drawn->link * in_link;
    view.draw(band.drawn->positions, optical, window, sun_over(optical), drawing_);
    sample(band, window, light);
  }
}

}  // namespace gaitway::simulator
