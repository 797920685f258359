// The twin of a real robot: what that one measures beside the simulated one, which is told the same; how the
// two differ; and what was tried here on its way there, through the pre-flight gate.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"
#include "tools/ctl/api_client.hpp"
#include "tools/twin/comparison.hpp"
#include "tools/twin/flight_process.hpp"
#include "tools/twin/follower.hpp"
#include "tools/twin/measured_pose.hpp"
#include "tools/twin/robot_stop.hpp"
#include "tools/twin/robot_watch.hpp"

namespace gaitway::tools {

struct TwinOptions {
  ApiAddress there;                           // of the real robot
  ApiAddress here;                            // of the simulated one
  std::vector<std::string> flight_arguments;  // of every pre-flight: robot, plug-ins, world
  std::filesystem::path out;                  // folder for verdicts and for what was sent
};

// How the simulation runs. Only at the pace of the real robot's time can the two be compared.
struct SimulationPace {
  bool plays = true;
  double speed = 1.0;
  std::uint32_t run = 0;  // rises when the simulated robot has been put to another instant
};

class Twin {
 public:
  // Has threads from here on.
  Twin(const TwinOptions& options, const urdf::RobotModel& robot);
  // First of all what is sent ends, and the robot there is stopped if it was being sent something.
  ~Twin();
  Twin(const Twin&) = delete;
  Twin& operator=(const Twin&) = delete;

  // Hears, compares, has the simulated robot follow.
  void look(const SimulationPace& pace);
  // What there is to say for people since the last call.
  [[nodiscard]] std::vector<std::string> take_lines();

  // The orders `twin` (its state), `twin_follow`, `twin_send`, `twin_stop`, `twin_reconnect` and
  // `twin_picture`; nothing for any other. Throws std::invalid_argument or std::runtime_error: why not.
  [[nodiscard]] std::optional<nlohmann::json> obey(const nlohmann::json& order);

 private:
  void hear(Comparison::Robot robot, RobotWatch& watch);
  void keep_pace(const SimulationPace& pace);
  void tell(std::string text);
  void look_at_link(const RobotWatch::Status& status);
  void look_at_stop();
  void look_at_following();
  void look_at_flight();
  void stop(const std::string& why);
  void begin_flight(const nlohmann::json& order);
  void join();
  [[nodiscard]] nlohmann::json state() const;
  [[nodiscard]] nlohmann::json picture(const nlohmann::json& order) const;

  std::string address_;
  Comparison comparison_;
  MeasuredPose pose_;
  RobotStop stop_;
  FlightProcess flight_;
  FlightProcess::State flight_seen_ = FlightProcess::State::idle;
  RobotWatch there_, here_;
  Follower follower_;
  RobotWatch::Status there_status_;
  RobotWatch::State link_told_ = RobotWatch::State::connecting;
  std::string follow_told_, pace_text_;
  std::uint32_t stops_told_ = 0;
  bool joins_ = false;             // the simulated robot is to go to where the one there stands
  bool is_stopped_again_ = false;  // after the flight that was to end has ended
  SimulationPace pace_;
  double began_s_ = monotonic_s();
  double measured_s_ = 0.0;                          // when its newest measurement came; 0: never
  std::deque<std::pair<double, std::string>> told_;  // s since the beginning
  std::vector<std::string> lines_;
};

}  // namespace gaitway::tools
