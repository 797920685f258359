// When each millisecond of the robot's is due by the wall clock.
#pragma once

#include <poll.h>

#include <cstdint>
#include <span>

#include "gaitway/process/duration_histogram.hpp"

namespace gaitway::simulator {

class Pace {
 public:
  // `speed`: times real time.
  explicit Pace(double speed);
  // Waits for the next one. False: told to stop by a signal, or a descriptor is readable before it is due;
  // then it is still to come.
  bool wait(std::span<pollfd> descriptors);
  // From now on.
  void set_speed(double speed);
  // After a pause nothing is to be caught up with.
  void begin_anew() noexcept { started_ = false; }

  // That the robot's time has fallen behind for good.
  [[nodiscard]] double lost_s() const noexcept { return lost_ns_ * 1e-9; }
  [[nodiscard]] process::DurationSummary lateness_us() const { return late_.summary(); }

 private:
  double millisecond_ns_;
  double due_ns_ = 0.0;  // of the last one that came
  double lost_ns_ = 0.0;
  bool started_ = false;
  process::DurationHistogram late_;
};

}  // namespace gaitway::simulator
