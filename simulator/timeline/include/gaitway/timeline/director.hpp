// Carries out what people and programs ask of a simulation that has a time line: play, pause, step, speed,
// reset, seek, and what is done to the robot and its world. README.md lists the orders.
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "gaitway/simulation/control_server.hpp"
#include "gaitway/timeline/timeline.hpp"

namespace gaitway::timeline {

// The JSON that an order `plan` is answered with, for a goal (x m, y m, yaw rad) and the state of the
// simulation (live_state.hpp). Throws std::exception: why there is no way.
using PlanWay = std::function<nlohmann::json(const std::array<double, 3>& goal, const nlohmann::json& state)>;

struct DirectorOptions {
  std::filesystem::path socket;  // where orders come
  bool playing = true;
  double speed = 1.0;
  std::string world;
  PlanWay plan_way;  // empty: the order `plan` is refused
};

inline constexpr double kSlowest = 0.1, kFastest = 40.0;  // times real time
inline constexpr int kMostSteps_ms = 10'000;              // at once

class Director {
 public:
  // `start`: the simulation at 0. Throws process::SocketError, and what the start of the live simulation
  // throws.
  Director(CopyHandle start, DirectorOptions options);

  // Waits for what comes, at most so long, and does it.
  void step(int patience_ms);

  [[nodiscard]] const Timeline& timeline() const noexcept { return timeline_; }
  // Ends the simulation that runs; its last reports count. Returns the digest of the whole, nothing where it
  // cannot be replayed to its end.
  [[nodiscard]] std::optional<std::uint64_t> finish();
  // Where the simulation is.
  [[nodiscard]] std::int64_t now_ns() const noexcept { return now_ns_; }
  [[nodiscard]] bool playing() const noexcept { return playing_; }
  [[nodiscard]] double speed() const noexcept { return speed_; }
  // Rises when the robot has been put to another instant.
  [[nodiscard]] std::uint32_t run() const noexcept { return run_; }
  // Empty while there is a simulation.
  [[nodiscard]] const std::string& failure() const noexcept { return failure_; }

 private:
  using Ticket = simulation::Ticket;

  [[nodiscard]] std::optional<std::string> obey(const Ticket& ticket, std::string_view text);
  void pass_on(const Ticket& ticket, nlohmann::json order);
  void require_simulation() const;
  void set_pace();
  void go_to(std::int64_t at_ns);
  void go_live(CopyHandle copy);
  void hear_live();
  void take_report(const nlohmann::json& report);
  void take_answer(const nlohmann::json& answer);
  void fail(const std::string& why);
  void measure_pace();
  [[nodiscard]] nlohmann::json state() const;

  DirectorOptions options_;
  Timeline timeline_;
  std::optional<CopyHandle> live_;
  bool playing_;
  double speed_;
  std::uint32_t run_ = 1;
  std::int64_t now_ns_ = 0;
  nlohmann::json seen_ = nlohmann::json::object();  // the newest state of the live simulation
  std::string failure_;
  std::map<std::uint64_t, Ticket> passed_on_;  // orders that the live simulation answers
  std::uint64_t last_order_ = 0;
  std::set<std::int64_t> falls_ns_;
  std::int64_t paced_ns_ = 0, paced_wall_ns_ = 0;
  double pace_ = 0.0;
  simulation::ControlServer server_;
};

}  // namespace gaitway::timeline
