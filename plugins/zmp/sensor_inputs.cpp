// Which joint brings which sensor comes from the network map: a silent joint makes its sensors stale.
#include "gaitway/zmp/sensor_inputs.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::zmp {
namespace {

using facts::kSlot_ns;
using facts::kSlot_s;
constexpr std::size_t kMaskBits = 64;
// No sensor on legs that move at this rate tells exactly the same so many times in a row: it is stuck.
constexpr double kMoving_rad_per_s = 0.05;
constexpr int kSamplesOfAStuckSensor = 15;

bool all_finite(std::span<const double> values) noexcept {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

std::uint64_t bit(std::size_t joint) noexcept {
  return joint < kMaskBits ? std::uint64_t{1} << joint : 0;
}

}  // namespace

SensorInputs::SensorInputs(const urdf::RobotModel& model, double stale_after_s)
    : stale_after_ns_(static_cast<std::int64_t>(std::llround(stale_after_s * 1e9))),
      has_inclinometer_(model.carries(urdf::SensorKind::inclination)),
      senses_load_(model.senses_load()),
      leg_joints_{model.legs[0].joints, model.legs[1].joints} {
  for (std::size_t joint = 0; joint < model.joints.size(); ++joint) {
    position_rad_.push_back(model.joints[joint].home_rad);
    if (joint >= model.channels.size()) continue;
    for (const urdf::SensorChannel& channel : model.channels[joint]) {
      using Kind = urdf::SensorKind;
      if (channel.kind == Kind::force_cell || channel.kind == Kind::foot_wrench) forces_.joints |= bit(joint);
      if (channel.kind == Kind::angular_velocity || channel.kind == Kind::inclination)
        imu_.joints |= bit(joint);
    }
  }
}

std::int64_t SensorInputs::stamp_ns() const noexcept {
  return std::min({joints_.stamp_ns, forces_.stamp_ns, imu_.stamp_ns});
}

bool SensorInputs::is_fresh(const Source& source, std::int64_t stamp_ns, std::int64_t now_ns,
                            std::uint64_t missing) const noexcept {
  return (!source.seen || stamp_ns > source.stamp_ns) && now_ns - stamp_ns <= stale_after_ns_ &&
         (source.joints & missing) == 0;
}

void SensorInputs::mark(Source& source, std::int64_t stamp_ns) noexcept {
  const std::int64_t elapsed_ns = source.seen ? stamp_ns - source.stamp_ns : kSlot_ns;
  source.slots = static_cast<int>(std::max<std::int64_t>(1, (elapsed_ns + kSlot_ns / 2) / kSlot_ns));
  source.stamp_ns = stamp_ns;
  source.seen = true;
}

void SensorInputs::take(std::int64_t now_ns, const JointStates& joints, const FootForces& forces,
                        const gaitway::Imu& imu) noexcept {
  joints_.slots = forces_.slots = imu_.slots = 0;
  faults_ = InputFaults{};
  take_joints(now_ns, joints);
  if (senses_load_) take_forces(now_ns, forces, faults_.missing);
  take_imu(now_ns, imu, faults_.missing);
  if (!senses_load_ && imu_.slots > 0) mark(forces_, imu_.stamp_ns);  // it tells them
  faults_.joints_stale = joints_.slots == 0;
  faults_.forces_stale = forces_.slots == 0;
  faults_.imu_stale = imu_.slots == 0;
}

void SensorInputs::take_joints(std::int64_t now_ns, const JointStates& joints) noexcept {
  faults_.missing = joints.missing;
  if (joints.joint_count != position_rad_.size() || !is_fresh(joints_, joints.stamp_ns, now_ns, 0)) return;
  for (std::size_t i = 0; i < position_rad_.size(); ++i) {
    if (!std::isfinite(joints.position[i])) {
      faults_.missing |= bit(i);
    } else if ((joints.missing & bit(i)) == 0) {
      position_rad_[i] = joints.position[i];
    }
  }
  const bool first = !joints_.seen;
  mark(joints_, joints.stamp_ns);
  leg_reference_rate_ = 0.0;
  for (std::size_t side = 0; side < leg_joints_.size(); ++side) {
    for (std::size_t i = 0; i < leg_joints_[side].size(); ++i) {
      const double reference = joints.reference_position[leg_joints_[side][i]];
      const double change = first ? 0.0 : std::abs(reference - leg_reference_rad_[side][i]);
      if (!std::isfinite(reference)) continue;
      leg_reference_rad_[side][i] = reference;
      leg_reference_rate_ = std::max(leg_reference_rate_, change / (kSlot_s * joints_.slots));
    }
  }
}

void SensorInputs::take_forces(std::int64_t now_ns, const FootForces& forces,
                               std::uint64_t missing) noexcept {
  if (!is_fresh(forces_, forces.stamp_ns, now_ns, missing)) return;
  for (std::size_t side = 0; side < force_N_.size(); ++side) {
    if (!all_finite(forces.force[side]) || !all_finite(forces.acceleration[side])) return;
  }
  for (std::size_t side = 0; side < force_N_.size(); ++side) {
    std::copy(std::begin(forces.force[side]), std::end(forces.force[side]), force_N_[side].begin());
    foot_acceleration_[side] = Eigen::Map<const Eigen::Vector3d>(forces.acceleration[side]);
  }
  mark(forces_, forces.stamp_ns);
}

void SensorInputs::take_imu(std::int64_t now_ns, const gaitway::Imu& imu, std::uint64_t missing) noexcept {
  if (!is_fresh(imu_, imu.stamp_ns, now_ns, missing)) return;
  if (!all_finite(imu.angular_velocity) || !all_finite(imu.acceleration) || !all_finite(imu.inclination))
    return;
  if (imu_is_stuck(imu)) return;
  gyro_ = Eigen::Map<const Eigen::Vector3d>(imu.angular_velocity);
  acceleration_ = Eigen::Map<const Eigen::Vector3d>(imu.acceleration);
  inclination_.reset();
  if (has_inclinometer_) inclination_ = Eigen::Map<const Eigen::Vector2d>(imu.inclination);
  mark(imu_, imu.stamp_ns);
}

// A robot that stands may tell the same for long where its sensors do not rattle.
bool SensorInputs::imu_is_stuck(const gaitway::Imu& imu) noexcept {
  const bool same = imu_.seen && (gyro_ == Eigen::Map<const Eigen::Vector3d>(imu.angular_velocity) ||
                                  acceleration_ == Eigen::Map<const Eigen::Vector3d>(imu.acceleration));
  if (!same) {
    same_imu_samples_ = 0;
  } else if (leg_reference_rate_ > kMoving_rad_per_s) {
    same_imu_samples_ = std::min(same_imu_samples_ + 1, kSamplesOfAStuckSensor);
  }
  return same_imu_samples_ == kSamplesOfAStuckSensor;
}

}  // namespace gaitway::zmp
