// A push that is asked for becomes a scenario's.
#include "gaitway/simulator/push_taker.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <iterator>
#include <stdexcept>
#include <string>
#include <utility>

#include "gaitway/facts/facts.hpp"
#include "gaitway/input/complaint.hpp"

namespace gaitway::simulator {
namespace {

using simulation::Push;

static_assert(simulation::kLargestForce_N * simulation::kLongestPush_s <= kLargestImpulse_Ns,
              "a scenario plays again whatever was asked for");

void require_link(const urdf::RobotModel& robot, const std::string& name) {
  std::vector<std::string> known;
  std::ranges::transform(robot.links, std::back_inserter(known), &urdf::Link::name);
  if (std::ranges::find(known, name) == known.end()) {
    throw std::invalid_argument(fmt::format("link is '{}', but must be one of {}'s links. {}", name,
                                            robot.name, input::suggest(name, known)));
  }
}

Eigen::Vector3d in_world(const Push& push, const Eigen::Isometry3d& base) {
  const Eigen::Vector3d force_N(push.force_N[0], push.force_N[1], push.force_N[2]);
  if (push.frame == simulation::Frame::world) {
    return force_N;
  }
  const Eigen::Vector3d ahead = base.linear().col(0);
  return Eigen::AngleAxisd(std::atan2(ahead.y(), ahead.x()), Eigen::Vector3d::UnitZ()) * force_N;
}

}  // namespace

ScenarioEvent PushTaker::take(const Push& asked) {
  const std::int64_t now_ns = run_.now_ns();
  require_link(run_.robot(), asked.link);
  std::erase_if(ends_ns_, [now_ns](std::int64_t end_ns) { return end_ns <= now_ns; });
  if (ends_ns_.size() >= kMostPushes) {
    throw std::invalid_argument(fmt::format(
        "{} pushes are under way, and no more may be: try again when one has ended", ends_ns_.size()));
  }
  const Eigen::Vector3d force_N = in_world(asked, run_.plant().truth().base);
  const auto duration_ns =
      static_cast<std::int64_t>(std::llround(asked.duration_s * static_cast<double>(facts::kSecond_ns)));
  const ScenarioEvent event{.at_s = static_cast<double>(now_ns) * 1e-9,
                            .action = PushEvent{.body = asked.link,
                                                .direction = force_N,
                                                .impulse_Ns = force_N.norm() * asked.duration_s,
                                                .duration_s = asked.duration_s}};
  run_.apply(event);
  ends_ns_.push_back(now_ns + duration_ns);
  return event;
}

}  // namespace gaitway::simulator
