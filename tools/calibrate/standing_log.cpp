// One sample a time slot, from SYNC to SYNC; what is still is found afterwards.
#include "tools/calibrate/standing_measurement.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "gaitway/can/messages.hpp"
#include "gaitway/facts/facts.hpp"
#include "gaitway/msgcontroller/feedback_collector.hpp"
#include "gaitway/msgcontroller/network_profile.hpp"

namespace gaitway::calibration {
namespace {

using facts::kSlot_s;
constexpr std::int64_t kLongestSlot_ns = 15'000'000;  // from SYNC to SYNC; beyond it some are missing
constexpr std::size_t kFewestPoses = 4;
// Still: no joint turns further from kApart samples before to kApart samples behind.
constexpr std::ptrdiff_t kApart = 20;
constexpr double kStill_rad = 0.004;
constexpr double kStands_N = 5.0;  // on a foot, in the mean over a pose
constexpr double kLifted_N = 2.0;  // on a foot that is off the ground, for kLiftedSlots
constexpr int kLiftedSlots = 5;

// What one time slot's feedback said.
struct Sample {
  std::vector<double> joint_rad;
  Eigen::Vector3d specific_force_m_per_s2;
  Eigen::Vector2d inclination_rad;
  std::array<std::array<double, kCells>, 2> force_N{};
  int placement = 0;
  bool follows = false;  // the sample before is of the slot before, and all joints were heard
};

double total_N(const std::array<double, kCells>& cells) {
  double sum_N = 0.0;
  for (const double cell_N : cells) sum_N += cell_N;
  return sum_N;
}

class LogReader {
 public:
  LogReader(const urdf::RobotModel& robot, std::span<const double> zero_in_use_rad)
      : profile_(msgcontroller::network_profile(robot)),
        nodes_(msgcontroller::joint_nodes(robot, profile_)),
        zero_in_use_rad_(zero_in_use_rad),
        collector_(robot, nodes_) {}

  std::vector<Sample> read(std::span<const can::LoggedFrame> log) {
    for (const can::LoggedFrame& logged : log) {
      if (logged.error || logged.frame.extended || logged.frame.remote) continue;
      if (can::decode_sync(profile_, logged.frame)) {
        end_slot(logged.time_ns);
      } else if (const auto feedback = can::decode_feedback(profile_, logged.frame)) {
        const auto joint = std::ranges::find(nodes_, feedback->node);
        if (joint != nodes_.end()) {
          collector_.take(static_cast<int>(joint - nodes_.begin()), *feedback, logged.time_ns);
        }
      }
    }
    return std::move(samples_);
  }

 private:
  void end_slot(std::int64_t now_ns) {
    Sample& sample = samples_.emplace_back();
    for (std::size_t j = 0; j < nodes_.size(); ++j) {
      sample.joint_rad.push_back(collector_.joint_states().position[j] + zero_in_use_rad_[j]);
    }
    sample.specific_force_m_per_s2 = Eigen::Map<const Eigen::Vector3d>(collector_.imu().acceleration);
    sample.inclination_rad = Eigen::Map<const Eigen::Vector2d>(collector_.imu().inclination);
    for (std::size_t side = 0; side < 2; ++side) {
      std::copy_n(collector_.foot_forces().force[side], kCells, sample.force_N[side].begin());
      note_contact(side, total_N(sample.force_N[side]));
    }
    sample.placement = placement_;
    sample.follows = now_ns - sync_ns_ <= kLongestSlot_ns && collector_.missing() == 0;
    sync_ns_ = now_ns;
    collector_.begin_slot(++slot_);
  }
  void note_contact(std::size_t side, double force_N) {
    lifted_slots_[side] = force_N < kLifted_N ? lifted_slots_[side] + 1 : 0;
    placement_ += lifted_slots_[side] == kLiftedSlots ? 1 : 0;
  }

