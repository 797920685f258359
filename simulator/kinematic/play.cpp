// Row by row: smooth, place, load, judge.
#include "gaitway/kinematic/play.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "gaitway/facts/facts.hpp"
#include "gaitway/kinematic/derivatives.hpp"
#include "gaitway/kinematic/self_collision.hpp"
#include "gaitway/kinematic/standing.hpp"
#include "gaitway/motion/body_load.hpp"
#include "gaitway/motion/stance_map.hpp"
#include "gaitway/urdf/forward_kinematics.hpp"
#include "rules.hpp"

namespace gaitway::kinematic {
namespace {

using motion::Contact;

constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
constexpr std::size_t kRowsBetweenProgress = 200;

void require_fit(const urdf::RobotModel& robot, const Trajectory& trajectory) {
  const std::size_t joints = robot.joints.size(), rows = trajectory.rows();
  if (trajectory.joint_count != joints) {
    throw std::invalid_argument(
        fmt::format("{}: joints = {}: must be the {} of the robot '{}'. Give its own "
                    "--robot",
                    trajectory.name, trajectory.joint_count, joints, robot.name));
  }
  if (rows < 3) {
    throw std::invalid_argument(fmt::format("{}: rows = {}: must be at least 3, for speeds and accelerations",
                                            trajectory.name, rows));
  }
  const auto fits = [rows](const auto& values) { return values.empty() || values.size() == rows; };
  const bool references =
      trajectory.reference_rad.empty() || trajectory.reference_rad.size() == rows * joints;
  if (!references || !fits(trajectory.contact) || !fits(trajectory.base) ||
      !std::ranges::all_of(trajectory.zmp, fits)) {
    throw std::invalid_argument(fmt::format("{}: its columns are not equally long", trajectory.name));
  }
  if (!std::ranges::all_of(trajectory.joint_rad, [](double angle) { return std::isfinite(angle); })) {
    throw std::invalid_argument(fmt::format("{}: an angle is not finite", trajectory.name));
  }
}

class Performance {
 public:
  Performance(const urdf::RobotModel& robot, const Trajectory& trajectory)
      : robot_(robot), trajectory_(trajectory), rows_(trajectory.rows()), kinematics_(robot), loads_(robot) {}

  Course run(const Checks& checks, const Progress& progress);

 private:
  // The rows by which derivatives are taken: `half` to either side of a middle row, which is the row itself
  // but near the ends.
  struct Window {
    int half = 1;
    std::size_t middle = 1;
    [[nodiscard]] int offset_of(std::size_t row) const noexcept {
      return static_cast<int>(row) - static_cast<int>(middle);
    }
    [[nodiscard]] std::size_t row(int k) const noexcept {
      return static_cast<std::size_t>(static_cast<std::ptrdiff_t>(middle) + k);
    }
  };
  [[nodiscard]] Window window(std::size_t row, int half) const noexcept {
    const auto rim = static_cast<std::size_t>(half);
    return {half, std::clamp(row, rim, rows_ - 1 - rim)};
  }
  [[nodiscard]] int widest() const noexcept {
    return std::clamp(trajectory_.half_window, 1, static_cast<int>((rows_ - 1) / 2));
  }
  // The widest one in which this foot stands all the while; half = 0: it does not.
  [[nodiscard]] Window standing_window(std::size_t row, urdf::Side side) const noexcept;
  void smooth();
  void place(const Checks& checks);
  void note_stands();
  void load(std::size_t row);
  void set_base_motion(std::size_t row, motion::BodyMotion& motion);
  void set_margins(ZmpCourse& zmp);

