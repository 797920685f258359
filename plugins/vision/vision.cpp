// The order of the work on a pair: is it any good, where was the camera, what is how far, what is on the
// ground, which tags are there.
#include "gaitway/vision/vision.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace gaitway::vision {
namespace {

constexpr std::uint64_t kAlignmentEvery = 6;  // pairs
constexpr double kTagMargin_px = 8.0;
constexpr double kFewMatches = 0.03;  // share of the pixels
constexpr std::string_view kSuspected = "one camera may be turned against the other: the map waits";
constexpr std::string_view kNoPose = "the robot lies or falls, or its posture at the exposure is not known";

Eigen::Isometry3d between(const ShutterPoses& poses, double share) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(poses.first.linear())
                      .slerp(share, Eigen::Quaterniond(poses.last.linear()))
                      .toRotationMatrix();
  pose.translation() =
      poses.first.translation() + share * (poses.last.translation() - poses.first.translation());
  return pose;
}

bool is_of_one_camera(Fault fault) noexcept {
  switch (fault) {
    case Fault::left_dark:
    case Fault::right_dark:
    case Fault::left_bright:
    case Fault::right_bright:
    case Fault::left_dead:
    case Fault::right_dead:
      return true;
    default:
      return false;
  }
}

std::uint32_t state_of(Fault fault, bool is_fine, bool sees_one) noexcept {
  namespace states = vision_state::state;
  if (fault == Fault::none) return is_fine ? states::sees : states::impaired;
  if (fault == Fault::few_matches || (is_of_one_camera(fault) && sees_one)) return states::impaired;
  return states::blind;
}

}  // namespace

Vision::Vision(const urdf::RobotModel& robot, const urdf::StereoCamera& camera,
               const VisionParameters& parameters)
    : parameters_(parameters),
      width_(camera.width_px),
      height_(camera.height_px),
      rig_(camera),
      history_(robot, robot.link_index(camera.link), rig_.in_link()),
      matcher_(camera.width_px),
      ground_(rig_.geometry(), parameters.ground),
      map_(parameters.cell_m),
      tags_(parameters.tags),
      targets_(parameters.forget_after_ns) {}

bool Vision::follow(const JointStates& joints, const Estimate& estimate) {
  history_.add(joints, estimate);
  has_lain_ = has_lain_ || estimate.fall == estimate::fall::lies;
  if (!has_lain_ || estimate.fall != estimate::fall::upright) return false;
  has_lain_ = false;
  forget_places();
  return true;
}

std::optional<ShutterPoses> Vision::poses_of(const PicturePair& pair) const noexcept {
  const auto first = history_.at(pair.stamp_ns - pair.readout_ns / 2);
  const auto last = history_.at(pair.stamp_ns + pair.readout_ns / 2);
  if (!first || !last || !first->upright || !last->upright) return std::nullopt;
  return ShutterPoses{
      .first = first->pose, .last = last->pose, .base_m = 0.5 * (first->base_m + last->base_m)};
}

void Vision::see(const PicturePair& pair, std::int64_t now_ns) {
  ++pairs_;
  if (last_number_ != 0 && pair.number > last_number_ + 1) dropped_ += pair.number - last_number_ - 1;
  last_number_ = pair.number;
  picture_ns_ = pair.stamp_ns;
  arrived_ns_ = now_ns;
  sees_one_ = false;
  is_suspected_ = false;
  const auto pixels = static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_);
  if (pair.width != width_ || pair.height != height_ || pair.left.size() != pixels ||
      pair.right.size() != pixels) {
    fault_ = Fault::wrong_size;
  } else if (now_ns - pair.stamp_ns > parameters_.late_after_ns) {
    fault_ = Fault::late_pictures;
  } else {
    fault_ = use(pair);
  }
  targets_.forget(now_ns);
}

void Vision::wait(std::int64_t now_ns) noexcept {
  if (!first_wait_ns_) first_wait_ns_ = now_ns;
  if (now_ns - std::max(arrived_ns_, *first_wait_ns_) > parameters_.missing_after_ns) {
    fault_ = Fault::no_pictures;
    targets_.forget(now_ns);
  }
}

Fault Vision::use(const PicturePair& pair) {
  const PairCheck check = pictures_.check(pair);
  const Fault fault = fault_of(check);
  if (fault == Fault::frozen_pictures) return fault;
  const std::optional<ShutterPoses> poses = poses_of(pair);
  has_pose_ = poses.has_value();
  if (!poses) return fault;
  const Seen seen{.left = check.fault[0] == PictureFault::none,
                  .right = check.fault[1] == PictureFault::none,
                  .poses = *poses};
  sees_one_ = seen.left || seen.right;
  rig_.rectify(pair);
  const Fault found = fault == Fault::none ? map(pair, *poses) : fault;
  if (found == Fault::none || found == Fault::few_matches || is_of_one_camera(found)) find_tags(pair, seen);
  return found;
}

// Odometry counts steps: where a fall and getting up have carried the robot, it does not know.
void Vision::forget_places() {
  map_ = HeightMap(parameters_.cell_m);
  obstacles_.renew({});
  targets_ = TargetMemory(parameters_.forget_after_ns);
}

