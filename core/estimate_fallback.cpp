// A complementary filter for the attitude, forward kinematics for the CoM.
#include "estimate_fallback.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/tilt.hpp"
#include "gaitway/instance/configuration.hpp"

namespace gaitway::core {
namespace {

constexpr double kShortestTurn_s = 0.010, kLongestTurn_s = 0.100;
using facts::kGravity_m_per_s2;
constexpr double kTiltTime_s = 0.5;  // gyro in less, what is measured in more
constexpr double kBiasTime_s = 1.0;  // in which the estimator's gyro bias is learned from it
constexpr double kLargestBias_rad_per_s = 0.05;
// Of a body like humanoid22:
constexpr double kVelocityTime_s = 0.04;   // low-pass of the CoM's velocity
constexpr double kDifferenceTime_s = 0.3;  // in which the CoM's difference fades
constexpr double kAccelerometerBand_m_per_s2 = 1.0;
constexpr double kContactOn = 0.10, kContactOff = 0.04;  // shares of the weight
constexpr double kSupportShare = 0.60;                   // of the load: then a foot becomes the support foot
constexpr std::int64_t kLongestAge_ns = 35'000'000;      // of forces
constexpr std::int64_t kHandedOnLifetime_ns = 200'000'000;

urdf::RobotModel load(const std::filesystem::path& directory) {
  try {
    return urdf::load_robot(directory);
  } catch (const urdf::RobotError& error) {
    throw PluginError(std::string("the fallback 'estimate' needs the robot: ") + error.what());
  }
}

template <std::size_t size>
bool all_finite(const double (&values)[size]) noexcept {
  return std::ranges::all_of(values, [](double value) { return std::isfinite(value); });
}

double turned_towards(double angle_rad, double measured_rad, double share) noexcept {
  return angle_rad + share * std::remainder(measured_rad - angle_rad, 2.0 * std::numbers::pi);
}

Eigen::Map<const Eigen::Vector3d> vector(const double (&values)[3]) noexcept {
  return Eigen::Map<const Eigen::Vector3d>(values);
}

}  // namespace

EstimateFallback::EstimateFallback(const FallbackSource& source)
    : robot_(load(source.robot_directory)),
      kinematics_(robot_),
      neck_(urdf::neck_of(robot_, kinematics_)),
      slower_(robot_.body_scale().factor("s")),
      weight_N_(robot_.total_mass_kg() * kGravity_m_per_s2),
      joint_reader_(source.client.read<JointStates>("joint_states")),
      imu_reader_(source.client.read<Imu>("imu")),
      force_reader_(source.client.read<FootForces>("foot_forces")),
      plan_reader_(source.client.read<MotionPlan>("motion_plan")),
      estimate_reader_(source.client.read<Estimate>("estimate")) {}

// Learns the gyro's bias from what the estimator makes of the gyro.
void EstimateFallback::follow(const Tick& tick) noexcept {
  take_turn(tick);
  acting_ = false;
  if (!estimate_reader_.read(last_) || !imu_reader_.read(imu_) || imu_.stamp_ns == imu_stamp_ns_) {
    return;
  }
  imu_stamp_ns_ = imu_.stamp_ns;
  const Eigen::Vector3d bias = vector(imu_.angular_velocity) - vector(last_.angular_velocity);
  if (!bias.allFinite()) {
    return;
  }
  gyro_bias_ += (has_bias_ ? turn_s_ / kBiasTime_s : 1.0) * (bias - gyro_bias_);
  gyro_bias_ = gyro_bias_.cwiseMax(-kLargestBias_rad_per_s).cwiseMin(kLargestBias_rad_per_s);
  has_bias_ = true;
}

// Its plug-in need not have its turn in every tick.
void EstimateFallback::take_turn(const Tick& tick) noexcept {
  turn_s_ = std::clamp(static_cast<double>(tick.now_ns - turn_ns_) * 1e-9, kShortestTurn_s, kLongestTurn_s);
  turn_ns_ = tick.now_ns;
}

// A pendulum feels the accelerations that the accelerometer feels, and late.
std::optional<Eigen::Vector2d> EstimateFallback::measured_tilt() const noexcept {
  if (robot_.senses_tilt()) {
    return Eigen::Vector2d(imu_.inclination[0], imu_.inclination[1]);
  }
  const Eigen::Vector3d f = vector(imu_.acceleration);
  if (!(std::abs(f.norm() - kGravity_m_per_s2) <= kAccelerometerBand_m_per_s2)) {
    return std::nullopt;
  }
  return geometry::tilt_at_rest(f);
}

void EstimateFallback::begin(const Tick& tick) noexcept {
  acting_ = true;
  started_ = false;
  const bool fresh =
      static_cast<bool>(estimate_reader_.read(last_)) && tick.now_ns - last_.stamp_ns < kHandedOnLifetime_ns;
  if (fresh) {
    attitude_ = vector(last_.attitude);
    rate_ = vector(last_.angular_velocity);
    com_velocity_ = vector(last_.com_velocity);
    support_ = std::min<std::size_t>(last_.support, 1);
    contact_ = {last_.contact[0] == estimate::contact::bears_load,
                last_.contact[1] == estimate::contact::bears_load};
    com_difference_ = vector(last_.com);  // less the kinematics' CoM, once it is known
    return;
  }
  const Eigen::Vector2d tilt = measured_tilt().value_or(Eigen::Vector2d::Zero());
  const double yaw = last_.attitude[2];
  attitude_ << tilt, std::isfinite(yaw) ? yaw : 0.0;
  com_velocity_.setZero();
  com_difference_.setConstant(std::numeric_limits<double>::quiet_NaN());
  contact_ = {true, true};
}

bool EstimateFallback::act(const Tick& tick, ManagedPlugin& through) noexcept {
  const bool known =
      static_cast<bool>(joint_reader_.read(joints_)) && joints_.joint_count == robot_.joints.size() &&
      static_cast<bool>(imu_reader_.read(imu_)) && all_finite(imu_.angular_velocity) &&
      all_finite(imu_.acceleration) && all_finite(imu_.inclination) && all_finite(joints_.position);
  if (!known) {
    return false;
  }
  take_turn(tick);
  if (!acting_) {
    begin(tick);
  }
  update_attitude();
  kinematics_.compute(std::span(joints_.position).first(robot_.joints.size()));
  update_levels();
  update_contacts(tick);
  update_com();
  write(tick);
  return through.publish_in_place("estimate", last_, tick.now_ns);
}

void EstimateFallback::update_attitude() noexcept {
  if (imu_.stamp_ns == imu_stamp_ns_) {
    return;
  }
  imu_stamp_ns_ = imu_.stamp_ns;
  rate_ = vector(imu_.angular_velocity) - gyro_bias_;
  attitude_ += turn_s_ * geometry::attitude_rate(attitude_, rate_);
  if (const std::optional<Eigen::Vector2d> tilt = measured_tilt()) {
    const double share = turn_s_ / (kTiltTime_s + turn_s_);
    attitude_.x() = turned_towards(attitude_.x(), tilt->x(), share);
    attitude_.y() = turned_towards(attitude_.y(), tilt->y(), share);
  }
}

// Each foot's frame: z against gravity, x in the vertical plane of the sole's x axis.
void EstimateFallback::update_levels() noexcept {
  const Eigen::Matrix3d tilt = (Eigen::AngleAxisd(attitude_.y(), Eigen::Vector3d::UnitY()) *
                                Eigen::AngleAxisd(attitude_.x(), Eigen::Vector3d::UnitX()))
                                   .toRotationMatrix();
  const Eigen::Matrix3d upright_from_base = tilt * kinematics_.link_rotation(robot_.imu.link).transpose();
  for (const urdf::Side side : urdf::kSides) {
    const Eigen::Vector3d forward = upright_from_base * kinematics_.sole_pose(side).linear().col(0);
    level_from_base_[static_cast<std::size_t>(side)] =
        Eigen::AngleAxisd(-std::atan2(forward.y(), forward.x()), Eigen::Vector3d::UnitZ()) *
        upright_from_base;
  }
}

Eigen::Vector3d EstimateFallback::com_seen_from(std::size_t foot) const noexcept {
  const urdf::Side side = urdf::kSides[foot];
  return level_from_base_[foot] * (kinematics_.com_m() - kinematics_.sole_pose(side).translation());
}

bool EstimateFallback::contacts_of_forces(const Tick& tick) noexcept {
  if (!robot_.senses_load() || !force_reader_.read(forces_) ||
      tick.now_ns - forces_.stamp_ns > kLongestAge_ns || !all_finite(forces_.force[0]) ||
      !all_finite(forces_.force[1])) {
    return false;
  }
  for (std::size_t foot = 0; foot < 2; ++foot) {
    force_N_[foot] = 0.0;
    for (const double cell_N : forces_.force[foot]) {
      force_N_[foot] += cell_N;
    }
    contact_[foot] = force_N_[foot] > (contact_[foot] ? kContactOff : kContactOn) * weight_N_;
  }
  return true;
}

// While the newest plan has not begun, what was in contact stays so.
void EstimateFallback::contacts_of_plan(const Tick& tick) noexcept {
  if (plan_reader_.newest_sequence() != plan_sequence_ && plan_reader_.read(*plan_)) {
    plan_sequence_ = plan_reader_.newest_sequence();
  }
  const std::int64_t since_ns = tick.now_ns - plan_->start_ns;
  if (plan_->sequence != 0 && since_ns >= 0) {
    const auto last = static_cast<std::int64_t>(
        kBatchPoints + std::min<std::uint32_t>(plan_->tail_count, kMaxTailPoints) - 1);
    const auto support = static_cast<Support>(plan_->support[std::min(since_ns / facts::kSlot_ns, last)]);
    contact_ = {support != Support::right, support != Support::left};
  } else if (plan_->sequence == 0) {
    contact_ = {true, true};
  }
  const double feet = (contact_[0] ? 1.0 : 0.0) + (contact_[1] ? 1.0 : 0.0);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    force_N_[foot] = contact_[foot] ? weight_N_ / feet : 0.0;
  }
}