  const urdf::RobotModel& robot_;
  const Trajectory& trajectory_;
  std::size_t rows_;
  urdf::ForwardKinematics kinematics_;
  motion::BodyLoadCalculator loads_;
  Eigen::MatrixXd angle_, speed_, acceleration_;  // columns: rows of the trajectory
  SolePoses sole_in_base_;
  std::vector<Eigen::Vector3d> com_in_base_m_;
  Standing standing_;
  motion::BodyMotion motion_;
  Course course_;
};

void Performance::smooth() {
  const auto joints = static_cast<Eigen::Index>(trajectory_.joint_count);
  const Eigen::Map<const Eigen::MatrixXd> raw(trajectory_.joint_rad.data(), joints,
                                              static_cast<Eigen::Index>(rows_));
  for (Eigen::MatrixXd* const values : {&angle_, &speed_, &acceleration_}) values->resize(joints, raw.cols());
  for (std::size_t row = 0; row < rows_; ++row) {
    const auto at = static_cast<Eigen::Index>(row);
    const Window near = window(row, widest());
    const auto fit = fit_parabola<Eigen::VectorXd>(
        near.half, facts::kSlot_s,
        [&](int k) -> Eigen::VectorXd { return raw.col(static_cast<Eigen::Index>(near.row(k))); },
        near.offset_of(row));
    angle_.col(at) = fit.value;
    speed_.col(at) = fit.first;
    acceleration_.col(at) = fit.second;
  }
  course_.speed_rad_per_s.assign(speed_.data(), speed_.data() + speed_.size());
}

void Performance::place(const Checks& checks) {
  for (std::size_t row = 0; row < rows_; ++row) {
    kinematics_.compute({angle_.col(static_cast<Eigen::Index>(row)).data(), trajectory_.joint_count});
    for (const urdf::Side side : urdf::kSides)
      sole_in_base_[urdf::index_of(side)].push_back(kinematics_.sole_pose(side));
    com_in_base_m_.push_back(kinematics_.com_m());
  }
  standing_ = find_standing(robot_, trajectory_, sole_in_base_, checks.touch_m);
  course_.base = standing_.base;
  course_.contact = standing_.contact;
  for (std::size_t row = 0; row < rows_; ++row)
    course_.com_m.push_back(standing_.base[row] * com_in_base_m_[row]);
  note_stands();
}

void Performance::note_stands() {
  for (const urdf::Side side : urdf::kSides) {
    for (std::size_t row = 0; row < rows_; ++row) {
      if (!motion::stands_on(standing_.contact[row], side)) continue;
      const double now_s = trajectory_.time_s(row);
      if (row == 0 || standing_.since[urdf::index_of(side)][row] == 0)
        course_.stands.push_back({side, now_s, now_s});
      course_.stands.back().to_s = now_s;
    }
  }
  std::ranges::stable_sort(course_.stands, {}, &Stand::from_s);
}

Performance::Window Performance::standing_window(std::size_t row, urdf::Side side) const noexcept {
  const auto s = urdf::index_of(side);
  if (!motion::stands_on(standing_.contact[row], side)) return {0, row};
  const std::size_t first = row - static_cast<std::size_t>(standing_.since[s][row]),
                    last = row + static_cast<std::size_t>(standing_.yet[s][row]);
  for (int half = widest(); half > 0; --half) {
    const Window near = window(row, half);
    if (near.row(-half) >= first && near.row(half) <= last) return near;
  }
  return {0, row};
}

// The base's own way where the source knows it; else as it is seen from the sole that stands longest around
// this row: that one does not move, so no jump from foot to foot is taken for an acceleration.
void Performance::set_base_motion(std::size_t row, motion::BodyMotion& motion) {
  const Eigen::Isometry3d& here = standing_.base[row];
  const bool known = !trajectory_.base.empty();
  const Window left = standing_window(row, urdf::Side::left), right = standing_window(row, urdf::Side::right);
  const std::size_t side = right.half > left.half ? 1 : 0;
  Window near = known ? window(row, widest()) : side == 1 ? right : left;
  if (near.half == 0) near = window(row, 1);
  const auto pose = [&](int k) -> Eigen::Isometry3d {
    const std::size_t at = near.row(k);
    return known ? standing_.base[at] : here * sole_in_base_[side][row] * sole_in_base_[side][at].inverse();
  };
  const auto fit = [&](const auto& sample) {
    return fit_parabola<Eigen::Vector3d>(near.half, facts::kSlot_s, sample, near.offset_of(row));
  };
  const auto turn = fit([&](int k) -> Eigen::Vector3d {
    const Eigen::AngleAxisd away(Eigen::Matrix3d(pose(k).linear() * here.linear().transpose()));
    return away.angle() * away.axis();
  });
  motion.pelvis = here;
  motion.acceleration_m_per_s2 = fit([&](int k) -> Eigen::Vector3d { return pose(k).translation(); }).second;
  motion.angular_velocity_rad_per_s = turn.first;
  motion.angular_acceleration_rad_per_s2 = turn.second;
  if (!course_.planned_is_computed) return;
  // The cart-table's ZMP: the CoM's, by the same rows.
  const auto com = fit([&](int k) -> Eigen::Vector3d { return pose(k) * com_in_base_m_[near.row(k)]; });
  course_.zmp[index_of(ZmpSource::planned)].at_m[row] =
      com.value.head<2>() - com.value.z() / facts::kGravity_m_per_s2 * com.second.head<2>();
}

void Performance::load(std::size_t row) {
  const auto at = static_cast<Eigen::Index>(row);
  const Contact contact = standing_.contact[row];
  const std::size_t joints = trajectory_.joint_count;
  if (contact == Contact::none) return;
  motion_.joint_rad = angle_.col(at);
  motion_.speed_rad_per_s = speed_.col(at);
  motion_.acceleration_rad_per_s2 = acceleration_.col(at);
  set_base_motion(row, motion_);
  const motion::BodyLoad& load = loads_.compute(motion_, contact,
                                                {standing_.sole(sole_in_base_, urdf::Side::left, row),
                                                 standing_.sole(sole_in_base_, urdf::Side::right, row)});
  std::copy_n(load.torque_Nm.data(), joints,
              course_.torque_Nm.begin() + static_cast<std::ptrdiff_t>(row * joints));
  course_.zmp[index_of(ZmpSource::all_masses)].at_m[row] = load.zmp_m;
}

void Performance::set_margins(ZmpCourse& zmp) {
  if (zmp.at_m.empty()) return;
  zmp.margin_m.assign(rows_, kUnknown);
  double sum_m = 0.0;
  for (std::size_t row = 0; row < rows_; ++row) {
    if (standing_.contact[row] == Contact::none || !zmp.at_m[row].allFinite()) continue;
    const motion::SupportArea area =
        motion::support_area(robot_, standing_.contact[row],
                             {standing_.sole(sole_in_base_, urdf::Side::left, row),
                              standing_.sole(sole_in_base_, urdf::Side::right, row)});
    const double margin_m = zmp.margin_m[row] = area.margin_m(zmp.at_m[row]);
    if (zmp.rows++ == 0 || margin_m < zmp.least_margin_m) {
      zmp.least_margin_m = margin_m;
      zmp.least_row = row;
      zmp.least_at_s = trajectory_.time_s(row);
    }
    sum_m += margin_m;
  }
  if (zmp.rows > 0) zmp.mean_margin_m = sum_m / static_cast<double>(zmp.rows);
}

Course Performance::run(const Checks& checks, const Progress& progress) {
  smooth();
  place(checks);
  const Eigen::Vector2d nowhere = Eigen::Vector2d::Constant(kUnknown);
  for (const ZmpSource source : kZmpSources)
    course_.zmp[index_of(source)].at_m = trajectory_.zmp[index_of(source)];
  course_.zmp[index_of(ZmpSource::all_masses)].at_m.assign(rows_, nowhere);
  course_.planned_is_computed = course_.of(ZmpSource::planned).at_m.empty();
  if (course_.planned_is_computed) course_.zmp[index_of(ZmpSource::planned)].at_m.assign(rows_, nowhere);
  course_.torque_Nm.assign(rows_ * trajectory_.joint_count, kUnknown);
  for (std::size_t row = 0; row < rows_; ++row) load(row);
  for (ZmpCourse& zmp : course_.zmp) set_margins(zmp);
  course_.notes = trajectory_.notes;
  if (trajectory_.place_error_m > 0.0) {
    course_.notes.push_back(fmt::format(
        "soles and ZMPs are known to {:.1f} mm, since the joints' zeros are: what is off by less is "
        "no finding",
        1e3 * trajectory_.place_error_m));
  }

  RuleBook rules(robot_, trajectory_, checks, course_);
  SelfCollision collision(robot_);
  course_.collision_pairs = checks.self_collision ? collision.pairs() : 0;
  for (std::size_t row = 0; row < rows_; ++row) {
    if (checks.joints) {
      rules.check_joints(row);
      rules.check_torques(row);
    }
    if (checks.self_collision) {
      kinematics_.compute(trajectory_.row(row));
      rules.check_collisions(row, collision.find(kinematics_));
    }
    if (checks.soles) rules.check_soles(row, standing_, sole_in_base_);
    if (checks.zmp) rules.check_zmp(row);
    if (progress && row % kRowsBetweenProgress == 0)
      progress(static_cast<double>(row) / static_cast<double>(rows_));
  }
  course_.findings = rules.findings();
  return std::move(course_);
}

}  // namespace

std::string_view name_of(ZmpSource source) noexcept {
  constexpr std::array<std::string_view, kZmpSources.size()> kNames{"planned", "all masses", "force cells",
                                                                    "contact solver"};
  return kNames[index_of(source)];
}

Course play(const urdf::RobotModel& robot, const Trajectory& trajectory, const Checks& checks,
            const Progress& progress) {
  require_fit(robot, trajectory);
  return Performance(robot, trajectory).run(checks, progress);
}

std::vector<JointDifference> compare(const Trajectory& one, const Trajectory& other) {
  if (one.joint_count != other.joint_count) {
    throw std::invalid_argument(fmt::format("{} has {} joints and {} has {}: they cannot be compared",
                                            one.name, one.joint_count, other.name, other.joint_count));
  }
  const std::size_t rows = std::min(one.rows(), other.rows());
  std::vector<JointDifference> differences(one.joint_count);
  for (std::size_t row = 0; row < rows; ++row) {
    for (std::size_t j = 0; j < one.joint_count; ++j) {
      const double away = one.row(row)[j] - other.row(row)[j];
      JointDifference& difference = differences[j];
      difference.rms_rad += away * away / static_cast<double>(rows);
      if (std::abs(away) <= difference.largest_rad) continue;
      difference.largest_rad = std::abs(away);
      difference.largest_at_s = one.time_s(row);
    }
  }
  for (JointDifference& difference : differences) difference.rms_rad = std::sqrt(difference.rms_rad);
  return differences;
}

}  // namespace gaitway::kinematic
