// Event -> rcl_interfaces/Log.
#include "gaitway/api/event_message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "gaitway/api/fixed_text.hpp"
#include "gaitway/api/ros_time.hpp"

namespace gaitway::api {
namespace {

constexpr std::uint8_t kInfo = 20, kWarning = 30, kError = 40;
// [core::EventKind]: info, warning, error, fault, refusal.
constexpr std::array<std::uint8_t, 5> kLevels{kInfo, kWarning, kError, kError, kWarning};

}  // namespace

ros::Log log_of(const Event& event) {
  ros::Log log;
  log.stamp = ros_time(event.stamp_ns);
  log.level = kLevels[std::min<std::size_t>(event.kind, kLevels.size() - 1)];
  log.name = text_of(event.source);
  log.msg = text_of(event.text);
  return log;
}

ros::Log log_of_missed(std::uint64_t count, std::int64_t stamp_ns) {
  ros::Log log;
  log.stamp = ros_time(stamp_ns);
  log.level = kWarning;
  log.name = "api";
  log.msg = fmt::format("{} events came faster than they were read, and were missed", count);
  return log;
}

}  // namespace gaitway::api