void EstimateFallback::update_contacts(const Tick& tick) noexcept {
  if (!contacts_of_forces(tick)) {
    contacts_of_plan(tick);
  }
  const double load_N = force_N_[0] + force_N_[1];
  const std::size_t other = 1 - support_;
  const bool alone = contact_[other] && !contact_[support_];
  if (alone || (contact_[other] && force_N_[other] > kSupportShare * load_N)) {
    change_support(other);
  }
}

void EstimateFallback::change_support(std::size_t to) noexcept {
  const Eigen::Matrix3d turn = level_from_base_[to] * level_from_base_[support_].transpose();
  com_velocity_ = (turn * com_velocity_).eval();
  if (started_) {
    com_difference_ = (turn * com_difference_).eval();
  } else {  // still the last estimate's CoM, seen from the other foot
    com_difference_ = (turn * (com_difference_ - com_seen_from(support_)) + com_seen_from(to)).eval();
  }
  support_ = to;
}

void EstimateFallback::update_com() noexcept {
  if (!started_) {
    started_ = true;
    com_difference_ -= com_seen_from(support_);
    com_difference_ += turn_s_ * com_velocity_;
    if (!com_difference_.allFinite()) {
      com_difference_.setZero();
    }
  } else {
    const Eigen::Vector3d velocity = (com_seen_from(support_) - com_before_[support_]) / turn_s_;
    com_velocity_ += turn_s_ / (slower_ * kVelocityTime_s + turn_s_) * (velocity - com_velocity_);
  }
  com_difference_ *= 1.0 - turn_s_ / (slower_ * kDifferenceTime_s);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    com_before_[foot] = com_seen_from(foot);
  }
}

