// A reason is told when it has lasted: while one end is started again there are several of them.
#include "gaitway/api/link_watch.hpp"

#include <array>
#include <utility>

#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

constexpr std::int64_t kLasting_ns = facts::kSecond_ns;
constexpr const char* kOtherCalibration =
    "the main controller was started with another calibration.yaml than this module: what the page shows of "
    "the "
    "calibration is not what the robot runs with. Copy the main controller's into this module's robot "
    "folder, and "
    "start the module anew";

}  // namespace

LinkWatch::LinkWatch(const link::LinkAddress& address, std::int64_t now_ns)
    : address_(link::text_of(address)),
      report_{.text = "connecting to the main controller at " + address_, .since_ns = now_ns},
      lost_ns_(now_ns) {}

std::string LinkWatch::reason_of(const LinkSight& sight) const {
  if (!sight.error.empty()) {
    return sight.error;
  }
  if (link::is_refusal(sight.why)) {
    return sight.description;
  }
  return "link '" + address_ + "': " + sight.description +
         ". Does main_controller run, with the plug-in api and this link?";
}

std::optional<std::string> LinkWatch::look(const LinkSight& sight, std::int64_t now_ns) {
  using State = LinkReport::State;
  const bool was_up = report_.state == State::up;
  if (sight.open) {
    const std::string text = sight.same_calibration ? "" : kOtherCalibration;
    if (was_up && report_.text == text) {
      return std::nullopt;
    }
    report_ = {State::up, text, was_up ? report_.since_ns : now_ns};
    return "linked to the main controller" + (text.empty() ? text : ", but " + text);
  }
  if (was_up) {
    report_ = {State::down, "the link to the main controller is lost: " + sight.description, now_ns};
    lost_ns_ = now_ns;
    reason_.clear();
    return report_.text;
  }
  std::string reason = reason_of(sight);
  if (reason != reason_) {
    reason_ = std::move(reason);
    reason_ns_ = now_ns;
  }
  if (now_ns - reason_ns_ <= kLasting_ns || reason_ == report_.text) {
    return std::nullopt;
  }
  const bool refused = sight.error.empty() && link::is_refusal(sight.why);
  report_ = {refused ? State::refused : State::down, reason_, lost_ns_};
  return "no link to the main controller: " + reason_;
}

ros::LinkState link_state_of(const LinkReport& report, std::string_view link, std::int64_t now_ns) {
  static constexpr std::array<const char*, 3> kNames{"down", "refused", "up"};
  constexpr double kSecond = 1e-9;
  return {.state = kNames[static_cast<std::size_t>(report.state)],
          .text = report.text,
          .link = std::string(link),
          .seconds = static_cast<double>(now_ns - report.since_ns) * kSecond};
}

}  // namespace gaitway::api
