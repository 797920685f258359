// Looks at what the robot does now; the time that a walk needs to begin is kept by who ordered it.
#include "stand_waits.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

#include "client_message.hpp"
#include "gaitway/facts/facts.hpp"

namespace gaitway::api {
namespace {

// What it does when it will not stand, and why.
struct Prevention {
  std::string_view activity, why;
};
constexpr std::array kPreventions{
    Prevention{"stopped", kEmergencyStopped},
    Prevention{"falls", "the robot falls"},
    Prevention{"fallen", "the robot has fallen"},
};

}  // namespace

StandWaits::StandWaits(const RobotPort& robot, const RobotCommands& commands, Finish finish)
    : robot_(robot), commands_(commands), finish_(std::move(finish)) {}

void StandWaits::require_room(std::uint64_t client) const {
  const auto count =
      std::ranges::count(waiting_, client, [](const Waiting& waiting) { return waiting.call.client; });
  if (static_cast<std::size_t>(count) >= kMostOfOneClient) {
    throw CommandDenied("this connection waits for " + std::to_string(count) +
                        " stands already: wait for one of them first");
  }
}

void StandWaits::wait(const ServiceCall& call, std::int64_t now_ns, std::int64_t most_ns) {
  waiting_.push_back({call, now_ns, now_ns + most_ns, commands_.authority().stops()});
}

void StandWaits::step(std::int64_t now_ns) {
  std::vector<std::pair<Waiting, Answer>> answered;
  std::erase_if(waiting_, [&](Waiting& waiting) {
    auto found = answer(waiting, now_ns);
    if (found) {
      answered.emplace_back(std::move(waiting), std::move(*found));
    }
    return found.has_value();
  });
  for (const auto& [waiting, found] : answered) {
    finish_(waiting.call, found.outcome, found.text);
  }
}

std::optional<StandWaits::Answer> StandWaits::answer(const Waiting& waiting, std::int64_t now_ns) const {
  const std::string_view activity = robot_.activity();
  const auto prevention = std::ranges::find(kPreventions, activity, &Prevention::activity);
  if (!robot_.connected()) {
    return Answer{Outcome::prevented, "the robot is not there any more: its " +
                                          std::string(robot_.silent_part()) + " does not answer"};
  }
  if (prevention != kPreventions.end()) {
    return Answer{Outcome::prevented, std::string(prevention->why)};
  }
  if (commands_.authority().stops() != waiting.stops) {
    return Answer{Outcome::prevented, "a stop came meanwhile, and was carried out instead"};
  }
  if (stands()) {
    return Answer{Outcome::stands, "stands"};
  }
  if (now_ns < waiting.ends_ns) {
    return std::nullopt;
  }
  const double waited_s = static_cast<double>(now_ns - waiting.began_ns) / facts::kSecond_ns;
  return Answer{Outcome::late,
                "the robot was told to stand, but does not within " + shown_json(nlohmann::json(waited_s)) +
                    " s: it " + (activity.empty() ? "says nothing of what it does" : std::string(activity)) +
                    "; /robot_state tells when it stands"};
}

// Not while a walk or motion of a moment ago may still be to come.
bool StandWaits::stands() const {
  return robot_.activity() == "stands" && robot_.now_ns() - commands_.moved_ns() >= kShows_ns;
}

void StandWaits::robot_lost() {
  const std::vector<Waiting> lost = std::exchange(waiting_, {});
  for (const Waiting& waiting : lost) {
    finish_(waiting.call, Outcome::prevented,
            "the link to the robot was lost meanwhile: the robot stands by itself, but nobody could see it "
            "do so");
  }
}

void StandWaits::forget(std::uint64_t client) {
  std::erase_if(waiting_, [client](const Waiting& waiting) { return waiting.call.client == client; });
}

}  // namespace gaitway::api
