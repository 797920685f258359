// A polynomial of fifth degree for each joint, and the points that have been played.
#include "gaitway/trajectory/fall_posture.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

// Of what a joint may do: a polynomial's points lie closer than its ends say, and wire counts are rounded.
constexpr double kSpeedShare = 0.94;
constexpr double kHomeSpeed_rad_per_s = 2.0;
constexpr double kShortest_s = 0.05, kLongest_s = 1.9;  // the tail must hold the rest of it

// The stand that the fall began in: nothing is planned for the body as a whole.
void write_stand(const Stand& stand, std::size_t i, MotionPlan& plan) noexcept {
  const Eigen::Vector2d com = stand.com_m();
  for (std::size_t axis = 0; axis < 2; ++axis) {
    plan.com[i][axis] = plan.zmp[i][axis] = com[static_cast<Eigen::Index>(axis)];
    plan.com_velocity[i][axis] = plan.trunk_attitude[i][axis] = 0.0;
  }
  plan.hip_height[i] = stand.hip_height_m;
  plan.base_yaw[i] = plan.commanded_yaw[i] = stand.middle.yaw_rad;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector2d foot = stand.foot_m(side);
    plan.foot_position[i][side][0] = foot.x();
    plan.foot_position[i][side][1] = foot.y();
    plan.foot_position[i][side][2] = 0.0;
    plan.foot_yaw[i][side] = stand.middle.yaw_rad;
  }
  plan.support[i] = kNothingStands;
}

}  // namespace

double FallPosture::Way::at(double since_start_s) const noexcept {
  return since_start_s < time_s ? path().at(since_start_s).position : to_rad;
}

double FallPosture::Way::fastest_rad_per_s() const noexcept {
  constexpr int kPlaces = 16;
  const Quintic to_rest = path();
  double fastest = 0.0;
  for (int place = 0; place < kPlaces; ++place) {
    fastest = std::max(fastest, std::abs(to_rest.at(time_s * place / kPlaces).velocity));
  }
  return fastest;
}

FallPosture::FallPosture(const urdf::RobotModel& robot, std::optional<FallPostures> postures)
    : postures_rad_(std::move(postures)) {
  for (const urdf::Joint& joint : robot.joints) {
    joints_.push_back({joint.lower_rad, joint.upper_rad, joint.velocity_limit_rad_per_s, joint.home_rad});
    home_rad_.push_back(joint.home_rad);
  }
}

void FallPosture::fall(double direction_rad, const References& references) noexcept {
  constexpr double kQuarter = std::numbers::pi / 2.0;
  if (!exists() || !std::isfinite(direction_rad)) return;
  const auto quarter = static_cast<std::size_t>(std::lround(direction_rad / kQuarter) + 8) % 4;
  begin(Stage::falls, references, (*postures_rad_)[quarter], std::numeric_limits<double>::infinity());
}

void FallPosture::go_home(const References& references) noexcept {
  begin(Stage::goes_home, references, home_rad_, kHomeSpeed_rad_per_s);
}

void FallPosture::begin(Stage stage, const References& references, std::span<const double> to_rad,
                        double most_rad_per_s) noexcept {
  state_ = State{};
  const std::size_t count = joints_.size();
  if (references.at_rad.size() < count || references.before_rad.size() < count || to_rad.size() < count)
    return;
  for (std::size_t j = 0; j < count; ++j) {
    Way& way = state_.ways[j];
    way.from_rad = references.at_rad[j];
    way.speed_rad_per_s = (references.at_rad[j] - references.before_rad[j]) / facts::kSlot_s;
    way.to_rad = std::isfinite(to_rad[j]) ? to_rad[j] : way.from_rad;
    if (!std::isfinite(way.from_rad) || !std::isfinite(way.speed_rad_per_s)) return;
    // A reference that turns faster already slows down.
    const double most = std::max(std::min(most_rad_per_s, kSpeedShare * joints_[j].speed_rad_per_s),
                                 std::abs(way.speed_rad_per_s));
    for (way.time_s = kShortest_s; way.time_s < kLongest_s && way.fastest_rad_per_s() > most;) {
      way.time_s += facts::kSlot_s;
    }
  }
  state_.stage = stage;
}

void FallPosture::plan(std::uint32_t sequence, std::int64_t start_ns, const Stand& stand, MotionPlan& plan,
                       PosturePlan& posture) noexcept {
  const std::size_t count = joints_.size();
  double time_s = 0.0;
  for (std::size_t j = 0; j < count; ++j) time_s = std::max(time_s, state_.ways[j].time_s);
  const auto all = static_cast<std::uint32_t>(std::ceil(time_s / facts::kSlot_s));
  const std::uint32_t played = state_.points + kBatchPoints;
  plan.sequence = posture.sequence = sequence;
  plan.start_ns = start_ns;
  plan.tail_count = posture.tail_count =
      std::clamp<std::uint32_t>(all - std::min(all, played), kBatchPoints, kMaxTailPoints);
  plan.motion = kFallPostureMotion;
  plan.footstep_count = 0;
  posture.joint_count = static_cast<std::uint32_t>(count);
  posture.from_home = 1;
  for (std::size_t i = 0; i < kBatchPoints + plan.tail_count; ++i) {
    write_stand(stand, i, plan);
    const double since_s = static_cast<double>(state_.points + i + 1) * facts::kSlot_s;
    for (std::size_t j = 0; j < count; ++j) {
      const Limits& joint = joints_[j];
      const double angle_rad = std::clamp(state_.ways[j].at(since_s), joint.lower_rad, joint.upper_rad);
      posture.offset[i][j] = static_cast<float>(angle_rad - joint.home_rad);
    }
  }
  state_.points = played;
  if (state_.stage == Stage::goes_home && played >= all) state_.stage = Stage::none;
}

// After the tail's last point the references stay there.
std::optional<FallPosture::References> AcceptedReferences::before(std::uint32_t sequence) noexcept {
  if (accepted_.sequence == 0 || sequence <= accepted_.sequence) return std::nullopt;
  const std::size_t points = kBatchPoints + std::min<std::size_t>(accepted_.tail_count, kMaxTailPoints);
  const std::size_t played = kBatchPoints * std::size_t{sequence - accepted_.sequence};
  const std::size_t at = std::min(played, points) - 1;
  const std::size_t before = played > points ? at : at - 1;
  const std::size_t joints = std::min<std::size_t>(accepted_.joint_count, kMaxJoints);
  std::copy_n(accepted_.position[before], joints, before_rad_.begin());
  std::copy_n(accepted_.position[at], joints, at_rad_.begin());
  return FallPosture::References{before_rad_, at_rad_};
}

}  // namespace gaitway::trajectory
