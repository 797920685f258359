// Table look-up, and the approach to a motion on the ground.
#include "gaitway/trajectory/motion_player.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "gaitway/facts/facts.hpp"

namespace gaitway::trajectory {
namespace {

constexpr auto kBatchSize = static_cast<std::size_t>(kBatchPoints);
// The approach: smooth from rest to rest, no joint faster than this if the time allows.
constexpr double kApproachSpeed_rad_per_s = 2.0, kSmoothPeak = 1.875;

double smooth(double s) noexcept {
  return s * s * s * (10.0 + s * (6.0 * s - 15.0));
}

}  // namespace

std::optional<std::size_t> MotionPlayer::find(std::string_view name) const noexcept {
  const auto found = std::ranges::find(motions_, name, &MotionTable::name);
  if (found == motions_.end()) return std::nullopt;
  return static_cast<std::size_t>(found - motions_.begin());
}

void MotionPlayer::start(std::size_t motion, const Stand& stand, std::span<const double> from_rad) noexcept {
  const std::uint32_t ended = state_.ended;
  const MotionResult result = state_.result;
  state_ = State{};
  state_.ended = ended;
  state_.result = result;
  state_.motion = static_cast<std::uint32_t>(motion);
  state_.stand = stand;
  const std::string& name = table().name;
  std::memcpy(state_.name.data(), name.data(), std::min(name.size(), state_.name.size() - 1));
  state_.stage = MotionStage::path;
  if (!table().on_ground) return;
  const std::span<const float> first = table().path.row(0);
  double farthest_rad = 0.0;
  for (std::size_t j = 0; j < std::min(from_rad.size(), first.size()); ++j) {
    state_.from_rad[j] = static_cast<float>(from_rad[j]);
    farthest_rad = std::max(farthest_rad, std::abs(from_rad[j] - static_cast<double>(first[j])));
  }
  // Never longer than a tail, which must hold the rest of it.
  const double time_s =
      std::min(kSmoothPeak * farthest_rad / kApproachSpeed_rad_per_s, kMaxTailPoints * facts::kSlot_s);
  const auto batches =
      static_cast<std::uint32_t>(std::ceil(time_s / facts::kSlot_s / static_cast<double>(kBatchSize)));
  state_.approach_points = batches * kBatchPoints;
  if (batches > 0) state_.stage = MotionStage::approach;
}

void MotionPlayer::leave() noexcept {
  if (state_.stage != MotionStage::path) return;  // the approach is short, and nowhere to turn back to
  if (state_.batches == 0) {
    end(MotionResult::left);
    return;
  }
  state_.stage = MotionStage::leaving;
  state_.points = 0;
}

void MotionPlayer::break_off() noexcept {
  if (plays()) end(MotionResult::broken_off);
}

// Whether it lies then, the point that is reached says: the tail's last one where it is broken off.
void MotionPlayer::end(MotionResult result) noexcept {
  if (state_.batches == 0) {
    state_.lies = table().on_ground;
  } else {
    const Place rest = place_in(MotionStage::leaving, state_.batches, table().exit_points(state_.batches));
    state_.lies = rest.way->points[rest.point].support == kNothingStands;
  }
  state_.stage = MotionStage::none;
  state_.result = result;
  ++state_.ended;
}

MotionPlayer::Place MotionPlayer::place_in(MotionStage stage, std::size_t batches,
                                           std::size_t point) const noexcept {
  const MotionTable& motion = table();
  const std::size_t last = motion.path.size() - 1;
  if (stage == MotionStage::approach) {
    const double share = static_cast<double>(point + 1) / std::max<std::uint32_t>(state_.approach_points, 1);
    return {&motion.path, 0, smooth(std::min(share, 1.0))};
  }
  std::size_t on_path = batches * kBatchSize + 1 + point;
  if (stage == MotionStage::leaving) {
    const MotionExit& exit = motion.exits[batches];
    const std::size_t going_on = exit.go_on_batches * kBatchSize;
    if (point >= going_on && exit.way >= 0) {
      const MotionWay& way = motion.ways[static_cast<std::size_t>(exit.way)];
      return {&way, std::min(point - going_on, way.size() - 1)};
    }
    on_path = std::min(on_path, (batches + exit.go_on_batches) * kBatchSize);
  }
  return {&motion.path, std::min(on_path, last)};
}

void MotionPlayer::write(const Place& place, std::size_t i, MotionPlan& plan,
                         PosturePlan& posture) const noexcept {
  const MotionPoint& point = place.way->points[place.point];
  const Pose2& middle = state_.stand.middle;
  const Eigen::Rotation2Dd turn(middle.yaw_rad);
  const Eigen::Vector2d com = middle.transform(point.com_m[0], point.com_m[1]);
  const Eigen::Vector2d zmp = middle.transform(point.zmp_m[0], point.zmp_m[1]);
  const Eigen::Vector2d velocity = turn * Eigen::Vector2d(point.com_velocity_m_per_s.data());
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const auto k = static_cast<Eigen::Index>(axis);
    plan.com[i][axis] = com[k];
    plan.com_velocity[i][axis] = velocity[k];
    plan.zmp[i][axis] = zmp[k];
    plan.trunk_attitude[i][axis] = point.trunk_attitude_rad[axis];
  }
  plan.hip_height[i] = point.hip_height_m;
  plan.base_yaw[i] = middle.yaw_rad + point.base_yaw_rad;
  plan.commanded_yaw[i] = middle.yaw_rad;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector2d foot = middle.transform(point.foot_m[side][0], point.foot_m[side][1]);
    plan.foot_position[i][side][0] = foot.x();
    plan.foot_position[i][side][1] = foot.y();
    plan.foot_position[i][side][2] = point.foot_m[side][2];
    plan.foot_yaw[i][side] = middle.yaw_rad + point.foot_yaw_rad[side];
  }
  plan.support[i] = static_cast<std::uint8_t>(point.support);
  const std::span<const float> row = place.way->row(place.point);
  const auto share = static_cast<float>(place.approach_share);
  for (std::size_t j = 0; j < row.size(); ++j) {
    posture.offset[i][j] =
        share == 1.0F ? row[j] : state_.from_rad[j] + share * (row[j] - state_.from_rad[j]);
  }
}

