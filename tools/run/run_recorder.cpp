// Turns what passes by into samples, metrics and the bus log.
#include "tools/run/run_recorder.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "gaitway/facts/facts.hpp"
#include "gaitway/geometry/convex_hull.hpp"

namespace gaitway::tools {
namespace {

using facts::kCycle_ns;
using facts::kSlot_ns;
using facts::kSlotsPerCycle;

using facts::kSlot_s;
constexpr std::int64_t kStartUp_ns = 2'000'000'000;  // from a walk command to steady walking
constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

double yaw_of(const Eigen::Isometry3d& pose) {
  return std::atan2(pose.linear()(1, 0), pose.linear()(0, 0));
}

Eigen::Vector3d roll_pitch_yaw(const Eigen::Matrix3d& rotation) {
  return {std::atan2(rotation(2, 1), rotation(2, 2)), std::asin(std::clamp(-rotation(2, 0), -1.0, 1.0)),
          std::atan2(rotation(1, 0), rotation(0, 0))};
}

Eigen::Vector3d ground_pose(const Eigen::Isometry3d& sole) {
  return {sole.translation().x(), sole.translation().y(), yaw_of(sole)};
}

Eigen::Vector3d planned_foot(const MotionPlan& plan, std::size_t point, std::size_t side) {
  return {plan.foot_position[point][side][0], plan.foot_position[point][side][1], plan.foot_yaw[point][side]};
}

// A plan-frame point, seen from the planned foot and laid out from the true one.
Eigen::Vector2d transfer(const Eigen::Vector2d& point, const Eigen::Vector3d& from,
                         const Eigen::Vector3d& to) {
  return to.head<2>() + Eigen::Rotation2Dd(to.z() - from.z()) * (point - from.head<2>());
}

}  // namespace

RunRecorder::RunRecorder(simulator::Cosimulation& run, const std::filesystem::path& bus_log,
                         bool keep_samples)
    : run_(run),
      joint_states_(run.client().read<JointStates>("joint_states")),
      foot_forces_(run.client().read<FootForces>("foot_forces")),
      imu_(run.client().read<Imu>("imu")),
      estimate_(run.client().read<Estimate>("estimate")),
      motion_plan_(run.client().read<MotionPlan>("motion_plan")),
      trim_(run.client().read<TrimCommand>("trim")),
      walk_command_(run.client().read<WalkCommand>("walk_command")),
      keep_samples_(keep_samples),
      way_(run.client()),
      mission_(run.client()) {
  if (!bus_log.empty()) {
    constexpr std::uint64_t kBusLog_bytes = std::uint64_t{256} << 20;
    bus_log_.emplace(bus_log, can::CandumpOptions{.most_bytes = keep_samples ? 0 : kBusLog_bytes});
  }
}

void RunRecorder::on_frame(const can::SimulatedBus::Delivery& delivery) {
  digest_.add(delivery.frame, delivery.start_ns);
  if (bus_log_ && !delivery.lost) {  // nobody heard it, so no log of a bus has it
    bus_log_->write(delivery.end_ns, delivery.frame);
  }
  if (delivery.start_ns >= cycle_start_ns_ + kCycle_ns) {
    // Keep the last whole cycle in which a batch was played.
    if (run_.message_controller().mode() == msgcontroller::Mode::batches) {
      cycle_.swap(cycle_candidate_);
    }
    cycle_candidate_.clear();
    cycle_start_ns_ = delivery.start_ns / kCycle_ns * kCycle_ns;
  }
  cycle_candidate_.push_back(delivery);
}

void RunRecorder::on_millisecond(std::int64_t now_ns) {
  const simulator::Plant& plant = run_.plant();
  digest_.add(plant.positions());
  digest_.add(plant.velocities());
  if (keep_samples_) {
    for (const double torque : plant.sensors().motor_torque_Nm) {
      torques_.push_back(static_cast<float>(torque));
    }
  }
  if (plant.fallen() && !metrics_.fell) {
    metrics_.fell = true;
    metrics_.fell_at_s = plant.time_s();
  }
  contacts_.add(now_ns, plant.body_contacts(), plant.world(), plant.geometry());
  cop_mean_.add(plant.ground_contact());
  if (now_ns % kSlot_ns == 0) {
    cop_mean_.close_slot();
  }
  if (core::is_tick(now_ns - facts::kMillisecond_ns)) {
    read_plan();
    way_.look(now_ns, run_.plant());
    mission_.look(now_ns, plant.fallen());
    follow_walk_command(now_ns);
    add_sample(now_ns);
  }
}

void RunRecorder::finish() {
  if (bus_log_) {
    bus_log_->finish();
  }
}

void RunRecorder::flush() {
  if (bus_log_) {
    bus_log_->flush();
  }
}

BusLogCount RunRecorder::bus_log() const {
  if (!bus_log_) return {};
  const process::LogCount count = bus_log_->count();
  return {count.lines, count.lost, bus_log_->error()};
}

// At the tick that prepares the next cycle's plan.
void RunRecorder::read_plan() {
  const NetworkState& network = run_.message_controller().state();
  const Tick tick = core::tick_at(network.stamp_ns);
  if (tick.batch) {
    motion_plan_.read(plans_[(network.cycle + 1U) % plans_.size()]);
  }
}

const MotionPlan* RunRecorder::running_plan(std::uint32_t cycle) const noexcept {
  const MotionPlan& plan = plans_[cycle % plans_.size()];
  return plan.sequence == cycle && cycle != 0 ? &plan : nullptr;
}

void RunRecorder::on_event(const simulator::ScenarioEvent& event, std::int64_t now_ns) {
  if (const auto* const walk = std::get_if<simulator::WalkEvent>(&event.action)) {
    on_command(walk->walk, walk->velocity_m_per_s, walk->turn_rate_rad_per_s, now_ns);
  } else if (std::holds_alternative<simulator::StopEvent>(event.action)) {
    on_command(false, Eigen::Vector2d::Zero(), 0.0, now_ns);
  } else if (std::holds_alternative<simulator::WalkToEvent>(event.action)) {
    way_.on_request();
  }
}

void RunRecorder::on_command(bool walk, const Eigen::Vector2d& velocity_m_per_s, double turn_rate_rad_per_s,
                             std::int64_t now_ns) {
  commanded_velocity_m_per_s_ = walk ? velocity_m_per_s : Eigen::Vector2d::Zero();
  commanded_turn_rate_rad_per_s_ = walk ? turn_rate_rad_per_s : 0.0;
  if (walk != walking_) {
    walking_ = walk;
    walking_since_ns_ = now_ns;
  }
}

// Where somebody else commands the walk there are no walk events.
void RunRecorder::follow_walk_command(std::int64_t now_ns) {
  WalkCommand command{};
  const bool scenario_commands =
      !run_.people_outside() && run_.arbiter().authority().commander() == msgcontroller::Commander::person;
  if (!scenario_commands && walk_command_.read(command).status == msgclient::ReadStatus::value) {
    on_command(command.walk != 0, {command.velocity[0], command.velocity[1]}, command.turn_rate, now_ns);
  }
}

void RunRecorder::add_sample(std::int64_t now_ns) {
  const simulator::PlantTruth truth = run_.plant().truth();
  RunSample sample;
  sample.time_s = static_cast<double>(now_ns) * 1e-9;
  sample.mode = static_cast<std::uint32_t>(run_.message_controller().mode());
  sample.base_m = truth.base.translation();
  sample.base_rpy_rad = roll_pitch_yaw(truth.base.linear());
  sample.com_m = truth.com_m;
  sample.cop_m = truth.cop_m.head<2>();
  for (std::size_t side = 0; side < 2; ++side) {
    const Eigen::Isometry3d& sole = run_.plant().ground_contact().sole[side];
    sample.foot[side] << sole.translation(), yaw_of(sole);
  }
  measure_progress(now_ns, sample);
  compare_zmp(now_ns, sample);
  track_joints(sample);
  Imu imu{};
  imu_.read(imu);
  std::copy_n(imu.angular_velocity, 3, sample.angular_velocity_rad_per_s.begin());
  std::copy_n(imu.acceleration, 3, sample.acceleration_m_per_s2.begin());
  std::copy_n(imu.inclination, 2, sample.inclination_rad.begin());
  FootForces forces{};
  foot_forces_.read(forces);
  for (std::size_t side = 0; side < 2; ++side) {
    std::copy_n(forces.force[side], 4, sample.force_N[side].begin());
  }
  TrimCommand trim{};
  trim_.read(trim);
  std::copy_n(trim.angle, 8, sample.trim_rad.begin());
  if (keep_samples_) {
    samples_.push_back(std::move(sample));
  }
}

void RunRecorder::measure_progress(std::int64_t now_ns, const RunSample& sample) {
  const double yaw = sample.base_rpy_rad.z();
  const Eigen::Vector2d position = sample.base_m.head<2>();
  if (!metrics_.started) {
    metrics_.started = true;
    metrics_.start_m = metrics_.end_m = position;
    metrics_.start_yaw_rad = metrics_.end_yaw_rad = yaw;
  }
  const Eigen::Vector2d moved = Eigen::Rotation2Dd(-metrics_.end_yaw_rad) * (position - metrics_.end_m);
  const bool started = walking_ && now_ns - walking_since_ns_ > kStartUp_ns;
  if (started) {
    metrics_.path_m += moved.x();
    metrics_.sideways_m += moved.y();
    metrics_.walked_s += kSlot_s;
  }
  const double turned = std::remainder(yaw - metrics_.end_yaw_rad, 2.0 * std::numbers::pi);
  if (const double speed = commanded_velocity_m_per_s_.norm(); speed > 0.0) {
    metrics_.way_m.add(speed * kSlot_s, moved.dot(commanded_velocity_m_per_s_) / speed, started);
  }
  if (const double rate = commanded_turn_rate_rad_per_s_; rate != 0.0) {
    metrics_.turn_rad.add(std::abs(rate) * kSlot_s, std::copysign(1.0, rate) * turned, started);
  }
  metrics_.end_m = position;
  metrics_.end_yaw_rad += turned;
  metrics_.commanded_yaw_rad += commanded_turn_rate_rad_per_s_ * kSlot_s;
}

void RunRecorder::compare_zmp(std::int64_t now_ns, RunSample& sample) {
  sample.measured_zmp_m.setConstant(kNone);
  sample.reference_zmp_m.setConstant(kNone);
  sample.reference_com_m.setConstant(kNone);
  Estimate estimate{};
  if (estimate_.read(estimate).status != msgclient::ReadStatus::value) {
    return;
  }
  const auto& soles = run_.plant().ground_contact().sole;
  const auto side = static_cast<std::size_t>(estimate.support);
  const Eigen::Vector3d support = ground_pose(soles[side]);
  const Eigen::Vector2d measured(estimate.zmp[0], estimate.zmp[1]);
  sample.measured_zmp_m = transfer(measured, Eigen::Vector3d::Zero(), support);
  // The cells' values are means over the slot that ended at this slot's edge, and so is the reference.
  const std::int64_t slot_index = (now_ns - facts::kMillisecond_ns) / kSlot_ns;
  const MotionPlan* const plan = running_plan(static_cast<std::uint32_t>((slot_index - 1) / kSlotsPerCycle));
  if (plan == nullptr || run_.message_controller().mode() != msgcontroller::Mode::batches) {
    return;
  }
  const auto point = static_cast<std::size_t>((slot_index - 1) % kSlotsPerCycle);
  const Eigen::Vector3d planned = planned_foot(*plan, point, side);
  const Eigen::Vector2d reference(plan->zmp[point][0], plan->zmp[point][1]);
  sample.reference_zmp_m = transfer(reference, planned, support);
  sample.reference_com_m = transfer({plan->com[point][0], plan->com[point][1]}, planned, support);
  if (!walking_ || metrics_.fell || now_ns - walking_since_ns_ < kStartUp_ns) {
    return;
  }
  metrics_.zmp_reference_error_m.add((sample.measured_zmp_m - sample.reference_zmp_m).norm());
  Eigen::Vector2d true_cop;
  if (cop_mean_.in_sole_frame(static_cast<int>(side), true_cop)) {
    metrics_.zmp_estimate_error_m.add((measured - true_cop).norm());
  }
  // The support polygon of the feet that bore load in this slot.
  std::vector<Eigen::Vector2d> corners;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    if (cop_mean_.mean_force_N(foot) > 0.0) {
      const auto sole = run_.robot().feet[foot].corners_m(ground_pose(soles[foot]));
      corners.insert(corners.end(), sole.begin(), sole.end());
    }
  }
  metrics_.zmp_margin_min_m =
      std::min(metrics_.zmp_margin_min_m, geometry::ConvexHull<>(corners).margin_m(sample.measured_zmp_m));
}

void RunRecorder::track_joints(RunSample& sample) {
  JointStates states{};
  joint_states_.read(states);
  const simulator::PlantSensors& sensors = run_.plant().sensors();
  for (int joint = 0; joint < run_.joints().size(); ++joint) {
    const auto j = static_cast<std::size_t>(joint);
    const localcontroller::JointController& controller = run_.joints().joint(joint);
    const urdf::Joint& description = run_.robot().joints[j];
    const double measured =
        sensors.encoder_count[j] * description.encoder_count_rad - description.encoder_zero_rad;
    const double reference = controller.reference_rad() + controller.trim_rad();
    if (!metrics_.fell) {
      metrics_.tracking_rad.add(reference - measured);
    }
    sample.joint_position_rad.push_back(static_cast<float>(measured));
    sample.joint_reference_rad.push_back(static_cast<float>(reference));
    sample.joint_velocity_rad_per_s.push_back(static_cast<float>(states.velocity[j]));
    sample.joint_torque_Nm.push_back(static_cast<float>(sensors.motor_torque_Nm[j]));
  }
}

}  // namespace gaitway::tools