void EstimateFallback::write(const Tick&) noexcept {
  const Eigen::Vector3d com = com_seen_from(support_) + com_difference_;
  const double omega = std::sqrt(kGravity_m_per_s2 / std::clamp(com.z(), 0.1, 2.0));
  last_.stamp_ns = std::min(joints_.stamp_ns, imu_.stamp_ns);
  std::ranges::copy(neck_.angles_rad(std::span(joints_.position).first(robot_.joints.size())), last_.head);
  last_.support = static_cast<std::uint32_t>(support_);
  for (std::size_t foot = 0; foot < 2; ++foot) {
    last_.contact[foot] = contact_[foot] ? estimate::contact::bears_load : estimate::contact::lifted;
    last_.foot_force[foot] = force_N_[foot];
    Eigen::Map<Eigen::Vector2d>(last_.foot_zmp[foot]) = robot_.feet[foot].centre_m;
  }
  Eigen::Map<Eigen::Vector2d>(last_.zmp) = com.head<2>();
  Eigen::Map<Eigen::Vector3d>(last_.com) = com;
  Eigen::Map<Eigen::Vector3d>(last_.com_velocity) = com_velocity_;
  Eigen::Map<Eigen::Vector2d>(last_.dcm) = com.head<2>() + com_velocity_.head<2>() / omega;
  Eigen::Map<Eigen::Vector3d>(last_.attitude) = attitude_;
  Eigen::Map<Eigen::Vector3d>(last_.angular_velocity) = rate_;
}

}  // namespace gaitway::core
