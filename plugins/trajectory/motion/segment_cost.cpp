// Residuals of one segment.
#include "segment_cost.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"

namespace gaitway::motion {
namespace {

constexpr double kSampleTime_s = 0.03;
constexpr int kFewestSamples = 10, kMostSamples = 40;
// What counts as one whole limit broken.
constexpr double kAngleScale_rad = 0.1, kZmpScale_m = 0.02, kReachScale_m = 0.01;
constexpr double kLengthScale_m = 0.2;  // of smoothness: as much as a radian

double broken(double excess) {
  return std::max(0.0, excess);
}

Eigen::VectorXd values(const Knot& knot, const double* block, std::size_t offset) {
  Eigen::VectorXd result = Eigen::VectorXd::Zero(knot.velocity.size());
  for (std::size_t i = 0; i < knot.moving.size(); ++i) result[knot.moving[i]] = block[offset + i];
  return result;
}

}  // namespace

double SegmentSampler::posture(const Segment& segment, const std::vector<trajectory::Quintic>& spline,
                               double time_s, BodyPosture& posture) {
  coordinates_.resize(static_cast<Eigen::Index>(spline.size()));
  for (std::size_t i = 0; i < spline.size(); ++i) {
    coordinates_[static_cast<Eigen::Index>(i)] = spline[i].at(time_s).position;
  }
  if (!segment.standing) {
    posture.joint_rad = coordinates_;
    return 0.0;
  }
  if (posture.joint_rad.size() == 0) posture.joint_rad.setZero(static_cast<Eigen::Index>(joint_count_));
  posture.pelvis = pose_at(coordinates_, StanceMap::kPelvis);
  return map_.joints(coordinates_, posture.joint_rad);
}

SegmentCost::SegmentCost(const urdf::RobotModel& robot, const MotionLimits& limits, const Segment& segment,
                         const Knot& start, const Knot& end, const CostWeights& weights)
    : friction_(robot.contact.friction),
      limits_(limits),
      joint_limits_(robot, limits),
      weights_(weights),
      samples_(std::clamp(static_cast<int>(std::ceil(segment.duration_s / kSampleTime_s)), kFewestSamples,
                          kMostSamples)),
      work_{segment, start, end, SegmentSampler(robot), {}} {
  if (!segment.standing) return;
  area_ =
      support_area(robot, segment.contact,
                   {pose_at(segment.from, StanceMap::kSole[0]), pose_at(segment.from, StanceMap::kSole[1])});
  for (const urdf::Side side : urdf::kSides) {
    if (!stands_on(segment.contact, side))
      lifted_.push_back(StanceMap::kSole[static_cast<std::size_t>(side)] + 2);
  }
}

int SegmentCost::residual_count() const noexcept {
  const int joints = static_cast<int>(joint_limits_.lower_rad.size());
  const int of_joints = 4 * joints;
  const int of_stance = 4 + static_cast<int>(lifted_.size());
  const int jerks = static_cast<int>(work_.segment.from.size());
  return 1 + (samples_ + 1) * (of_joints + of_stance + jerks);
}

bool SegmentCost::operator()(const double* const* parameters, double* residuals) const {
  Workspace& work = work_;
  work.segment.duration_s = parameters[0][0];
  if (work.segment.duration_s < facts::kSlot_s) return false;
  std::size_t block = 1;
  for (Knot* const knot : {&work.start, &work.end}) {
    if (knot->moving.empty()) continue;
    knot->velocity = values(*knot, parameters[block], 0);
    knot->acceleration = values(*knot, parameters[block], knot->moving.size());
    ++block;
  }
  const std::vector<trajectory::Quintic> spline = polynomials(work.segment, work.start, work.end);
  double* residual = residuals;
  *residual++ = std::sqrt(work.segment.duration_s);
  const double interval_s = work.segment.duration_s / samples_;
  const double jerk_weight = std::sqrt(weights_.smoothness * interval_s);
  for (int i = 0; i <= samples_; ++i) {
    const double time_s = i * interval_s;
    for (std::size_t c = 0; c < spline.size(); ++c) {
      const std::size_t in_pose = c % StanceMap::kPoseSize;
      const bool length =
          work.segment.standing && c < static_cast<std::size_t>(StanceMap::kOthers) && in_pose < 3;
      *residual++ = jerk_weight * spline[c].jerk(time_s) / (length ? kLengthScale_m : 1.0);
    }
    double reach_m = 0.0;
    for (const int k : {0, 2, 1}) {
      reach_m =
          std::max(reach_m, work.sampler.posture(work.segment, spline, time_s + (k - 1) * facts::kSlot_s,
                                                 work.posture[static_cast<std::size_t>(k)]));
    }
    const Eigen::VectorXd& coordinates = work.sampler.coordinates();
    std::array<Eigen::Isometry3d, 2> sole{Eigen::Isometry3d::Identity(), Eigen::Isometry3d::Identity()};
    if (work.segment.standing) {
      sole = {pose_at(coordinates, StanceMap::kSole[0]), pose_at(coordinates, StanceMap::kSole[1])};
    }
    const BodyLoad& load =
        work.sampler.loads().compute(work.posture, facts::kSlot_s, work.segment.contact, sole);
    *residual++ = weights_.penalty * reach_m / kReachScale_m;
    residual = limits_of_joints(work.posture[1], load, residual);
    residual = limits_of_stance(load, coordinates, residual);
  }
  return true;
}

double* SegmentCost::limits_of_joints(const BodyPosture& posture, const BodyLoad& load,
                                      double* residual) const {
  for (Eigen::Index j = 0; j < posture.joint_rad.size(); ++j) {
    const double angle = posture.joint_rad[j], speed = load.speed_rad_per_s[j];
    const double beyond = std::max(joint_limits_.lower_rad[j] - angle, angle - joint_limits_.upper_rad[j]);
    *residual++ = weights_.penalty * broken(beyond / kAngleScale_rad);
    *residual++ = weights_.penalty * broken(std::abs(speed) / joint_limits_.speed_rad_per_s[j] - 1.0);
    *residual++ =
        weights_.penalty *
        broken(std::abs(load.acceleration_rad_per_s2[j]) / joint_limits_.acceleration_rad_per_s2[j] - 1.0);
    const double torque = work_.segment.standing ? load.torque_Nm[j] : 0.0;
    *residual++ = weights_.penalty * broken((std::abs(torque) - joint_limits_.torque_Nm(j, speed, torque)) /
                                            joint_limits_.standstill_torque_Nm[j]);
  }
  return residual;
}

double* SegmentCost::limits_of_stance(const BodyLoad& load, const Eigen::VectorXd& coordinates,
                                      double* residual) const {
  const bool standing = work_.segment.standing;
  const double weight_share = load.normal_force_N / work_.sampler.loads().weight_N();
  const double friction_limit = limits_.friction_share * friction_;
  *residual++ =
      standing ? weights_.penalty * broken((limits_.zmp_margin_m - area_.margin_m(load.zmp_m)) / kZmpScale_m)
               : 0.0;
  *residual++ = standing ? weights_.penalty * broken(load.friction_ratio / friction_limit - 1.0) : 0.0;
  *residual++ = standing ? weights_.penalty * broken(1.0 - weight_share / limits_.least_weight_share) : 0.0;
  for (const Eigen::Index height : lifted_) {
    *residual++ = weights_.penalty * broken(-coordinates[height] / kReachScale_m);
  }
  return residual;
}

}  // namespace gaitway::motion