  can::Profile profile_;
  std::vector<can::NodeId> nodes_;
  std::span<const double> zero_in_use_rad_;
  msgcontroller::FeedbackCollector collector_;
  std::uint32_t slot_ = 0;
  std::int64_t sync_ns_ = 0;
  std::array<int, 2> lifted_slots_{};
  int placement_ = 0;
  std::vector<Sample> samples_;
};

bool is_still(std::span<const Sample> samples, std::size_t at) {
  const auto apart = static_cast<std::size_t>(kApart);
  if (at < apart || at + apart >= samples.size()) return false;
  const Sample &before = samples[at - apart], &behind = samples[at + apart];
  bool still = samples[at].follows;
  for (std::size_t j = 0; still && j < before.joint_rad.size(); ++j) {
    still = std::abs(behind.joint_rad[j] - before.joint_rad[j]) < kStill_rad;
  }
  return still;
}

StandingMeasurement measure(std::span<const Sample> samples) {
  StandingReading reading(samples.front().joint_rad.size(), static_cast<int>(samples.size()));
  for (const Sample& sample : samples) {
    reading.take(sample.joint_rad, sample.specific_force_m_per_s2, sample.inclination_rad, sample.force_N);
  }
  StandingMeasurement pose = reading.result();
  pose.placement = samples.back().placement;
  for (std::size_t side = 0; side < 2; ++side) pose.stands[side] = total_N(pose.force_N[side]) > kStands_N;
  return pose;
}

// A mean cannot be better than the counts on the wire, where noise does not stir them.
void allow_counts(const urdf::RobotModel& robot, StandingMeasurement& pose) {
  for (const auto& joint : robot.channels) {
    for (const urdf::SensorChannel& channel : joint) {
      const double count = channel.scale / std::sqrt(12.0);
      const auto side = static_cast<std::size_t>(channel.side);
      const auto raise = [count](double& deviation) { deviation = std::max(deviation, count); };
      if (channel.kind == urdf::SensorKind::force_cell) {
        raise(pose.force_deviation_N[side][static_cast<std::size_t>(channel.index)]);
      } else if (channel.kind == urdf::SensorKind::acceleration) {
        raise(pose.specific_force_deviation_m_per_s2[channel.index]);
      } else if (channel.kind == urdf::SensorKind::inclination) {
        raise(pose.inclination_deviation_rad[channel.index]);
      }
    }
  }
}

}  // namespace

std::vector<StandingMeasurement> standing_poses(const urdf::RobotModel& robot,
                                                std::span<const double> zero_in_use_rad,
                                                std::span<const can::LoggedFrame> log, double measured_s) {
  const std::vector<Sample> samples = LogReader(robot, zero_in_use_rad).read(log);
  const auto measured = static_cast<std::size_t>(std::lround(measured_s / kSlot_s));
  std::vector<StandingMeasurement> poses;
  for (std::size_t begin = 0, end = 0; begin < samples.size(); begin = end + 1) {
    for (end = begin; end < samples.size() && is_still(samples, end);) ++end;
    if (end - begin < measured) continue;
    StandingMeasurement pose = measure(std::span(samples).subspan(end - measured, measured));
    if (!pose.stands[0] && !pose.stands[1]) continue;
    if (!robot.carries(urdf::SensorKind::inclination))
      pose.inclination_rad.reset();  // what is there is derived
    allow_counts(robot, pose);
    pose.pose = fmt::format("pose {}", poses.size() + 1);
    poses.push_back(std::move(pose));
  }
  if (poses.size() < kFewestPoses) {
    throw StandingLogError(fmt::format(
        "in {:.1f} s the robot stands still for {:g} s in {} poses, but it takes {} at least. Log "
        "the bus while it takes the poses, as docs/calibration.md says",
        static_cast<double>(samples.size()) * kSlot_s, measured_s, poses.size(), kFewestPoses));
  }
  return poses;
}

}  // namespace gaitway::calibration
