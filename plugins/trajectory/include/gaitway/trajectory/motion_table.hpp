// A key-frame motion as it is played, and its file: rows of points that were planned before, and for every
// batch the way that leaves it. Frame: on the ground in the middle between the soles of the stand in which
// the motion begins, x forward, z up.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace gaitway::trajectory {

// On which side a robot lies.
enum class LyingSide : std::uint8_t { front, back, left, right };
inline constexpr std::array<std::string_view, 4> kLyingSideNames{"front", "back", "left", "right"};

[[nodiscard]] constexpr std::string_view name_of(LyingSide side) noexcept {
  return kLyingSideNames[static_cast<std::size_t>(side)];
}

[[nodiscard]] constexpr LyingSide opposite(LyingSide side) noexcept {
  constexpr std::array kOpposite{LyingSide::back, LyingSide::front, LyingSide::right, LyingSide::left};
  return kOpposite[static_cast<std::size_t>(side)];
}

// The side of the trunk (x forward, y left) that points down most. Of a trunk that does not stand upright;
// roll and pitch as in Estimate::attitude.
[[nodiscard]] inline LyingSide lying_side(double roll_rad, double pitch_rad) noexcept {
  const double forward_down = std::sin(pitch_rad);
  const double left_down = -std::cos(pitch_rad) * std::sin(roll_rad);
  if (std::abs(forward_down) >= std::abs(left_down)) {
    return forward_down > 0.0 ? LyingSide::front : LyingSide::back;
  }
  return left_down > 0.0 ? LyingSide::left : LyingSide::right;
}

// What stands, as MotionPlan::support has it.
inline constexpr std::uint8_t kNothingStands = 3;

// One point, beside the joints.
struct MotionPoint {
  std::array<double, 2> com_m{}, com_velocity_m_per_s{}, zmp_m{};
  std::array<double, 2> trunk_attitude_rad{};     // roll, pitch
  std::array<std::array<double, 3>, 2> foot_m{};  // [Side]
  std::array<double, 2> foot_yaw_rad{};           // [Side]
  double hip_height_m = 0.0;
  double base_yaw_rad = 0.0;
  std::uint64_t support = 2;
};

struct MotionWay {
  std::vector<MotionPoint> points;
  // For each point a row with every joint's reference, from where it is in the standing posture.
  std::vector<float> offset_rad;

  [[nodiscard]] std::size_t size() const noexcept { return points.size(); }
  [[nodiscard]] std::span<const float> row(std::size_t point) const noexcept {
    const std::size_t joints = offset_rad.size() / points.size();
    return std::span(offset_rad).subspan(point * joints, joints);
  }
};

// How to come to rest from the end of a batch: so many batches further on the path, and then along a way, if
// any.
struct MotionExit {
  std::uint32_t go_on_batches = 0;
  std::int32_t way = -1;  // index into MotionTable::ways; -1: none, the path ends there
};

struct MotionTable {
  std::string name, description;
  std::uint64_t robot_digest = 0;  // of the description that it was planned for
  std::size_t joint_count = 0;
  bool on_ground = false;            // begins lying in its first posture, not in the stand
  std::optional<LyingSide> lies_on;  // on which side it begins; of one on the ground, if its file says so
  // Point 0 is where it begins; whole batches follow it.
  MotionWay path;
  std::vector<MotionExit> exits;  // [batches played]
  std::vector<MotionWay> ways;    // whole batches each

  [[nodiscard]] std::size_t batch_count() const noexcept { return exits.size() - 1; }
  // Points until the robot rests, when the motion is left after so many batches.
  [[nodiscard]] std::size_t exit_points(std::size_t batches) const noexcept;
};

// Files with prepared motions: `gaitway motion prepare` writes them, the plug-in reads them when it is
// constructed.
inline constexpr const char* kMotionTableEnding = ".motion";

// The file is none, or of another layout; the message names it and what to do.
class MotionTableError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

// For this machine's byte order. Both throw MotionTableError.
void write_motion_table(const MotionTable& table, const std::filesystem::path& file);
[[nodiscard]] MotionTable read_motion_table(const std::filesystem::path& file);

// Of a robot's description: a table holds for this one alone. Throws MotionTableError when it cannot be read.
[[nodiscard]] std::uint64_t robot_digest(const std::filesystem::path& robot_directory);

// The tables of a folder, in the order of their names; none if there is no such folder.
[[nodiscard]] std::vector<std::filesystem::path> motion_table_files(const std::filesystem::path& folder);

}  // namespace gaitway::trajectory
