// The faults of a stereo camera that hold now.
#pragma once

#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "gaitway/simulator/camera_fault.hpp"
#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::simulator {

class CameraFaults {
 public:
  // A camera has one fault of a kind: a newer one takes its place.
  void begin(const CameraFault& fault, std::int64_t now_ns);
  // Forgets those that have ended.
  void at(std::int64_t now_ns);

  [[nodiscard]] bool dead(urdf::Side side) const noexcept { return holds(CameraFault::How::dead, side); }
  [[nodiscard]] bool frozen(urdf::Side side) const noexcept { return holds(CameraFault::How::frozen, side); }
  [[nodiscard]] bool exchanged() const noexcept { return find(CameraFault::How::exchanged) != nullptr; }
  // Of the light that reaches it.
  [[nodiscard]] double light(urdf::Side side) const noexcept;
  [[nodiscard]] Eigen::Quaterniond turn(urdf::Side side) const noexcept;
  [[nodiscard]] double dropped_share() const noexcept;
  [[nodiscard]] std::int64_t later_ns() const noexcept;

 private:
  struct Active {
    CameraFault fault;
    std::int64_t until_ns = 0;
  };
  [[nodiscard]] const CameraFault* find(CameraFault::How how) const noexcept;
  [[nodiscard]] const CameraFault* find(CameraFault::How how, urdf::Side side) const noexcept;
  [[nodiscard]] bool holds(CameraFault::How how, urdf::Side side) const noexcept {
    return find(how, side) != nullptr;
  }
  std::vector<Active> active_;
};

}  // namespace gaitway::simulator
