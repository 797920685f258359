// Reads logs of one robot's bus for who feeds them to its joints.
#include "tools/bus/log_input.hpp"

#include <fmt/format.h>

#include <stdexcept>

#include "gaitway/facts/facts.hpp"

namespace gaitway::tools {
namespace {

using facts::kMillisecond_ns;

// A log that begins later than this after time zero was not taken from the robot's own clock.
constexpr std::int64_t kLatestStart_ns = 1'000'000'000;

// Frames in order, most of them messages of this profile.
void check_log(const std::filesystem::path& file, const std::vector<can::LoggedFrame>& log,
               const can::Profile& profile) {
  if (log.empty()) {
    throw std::invalid_argument(
        fmt::format("{}: no frame in it. Give a log that `gaitway run` or candump -L wrote", file.string()));
  }
  std::size_t known = 0;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (i > 0 && log[i].time_ns < log[i - 1].time_ns) {
      throw std::invalid_argument(
          fmt::format("{}: frame {} at {:.6f} s comes before the one above it: frames must be in order of "
                      "time. Sort the log",
                      file.string(), i + 1, static_cast<double>(log[i].time_ns) * 1e-9));
    }
    const can::Frame& frame = log[i].frame;
    const auto message = profile.identify(frame.id);
    known += message && frame.size == can::layout(message->kind).size ? 1U : 0U;
  }
  if (2 * known < log.size()) {
    throw std::invalid_argument(fmt::format(
        "{}: {} of {} frames are no messages of the profile '{}'. Give the recorded run's --profile",
        file.string(), log.size() - known, log.size(), profile.name));
  }
}

// A log of another clock than the robot's is laid out so that its first frame is within its first
// millisecond; returns what was taken off.
std::int64_t start_at_zero(std::vector<can::LoggedFrame>& log) {
  const std::int64_t first_ns = log.front().time_ns;
  if (first_ns <= kLatestStart_ns) {
    return 0;
  }
  const std::int64_t shift_ns = first_ns / kMillisecond_ns * kMillisecond_ns;
  for (can::LoggedFrame& logged : log) {
    logged.time_ns -= shift_ns;
  }
  return shift_ns;
}

}  // namespace

RobotLog read_robot_log(const std::filesystem::path& file, const can::Profile& profile) {
  RobotLog log{can::read_candump_log(file)};
  check_log(file, log.frames, profile);
  log.shift_ns = start_at_zero(log.frames);
  return log;
}

}  // namespace gaitway::tools
