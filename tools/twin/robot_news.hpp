// What a robot's API tells of it, message by message, as far as a twin wants it.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "gaitway/urdf/robot_model.hpp"

namespace gaitway::tools {

// What is measured together, by one stamp.
enum class Measurement : std::uint8_t {
  joints,    // rad, in the model's order
  attitude,  // roll, pitch, rad, of the estimate
  left_foot,
  right_foot,  // N, upwards
  odometry,    // of the base: x, y, z m, quaternion x, y, z, w
  place        // of the middle between the feet in the robot's map: x, y m, yaw rad
};
inline constexpr std::size_t kMeasurements = 6;

struct MeasuredPoint {
  Measurement what = Measurement::joints;
  double stamp_s = 0.0;        // of the robot's clock
  std::vector<double> values;  // NaN: the robot does not know it
};

// What the robot does, and what it was told.
struct RobotNews {
  std::string activity, commander;                  // as /robot_state and /commander have them
  std::array<double, 3> walk{};                     // m/s ahead, m/s to the left, rad/s
  std::string motion, motion_state, motion_result;  // as /motion_state has them
  std::uint32_t motions_ended = 0;
  std::string way_state, way_result;          // as /walk_to/state has them
  std::optional<std::array<double, 3>> goal;  // x m, y m, yaw rad
};

// Of what somebody else says: in a line, without what a terminal obeys, and no longer than people read.
[[nodiscard]] std::string shortened(std::string text);

class RobotReader {
 public:
  explicit RobotReader(const urdf::RobotModel& robot);

  // Topics to subscribe to, each with the least time between two messages [ms].
  struct Topic {
    const char* name;
    int period_ms;
  };
  [[nodiscard]] static std::vector<Topic> topics();

  // A message of one of them: into `news`, or as a point. Throws nlohmann::json::exception for what has other
  // fields.
  std::optional<MeasuredPoint> take(std::string_view topic, const nlohmann::json& message, RobotNews& news);

 private:
  [[nodiscard]] MeasuredPoint joints_of(const nlohmann::json& message) const;

  std::map<std::string, std::size_t, std::less<>> index_;  // of joints
};

}  // namespace gaitway::tools
