// What is seen of a robot after a fault, and what it amounts to: does it walk, when may it be commanded
// again, what was lost. Told what was seen and when; looks at nothing itself.
#pragma once

#include <cstdint>
#include <deque>
#include <optional>

#include "tools/campaign/real_time/real_time_trial.hpp"

namespace gaitway::tools {

// A count that begins anew at 0 when whoever counts is started again.
class RestartingCount {
 public:
  void look(std::uint64_t count) noexcept {
    if (seen_) sum_ += count >= last_ ? count - last_ : count;
    seen_ = true;
    last_ = count;
  }
  [[nodiscard]] std::uint64_t sum() const noexcept { return sum_; }  // since the first look

 private:
  bool seen_ = false;
  std::uint64_t last_ = 0, sum_ = 0;
};

// Whether the robot gets ahead: by the straight way of the last second, in whichever frame it is told.
class WalkMeter {
 public:
  explicit WalkMeter(double speed_m_per_s) : speed_m_per_s_(speed_m_per_s) {}

  // A place of the robot that is new. A jump means that a new frame has begun.
  void look(std::int64_t at_ns, double x_m, double y_m);
  // In the last second it covered at least half of its way.
  [[nodiscard]] bool walks(std::int64_t now_ns) const;

 private:
  struct Place {
    std::int64_t at_ns;
    double x_m, y_m;
  };
  double speed_m_per_s_;
  std::deque<Place> places_;
};

struct RobotSight {
  std::int64_t at_ns = 0;
  bool is_commandable = false;  // its joints answer, and carry out what is planned now
  std::optional<std::int64_t>
      walk_order_ns;  // when the order to walk was given that is obeyed; none: none is
  struct Place {
    std::int64_t stamp_ns;
    double x_m, y_m;
  };
  std::optional<Place> place = {};  // its own estimate
  double lean_rad = 0.0;            // of the trunk
  bool all_parts_work = false;
  std::int64_t told_ns = 0;  // when supervisor and plug-in manager last said so, the older one
  struct Counts {
    std::uint64_t late = 0, refused = 0, tail_played = 0, left_to_joints = 0, stops = 0;
  };
  std::optional<Counts> counts = {};  // of the message controller
  std::optional<std::uint64_t> plugin_faults = {};
  std::uint64_t restarts = 0, lost_lines = 0;  // as its supervisor counts them
};

class RecoveryWatch {
 public:
  explicit RecoveryWatch(double speed_m_per_s) : meter_(speed_m_per_s) {}

  void look(const RobotSight& sight);
  void on_fault(std::int64_t at_ns);
  void on_stop_asked(std::int64_t at_ns) noexcept { stop_asked_ns_ = at_ns; }
  void on_fall(std::int64_t at_ns);

  [[nodiscard]] bool walks() const { return walks_; }
  // For so long now all has been as it should be: it walks, may be commanded, and all parts work.
  [[nodiscard]] std::int64_t well_ns(std::int64_t now_ns) const noexcept;
  [[nodiscard]] bool has_fallen() const noexcept { return outcome_.fell; }
  [[nodiscard]] bool has_stopped() const noexcept { return outcome_.stop_s.has_value(); }
  // Valid as of the last look.
  [[nodiscard]] RealTimeOutcome outcome() const;

 private:
  [[nodiscard]] double since_fault_s(std::int64_t at_ns) const noexcept {
    return static_cast<double>(at_ns - fault_ns_) * 1e-9;
  }
  void count(const RobotSight& sight);
  [[nodiscard]] RealTimeLosses losses() const noexcept;
  void judge(const RobotSight& sight);

  WalkMeter meter_;
  std::int64_t fault_ns_ = 0, stop_asked_ns_ = 0, leans_ns_ = 0;  // 0: not
  std::int64_t place_ns_ = 0;
  bool walks_ = false, was_still_ = false;
  std::int64_t well_since_ns_ = 0;  // 0: it is not
  std::optional<std::uint64_t> stops_;
  RestartingCount late_, refused_, tails_, joints_, plugin_faults_, restarts_, lines_;
  RealTimeLosses before_;  // the fault
  RealTimeOutcome outcome_;
};

}  // namespace gaitway::tools