Fault Vision::map(const PicturePair& pair, const ShutterPoses& poses) {
  matcher_.match(rig_.left(), rig_.right());
  matched_share_ = matcher_.matched_share();
  ground_.look(matcher_, poses);
  const bool has_few = matched_share_ < kFewMatches;
  const bool looks = has_few || pairs_ % kAlignmentEvery == 1 || alignment_.is_suspected();
  alignment_.judge(looks ? alignment_of(matcher_.left(), matcher_.right()) : Alignment{}, ground_.shift());
  if (alignment_.fault() != Fault::none) return alignment_.fault();
  if (has_few) return Fault::few_matches;
  is_suspected_ = alignment_.is_suspected();
  if (is_suspected_) return Fault::none;  // not yet a fault, but nothing to go by
  const Eigen::Vector3d ahead = poses.first.linear().col(2);
  const double level = std::max(ahead.head<2>().norm(), 1e-6);
  map_.centre(poses.base_m + parameters_.map_ahead_m / level * ahead.head<2>());
  map_.forget(pair.stamp_ns - parameters_.forget_after_ns);
  ground_.tell(map_, pair.stamp_ns);
  eye_m_ = poses.first.translation().head<2>();
  obstacles_.renew(boxes_in(map_, eye_m_));
  mapped_ns_ = pair.stamp_ns;
  return Fault::none;
}

void Vision::find_tags(const PicturePair& pair, const Seen& seen) {
  looked_ns_ = pair.stamp_ns;
  for (const FoundTag& tag : tags_.find(seen.left ? rig_.left() : rig_.right())) {
    if (!seen.left) {
      remember(nullptr, &tag, seen, pair.stamp_ns);
      continue;
    }
    // In the right picture it is looked for where it must be.
    const std::vector<FoundTag> right =
        seen.right ? tags_.find(rig_.right(), place_in_right(tag)) : std::vector<FoundTag>{};
    const auto same = std::ranges::find(right, tag.id, &FoundTag::id);
    remember(&tag, same == right.end() ? nullptr : &*same, seen, pair.stamp_ns);
  }
}

cv::Rect Vision::place_in_right(const FoundTag& tag) const {
  Eigen::Vector2d least = tag.corner_px[0], most = tag.corner_px[0];
  for (const Eigen::Vector2d& corner : tag.corner_px) {
    least = least.cwiseMin(corner);
    most = most.cwiseMax(corner);
  }
  const double side_px = std::max((most - least).maxCoeff(), 1.0);
  // A tag of that size is at about this distance; turned aside it may be nearer, and so more to the left.
  const double disparity_px = rig_.geometry().base_m / size_of(tag.id) * side_px;
  const double margin_px = 0.5 * side_px + kTagMargin_px;
  const double left_px = least.x() - 1.3 * disparity_px - margin_px;
  const double right_px = most.x() - 0.8 * disparity_px + margin_px;
  return {cvFloor(left_px), cvFloor(least.y() - margin_px), cvCeil(right_px - left_px),
          cvCeil(most.y() - least.y() + 2.0 * margin_px)};
}

void Vision::remember(const FoundTag* left, const FoundTag* right, const Seen& seen, std::int64_t stamp_ns) {
  const FoundTag& tag = left != nullptr ? *left : *right;
  const double size_m = size_of(tag.id);
  const std::optional<TagPose> found =
      tag_pose(rig_.geometry(), left, right, size_m, parameters_.corner_deviation_px,
               parameters_.most_corner_error_px);
  if (!found) return;
  const double row_px = 0.5 * (tag.corner_px[0] + tag.corner_px[2]).y();
  const Eigen::Isometry3d camera = between(seen.poses, std::clamp(row_px / (height_ - 1), 0.0, 1.0));
  const Eigen::Isometry3d pose = camera * found->pose;
  const Eigen::Vector3d arm = pose.translation() - camera.translation();
  // The attitude's error moves the tag across the line of sight.
  const double aside_m2 = std::pow(parameters_.attitude_deviation_rad, 2);
  const Eigen::Matrix3d by_attitude =
      aside_m2 * (arm.squaredNorm() * Eigen::Matrix3d::Identity() - arm * arm.transpose());
  targets_.see(
      {.id = tag.id,
       .position_m = pose.translation(),
       .covariance_m2 = camera.linear() * found->covariance_m2 * camera.linear().transpose() + by_attitude +
                        std::pow(parameters_.pose_deviation_m, 2) * Eigen::Matrix3d::Identity(),
       .orientation = Eigen::Quaterniond(pose.linear()),
       .knows_orientation = found->is_certain,
       .size_m = size_m},
      stamp_ns);
}

double Vision::size_of(int id) const noexcept {
  const auto named = std::ranges::find(parameters_.tag_sizes, id, &TagSize::id);
  return named == parameters_.tag_sizes.end() ? parameters_.tag_size_m : named->size_m;
}

void Vision::write(VisionState& state, std::int64_t now_ns, std::int64_t compute_ns) const noexcept {
  state = {};
  state.stamp_ns = now_ns;
  state.picture_ns = picture_ns_;
  state.state = state_of(fault_, has_pose_ && !is_suspected_, sees_one_);
  state.fault = static_cast<std::uint32_t>(fault_);
  state.pairs = pairs_;
  state.dropped = dropped_;
  state.compute_ns = compute_ns;
  state.matched = matched_share_;
  const std::string_view words = fault_ != Fault::none ? words_of(fault_)
                                 : !has_pose_          ? kNoPose
                                 : is_suspected_       ? kSuspected
                                                       : std::string_view{};
  std::ranges::copy(words.substr(0, sizeof state.text - 1), state.text);
}

}  // namespace gaitway::vision
