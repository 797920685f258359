// One simulated robot on its flight.
#pragma once

#include "gaitway/msgclient/topics.hpp"
#include "gaitway/preflight/preflight.hpp"

namespace gaitway::preflight {

class FlightRun {
 public:
  FlightRun(const urdf::RobotModel& robot, const Flight& flight, simulator::CosimulationOptions options,
            std::uint64_t seed);

  [[nodiscard]] bool goes_on() const;
  void advance_millisecond();
  [[nodiscard]] simulator::Cosimulation& run() noexcept { return run_; }
  // So far.
  [[nodiscard]] Trial trial() const;

 private:
  void look();
  void look_at_answers();
  [[nodiscard]] std::string contact_text(const simulator::BodyContact& contact) const;
  [[nodiscard]] std::string left_undone() const;

  const Flight& flight_;
  simulator::Cosimulation run_;
  msgclient::Reader<MotionState> motion_;
  msgclient::Reader<NavigationState> way_;
  std::size_t next_event_ = 0;
  Trial trial_;
  std::size_t motions_ended_ = 0;
  bool arrived_ = false;
  double distance_left_m_ = 0.0;
};

}  // namespace gaitway::preflight
