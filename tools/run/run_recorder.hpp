// Watches a co-simulation and keeps what reports, metrics and logs need: every frame, a sample each 10 ms,
// one 80 ms cycle of the bus, applied torques for the bare replay, and the digest.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "gaitway/can/candump_log.hpp"
#include "gaitway/can/frame.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "gaitway/simulator/run_digest.hpp"
#include "tools/run/contact_log.hpp"
#include "tools/run/mission_record.hpp"
#include "tools/run/run_metrics.hpp"
#include "tools/run/way_record.hpp"

namespace gaitway::tools {

// One row of a run's record, every 10 ms: what the robot did, what it was asked for and what its sensors
// said.
struct RunSample {
  double time_s = 0.0;
  std::uint32_t mode = 0;  // of the message controller
  // truth, world frame
  Eigen::Vector3d base_m = Eigen::Vector3d::Zero();
  Eigen::Vector3d base_rpy_rad = Eigen::Vector3d::Zero();
  Eigen::Vector3d com_m = Eigen::Vector3d::Zero();
  Eigen::Vector2d cop_m = Eigen::Vector2d::Zero();  // centre of pressure of the physics engine
  std::array<Eigen::Vector4d, 2> foot{};            // x, y, z, yaw of each sole
  // measured and reference, laid into the world at the true support foot; NaN where there is none
  Eigen::Vector2d measured_zmp_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d reference_zmp_m = Eigen::Vector2d::Zero();
  Eigen::Vector2d reference_com_m = Eigen::Vector2d::Zero();
  // measured, as the topics carry it
  std::array<double, 3> angular_velocity_rad_per_s{};
  std::array<double, 3> acceleration_m_per_s2{};
  std::array<double, 2> inclination_rad{};
  std::array<std::array<double, 4>, 2> force_N{};
  std::array<double, 8> trim_rad{};
  std::vector<float> joint_position_rad, joint_velocity_rad_per_s, joint_reference_rad, joint_torque_Nm;
};

// What has become of the bus log.
struct BusLogCount {
  std::uint64_t lines = 0, lost = 0;
  std::string error{};  // why lines were lost; empty: none were
};

class RunRecorder final : public simulator::CosimulationObserver {
 public:
  // `bus_log`: candump file to write, or an empty path for none. `keep_samples`: memory for csv, report and
  // bare replay; without it nothing grows with the run, and of the bus log
  // the last 256 MiB are kept, and FILE.1 with as much before them.
  RunRecorder(simulator::Cosimulation& run, const std::filesystem::path& bus_log, bool keep_samples);

  // What was commanded at `now_ns`: the metrics of walking depend on it.
  void on_event(const simulator::ScenarioEvent& event, std::int64_t now_ns);
  void on_frame(const can::SimulatedBus::Delivery& delivery) override;
  void on_millisecond(std::int64_t now_ns) override;
  // Writes what of the bus log waits, and ends it. A full disk costs lines, no more.
  void finish();
  // Writes what of it waits.
  void flush();
  [[nodiscard]] BusLogCount bus_log() const;

  [[nodiscard]] bool keeps_samples() const noexcept { return keep_samples_; }
  [[nodiscard]] const std::vector<RunSample>& samples() const noexcept { return samples_; }
  [[nodiscard]] const RunMetrics& metrics() const noexcept { return metrics_; }
  [[nodiscard]] const ContactLog& contacts() const noexcept { return contacts_; }
  [[nodiscard]] const WayRecord& way() const noexcept { return way_; }
  [[nodiscard]] const MissionRecord& mission() const noexcept { return mission_; }
  [[nodiscard]] MissionRecord& mission() noexcept { return mission_; }
  [[nodiscard]] std::uint64_t digest() const noexcept { return digest_.value(); }
  [[nodiscard]] const std::vector<float>& torques() const noexcept { return torques_; }
  // Every frame of the cycle that starts at `cycle_start_ns()`: one that was walked, for the timeline.
  [[nodiscard]] const std::vector<can::SimulatedBus::Delivery>& cycle() const noexcept { return cycle_; }
  [[nodiscard]] std::int64_t cycle_start_ns() const noexcept { return cycle_start_ns_; }

 private:
  void read_plan();
  void follow_walk_command(std::int64_t now_ns);
  void on_command(bool walk, const Eigen::Vector2d& velocity_m_per_s, double turn_rate_rad_per_s,
                  std::int64_t now_ns);
  void add_sample(std::int64_t now_ns);
  [[nodiscard]] const MotionPlan* running_plan(std::uint32_t cycle) const noexcept;
  void measure_progress(std::int64_t now_ns, const RunSample& sample);
  void compare_zmp(std::int64_t now_ns, RunSample& sample);
  void track_joints(RunSample& sample);

  simulator::Cosimulation& run_;
  msgclient::Reader<JointStates> joint_states_;
  msgclient::Reader<FootForces> foot_forces_;
  msgclient::Reader<Imu> imu_;
  msgclient::Reader<Estimate> estimate_;
  msgclient::Reader<MotionPlan> motion_plan_;
  msgclient::Reader<TrimCommand> trim_;
  msgclient::Reader<WalkCommand> walk_command_;
  std::optional<can::CandumpWriter> bus_log_;
  bool keep_samples_;
  simulator::RunDigest digest_;
  RunMetrics metrics_;
  ContactLog contacts_;
  WayRecord way_;
  MissionRecord mission_;
  CentreOfPressureMean cop_mean_;
  std::array<MotionPlan, 3> plans_{};  // the newest, by sequence modulo 3
  std::vector<RunSample> samples_;
  std::vector<float> torques_;
  std::vector<can::SimulatedBus::Delivery> cycle_, cycle_candidate_;
  std::int64_t cycle_start_ns_ = 0;
  bool walking_ = false;
  std::int64_t walking_since_ns_ = 0;
  Eigen::Vector2d commanded_velocity_m_per_s_ = Eigen::Vector2d::Zero();
  double commanded_turn_rate_rad_per_s_ = 0.0;
};

}  // namespace gaitway::tools
