// Which fault of which camera, and for how long.
#include "camera_faults.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "gaitway/facts/facts.hpp"

namespace gaitway::simulator {
namespace {

constexpr double kCovered = 0.01, kDazzled = 40.0;

bool is_of(const CameraFault& fault, urdf::Side side) {
  return fault.camera == CameraFault::Camera::both ||
         (fault.camera == CameraFault::Camera::left) == (side == urdf::Side::left);
}

std::int64_t nanoseconds(double seconds) {
  return static_cast<std::int64_t>(std::llround(seconds * static_cast<double>(facts::kSecond_ns)));
}

}  // namespace

void CameraFaults::begin(const CameraFault& fault, std::int64_t now_ns) {
  std::erase_if(active_, [&fault](const Active& one) {
    return one.fault.how == fault.how &&
           (one.fault.camera == fault.camera || fault.camera == CameraFault::Camera::both);
  });
  active_.push_back({fault, fault.duration_s > 0.0 ? now_ns + nanoseconds(fault.duration_s)
                                                   : std::numeric_limits<std::int64_t>::max()});
}

void CameraFaults::at(std::int64_t now_ns) {
  std::erase_if(active_, [now_ns](const Active& one) { return now_ns >= one.until_ns; });
}

const CameraFault* CameraFaults::find(CameraFault::How how) const noexcept {
  const auto found = std::ranges::find_if(active_, [how](const Active& one) { return one.fault.how == how; });
  return found == active_.end() ? nullptr : &found->fault;
}

const CameraFault* CameraFaults::find(CameraFault::How how, urdf::Side side) const noexcept {
  const auto found = std::ranges::find_if(
      active_, [how, side](const Active& one) { return one.fault.how == how && is_of(one.fault, side); });
  return found == active_.end() ? nullptr : &found->fault;
}

double CameraFaults::light(urdf::Side side) const noexcept {
  return (holds(CameraFault::How::dark, side) ? kCovered : 1.0) *
         (holds(CameraFault::How::over_exposed, side) ? kDazzled : 1.0);
}

Eigen::Quaterniond CameraFaults::turn(urdf::Side side) const noexcept {
  const CameraFault* const fault = find(CameraFault::How::turned, side);
  const Eigen::Vector3d turn_rad =
      fault == nullptr ? Eigen::Vector3d::Zero() : Eigen::Vector3d(fault->turn_deg * facts::kRadPerDegree);
  if (turn_rad.isZero()) return Eigen::Quaterniond::Identity();
  return Eigen::Quaterniond(Eigen::AngleAxisd(turn_rad.norm(), turn_rad.normalized()));
}

double CameraFaults::dropped_share() const noexcept {
  const CameraFault* const fault = find(CameraFault::How::dropped);
  return fault == nullptr ? 0.0 : fault->share;
}

std::int64_t CameraFaults::later_ns() const noexcept {
  const CameraFault* const fault = find(CameraFault::How::late);
  return fault == nullptr ? 0 : nanoseconds(fault->later_s);
}

}  // namespace gaitway::simulator
