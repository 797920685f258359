// From light to numbers: exposure, what a pixel holds at most, photon noise, read noise, eight bits.
#pragma once

#include <cstdint>
#include <span>

#include "gaitway/facts/random_stream.hpp"
#include "gaitway/simulator/stereo_camera.hpp"

namespace gaitway::simulator {

// A picture's exposure, the same for both cameras.
struct Exposure {
  double time_s = 0.004;
  double gain = 1.0;
};

// `light`: of each pixel; 1 fills it in `full_time_s` at a gain of 1. Electrons are counted with noise of
// their square root and of the read-out, both as normal deviations (a photon count of less than ten is none);
// then gain, 255 at most. The same stream gives the same picture.
void expose(std::span<const float> light, const Exposure& exposure, double full_time_s,
            facts::RandomStream& noise, std::span<std::uint8_t> grey);

// Chooses the next picture's exposure by the last one's mean. It takes some pictures to follow the light.
class ExposureControl {
 public:
  ExposureControl(const StereoCameraOptions& options, double longest_s) noexcept;

  [[nodiscard]] const Exposure& exposure() const noexcept { return exposure_; }
  void look(std::span<const std::uint8_t> grey) noexcept;

 private:
  void set(double amount) noexcept;  // time times gain, of longest_s_ at gain 1

  bool fixed_;
  double longest_s_;
  double amount_ = 1.0;
  Exposure exposure_;
};

}  // namespace gaitway::simulator
