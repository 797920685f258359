// Means over a time slot, and the verdict on a run.
#include "tools/run/run_metrics.hpp"

#include <fmt/format.h>

#include <array>
#include <string_view>

#include "tools/command_line.hpp"

namespace gaitway::tools {

void CentreOfPressureMean::add(const simulator::GroundContact& contact) {
  open_.samples += 1.0;
  for (std::size_t foot = 0; foot < 2; ++foot) {
    const double force = contact.normal_force_N[foot];
    if (force <= 0.0) {
      continue;
    }
    open_.force += force;
    open_.foot_force[foot] += force;
    for (std::size_t frame = 0; frame < 2; ++frame) {
      Eigen::Vector2d cop = contact.foot_cop_m[foot];
      if (frame != foot) {
        const Eigen::Vector3d in_world = contact.sole[foot] * Eigen::Vector3d(cop.x(), cop.y(), 0.0);
        cop = (contact.sole[frame].inverse() * in_world).head<2>();
      }
      open_.moment[frame] += force * cop;
    }
  }
}

void CentreOfPressureMean::close_slot() {
  closed_ = open_;
  open_ = Sum{};
}

bool CentreOfPressureMean::in_sole_frame(int side, Eigen::Vector2d& cop_m) const {
  if (closed_.force <= 0.0) {
    return false;
  }
  cop_m = closed_.moment[static_cast<std::size_t>(side)] / closed_.force;
  return true;
}

namespace {

using Verdict = RunOutcome::Verdict;

constexpr double kLeastShare = 0.5;          // of the commanded way
constexpr double kLeastWay_m = 0.2;          // shorter ones tell nothing
constexpr double kLeastTurn_rad = 0.3;       // 〃
constexpr std::uint64_t kRefusedOneOf = 10;  // of so many batches one may be refused
constexpr double kBatchesWithin_s = 1.0;     // a shorter run may end before the first batch

void add(std::string& text, const std::string& part) {
  text += (text.empty() ? "" : ", ") + part;
}

// What was asked and not done; empty: nothing.
std::string missing(const RunMetrics& metrics, const BatchCount& batches, double virtual_s) {
  std::string text;
  const CommandedMotion& way = metrics.way_m;
  const CommandedMotion& turn = metrics.turn_rad;
  if (way.due >= kLeastWay_m && way.done < kLeastShare * way.due) {
    add(text, fmt::format("walked {:.2f} m of the commanded {:.2f} m", way.done, way.commanded));
  }
  if (turn.due >= kLeastTurn_rad && turn.done < kLeastShare * turn.due) {
    add(text, fmt::format("turned {:.2f} rad of the commanded {:.2f} rad", turn.done, turn.commanded));
  }
  const std::uint64_t all = batches.handed_over + batches.refused;
  const std::uint64_t refused_unasked = batches.refused - batches.refused_by_a_stop;
  if (refused_unasked * kRefusedOneOf > all) {
    add(text, fmt::format("refused batches: {} of {}", batches.refused, all));
  } else if (all == 0 && virtual_s >= kBatchesWithin_s) {
    add(text, "no plug-in gave a batch");
  }
  return text;
}

}  // namespace

RunOutcome outcome_of(const RunMetrics& metrics, const BatchCount& batches, double virtual_s,
                      const std::string& way_missing) {
  if (metrics.fell) {
    return {Verdict::fell, fmt::format("FELL at {:.2f} s", metrics.fell_at_s)};
  }
  std::string text_missing = missing(metrics, batches, virtual_s);
  if (!way_missing.empty()) add(text_missing, way_missing);
  if (const std::string& text = text_missing; !text.empty()) {
    return {Verdict::not_done, "stayed up, but DID NOT DO WHAT WAS ASKED: " + text};
  }
  std::string text = "stayed up";
  if (metrics.way_m.commanded > 0.0) {
    add(text, fmt::format("walked {:.2f} m of the commanded {:.2f} m", metrics.way_m.done,
                          metrics.way_m.commanded));
  }
  if (batches.refused > 0) {
    add(text,
        fmt::format("refused batches: {} of {}", batches.refused, batches.refused + batches.handed_over));
  }
  return {Verdict::done, text};
}

namespace {

std::string falls_of(const MissionEnd& mission) {
  if (mission.falls == 0) return "did not fall";
  return fmt::format("fell {} time{}", mission.falls, mission.falls == 1 ? "" : "s");
}

}  // namespace

RunOutcome outcome_of(const MissionEnd& mission, RunOutcome walked) {
  if (mission.is_of_people) {
    constexpr std::array<std::string_view, 3> kStates{"goes on", "has succeeded", "has failed"};
    const std::string_view state = mission.waits ? "waits" : kStates[static_cast<std::size_t>(mission.state)];
    walked.text += fmt::format(", mission '{}' {}", mission.name, state);
    return walked;
  }
  if (mission.state == MissionEnd::State::runs && mission.silent_since_s) {
    return {mission.on_feet ? Verdict::not_done : Verdict::fell,
            fmt::format("the behaviour HAS GONE SILENT at {:.2f} s, in the middle of mission '{}'; it {}",
                        *mission.silent_since_s, mission.name, falls_of(mission))};
  }
  if (!mission.endless || mission.state != MissionEnd::State::runs) return outcome_of(mission);
  if (walked.verdict == Verdict::done && mission.waits) {
    return {Verdict::not_done,
            fmt::format("mission '{}' WAITS at the end: somebody else commands the robot; it {}",
                        mission.name, falls_of(mission))};
  }
  if (walked.verdict == Verdict::done && mission.falls > 0) {
    walked.text = fmt::format("is on its feet at the end, {}", falls_of(mission));
  }
  walked.text += fmt::format(", mission '{}' goes on", mission.name);
  return walked;
}

RunOutcome outcome_of(const MissionEnd& mission) {
  using State = MissionEnd::State;
  const std::string falls = falls_of(mission);
  const std::string lies = mission.on_feet ? "" : ", and LIES ON THE GROUND";
  switch (mission.state) {
    case State::succeeded:
      return {Verdict::done,
              fmt::format("mission '{}' succeeded after {:.2f} s, {}", mission.name, mission.at_s, falls)};
    case State::failed:
      return {mission.on_feet ? Verdict::not_done : Verdict::fell,
              fmt::format("mission '{}' FAILED after {:.2f} s{}: {}; it {}", mission.name, mission.at_s, lies,
                          mission.reason.empty() ? "it said no reason" : mission.reason, falls)};
    case State::runs:
      break;
  }
  return {mission.on_feet ? Verdict::not_done : Verdict::fell,
          fmt::format("mission '{}' HAS NOT COME TO ITS END{}; it {}", mission.name, lies, falls)};
}

int exit_code(Verdict verdict) noexcept {
  return verdict == Verdict::done ? kExitFine : verdict == Verdict::fell ? kExitFell : kExitNotDone;
}

const char* name(Verdict verdict) noexcept {
  return verdict == Verdict::done ? "done" : verdict == Verdict::fell ? "fell" : "not done";
}

}  // namespace gaitway::tools