void MotionPlayer::plan(std::uint32_t sequence, std::int64_t start_ns, MotionPlan& plan,
                        PosturePlan& posture) noexcept {
  const MotionStage stage = state_.stage;
  const bool on_path = stage == MotionStage::path;
  for (std::size_t i = 0; i < kBatchSize; ++i) {
    write(place_in(stage, state_.batches, state_.points + i), i, plan, posture);
  }
  // The tail is the exit from the end of this batch, or what is left of one that has begun.
  const MotionStage tail_stage = on_path ? MotionStage::leaving : stage;
  const std::size_t tail_batches = on_path ? state_.batches + 1 : state_.batches;
  const std::size_t played = on_path ? 0 : state_.points + kBatchSize;
  const std::size_t all = tail_stage == MotionStage::leaving ? table().exit_points(tail_batches)
                                                             : std::size_t{state_.approach_points};
  const std::size_t tail = std::max(all - std::min(all, played), kBatchSize);
  for (std::size_t k = 0; k < tail; ++k) {
    write(place_in(tail_stage, tail_batches, played + k), kBatchSize + k, plan, posture);
  }
  plan.sequence = posture.sequence = sequence;
  plan.tail_count = posture.tail_count = static_cast<std::uint32_t>(tail);
  plan.start_ns = start_ns;
  plan.motion = 1;
  plan.footstep_count = 0;
  posture.joint_count = static_cast<std::uint32_t>(table().joint_count);
  posture.from_home = table().on_ground ? 1 : 0;
  const Stand& stand = state_.stand;
  const Eigen::Vector2d com = stand.com_m();
  posture.stand_com[0] = com.x();
  posture.stand_com[1] = com.y();
  posture.stand_hip_height = stand.hip_height_m;
  posture.stand_yaw = stand.middle.yaw_rad;
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Vector2d foot = stand.foot_m(side);
    posture.stand_foot[side][0] = foot.x();
    posture.stand_foot[side][1] = foot.y();
    posture.stand_foot[side][2] = stand.middle.yaw_rad;
  }
  advance();
}

void MotionPlayer::advance() noexcept {
  switch (state_.stage) {
    case MotionStage::none:
      break;
    case MotionStage::approach:
      state_.points += kBatchPoints;
      if (state_.points >= state_.approach_points) {
        state_.stage = MotionStage::path;
        state_.points = 0;
      }
      break;
    case MotionStage::path:
      ++state_.batches;
      if (state_.batches == table().batch_count()) end(MotionResult::finished);
      break;
    case MotionStage::leaving:
      state_.points += kBatchPoints;
      if (state_.points >= table().exit_points(state_.batches)) end(MotionResult::left);
      break;
  }
}

void MotionPlayer::tell(gaitway::MotionState& state) const noexcept {
  state.state = static_cast<std::uint32_t>(state_.stage);
  state.result = static_cast<std::uint32_t>(state_.result);
  state.ended = state_.ended;
  std::memcpy(state.name, state_.name.data(), state_.name.size());
  const bool known = state_.name[0] != 0;
  state.duration = known ? static_cast<double>(table().path.size() - 1) * facts::kSlot_s : 0.0;
  const std::size_t played =
      state_.stage == MotionStage::approach ? 0 : state_.batches * kBatchSize + state_.points;
  state.time = known ? static_cast<double>(played) * facts::kSlot_s : 0.0;
}

void MotionPlayer::resume() noexcept {
  const auto* const name = reinterpret_cast<const char*>(state_.name.data());
  const auto found = find({name, strnlen(name, state_.name.size())});
  const bool fits = found && state_.batches <= motions_[*found].batch_count();
  if (fits) {
    state_.motion = static_cast<std::uint32_t>(*found);
  } else {
    if (plays()) {
      state_.result = MotionResult::broken_off;
      ++state_.ended;
    }
    state_.stage = MotionStage::none;
    state_.name = {};
  }
}

}  // namespace gaitway::trajectory
