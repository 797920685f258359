// Two programs, each in a network namespace of its own, and the emulated link between them, paced by the
// clock.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "gaitway/process/duration_histogram.hpp"
#include "tools/wireless/link_emulator.hpp"
#include "tools/wireless/outage_schedule.hpp"

namespace gaitway::tools {

struct WirelessSettings {
  LinkSettings link;
  std::uint64_t seed = 1;
  std::vector<Outage> outages;  // from the client's start
  std::vector<std::string> robot, client;
  std::optional<std::string> robot_ready;  // a line of its output in which this regular expression is found
  std::int64_t robot_ready_within_ns = 30'000'000'000;
  std::optional<std::filesystem::path> control;     // FIFO for lines like "outage 0.5s"
  std::optional<std::filesystem::path> outage_log;  // a line of JSON for each beginning and end
};

struct WirelessResult {
  int client_code = 0;
  std::optional<int> robot_code;  // it ended before it was told to
  std::array<DirectionStatistics, 2> from;
  std::array<std::size_t, 2> under_way{};
  std::vector<Outage> outages;          // CLOCK_MONOTONIC; one that did not begin is not among them
  process::DurationHistogram lateness;  // of packets behind their instant
  std::int64_t client_started_ns = 0, client_ended_ns = 0;
};

// Throws NoIsolation, NotDone when the robot does not become ready, and std::invalid_argument.
[[nodiscard]] WirelessResult run_wireless(const WirelessSettings& settings);

}  // namespace gaitway::tools
