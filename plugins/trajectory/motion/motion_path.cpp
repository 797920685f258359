// Segments, knots and first guesses.
#include "gaitway/motion/motion_path.hpp"

#include <algorithm>
#include <cmath>

#include "gaitway/facts/facts.hpp"
#include "gaitway/motion/stance_map.hpp"

namespace gaitway::motion {
namespace {

constexpr double kMoves = 1e-7;  // m or rad: less is rest
constexpr double kShortestGuess_s = 0.4;
// A rest-to-rest quintic's largest speed and acceleration for a unit of way and time.
constexpr double kPeakSpeed = 1.875, kPeakAcceleration = 5.774;
constexpr double kGuessShare = 0.4;                  // of the limits that the first guess uses
constexpr double kGuessAcceleration_m_per_s2 = 0.3;  // of the pelvis: moves the ZMP by some 12 mm

double guess_duration_s(const KeyPosture& from, const KeyPosture& to, const Segment& segment,
                        const JointLimits& limits) {
  const Eigen::ArrayXd way = (to.joint_rad - from.joint_rad).array().abs();
  const double by_speed = (kPeakSpeed * way / (kGuessShare * limits.speed_rad_per_s.array())).maxCoeff();
  const double by_acceleration =
      (kPeakAcceleration * way / (kGuessShare * limits.acceleration_rad_per_s2.array())).sqrt().maxCoeff();
  double by_balance = 0.0;
  if (segment.standing) {
    const double shift = (segment.to - segment.from).segment<3>(StanceMap::kPelvis).norm();
    by_balance = std::sqrt(kPeakAcceleration * shift / kGuessAcceleration_m_per_s2);
  }
  return std::max({by_speed, by_acceleration, by_balance, segment.min_time_s, kShortestGuess_s});
}

Knot knot_between(const Segment* before, const Segment* after, Eigen::Index size) {
  Knot knot{Eigen::VectorXd::Zero(size), Eigen::VectorXd::Zero(size), {}};
  const bool passes =
      before != nullptr && after != nullptr && before->hold_s == 0.0 && before->standing == after->standing;
  for (Eigen::Index i = 0; passes && i < size; ++i) {
    const bool moves = std::abs(before->to[i] - before->from[i]) > kMoves &&
                       std::abs(after->to[i] - after->from[i]) > kMoves;
    if (moves) knot.moving.push_back(i);
  }
  return knot;
}

double up_to_points(double time_s) {
  constexpr double kRounding = 1e-9;  // a whole number stays one
  return std::ceil(time_s / facts::kSlot_s - kRounding) * facts::kSlot_s;
}

}  // namespace

MotionPath first_path(const urdf::RobotModel& robot, const Motion& motion,
                      const std::vector<KeyPosture>& postures, const MotionLimits& limits) {
  const JointLimits joint_limits(robot, limits);
  MotionPath path;
  const std::size_t first_key = motion.starts_at_first_key ? 1 : 0;
  for (std::size_t i = 0; i + 1 < postures.size(); ++i) {
    const Key& key = motion.keys[i + first_key];
    const bool standing = key.contact != Contact::none;
    const auto coordinates = [standing](const KeyPosture& posture) {
      return standing ? *posture.stance : posture.joint_rad;
    };
    Segment segment{.standing = standing,
                    .contact = key.contact,
                    .from = coordinates(postures[i]),
                    .to = coordinates(postures[i + 1]),
                    .min_time_s = key.min_time_s,
                    .hold_s = key.hold_s};
    segment.duration_s = guess_duration_s(postures[i], postures[i + 1], segment, joint_limits);
    path.segments.push_back(std::move(segment));
  }
  for (std::size_t i = 0; i <= path.segments.size(); ++i) {
    const Segment* const before = i > 0 ? &path.segments[i - 1] : nullptr;
    const Segment* const after = i < path.segments.size() ? &path.segments[i] : nullptr;
    path.knots.push_back(knot_between(before, after, (after != nullptr ? after : before)->from.size()));
  }
  return path;
}

void MotionPath::stretch(double factor) {
  for (Segment& segment : segments) segment.duration_s *= factor;
  for (Knot& knot : knots) {
    knot.velocity /= factor;
    knot.acceleration /= factor * factor;
  }
}

void MotionPath::round_up_to_points() {
  for (Segment& segment : segments) {
    segment.duration_s = up_to_points(segment.duration_s);
    segment.hold_s = up_to_points(segment.hold_s);
  }
}

std::vector<trajectory::Quintic> polynomials(const Segment& segment, const Knot& start, const Knot& end) {
  std::vector<trajectory::Quintic> result;
  const Eigen::Index size = segment.from.size();
  result.reserve(static_cast<std::size_t>(size));
  // A knot between two kinds of coordinates is at rest, and its size that of one of them.
  const bool starts = !start.moving.empty(), ends = !end.moving.empty();
  for (Eigen::Index i = 0; i < size; ++i) {
    result.emplace_back(trajectory::MotionState{segment.from[i], starts ? start.velocity[i] : 0.0,
                                                starts ? start.acceleration[i] : 0.0},
                        trajectory::MotionState{segment.to[i], ends ? end.velocity[i] : 0.0,
                                                ends ? end.acceleration[i] : 0.0},
                        segment.duration_s);
  }
  return result;
}

}  // namespace gaitway::motion
