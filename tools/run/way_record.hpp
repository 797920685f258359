// What became of the ways that a run was asked to walk: where the feet landed against where they were
// planned, and where the robot came to stand.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "gaitway/msgclient/client.hpp"
#include "gaitway/msgclient/topics.hpp"
#include "gaitway/simulator/plant.hpp"
#include "tools/run/run_metrics.hpp"

namespace gaitway::tools {

class WayRecord {
 public:
  explicit WayRecord(msgclient::Client& client)
      : navigation_(client.read<NavigationState>("navigation_state")),
        way_(client.read<NavigationWay>("navigation_way")),
        walk_(client.read<FootstepState>("footstep_state")) {}

  // Every 10 ms.
  void look(std::int64_t now_ns, const simulator::Plant& plant);
  void on_request() noexcept { asked_ = true; }

  [[nodiscard]] bool asked() const noexcept { return asked_; }
  // The newest way has ended, one way or the other.
  [[nodiscard]] bool ended() const noexcept;
  // What was asked and not done; empty: the robot has arrived, somebody has ended the way, or none was asked
  // for.
  [[nodiscard]] std::string missing() const;
  // For summary.json and the table; null: nothing was asked.
  [[nodiscard]] nlohmann::ordered_json json() const;

 private:
  struct Place {
    std::uint8_t side = 0;
    std::array<double, 3> pose{};  // x, y, yaw
  };
  void take_plan();
  void measure_landed(const simulator::Plant& plant);

  msgclient::Reader<NavigationState> navigation_;
  msgclient::Reader<NavigationWay> way_;
  msgclient::Reader<FootstepState> walk_;
  NavigationState state_{};
  FootstepState footsteps_{};
  bool asked_ = false;
  std::map<std::uint32_t, Place> planned_;  // as they were planned last, by number
  std::uint32_t landed_ = 0;                // whose foot stands still now
  RootMeanSquare placement_m_, placement_rad_;
  double worst_m_ = 0.0;
  double ended_s_ = 0.0;
  std::array<double, 3> stand_{};  // of the feet's middle, true
};

}  // namespace gaitway::tools
