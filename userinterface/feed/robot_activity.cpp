// What is worse is told first: gone, stopped, fallen; then what the plan in force is for.
#include "gaitway/api/robot_activity.hpp"

#include <array>
#include <string>
#include <string_view>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::array<std::string_view, 8> kWords{"stands",  "walks", "plays",  "stops",
                                                 "stopped", "falls", "fallen", "gone"};

}  // namespace

Activity activity_of(const ActivityEvidence& evidence) noexcept {
  namespace mode = network_state::mode;
  namespace fall = estimate::fall;
  if (evidence.network == nullptr || evidence.heartbeat_age_ns >= facts::kSecond_ns) return Activity::gone;
  if (evidence.network->mode == mode::emergency_stop) return Activity::stopped;
  if (evidence.estimate != nullptr && evidence.estimate->fall == fall::lies) return Activity::fallen;
  if (evidence.estimate != nullptr && evidence.estimate->fall == fall::falls) return Activity::falls;
  if (evidence.network->mode == mode::holding) return Activity::stands;
  if (evidence.network->mode == mode::safe_tail) return Activity::stops;
  if (evidence.motion != nullptr && evidence.motion->state != 0) return Activity::plays;
  if (evidence.planned == nullptr) return Activity::gone;  // it plays batches, and may walk
  return evidence.planned->walks != 0 ? Activity::walks : Activity::stands;
}

std::string_view word_of(Activity activity) noexcept {
  return kWords[static_cast<std::size_t>(activity)];
}

ros::RobotState robot_state_of(Activity activity, std::int64_t robot_ns) {
  ros::RobotState message;
  message.header.stamp = ros_time(robot_ns);
  message.state = word_of(activity);
  return message;
}

}  // namespace gaitway::api
