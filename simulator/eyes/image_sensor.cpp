// A small sensor with a rolling shutter, as cameras of this price have it.
#include "image_sensor.hpp"

#include <algorithm>
#include <cmath>

namespace gaitway::simulator {
namespace {

constexpr float kFull_electrons = 9000.0F;  // what a pixel holds
constexpr float kRead_electrons = 6.0F;     // standard deviation of reading it
constexpr float kWhite = 255.0F;

constexpr double kMeanGoal = 105.0;
constexpr double kFollow = 0.6;  // of the way to the goal with each picture, as a power
constexpr double kShortest = 0.1, kMostGain = 8.0;

}  // namespace

void expose(std::span<const float> light, const Exposure& exposure, double full_time_s,
            facts::RandomStream& noise, std::span<std::uint8_t> grey) {
  const auto electrons_of_light = kFull_electrons * static_cast<float>(exposure.time_s / full_time_s);
  const float grey_of_electron = kWhite / kFull_electrons * static_cast<float>(exposure.gain);
  for (std::size_t i = 0; i < light.size(); ++i) {
    const float electrons = light[i] * electrons_of_light;
    const float deviation = std::sqrt(electrons + kRead_electrons * kRead_electrons);
    const float counted =
        std::min(electrons + deviation * static_cast<float>(noise.quick_normal()), kFull_electrons);
    grey[i] = static_cast<std::uint8_t>(std::clamp(counted * grey_of_electron + 0.5F, 0.0F, kWhite));
  }
}

ExposureControl::ExposureControl(const StereoCameraOptions& options, double longest_s) noexcept
    : fixed_(!options.auto_exposure), longest_s_(longest_s) {
  set(fixed_ ? options.fixed_exposure : 1.0);
}

void ExposureControl::set(double amount) noexcept {
  amount_ = std::clamp(amount, kShortest, kMostGain);
  exposure_.time_s = longest_s_ * std::min(amount_, 1.0);
  exposure_.gain = std::max(amount_, 1.0);
}

void ExposureControl::look(std::span<const std::uint8_t> grey) noexcept {
  if (fixed_ || grey.empty()) return;
  double sum = 0.0;
  for (const std::uint8_t pixel : grey) sum += pixel;
  const double mean = std::max(sum / static_cast<double>(grey.size()), 1.0);
  set(amount_ * std::pow(kMeanGoal / mean, kFollow));
}

}  // namespace gaitway::simulator
