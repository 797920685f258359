// What is worse is told first: gone, stopped, fallen; then what the plan in force is for.
#include "robot_activity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::array<std::string_view, 8> kWords{"stands",  "walks", "plays",  "stops",
                                                 "stopped", "falls", "fallen", "gone"};

// Whether a foot is lifted in the batch that plays, a step is still to come, or the body still comes to rest
// after the last one.
bool walks(const MotionPlan& plan, std::int64_t robot_ns) noexcept {
  constexpr std::uint8_t kBothFeet = 2;
  constexpr double kRest_m_per_s = 1e-3;
  const auto support = std::span(plan.support).first(kBatchPoints);
  const auto velocities = std::span(plan.com_velocity).first(kBatchPoints);
  const auto landings =
      std::span(plan.footstep_landing_ns).first(std::min<std::size_t>(plan.footstep_count, kMaxFootsteps));
  return std::ranges::any_of(support, [](std::uint8_t feet) { return feet != kBothFeet; }) ||
         std::ranges::any_of(landings,
                             [robot_ns](std::int64_t landing_ns) { return landing_ns > robot_ns; }) ||
         std::ranges::any_of(velocities, [](const auto& velocity_m_per_s) {
           return std::hypot(velocity_m_per_s[0], velocity_m_per_s[1]) > kRest_m_per_s;
         });
}

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
  return evidence.plan != nullptr && walks(*evidence.plan, evidence.robot_ns) ? Activity::walks
                                                                              : Activity::stands;
}

ros::RobotState robot_state_of(Activity activity, std::int64_t robot_ns) {
  ros::RobotState message;
  message.header.stamp = ros_time(robot_ns);
  message.state = kWords[static_cast<std::size_t>(activity)];
  return message;
}

}  // namespace gaitway::api
