// Watches a robot from its fault on: whether it falls, what it does about that, whether it stands, walks on
// or walks again.
#pragma once

#include <Eigen/Core>
#include <deque>
#include <optional>

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/cosimulation.hpp"
#include "tools/campaign/fault_trial.hpp"

namespace gaitway::tools {

class FaultWatch final : public simulator::CosimulationObserver {
 public:
  // From now on. `run` outlives it.
  FaultWatch(simulator::Cosimulation& run, double speed_m_per_s);

  void on_frame(const can::SimulatedBus::Delivery& delivery) override;
  void on_millisecond(std::int64_t now_ns) override;

  [[nodiscard]] double since_s() const;  // since the fault
  // It has fallen, and there is nothing more to see.
  [[nodiscard]] bool fall_is_over() const { return fallen_ms_ > kWatchedFall_ms; }
  [[nodiscard]] FaultOutcome outcome() const;

 private:
  static constexpr int kWatchedFall_ms = 1000;

  void watch_fall();
  void watch_stand(const Eigen::Vector3d& com_m);
  void watch_walk(const Eigen::Vector2d& base_m);
  void compare_references();
  [[nodiscard]] FaultLosses counts() const;

  simulator::Cosimulation& run_;
  double speed_m_per_s_;
  std::int64_t from_ns_;
  msgclient::Reader<Estimate> estimate_;
  FaultLosses before_;
  FaultOutcome outcome_;
  int fallen_ms_ = 0;
  std::optional<Eigen::Vector3d> last_com_m_;
  std::optional<double> still_since_s_;
  std::deque<Eigen::Vector2d> way_m_;  // of the last gait cycle
  bool stopped_ = false;               // at any time
  std::optional<double> walks_since_s_;
};

// Watches nothing but the bus: when the first emergency stop has come to its end there.
class StopWatch final : public simulator::CosimulationObserver {
 public:
  explicit StopWatch(const can::Profile& profile) : profile_(profile) {}
  void on_frame(const can::SimulatedBus::Delivery& delivery) override;
  void on_millisecond(std::int64_t) override {}
  [[nodiscard]] std::optional<std::int64_t> sent_ns() const { return sent_ns_; }

 private:
  can::Profile profile_;
  std::optional<std::int64_t> sent_ns_;
};

}  // namespace gaitway::tools
